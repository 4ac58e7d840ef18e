// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Quantities beside irradiance, statistics, masks; solid angles, intensities and sensor grids.
#include "IrradianceFixtures.h"

#include "vtkLumiRadiantIntensity.h"
#include "vtkLumiSensorGrid.h"
#include "vtkLumiSolidAngle.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace lumitree::testing
{
namespace
{

constexpr double pi = 3.14159265358979323846;

double number(vtkDataObject* object, const char* name)
{
  vtkDataArray* array = object->GetFieldData()->GetArray(name);
  EXPECT_TRUE(array) << name;
  return array ? array->GetComponent(0, 0) : std::nan("");
}

TEST(IrradianceEstimates, StatisticsInFieldData)
{
  // A strip behind a wall, in parallel light at 45 degrees: 2 m of shadow.
  Irradiance filter(floorStrip(-4.0, 0.5, 10), { directionalLight({ -1, 0, -1 }, 1000.0) });
  filter->SetOccludersData(wall());
  vtkDataArray* e = filter.run("Irradiance [W/m^2]");
  ASSERT_TRUE(e) << filter.text;
  vtkDataObject* output = filter->GetOutputDataObject(0);
  EXPECT_EQ(number(output, "IrradianceMinimum [W/m^2]"), 0.0);
  EXPECT_NEAR(number(output, "IrradianceMaximum [W/m^2]"), 1000.0 * std::sqrt(0.5), 1e-10);
  double sum = 0.0;
  for (vtkIdType i = 0; i < e->GetNumberOfTuples(); ++i)
  {
    sum += e->GetComponent(i, 0);
  }
  EXPECT_NEAR(number(output, "IrradianceMean [W/m^2]"), sum / 10.0, 1e-10);
  EXPECT_EQ(number(output, "Uniformity"), 0.0);
  EXPECT_FALSE(output->GetFieldData()->GetArray("DaylightFactor [%]")); // there is no sky
}

TEST(IrradianceEstimates, EveryArrayOfThePage)
{
  Irradiance filter(floorStrip(-4.0, 0.5, 10), { directionalLight({ -1, 0, -1 }, 1000.0) });
  filter->SetOccludersData(wall());
  filter->TwoSidedOn();
  filter->ScalarIrradianceOn();
  filter->LightVectorOn();
  filter->CylindricalIrradianceOn();
  filter->HemisphericalIrradianceOn();
  filter->EstimateArraysOn();
  filter->ShadowMasksOn();
  vtkDataArray* e = filter.run("Irradiance [W/m^2]");
  ASSERT_TRUE(e) << filter.text;
  vtkDataSetAttributes* cells =
    vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetCellData();
  EXPECT_EQ(cells->GetScalars(), e);
  const auto at = [&](const char* name, vtkIdType i, int component = 0)
  {
    vtkDataArray* array = cells->GetArray(name);
    EXPECT_TRUE(array) << name;
    return array ? array->GetComponent(i, component) : std::nan("");
  };
  for (vtkIdType i = 0; i < 10; ++i)
  {
    const bool lit = -4.0 + 0.5 * static_cast<double>(i) + 0.25 < -1.0;
    const double value = lit ? 1000.0 * std::sqrt(0.5) : 0.0;
    EXPECT_NEAR(e->GetComponent(i, 0), value, 1e-10) << i;
    EXPECT_EQ(at("BackIrradiance [W/m^2]", i), 0.0);
    EXPECT_NEAR(at("ScalarIrradiance [W/m^2]", i), lit ? 1000.0 : 0.0, 1e-10);
    EXPECT_NEAR(at("LightVector [W/m^2]", i, 0), value, 1e-10);
    EXPECT_NEAR(at("LightVector [W/m^2]", i, 2), value, 1e-10);
    EXPECT_NEAR(at("CylindricalIrradiance [W/m^2]", i), value / pi, 1e-10);
    EXPECT_NEAR(
      at("HemisphericalIrradiance [W/m^2]", i), lit ? 0.25 * (1000.0 + value) : 0.0, 1e-10);
    EXPECT_EQ(at("IrradianceLower [W/m^2]", i), e->GetComponent(i, 0));
    EXPECT_EQ(at("IrradianceUpper [W/m^2]", i), e->GetComponent(i, 0));
    EXPECT_EQ(at("EstimateMethod", i), 2); // a sightline
    EXPECT_EQ(at("RayCount", i), 2);       // for the surface and for free space
    EXPECT_EQ(at("ShadowMask", i), lit ? 0 : 1);
    EXPECT_EQ(at("PenumbraMask", i), 0);
  }
}

TEST(IrradianceEstimates, VolumesHaveLightVectorsToo)
{
  const vtkNew<vtkImageData> volume;
  volume->SetDimensions(3, 3, 3);
  Irradiance filter(volume, { pointLight({ 1, 1, 9 }, 4.0 * pi) });
  filter->SetReceiverLocation(vtkLumiIrradiance::Points);
  filter->SetShadows(false);
  filter->LightVectorOn();
  filter->EstimateArraysOn();
  vtkDataArray* e = filter.run("ScalarIrradiance [W/m^2]");
  ASSERT_TRUE(e) << filter.text;
  vtkPointData* points = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetPointData();
  EXPECT_NEAR(e->GetComponent(4, 0), 1.0 / 81.0, 1e-14); // below the lamp
  EXPECT_NEAR(points->GetArray("LightVector [W/m^2]")->GetComponent(4, 2), 1.0 / 81.0, 1e-14);
  EXPECT_TRUE(points->GetArray("ScalarIrradianceLower [W/m^2]"));
}

/// Counts the errors of a filter.
class Errors
{
public:
  explicit Errors(vtkAlgorithm* filter)
  {
    this->observer_->SetClientData(this);
    this->observer_->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*) { ++static_cast<Errors*>(self)->count; });
    filter->AddObserver(vtkCommand::ErrorEvent, this->observer_);
  }

  int count = 0;

private:
  vtkNew<vtkCallbackCommand> observer_;
};

