// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Run on three ranks: occluders and lights of one rank count on all of them, receivers and rays
// stay where they are.
#include "IrradianceFixtures.h"

#include "vtkLumiPointLight.h"
#include "vtkLumiRadiance.h"
#include "vtkLumiShapeLight.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMPIController.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace lumitree::testing
{
namespace
{

constexpr char irradiance[] = "Irradiance [W/m^2]";

vtkMPIController* world = nullptr;

int rank()
{
  return world->GetLocalProcessId();
}

/// The part of the floor that a rank has, from x = −4 to 0.8 over all three.
vtkSmartPointer<vtkPolyData> floorOf(int process)
{
  return floorStrip(-4.0 + 1.6 * process, 0.01, 160);
}

vtkSmartPointer<vtkPolyData> lampOf(int process)
{
  return process == 0 ? pointLight({ 3, 0, 4 }, 1000.0, "High")
                      : pointLight({ 2, 0, 3 }, 100.0, "Low");
}

/// What one process that has everything gets for the floor of this rank.
std::vector<double> expected()
{
  const vtkNew<vtkMultiBlockDataSet> scene;
  scene->SetBlock(0, floorOf(rank()));
  scene->SetBlock(1, wall());
  Irradiance filter(scene, { lampOf(0), lampOf(2) });
  filter->SetController(nullptr);
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter.run());
  auto* e = vtkDoubleArray::SafeDownCast(
    vtkDataSet::SafeDownCast(output->GetBlock(0))->GetCellData()->GetArray(irradiance));
  return { e->GetPointer(0), e->GetPointer(0) + e->GetNumberOfValues() };
}

void expectSame(vtkDataArray* e)
{
  ASSERT_TRUE(e);
  const std::vector<double> values = expected();
  ASSERT_EQ(e->GetNumberOfTuples(), static_cast<vtkIdType>(values.size()));
  int shadowed = 0;
  for (vtkIdType i = 0; i < e->GetNumberOfTuples(); ++i)
  {
    EXPECT_EQ(e->GetComponent(i, 0), values[i]) << i;
    shadowed += values[i] == 0.0 ? 1 : 0;
  }
  if (rank() == 2)
  {
    EXPECT_GT(shadowed, 0);
  }
}

std::vector<vtkSmartPointer<vtkPolyData>> myLamps()
{
  if (rank() == 1)
  {
    return { vtkSmartPointer<vtkPolyData>::New() };
  }
  return { lampOf(rank()) };
}

TEST(IrradianceRanks, OccludersOfOneRank)
{
  Irradiance filter(floorOf(rank()), myLamps());
  filter->SetController(world);
  filter->SetOccludersData(rank() == 1 ? wall() : vtkSmartPointer<vtkPolyData>::New());
  vtkDataArray* e = filter.run(irradiance);
  EXPECT_EQ(filter.errors, 0) << filter.text;
  expectSame(e);
}

TEST(IrradianceRanks, ReceiversShadowEachOther)
{
  const vtkNew<vtkMultiBlockDataSet> scene;
  scene->SetBlock(0, floorOf(rank()));
  if (rank() == 1)
  {
    scene->SetBlock(1, wall());
  }
  Irradiance filter(scene, myLamps());
  filter->SetController(world);
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter.run());
  EXPECT_EQ(filter.errors, 0) << filter.text;
  ASSERT_TRUE(output);
  expectSame(vtkDataSet::SafeDownCast(output->GetBlock(0))->GetCellData()->GetArray(irradiance));
}

TEST(IrradianceRanks, ALightSourceCountsOnce)
{
  // Every rank runs the source; only its first piece has the light.
  const vtkNew<vtkLumiPointLight> source;
  source->SetPosition(3, 0, 4);
  source->SetFlux(1000.0);
  Irradiance filter(floorOf(rank()));
  filter->SetController(world);
  filter->SetOccludersData(rank() == 1 ? wall() : vtkSmartPointer<vtkPolyData>::New());
  filter->AddLightsConnection(source->GetOutputPort());
  filter->AddLightsData(rank() == 0 ? lampOf(2) : vtkSmartPointer<vtkPolyData>::New());
  filter->UpdatePiece(rank(), world->GetNumberOfProcesses(), 0);
  EXPECT_EQ(filter.errors, 0) << filter.text;
  expectSame(
    vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetCellData()->GetArray(irradiance));
}

