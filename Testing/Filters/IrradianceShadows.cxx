// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// What shadows what: blocks of a composite, ghosts, the receiver itself; and when a tree is built.
#include "IrradianceFixtures.h"

#include "LumiCache.h"
#include "vtkLumiDirectionalLight.h"
#include "vtkLumiPointLight.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lumitree::testing
{
namespace
{

constexpr char irradiance[] = "Irradiance [W/m^2]";

/// Checks the shadow of wall() in the light of (3, 0, 4): it ends at x = −1 on the floor.
void expectShadow(vtkDataSet* floor, bool points = false)
{
  ASSERT_TRUE(floor);
  vtkDataArray* e = points ? floor->GetPointData()->GetArray(irradiance)
                           : floor->GetCellData()->GetArray(irradiance);
  ASSERT_TRUE(e);
  for (vtkIdType i = 0; i < e->GetNumberOfTuples(); ++i)
  {
    const double* bounds = points ? nullptr : floor->GetCell(i)->GetBounds();
    const double x = points ? floor->GetPoint(i)[0] : 0.5 * (bounds[0] + bounds[1]);
    if (std::fabs(x + 1.0) > 1e-9)
    {
      ASSERT_EQ(e->GetComponent(i, 0) > 0.0, x < -1.0) << x;
    }
  }
}

std::vector<vtkSmartPointer<vtkPolyData>> lamp()
{
  return { pointLight({ 3, 0, 4 }, 1000.0) };
}

void mark(vtkDataSet* data, vtkIdType cell, int what)
{
  data->AllocateCellGhostArray()->SetValue(cell, static_cast<unsigned char>(what));
}

TEST(IrradianceShadows, OneBlockShadowsAnother)
{
  const vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetNumberOfBlocks(2);
  inner->SetBlock(1, floorStrip(-4, 0.01, 490));
  const vtkNew<vtkMultiBlockDataSet> scene;
  scene->SetNumberOfBlocks(3); // the second is empty
  scene->SetBlock(0, wall());
  scene->SetBlock(2, inner);
  scene->GetMetaData(2u)->Set(vtkCompositeDataSet::NAME(), "inside");
  Irradiance filter(scene, lamp());
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter.run());
  ASSERT_TRUE(output) << filter.text;
  ASSERT_EQ(output->GetNumberOfBlocks(), 3u);
  EXPECT_FALSE(output->GetBlock(1));
  EXPECT_STREQ(output->GetMetaData(2u)->Get(vtkCompositeDataSet::NAME()), "inside");
  auto* lit = vtkMultiBlockDataSet::SafeDownCast(output->GetBlock(2));
  ASSERT_TRUE(lit);
  expectShadow(vtkDataSet::SafeDownCast(lit->GetBlock(1)));
  EXPECT_TRUE(output->GetFieldData()->GetArray("MetresPerUnit"));
  EXPECT_TRUE(lit->GetBlock(1)->GetFieldData()->GetArray("MetresPerUnit"));
  EXPECT_EQ(filter.errors + filter.warnings, 0) << filter.text;

  filter->SetReceiverLocation(vtkLumiIrradiance::Points);
  output = vtkMultiBlockDataSet::SafeDownCast(filter.run());
  lit = vtkMultiBlockDataSet::SafeDownCast(output->GetBlock(2));
  expectShadow(vtkDataSet::SafeDownCast(lit->GetBlock(1)), true);
}

TEST(IrradianceShadows, OnePartitionShadowsAnother)
{
  const vtkNew<vtkPartitionedDataSet> parts;
  parts->SetPartition(0, floorStrip(-4, 0.01, 490));
  parts->SetPartition(1, wall());
  const vtkNew<vtkPartitionedDataSetCollection> scene;
  scene->SetPartitionedDataSet(0, parts);
  Irradiance filter(scene, lamp());
  auto* output = vtkPartitionedDataSetCollection::SafeDownCast(filter.run());
  ASSERT_TRUE(output) << filter.text;
  expectShadow(output->GetPartition(0, 0));
}

TEST(IrradianceShadows, OccludersOfTheirOwn)
{
  Irradiance filter(floorStrip(-4, 0.01, 490), lamp());
  filter->SetOccludersData(wall());
  expectShadow(vtkDataSet::SafeDownCast(filter.run()));
  filter->ShadowsOff();
  vtkDataArray* e = filter.run(irradiance);
  EXPECT_GT(e->GetRange()[0], 0.0);
}

TEST(IrradianceShadows, OccludersThatHoldTheReceiversToo)
{
  auto floor = floorStrip(-4, 0.01, 490);
  const vtkNew<vtkMultiBlockDataSet> scene;
  scene->SetBlock(0, floor);
  scene->SetBlock(1, wall());
  for (const int location : { vtkLumiIrradiance::Points, vtkLumiIrradiance::Cells })
  {
    Irradiance filter(floor, lamp());
    filter->SetOccludersData(scene);
    filter->SetReceiverLocation(location);
    expectShadow(vtkDataSet::SafeDownCast(filter.run()), location == vtkLumiIrradiance::Points);
  }
}

TEST(IrradianceShadows, EveryStructureThatIsThere)
{
  int answered = 0;
  for (int structure = vtkLumiIrradiance::Auto; structure <= vtkLumiIrradiance::Embree; ++structure)
  {
    Irradiance filter(floorStrip(-4, 0.01, 490), lamp());
    filter->SetOccludersData(wall());
    filter->SetStructure(structure);
    auto* output = vtkDataSet::SafeDownCast(filter.run());
    if (filter.errors == 0)
    {
      expectShadow(output);
      ++answered;
    }
    else
    {
      EXPECT_EQ(filter.errors, 1) << filter.text;
      EXPECT_EQ(output->GetNumberOfCells(), 0);
    }
  }
  EXPECT_GE(answered, 3);
}

TEST(IrradianceShadows, HiddenAndDuplicateCellsDoNotOcclude)
{
  for (const int what :
    { int{ vtkDataSetAttributes::HIDDENCELL }, int{ vtkDataSetAttributes::DUPLICATECELL } })
  {
    auto occluder = wall();
    mark(occluder, 0, what);
    Irradiance filter(floorStrip(-4, 0.01, 490), lamp());
    filter->SetOccludersData(occluder);
    vtkDataArray* e = filter.run(irradiance);
    ASSERT_TRUE(e);
    EXPECT_GT(e->GetRange()[0], 0.0);
  }
}

TEST(IrradianceShadows, GhostsAsReceivers)
{
  auto floor = floorStrip(-4, 1, 4);
  mark(floor, 1, vtkDataSetAttributes::HIDDENCELL);
  floor->GetCellData()
    ->GetArray(vtkDataSetAttributes::GhostArrayName())
    ->SetComponent(2, 0, vtkDataSetAttributes::DUPLICATECELL);
  Irradiance filter(floor, lamp());
  vtkDataArray* e = filter.run(irradiance);
  ASSERT_TRUE(e);
  EXPECT_GT(e->GetComponent(0, 0), 0.0);
  EXPECT_TRUE(std::isnan(e->GetComponent(1, 0)));
  EXPECT_GT(e->GetComponent(2, 0), 0.0);
  EXPECT_EQ(filter.warnings, 0) << filter.text;

  floor->AllocatePointGhostArray()->SetValue(9, vtkDataSetAttributes::HIDDENPOINT);
  filter->SetReceiverLocation(vtkLumiIrradiance::Points);
  e = filter.run(irradiance);
  EXPECT_TRUE(std::isnan(e->GetComponent(9, 0)));
  EXPECT_GT(e->GetComponent(2, 0), 0.0); // one of its two cells is hidden
  EXPECT_EQ(filter.warnings, 0) << filter.text;
}

TEST(IrradianceShadows, NothingShadowsItself)
{
  for (const double offset : { 0.0, 1e4, 1e6 })
  {
    const vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(100.0);
    sphere->SetThetaResolution(60);
    sphere->SetPhiResolution(40);
    const vtkNew<vtkTransform> turn; // inside out, and away
    turn->Translate(offset, offset, offset);
    turn->Scale(-1, 1, 1);
    const vtkNew<vtkTransformPolyDataFilter> moved;
    moved->SetInputConnection(sphere->GetOutputPort());
    moved->SetTransform(turn);
    moved->Update();
    auto body = vtkSmartPointer<vtkPolyData>::New();
    body->ShallowCopy(moved->GetOutput());
    body->GetPointData()->SetNormals(nullptr);
    for (const int location : { vtkLumiIrradiance::Points, vtkLumiIrradiance::Cells })
    {
      Irradiance filter(body, { pointLight({ offset + 30, offset - 20, offset + 40 }, 1000.0) });
      filter->SetReceiverLocation(location);
      vtkDataArray* e = filter.run(irradiance);
      ASSERT_TRUE(e) << filter.text;
      EXPECT_GT(e->GetRange()[0], 0.0) << offset;
    }
  }
}

TEST(IrradianceShadows, MovingLightsRebuildsNothing)
{
  const vtkNew<vtkLumiPointLight> light;
  light->SetPosition(3, 0, 4);
  light->SetFlux(1000.0);
  const vtkNew<vtkLumiDirectionalLight> sun;
  sun->SetDirection(-1, 0, -1);
  auto occluder = wall();
  Irradiance filter(floorStrip(-4, 0.01, 490));
  filter->SetOccludersData(occluder);
  filter->AddLightsConnection(light->GetOutputPort());
  filter->AddLightsConnection(sun->GetOutputPort());
  const std::uint64_t before = filters::treeBuilds();
  vtkDataArray* e = filter.run(irradiance);
  ASSERT_TRUE(e) << filter.text;
  const double first = e->GetComponent(0, 0);
  EXPECT_EQ(filters::treeBuilds(), before + 1);
  light->SetPosition(3, 0, 5);
  sun->SetDirection(-1, 0, -2);
  filter->SetLengthUnit(vtkLumiIrradiance::Centimetre);
  filter->PerLightArraysOn();
  EXPECT_NE(filter.run(irradiance)->GetComponent(0, 0), first);
  EXPECT_EQ(filters::treeBuilds(), before + 1);
  occluder->GetPoints()->SetPoint(2, 1, 10, 3);
  occluder->GetPoints()->Modified();
  occluder->Modified();
  filter.run();
  EXPECT_EQ(filters::treeBuilds(), before + 2);
}

TEST(IrradianceShadows, OccludersAreAskedForAsAWhole)
{
  // Structured receivers and occluders of other extents, and only a part of the receivers.
  const vtkNew<vtkImageData> floor;
  floor->SetExtent(-40, 9, 0, 1, 0, 0); // cells along x
  const vtkNew<vtkImageData> block;
  block->SetExtent(10, 11, -10, 10, -1, 20);
  Irradiance filter(floor, { pointLight({ 30, 0.5, 40 }, 1000.0) });
  filter->SetOccludersData(block);
  int part[6] = { -20, 5, 0, 1, 0, 0 };
  filter->UpdateInformation();
  filter->UpdateExtent(part);
  EXPECT_EQ(filter.errors, 0) << filter.text;
  auto* output = vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_TRUE(output);
  vtkDataArray* e = output->GetCellData()->GetArray(irradiance);
  ASSERT_TRUE(e);
  // The edge x = 10, z = 20 of the block throws a shadow up to x = −10.
  for (vtkIdType i = 0; i < e->GetNumberOfTuples(); ++i)
  {
    const double* bounds = output->GetCell(i)->GetBounds();
    if (bounds[0] >= -20.0 && bounds[1] <= 5.0)
    {
      EXPECT_EQ(e->GetComponent(i, 0) > 0.0, bounds[1] <= -10.0) << bounds[0];
    }
  }
}

TEST(IrradianceShadows, PiecesThatCannotShadowEachOtherAreAnError)
{
  const vtkNew<vtkSphereSource> sphere;
  Irradiance filter(nullptr, lamp());
  filter->SetInputConnection(0, sphere->GetOutputPort());
  filter->UpdatePiece(1, 4, 0);
  EXPECT_EQ(filter.errors, 1);
  EXPECT_NE(filter.text.find("port 1"), std::string::npos) << filter.text;
  filter->SetOccludersConnection(sphere->GetOutputPort());
  filter->UpdatePiece(1, 4, 0);
  EXPECT_EQ(filter.errors, 1) << filter.text;
}

TEST(IrradianceShadows, CompositesOfLights)
{
  const vtkNew<vtkMultiBlockDataSet> lights;
  lights->SetBlock(0, pointLight({ 3, 0, 4 }, 1000.0, "A"));
  lights->SetBlock(2, pointLight({ 0, 0, 4 }, 1000.0, "B"));
  lights->SetBlock(3, vtkNew<vtkPolyData>()); // a piece that lives elsewhere
  Irradiance filter(floorStrip(-4, 1, 4), { directionalLight({ 0, 0, -1 }, 10.0, "C") });
  filter->AddLightsData(lights);
  filter->PerLightArraysOn();
  ASSERT_TRUE(filter.run(irradiance)) << filter.text;
  vtkCellData* cells = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetCellData();
  EXPECT_EQ(cells->GetNumberOfArrays(), 4);
  for (const char* name : { "A", "B", "C" })
  {
    EXPECT_TRUE(cells->GetArray((std::string(irradiance) + " " + name).c_str()));
  }
}

} // namespace
} // namespace lumitree::testing
