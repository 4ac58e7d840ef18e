// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Run on three ranks: the rays of every rank meet the surfaces of all of them.
#include "RaysFixtures.h"

#include "vtkLumiAccelerationStructure.h"
#include "vtkLumiImplicitSurface.h"
#include "vtkLumiRayCast.h"
#include "vtkLumiRayDisagreement.h"
#include "vtkLumiStructureComparison.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMPIController.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

using namespace lumitree::testing;

namespace
{

vtkMPIController* world = nullptr;

int rank()
{
  return world->GetLocalProcessId();
}

/// On rank r a large triangle at height r + 1, where the point array X is x.
vtkSmartPointer<vtkPolyData> wall()
{
  const double z = rank() + 1;
  const auto surface = triangles({ { -9, -9, z }, { 9, -9, z }, { 0, 9, z } });
  vtkNew<vtkDoubleArray> x;
  x->SetName("X");
  for (vtkIdType i = 0; i < 3; ++i)
  {
    x->InsertNextValue(surface->GetPoint(i)[0]);
  }
  surface->GetPointData()->AddArray(x);
  return surface;
}

/// On rank r, r + 1 rays upward.
vtkSmartPointer<vtkPolyData> upward()
{
  std::vector<TestRay> rays;
  for (int i = 0; i <= rank(); ++i)
  {
    rays.push_back({ { 0.1 * i, 0.2, 0 }, { 0, 0, 1 } });
  }
  return pointRays(rays);
}

template <class Filter>
void connect(Filter* filter)
{
  filter->SetController(world);
  filter->SetInputData(0, wall());
  filter->SetRaysData(upward());
}

} // namespace

TEST(RaysDistributed, BodiesOfEveryRankAreMet)
{
  // On rank r a ball of radius 0.5 at height r, and one that is never hit; rank 1 has a mesh.
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 2 * rank());
  points->InsertNextPoint(9, 9, 9);
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  vtkNew<vtkLumiImplicitSurface> balls;
  balls->SetInputData(places);
  balls->Update();
  vtkNew<vtkMultiBlockDataSet> scene;
  scene->SetBlock(0, balls->GetOutput());
  if (rank() == 1)
  {
    scene->SetBlock(1, triangles({ { -9, -9, 7 }, { 9, -9, 7 }, { 0, 9, 7 } }));
  }
  vtkNew<vtkLumiRayCast> cast;
  cast->SetController(world);
  cast->SetInputDataObject(0, scene);
  cast->SetRaysData(pointRays({ { { 0, 0, -1 }, { 0, 0, 1 } } }));
  cast->SetQuery(vtkLumiRayCast::All);
  cast->PassSurfaceDataOn();
  cast->Update();
  vtkPointData* hits = vtkPolyData::SafeDownCast(cast->GetOutputDataObject(0))->GetPointData();
  ASSERT_EQ(hits->GetNumberOfTuples(), 7);
  for (vtkIdType h = 0; h < 6; ++h)
  {
    EXPECT_EQ(value(hits, "ProcessId", h), h / 2);
    EXPECT_EQ(value(hits, "CellId", h), 0.0);
    EXPECT_EQ(value(hits, "CompositeIndex", h), 1);
    EXPECT_EQ(value(hits, "T", h), 2 * (h / 2) + 0.5 + h % 2);
  }
  EXPECT_EQ(value(hits, "ProcessId", 6), 1);
  EXPECT_EQ(value(hits, "CompositeIndex", 6), 2);
}

TEST(RaysDistributed, EveryRankMeetsAllSurfaces)
{
  vtkNew<vtkLumiRayCast> cast;
  connect(cast.Get());
  cast->SetQuery(vtkLumiRayCast::All);
  cast->PassSurfaceDataOn();
  cast->Update();
  vtkPointData* hits = vtkPolyData::SafeDownCast(cast->GetOutputDataObject(0))->GetPointData();
  ASSERT_EQ(hits->GetNumberOfTuples(), 3 * (rank() + 1));
  EXPECT_EQ(shape(hits, "ProcessId"), "int 1");
  for (vtkIdType h = 0; h < hits->GetNumberOfTuples(); ++h)
  {
    EXPECT_EQ(value(hits, "ProcessId", h), h % 3);
    EXPECT_EQ(value(hits, "T", h), h % 3 + 1.0);
    EXPECT_EQ(value(hits, "CellId", h), 0);
    EXPECT_EQ(value(hits, "CompositeIndex", h), 0);
    EXPECT_NEAR(value(hits, "X", h), 0.1 * (h / 3), 1e-13);
  }
  EXPECT_EQ(
    vtkDataSet::SafeDownCast(cast->GetOutputDataObject(1))->GetNumberOfPoints(), rank() + 1);
}

TEST(RaysDistributed, ARankMayHaveNothing)
{
  vtkNew<vtkLumiRayCast> cast;
  connect(cast.Get());
  if (rank() == 1)
  {
    cast->SetInputData(0, vtkNew<vtkPolyData>());
    cast->SetRaysData(vtkNew<vtkPolyData>());
  }
  cast->SetQuery(vtkLumiRayCast::Count);
  cast->Update();
  auto* rays = vtkDataSet::SafeDownCast(cast->GetOutputDataObject(1));
  for (vtkIdType r = 0; r < rays->GetNumberOfPoints(); ++r)
  {
    EXPECT_EQ(value(rays->GetPointData(), "HitCount", r), 2);
  }
}