TEST(IrradianceRanks, AWrongLightIsAnErrorEverywhere)
{
  auto lamps = myLamps();
  if (rank() == 2)
  {
    setText(lamps[0], "LightType", "laser");
  }
  Irradiance filter(floorOf(rank()), lamps);
  filter->SetController(world);
  filter.run();
  EXPECT_EQ(filter.errors, 1) << filter.text;
  EXPECT_NE(filter.text.find("laser"), std::string::npos) << filter.text;
}

TEST(IrradianceRanks, SomethingThatIsNoLightIsAnErrorEverywhere)
{
  const vtkNew<vtkMultiBlockDataSet> lights;
  if (rank() == 1)
  {
    lights->SetBlock(0, vtkSmartPointer<vtkImageData>::New());
  }
  Irradiance filter(floorOf(rank()), myLamps());
  filter->AddLightsData(lights);
  filter->SetController(world);
  filter.run();
  EXPECT_EQ(filter.errors, 1) << filter.text;
}

/// Radiance of the directions around this rank's part of the floor, which reflects no light.
std::vector<double> radianceOfFloor(vtkMultiProcessController* controller, vtkPolyData* occluders,
  const std::vector<vtkSmartPointer<vtkPolyData>>& lights, int look, int threads)
{
  const vtkNew<vtkLumiRadiance> filter;
  vtkSmartPointer<vtkPolyData> places = floorStrip(-4.0 + 1.6 * rank(), 0.1, 16);
  if (look == vtkLumiRadiance::AlongRays)
  {
    const vtkNew<vtkDoubleArray> directions;
    directions->SetName("RayDirection");
    directions->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < places->GetNumberOfPoints(); ++i)
    {
      directions->InsertNextTuple3(
        1.0, 0.1 * static_cast<double>(i % 3), 0.02 * static_cast<double>(i));
    }
    places->GetPointData()->AddArray(directions);
  }
  filter->SetController(controller);
  filter->SetLook(look);
  filter->ReflectionOn();
  filter->SetNumberOfThreads(threads);
  filter->SetInputDataObject(0, places);
  filter->SetOccludersData(occluders);
  for (const auto& light : lights)
  {
    filter->AddLightsData(light);
  }
  filter->Update();
  vtkDataArray* seen =
    vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetPointData()->GetScalars();
  std::vector<double> values;
  for (vtkIdType i = 0; seen && i < seen->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < seen->GetNumberOfComponents(); ++c)
    {
      values.push_back(seen->GetComponent(i, c));
    }
  }
  return values;
}

TEST(RadianceRanks, SurfaceAndLightsOfOneRankAndAnyNumberOfThreads)
{
  const vtkNew<vtkLumiShapeLight> panel;
  panel->SetShape(vtkLumiShapeLight::Rectangle);
  panel->SetOrigin(2, -1, 1);
  panel->SetPoint1(2, 1, 1);
  panel->SetPoint2(2, -1, 3);
  panel->SetEmissionQuantity(vtkLumiShapeLight::Radiance);
  panel->SetEmission(50.0);
  panel->SetTwoSided(true);
  panel->Update();
  const auto nothing = vtkSmartPointer<vtkPolyData>::New();
  const auto before = pointLight({ -6, 0, 3 }, 1000.0, "Before the wall");
  for (const int look : { vtkLumiRadiance::AlongRays, vtkLumiRadiance::ByDirection })
  {
    const auto alone = radianceOfFloor(
      nullptr, wall(), { panel->GetOutput(), lampOf(0), before, lampOf(2) }, look, 1);
    const auto together = radianceOfFloor(world, rank() == 1 ? wall() : nothing,
      { rank() == 0 ? panel->GetOutput() : nothing.Get(), rank() == 1 ? before : lampOf(rank()) },
      look, 1 + rank());
    ASSERT_FALSE(alone.empty());
    ASSERT_EQ(alone.size(), together.size());
    EXPECT_EQ(std::memcmp(alone.data(), together.data(), alone.size() * sizeof(double)), 0) << look;
    EXPECT_GT(*std::max_element(alone.begin(), alone.end()), 0.0);
  }
}

} // namespace
} // namespace lumitree::testing

int main(int argc, char** argv)
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  lumitree::testing::world = controller;
  testing::InitGoogleTest(&argc, argv);
  const int failed = RUN_ALL_TESTS();
  controller->Finalize();
  return failed;
}
