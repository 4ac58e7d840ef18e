// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkLumiRadiance: the forms of rays, directions around points, reflection, bad input.
#include "IrradianceFixtures.h"

#include "vtkLumiCameraRays.h"
#include "vtkLumiRadiance.h"
#include "vtkLumiShapeLight.h"
#include "vtkLumiSky.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

namespace lumitree::testing
{
namespace
{

constexpr double pi = 3.14159265358979323846;
const char* const name = "Radiance [W/(m^2 sr)]";

/// A panel of 2 m x 2 m, 3 m high, that shines down with a radiance of 50.
vtkSmartPointer<vtkPolyData> panel()
{
  const vtkNew<vtkLumiShapeLight> light;
  light->SetShape(vtkLumiShapeLight::Rectangle);
  light->SetOrigin(-1, -1, 3);
  light->SetPoint1(-1, 1, 3);
  light->SetPoint2(1, -1, 3);
  light->SetEmissionQuantity(vtkLumiShapeLight::Radiance);
  light->SetEmission(50.0);
  light->Update();
  return light->GetOutput();
}

vtkSmartPointer<vtkPolyData> raysUp(const std::vector<Point>& origins, double size = 1.0)
{
  auto rays = polygons(origins, {});
  const vtkNew<vtkDoubleArray> directions;
  directions->SetName("RayDirection");
  directions->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < origins.size(); ++i)
  {
    directions->InsertNextTuple3(0, 0, size);
  }
  rays->GetPointData()->AddArray(directions);
  return rays;
}

/// A filter with inputs, and what it says.
struct Filter
{
  vtkNew<vtkLumiRadiance> filter;
  vtkNew<vtkCallbackCommand> observer;
  int errors = 0;
  int warnings = 0;

  explicit Filter(vtkDataObject* input, const std::vector<vtkSmartPointer<vtkPolyData>>& lights)
  {
    this->observer->SetClientData(this);
    this->observer->SetCallback(
      [](vtkObject*, unsigned long event, void* self, void*)
      {
        auto* me = static_cast<Filter*>(self);
        ++(event == vtkCommand::ErrorEvent ? me->errors : me->warnings);
      });
    this->filter->AddObserver(vtkCommand::ErrorEvent, this->observer);
    this->filter->AddObserver(vtkCommand::WarningEvent, this->observer);
    this->filter->SetInputDataObject(0, input);
    for (const auto& light : lights)
    {
      this->filter->AddLightsData(light);
    }
  }
  vtkLumiRadiance* operator->() { return this->filter; }
  vtkDataSet* run()
  {
    this->filter->Update();
    return vtkDataSet::SafeDownCast(this->filter->GetOutputDataObject(0));
  }
};

TEST(Radiance, AlongRaysThatAreOccludedOrNot)
{
  auto ceiling =
    polygons({ { 0, -9, 2 }, { 9, -9, 2 }, { 9, 9, 2 }, { 0, 9, 2 } }, { { 0, 1, 2, 3 } });
  Filter filter(raysUp({ { -0.5, 0, 0 }, { 0.5, 0, 0 }, { -5, 0, 0 } }, 0.01), { panel() });
  filter->SetOccludersData(ceiling);
  vtkDataArray* seen = filter.run()->GetPointData()->GetArray(name);
  ASSERT_TRUE(seen);
  EXPECT_EQ(filter.run()->GetPointData()->GetScalars(), seen);
  EXPECT_EQ(seen->GetComponent(0, 0), 50.0);
  EXPECT_EQ(seen->GetComponent(1, 0), 0.0);
  EXPECT_EQ(seen->GetComponent(2, 0), 0.0);
  filter->SetTMax(299.0); // of 0.01 each
  EXPECT_EQ(filter.run()->GetPointData()->GetArray(name)->GetComponent(0, 0), 0.0);
}

TEST(Radiance, SegmentsHaveACellArrayAndCamerasAnImage)
{
  auto lines = polygons({ { 0, 0, 0 }, { 0, 0, 2.5 }, { 0, 0, 3.5 } }, {});
  const vtkNew<vtkCellArray> cells;
  const vtkIdType ids[3] = { 0, 1, 2 };
  cells->InsertNextCell(3, ids);
  lines->SetLines(cells);
  lines->SetVerts(nullptr);
  Filter filter(lines, { panel() });
  vtkDataArray* seen = filter.run()->GetCellData()->GetArray(name);
  ASSERT_TRUE(seen);
  ASSERT_EQ(seen->GetNumberOfTuples(), 2);
  EXPECT_EQ(seen->GetComponent(0, 0), 0.0);
  EXPECT_EQ(seen->GetComponent(1, 0), 50.0);
  const vtkNew<vtkLumiCameraRays> camera;
  camera->SetPosition(0, 0, 0);
  camera->SetFocalPoint(0, 0, 3);
  camera->SetViewUp(0, 1, 0);
  camera->SetViewAngle(60);
  camera->SetResolution(9, 9);
  filter->SetInputConnection(0, camera->GetOutputPort());
  auto* image = vtkImageData::SafeDownCast(filter.run());
  ASSERT_TRUE(image);
  EXPECT_EQ(image->GetPointData()->GetArray(name)->GetComponent(40, 0), 50.0);
  EXPECT_EQ(image->GetPointData()->GetArray(name)->GetComponent(0, 0), 0.0);
}

TEST(Radiance, ReflectanceOfTheSurfaceComesFirst)
{
  auto floor = floorStrip(-5.0, 2.0, 5); // cells of 2 m
  const vtkNew<vtkDoubleArray> reflectance;
  reflectance->SetName("Reflectance");
  for (const double value : { 0.1, 0.2, 0.3, 0.4, 0.5 })
  {
    reflectance->InsertNextValue(value);
  }
  auto rays = raysUp({ { -4, 0.1, 1 }, { 0, 0.1, 1 }, { 4, 0.1, 1 } }, -1.0);
  Filter filter(rays, { directionalLight({ 0, 0, -1 }, 100.0) });
  filter->SetOccludersData(floor);
  const auto at = [&](vtkIdType i)
  { return filter.run()->GetPointData()->GetArray(name)->GetComponent(i, 0); };
  EXPECT_EQ(at(1), 0.0);
  filter->ReflectionOn();
  filter->SetReflectance(0.6);
  EXPECT_NEAR(at(1), 60.0 / pi, 1e-10);
  floor->GetCellData()->AddArray(reflectance);
  filter->SetOccludersData(nullptr);
  filter->SetOccludersData(floor);
  EXPECT_NEAR(at(0), 10.0 / pi, 1e-10);
  EXPECT_NEAR(at(1), 30.0 / pi, 1e-10);
  EXPECT_NEAR(at(2), 50.0 / pi, 1e-10);
  reflectance->SetValue(0, 1.5);
  reflectance->Modified();
  filter->Modified();
  filter.run();
  EXPECT_EQ(filter.errors, 1);
}

TEST(Radiance, DirectionsAreComponents)
{
  auto floor = floorStrip(-1.0, 1.0, 2);
  const vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, floor);
  Filter filter(blocks, { panel() });
  filter->SetLook(vtkLumiRadiance::ByDirection);
  filter->SetReceiverLocation(vtkLumiRadiance::Cells);
  filter->SetRings(90);
  filter->SetSectors(180);
  filter->SetNumberOfThreads(1);
  filter.run();
  const auto first = [&]
  {
    auto* out = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    return vtkDataSet::SafeDownCast(out->GetBlock(0));
  };
  vtkDataArray* seen = first()->GetCellData()->GetArray(name);
  ASSERT_TRUE(seen);
  ASSERT_EQ(seen->GetNumberOfComponents(), 90 * 180);
  vtkDataArray* directions = first()->GetFieldData()->GetArray("RadianceDirections");
  vtkDataArray* solidAngles = first()->GetFieldData()->GetArray("RadianceSolidAngles [sr]");
  ASSERT_TRUE(directions && solidAngles);
  double sum = 0.0;
  for (int d = 0; d < 90 * 180; ++d)
  {
    sum += seen->GetComponent(0, d) * solidAngles->GetComponent(d, 0) *
      std::max(0.0, directions->GetComponent(d, 2));
  }
  Irradiance exact(floor, { panel() });
  const double expected = exact.run("Irradiance [W/m^2]")->GetComponent(0, 0);
  EXPECT_NEAR(sum, expected, 0.01 * expected);
  const std::vector<double> once(static_cast<double*>(seen->GetVoidPointer(0)),
    static_cast<double*>(seen->GetVoidPointer(0)) + 2 * 90 * 180);
  filter->SetNumberOfThreads(3);
  filter.run();
  EXPECT_EQ(std::memcmp(first()->GetCellData()->GetArray(name)->GetVoidPointer(0), once.data(),
              once.size() * sizeof(double)),
    0);
}