TEST(RaysDistributed, WrongRaysOfOneRankStopNoOther)
{
  vtkNew<vtkLumiRayCast> cast;
  connect(cast.Get());
  Messages messages(cast);
  if (rank() == 2)
  {
    cast->SetRaysData(wall());
  }
  cast->Update();
  EXPECT_EQ(messages.errors, rank() == 2 ? 1 : 0);
  EXPECT_EQ(vtkPolyData::SafeDownCast(cast->GetOutputDataObject(0))->GetNumberOfPoints(),
    rank() == 2 ? 0 : rank() + 1);
}

TEST(RaysDistributed, RankZeroShowsTheStructureForAll)
{
  vtkNew<vtkLumiAccelerationStructure> structure;
  connect(structure.Get());
  structure->SetStructure(vtkLumiAccelerationStructure::Bvh);
  structure->SetLeafSize(1);
  structure->SetQuery(vtkLumiRayCast::Count);
  structure->Update();
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(structure->GetOutputDataObject(0));
  auto* table = vtkTable::SafeDownCast(structure->GetOutputDataObject(1));
  EXPECT_EQ(blocks->GetNumberOfBlocks(), 3u); // three leaves
  EXPECT_TRUE(table->GetColumnByName("Rays")); // on every rank
  EXPECT_EQ(table->GetNumberOfRows(), rank() == 0 ? 1 : 0);
  auto* root = vtkPolyData::SafeDownCast(blocks->GetBlock(0));
  EXPECT_EQ(root->GetNumberOfCells(), rank() == 0 ? 12 : 0);
  EXPECT_EQ(shape(root->GetCellData(), "Visits"), "id 1");
  if (rank() == 0)
  {
    EXPECT_EQ(value(root->GetCellData(), "Visits", 0), 1 + 2 + 3);
    EXPECT_EQ(value(table->GetRowData(), "Rays", 0), 1 + 2 + 3);
    EXPECT_EQ(value(table->GetRowData(), "RayPrimitivesTested", 0), 3 * (1 + 2 + 3));
  }
}

TEST(RaysDistributed, AWrongRankLeavesNoHalfStructure)
{
  vtkNew<vtkLumiAccelerationStructure> structure;
  connect(structure.Get());
  Messages messages(structure);
  if (rank() == 1)
  {
    structure->SetRaysData(wall());
  }
  structure->Update();
  EXPECT_EQ(messages.errors, rank() == 1 ? 1 : 0);
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(structure->GetOutputDataObject(0));
  EXPECT_EQ(blocks->GetNumberOfBlocks(), 0u);
}

TEST(RaysDistributed, CellsTellWhatTheRaysOfAllRanksCost)
{
  vtkNew<vtkLumiRayCast> cast;
  connect(cast.Get());
  cast->SetStructure(vtkLumiRayCast::BruteForce);
  cast->CountTraversalOn();
  Messages messages(cast);
  cast->Update();
  vtkCellData* cells = vtkDataSet::SafeDownCast(cast->GetOutputDataObject(2))->GetCellData();
  ASSERT_EQ(cells->GetNumberOfTuples(), 1); // this rank's triangle
  EXPECT_EQ(value(cells, "RayTests", 0), 1 + 2 + 3);
  EXPECT_EQ(value(cells, "RayHits", 0), rank() == 0 ? 1 + 2 + 3 : 0); // the others are behind
  EXPECT_EQ(value(cells, "LeafReferences", 0), 1);
  if (rank() == 1)
  {
    cast->SetRaysData(wall()); // wrong rays of one rank keep no other waiting
  }
  cast->Modified();
  cast->Update();
  EXPECT_EQ(messages.errors, rank() == 1 ? 1 : 0);
}

TEST(RaysDistributed, ComparisonsCountTheRaysOfAllRanks)
{
  vtkNew<vtkLumiStructureComparison> comparison;
  connect(comparison.Get());
  comparison->SetRepetitions(1);
  comparison->CountDisagreementsOn();
  comparison->SetPrecision(vtkLumiStructureComparison::Exact);
  comparison->Update();
  auto* table = vtkTable::SafeDownCast(comparison->GetOutputDataObject(0));
  EXPECT_TRUE(table->GetColumnByName("Rays")); // on every rank
  EXPECT_EQ(table->GetNumberOfRows() > 1, rank() == 0);
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    EXPECT_EQ(value(table->GetRowData(), "Rays", row), 1 + 2 + 3);
    EXPECT_EQ(value(table->GetRowData(), "HitRays", row), 1 + 2 + 3);
    EXPECT_EQ(value(table->GetRowData(), "Disagreements", row), 0);
  }

  vtkNew<vtkLumiRayDisagreement> disagreement;
  connect(disagreement.Get());
  disagreement->Update();
  auto* counts = vtkTable::SafeDownCast(disagreement->GetOutputDataObject(1));
  EXPECT_EQ(counts->GetNumberOfRows(), rank() == 0 ? 1 : 0);
  if (rank() == 0)
  {
    EXPECT_EQ(value(counts->GetRowData(), "Agree", 0), 1 + 2 + 3);
  }
}

int main(int argc, char** argv)
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  world = controller;
  ::testing::InitGoogleTest(&argc, argv);
  const int failed = RUN_ALL_TESTS();
  controller->Finalize();
  return failed;
}