TEST(SolidAngle, OfAClosedSurfaceAndItsVisiblePart)
{
  const vtkNew<vtkSphereSource> ball;
  ball->SetRadius(1.0);
  ball->SetThetaResolution(32);
  ball->SetPhiResolution(17);
  auto points = polygons({ { 0, 0, 0 }, { 0, 0, 4 }, { 3, 0, 0 } }, {});
  const vtkNew<vtkLumiSolidAngle> filter;
  filter->SetInputData(points);
  filter->SetSurfaceConnection(ball->GetOutputPort());
  filter->VisiblePartOn();
  filter->SetRelativeTolerance(0.005);
  filter->Update();
  auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  vtkDataArray* whole = output->GetPointData()->GetArray("SolidAngle [sr]");
  vtkDataArray* seen = output->GetPointData()->GetArray("VisibleSolidAngle [sr]");
  ASSERT_TRUE(whole && seen);
  EXPECT_NEAR(whole->GetComponent(0, 0), 4.0 * pi, 1e-5); // points are float
  EXPECT_NEAR(whole->GetComponent(1, 0), 0.0, 1e-5);
  EXPECT_NEAR(seen->GetComponent(0, 0), 4.0 * pi, 0.02 * 4.0 * pi);
  const double cap = 2.0 * pi * (1.0 - std::sqrt(1.0 - 1.0 / 16.0));
  EXPECT_NEAR(seen->GetComponent(1, 0), cap, 0.03 * cap); // the polyhedron is smaller
}

TEST(SolidAngle, WithoutASurfaceThereIsOneError)
{
  const vtkNew<vtkLumiSolidAngle> filter;
  filter->SetInputData(polygons({ { 0, 0, 0 } }, {}));
  const Errors errors(filter);
  filter->Update();
  EXPECT_EQ(errors.count, 1);
  EXPECT_EQ(vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints(), 0);
}

TEST(RadiantIntensity, ASquareIsACosine)
{
  auto square =
    polygons({ { 0, 0, 0 }, { 0, 2, 0 }, { 2, 2, 0 }, { 2, 0, 0 } }, { { 0, 1, 2, 3 } });
  const vtkNew<vtkLumiRadiantIntensity> filter;
  filter->SetInputData(square); // faces down, as the axis does
  filter->SetValue(100.0 * pi);
  filter->Update();
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  ASSERT_EQ(table->GetNumberOfColumns(), 25);
  ASSERT_EQ(table->GetNumberOfRows(), 37);
  auto* column = vtkDataArray::SafeDownCast(table->GetColumnByName("C 15"));
  ASSERT_TRUE(column);
  for (int g = 0; g <= 36; ++g)
  {
    EXPECT_NEAR(column->GetComponent(g, 0), 100.0 * std::max(0.0, std::cos(pi * g / 36.0)), 1e-4);
  }
  auto* solid = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(std::string(solid->GetPointData()->GetScalars()->GetName()), "RadiantIntensity [W/sr]");
  EXPECT_NEAR(number(solid, "EmittedFlux [W]"), 100.0 * pi, 1e-9);
  EXPECT_NEAR(number(solid, "IntegratedFlux [W]"), 100.0 * pi, 0.3); // of the interpolant
  EXPECT_NEAR(number(solid, "FarFieldDistance"), 5.0 * std::sqrt(8.0), 1e-6);
}