TEST(Radiance, BadInputIsOneError)
{
  const auto errorsOf = [](vtkDataObject* input,
                          const std::vector<vtkSmartPointer<vtkPolyData>>& lights,
                          const std::function<void(vtkLumiRadiance*)>& spoil = {})
  {
    Filter filter(input, lights);
    if (spoil)
    {
      spoil(filter.filter);
    }
    vtkDataSet* output = filter.run();
    EXPECT_TRUE(!output || output->GetNumberOfPoints() == 0);
    return filter.errors;
  };
  auto rays = raysUp({ { 0, 0, 0 } });
  EXPECT_EQ(errorsOf(rays, {}), 1);
  EXPECT_EQ(errorsOf(rays, { rays }), 1) << "no light";
  EXPECT_EQ(errorsOf(polygons({ { 0, 0, 0 } }, {}), { panel() }), 1) << "no rays";
  EXPECT_EQ(errorsOf(vtkNew<vtkMultiBlockDataSet>(), { panel() }), 1) << "not one dataset";
  EXPECT_EQ(errorsOf(rays, { panel() },
              [](vtkLumiRadiance* f)
              {
                f->SetLook(vtkLumiRadiance::ByDirection);
                f->SetReference(0, 0, 1);
              }),
    1);
  Filter invalid(raysUp({ { 0, 0, 0 }, { std::nan(""), 0, 0 } }), { panel() });
  vtkDataArray* seen = invalid.run()->GetPointData()->GetArray(name);
  EXPECT_EQ(seen->GetComponent(0, 0), 50.0);
  EXPECT_TRUE(std::isnan(seen->GetComponent(1, 0)));
  EXPECT_EQ(invalid.warnings, 1);
  Filter empty(raysUp({}), { panel() });
  EXPECT_EQ(empty.run()->GetNumberOfPoints(), 0);
  EXPECT_EQ(empty.errors, 0);
}

} // namespace
} // namespace lumitree::testing
