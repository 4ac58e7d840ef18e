// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Wrong input is one error and an empty output; poor input is one warning.
#include "IrradianceFixtures.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace lumitree::testing
{
namespace
{

constexpr char irradiance[] = "Irradiance [W/m^2]";
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void expectError(Irradiance& filter, const std::string& about)
{
  auto* output = vtkPolyData::SafeDownCast(filter.run());
  EXPECT_EQ(filter.errors, 1) << filter.text;
  EXPECT_NE(filter.text.find(about), std::string::npos) << filter.text;
  ASSERT_TRUE(output);
  EXPECT_EQ(output->GetNumberOfPoints(), 0);
  EXPECT_EQ(output->GetNumberOfCells(), 0);
}

void expectError(vtkSmartPointer<vtkPolyData> light, const std::string& about)
{
  Irradiance filter(floorStrip(0, 1, 3), { pointLight({ 0, 0, 2 }, 1.0), light });
  expectError(filter, about);
  EXPECT_NE(filter.text.find("Light 2"), std::string::npos) << filter.text;
}

TEST(IrradianceInputs, NoLights)
{
  Irradiance filter(floorStrip(0, 1, 3));
  filter->AddLightsData(vtkNew<vtkMultiBlockDataSet>());
  expectError(filter, "no lights");
}

TEST(IrradianceInputs, NothingConnectedAsLights)
{
  Irradiance filter(floorStrip(0, 1, 3));
  expectError(filter, "no lights");
}

TEST(IrradianceInputs, LightsThatAreNone)
{
  const vtkNew<vtkMultiBlockDataSet> lights;
  lights->SetBlock(0, vtkNew<vtkImageData>());
  Irradiance filter(floorStrip(0, 1, 3));
  filter->AddLightsData(lights);
  expectError(filter, "vtkImageData");
  expectError(floorStrip(0, 1, 1), "LightSchema");
}

TEST(IrradianceInputs, UnknownLightsAreNamed)
{
  auto light = pointLight({ 0, 0, 2 }, 1.0, "Torch");
  setText(light, "LightType", "laser");
  expectError(light, "\"laser\"");
  expectError(light, "\"Torch\"");
  light = pointLight({ 0, 0, 2 }, 1.0);
  setField(light, "LightSchema", { 2.0 });
  expectError(light, "version 2");
  light = pointLight({ 0, 0, 2 }, 1.0);
  setField(light, "LightSystem", { 3.0 });
  expectError(light, "LightSystem");
}

TEST(IrradianceInputs, MissingFields)
{
  for (const char* field :
    { "LightSchema", "LightType", "LightName", "LightSystem", "RadiantFlux [W]" })
  {
    auto light = pointLight({ 0, 0, 2 }, 1.0);
    light->GetFieldData()->RemoveArray(field);
    expectError(light, field);
  }
  for (const char* field : { "LightDirection", "NormalIrradiance [W/m^2]" })
  {
    auto light = directionalLight({ 0, 0, -1 }, 1.0);
    light->GetFieldData()->RemoveArray(field);
    expectError(light, field);
  }
  auto light = directionalLight({ 0, 0, -1 }, 1.0);
  setField(light, "LightDirection", { 0.0, 1.0 });
  expectError(light, "LightDirection");
}

TEST(IrradianceInputs, ImpossibleValues)
{
  expectError(pointLight({ 0, 0, 2 }, -1.0), "-1");
  expectError(pointLight({ 0, 0, 2 }, nan), "RadiantFlux [W]");
  expectError(pointLight({ 0, nan, 2 }, 1.0), "position");
  expectError(directionalLight({ 0, 0, 0 }, 1.0), "LightDirection");
  expectError(directionalLight({ 0, 0, nan }, 1.0), "LightDirection");
  expectError(directionalLight({ 0, 0, -1 }, -2.0), "NormalIrradiance [W/m^2]");
  auto light = pointLight({ 0, 0, 2 }, 1.0);
  light->GetPoints()->InsertNextPoint(1, 1, 1);
  expectError(light, "one point");
}

TEST(IrradianceInputs, WattsAndLumensAreNotAdded)
{
  expectError(pointLight({ 0, 0, 2 }, 1.0, "Lumens", true), "photometric");
}

TEST(IrradianceInputs, NoReceivers)
{
  for (const int location : { vtkLumiIrradiance::Points, vtkLumiIrradiance::Cells })
  {
    Irradiance filter(vtkNew<vtkUnstructuredGrid>(), { pointLight({ 0, 0, 2 }, 1.0) });
    filter->SetReceiverLocation(location);
    vtkDataArray* e = filter.run(irradiance);
    ASSERT_TRUE(e) << filter.text;
    EXPECT_EQ(e->GetNumberOfTuples(), 0);
    EXPECT_EQ(filter.errors + filter.warnings, 0) << filter.text;
  }
}

TEST(IrradianceInputs, ReceiversWithoutAValueAreCountedOnce)
{
  // A square, one with a NaN corner, one without area, and a point that no cell uses.
  Irradiance filter(polygons({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { nan, 0, 0 },
                               { 2, 0, 0 }, { 3, 0, 0 }, { 9, 9, 9 } },
                      { { 0, 1, 2, 3 }, { 0, 4, 2 }, { 1, 5, 6 } }),
    { directionalLight({ 0, 0, -1 }, 10.0) });
  vtkDataArray* e = filter.run(irradiance);
  ASSERT_TRUE(e) << filter.text;
  EXPECT_EQ(e->GetComponent(0, 0), 10.0);
  EXPECT_TRUE(std::isnan(e->GetComponent(1, 0)));
  EXPECT_TRUE(std::isnan(e->GetComponent(2, 0)));
  EXPECT_EQ(filter.warnings, 1);
  EXPECT_NE(filter.text.find("2 of 3"), std::string::npos) << filter.text;

  filter->SetReceiverLocation(vtkLumiIrradiance::Points);
  e = filter.run(irradiance);
  EXPECT_EQ(e->GetComponent(3, 0), 10.0);
  EXPECT_TRUE(std::isnan(e->GetComponent(7, 0)));
  EXPECT_EQ(filter.warnings, 2);
  EXPECT_EQ(filter.errors, 0);
}

TEST(IrradianceInputs, AReceiverAtTheLight)
{
  Irradiance filter(floorStrip(-0.5, 1, 3), { pointLight({ 1, 0, 0 }, 1.0) });
  vtkDataArray* e = filter.run(irradiance);
  ASSERT_TRUE(e);
  EXPECT_EQ(e->GetComponent(0, 0), 0.0);
  EXPECT_TRUE(std::isnan(e->GetComponent(1, 0)));
  EXPECT_EQ(filter.warnings, 1);
}

TEST(IrradianceInputs, ArraysOfTheInputAreKeptAndReplaced)
{
  auto floor = floorStrip(0, 1, 3);
  Irradiance first(floor, { directionalLight({ 0, 0, -1 }, 10.0) });
  vtkDataObject* once = first.run();
  Irradiance second(once, { directionalLight({ 0, 0, -1 }, 20.0) });
  second->PerLightArraysOn();
  vtkDataArray* e = second.run(irradiance);
  ASSERT_TRUE(e);
  EXPECT_EQ(e->GetComponent(0, 0), 20.0);
  EXPECT_EQ(
    vtkDataSet::SafeDownCast(once)->GetCellData()->GetArray(irradiance)->GetComponent(0, 0), 10.0);
}

TEST(IrradianceInputs, PrintsItself)
{
  std::ostringstream out;
  Irradiance filter(floorStrip(0, 1, 3));
  filter->Print(out);
  for (const char* property : { "ReceiverLocation", "Shadows", "PerLightArrays", "LengthUnit",
         "Structure", "Precision", "NumberOfThreads", "Controller" })
  {
    EXPECT_NE(out.str().find(property), std::string::npos) << property;
  }
}

} // namespace
} // namespace lumitree::testing