TEST(RadiantIntensity, OfALight)
{
  const vtkNew<vtkLumiRadiantIntensity> filter;
  filter->SetInputData(pointLight({ 1, 2, 3 }, 400.0 * pi, "Lamp", true));
  filter->Update();
  auto* solid = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_TRUE(solid->GetPointData()->GetArray("LuminousIntensity [cd]"));
  EXPECT_NEAR(solid->GetPointData()->GetScalars()->GetComponent(7, 0), 100.0, 1e-11);
  EXPECT_NEAR(number(solid, "IntegratedFlux [lm]"), 400.0 * pi, 1e-9);
  EXPECT_FALSE(solid->GetFieldData()->GetArray("FarFieldDistance"));
}

TEST(RadiantIntensity, BadInputIsOneError)
{
  const auto errorsOf =
    [](vtkDataObject* input, const std::function<void(vtkLumiRadiantIntensity*)>& spoil)
  {
    const vtkNew<vtkLumiRadiantIntensity> filter;
    filter->SetInputDataObject(input);
    spoil(filter);
    const Errors errors(filter);
    filter->Update();
    EXPECT_EQ(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints(), 0);
    EXPECT_EQ(vtkTable::SafeDownCast(filter->GetOutputDataObject(1))->GetNumberOfColumns(), 0);
    return errors.count;
  };
  const auto nothing = [](vtkLumiRadiantIntensity*) {};
  auto square = polygons({ { 0, 0, 0 }, { 0, 2, 0 }, { 2, 2, 0 } }, { { 0, 1, 2 } });
  EXPECT_EQ(errorsOf(polygons({ { 0, 0, 0 } }, {}), nothing), 1);
  EXPECT_EQ(errorsOf(directionalLight({ 0, 0, -1 }, 1.0), nothing), 1);
  EXPECT_EQ(errorsOf(square, [](auto* f) { f->SetValue(-1.0); }), 1);
  EXPECT_EQ(errorsOf(square, [](auto* f) { f->SetAxis(0, 0, 0); }), 1);
  EXPECT_EQ(errorsOf(square, [](auto* f) { f->SetReference(0, 0, 2); }), 1);
}

TEST(SensorGrid, SpacingOfTheStandard)
{
  const vtkNew<vtkLumiSensorGrid> grid;
  grid->SetPoint1(5, 0, 0);
  grid->SetPoint2(0, 4, 0);
  grid->Update();
  // p = 0.616 m: 9 by 7.
  EXPECT_EQ(grid->GetOutput()->GetNumberOfCells(), 63);
  EXPECT_EQ(grid->GetOutput()->GetCellData()->GetNormals()->GetComponent(0, 2), 1.0);
  grid->SetLengthUnit(vtkLumiSensorGrid::Millimetre);
  grid->SetPoint1(5000, 0, 0);
  grid->SetPoint2(0, 4000, 0);
  grid->Update();
  EXPECT_EQ(grid->GetOutput()->GetNumberOfCells(), 63);
  grid->SetMargin(500); // 4 by 3 m: p = 0.527 m
  grid->FlipOn();
  grid->Update();
  EXPECT_EQ(grid->GetOutput()->GetNumberOfCells(), 8 * 6);
  EXPECT_NEAR(grid->GetOutput()->GetBounds()[0], 500.0, 1e-9);
  EXPECT_EQ(grid->GetOutput()->GetCellData()->GetNormals()->GetComponent(0, 2), -1.0);
  const Errors errors(grid);
  grid->SetMargin(2500);
  grid->Update();
  grid->SetMargin(0);
  grid->SetPoint2(1, 0, 0);
  grid->Update();
  EXPECT_EQ(errors.count, 2);
}

} // namespace
} // namespace lumitree::testing
