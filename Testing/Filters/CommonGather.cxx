// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Run on three ranks: every rank gets the surface of all of them, the same one, and only when one
// changed.
#include "CommonFixtures.h"

#include "LumiGather.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMPIController.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTree.h"

#include <gtest/gtest.h>

using namespace lumitree;
using namespace lumitree::filters;

namespace
{

vtkMPIController* world = nullptr;

int rank()
{
  return world->GetLocalProcessId();
}

std::shared_ptr<const Tree> treeOf(vtkDataObject* data, GatherArrays arrays = GatherArrays::Yes)
{
  Reporter reporter;
  auto tree = treeFor(data, {}, world, reporter.algorithm(), arrays);
  EXPECT_EQ(reporter.errors, 0) << reporter.text;
  EXPECT_TRUE(tree);
  return tree;
}

/// rank r has r + 1 squares by r + 1 at the height r, with the cell array Height and the point
/// array X.
vtkSmartPointer<vtkPolyData> piece()
{
  const auto data = squares(rank() + 1, rank());
  vtkNew<vtkDoubleArray> height;
  height->SetName("Height");
  vtkNew<vtkDoubleArray> x;
  x->SetName("X");
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    height->InsertNextValue(rank());
  }
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    x->InsertNextValue(data->GetPoint(i)[0]);
  }
  data->GetCellData()->AddArray(height);
  data->GetPointData()->AddArray(x);
  return data;
}

} // namespace

TEST(Gather, EveryRankHasTheWholeSurface)
{
  const auto tree = treeOf(piece());
  const SurfaceInput& input = *tree->input;
  ASSERT_EQ(input.leaves.size(), 3u);
  ASSERT_EQ(input.surface->size(), 2u * (1 + 4 + 9));
  EXPECT_EQ(input.firstPrimitive, (std::vector<PrimitiveId>{ 0, 2, 10 }));
  for (PrimitiveId i = 0; i < input.surface->size(); ++i)
  {
    const std::size_t leaf = input.leafOf(i);
    EXPECT_EQ(input.leaves[leaf].process, static_cast<int>(leaf));
    EXPECT_EQ(input.surface->source(i).cell, (i - input.firstPrimitive[leaf]) / 2);
    EXPECT_EQ(input.surface->vertices(i)[0][2], static_cast<double>(leaf));
    vtkDataSet* data = input.leaves[leaf].data;
    EXPECT_EQ(data->GetCellData()->GetArray("Height")->GetComponent(input.leafCellId(i), 0),
      static_cast<double>(leaf));
    for (std::size_t k = 0; k < 3; ++k)
    {
      EXPECT_EQ(data->GetPointData()->GetArray("X")->GetComponent(input.leafPointIds(i)[k], 0),
        input.surface->vertices(i)[k][0]);
    }
  }
  EXPECT_EQ(input.findLeaf(0, 2), 2u);
  EXPECT_EQ(input.primitivesOfCell(2, 8), (std::vector<PrimitiveId>{ 26, 27 }));
  EXPECT_EQ(input.primitivesAroundPoint(1, 0), (std::vector<PrimitiveId>{ 2, 3 }));
}

TEST(Gather, OnlyWhenARankChanged)
{
  const auto data = piece();
  const std::uint64_t before = treeBuilds();
  const auto first = treeOf(data, GatherArrays::No);
  EXPECT_EQ(first->input->leaves[0].data->GetCellData()->GetNumberOfArrays(), 0);
  const auto second = treeOf(data, GatherArrays::No);
  EXPECT_EQ(first->accelerator, second->accelerator);
  EXPECT_EQ(treeBuilds(), before + 1);
  if (rank() == 1)
  {
    data->GetPoints()->SetPoint(0, 0.0, 0.0, 7.0);
    data->GetPoints()->Modified();
  }
  const auto third = treeOf(data, GatherArrays::No);
  EXPECT_EQ(treeBuilds(), before + 2) << "on ranks that did not change as well";
  EXPECT_EQ(third->input->surface->bounds().upper[2], 7.0);
}

TEST(Gather, SameLocalGeometryInTwoSurfaces)
{
  // Rank 0 brings the same mesh to both; what it remembers of the one must not answer for the
  // other.
  const auto data = piece();
  vtkNew<vtkPolyData> raised;
  raised->DeepCopy(data);
  raised->GetPoints()->SetPoint(0, 0.0, 0.0, 9.0);
  vtkPolyData* other = rank() == 0 ? data.Get() : raised.Get();
  const auto low = treeOf(data, GatherArrays::No);
  const auto high = treeOf(other, GatherArrays::No);
  const auto again = treeOf(data, GatherArrays::No);
  EXPECT_EQ(low->input->surface->bounds().upper[2], 2.0);
  EXPECT_EQ(high->input->surface->bounds().upper[2], 9.0);
  EXPECT_EQ(again->input->surface->bounds().upper[2], 2.0);
}

TEST(Gather, ChangedArraysAreSentAgain)
{
  const auto data = piece();
  const auto first = treeOf(data);
  if (rank() == 2)
  {
    data->GetCellData()->GetArray("Height")->SetComponent(0, 0, 42.0);
    data->GetCellData()->GetArray("Height")->Modified();
  }
  const auto second = treeOf(data);
  EXPECT_EQ(
    second->input->leaves[2].data->GetCellData()->GetArray("Height")->GetComponent(0, 0), 42.0);
}

TEST(Gather, RanksWithoutInputTakePart)
{
  const auto data = piece();
  const auto fromOne = treeOf(rank() == 1 ? data.Get() : nullptr);
  EXPECT_EQ(fromOne->input->surface->size(), 8u);
  EXPECT_EQ(fromOne->input->leaves.size(), 1u);
  EXPECT_EQ(fromOne->input->leaves[0].process, 1);
  vtkNew<vtkPolyData> empty;
  const auto fromNone = treeOf(empty);
  EXPECT_EQ(fromNone->input->surface->size(), 0u);
}

TEST(Gather, BadInputOfOneRankIsAnErrorOnAll)
{
  const auto data = piece();
  vtkNew<vtkTree> bad;
  Reporter reporter;
  const auto tree =
    treeFor(rank() == 2 ? static_cast<vtkDataObject*>(bad) : data, {}, world, reporter.algorithm());
  EXPECT_FALSE(tree);
  EXPECT_EQ(reporter.errors, 1);
  const auto broken = polygons({ { 0, 0, 0 } }, { { 0, 1, 2 } });
  EXPECT_FALSE(treeFor(rank() == 0 ? broken : data, {}, world, reporter.algorithm()));
  EXPECT_EQ(reporter.errors, 2);
}

TEST(Gather, GhostsStayAtHomeAndBlocksKeepTheirIndex)
{
  // Two voxels a rank, the second of them the neighbour's.
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 2, 2);
  image->SetOrigin(rank(), 0.0, 0.0);
  if (rank() < 2)
  {
    setGhosts(image, { 0, vtkDataSetAttributes::DUPLICATECELL });
  }
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetNumberOfBlocks(2);
  blocks->SetBlock(1, image);
  const auto tree = treeOf(blocks);
  EXPECT_EQ(tree->input->duplicateCells, 2u);
  double area = 0.0;
  for (PrimitiveId i = 0; i < tree->input->surface->size(); ++i)
  {
    area += 0.5 * length(areaVector(*tree->input->surface, i));
    EXPECT_EQ(tree->input->surface->source(i).composite, 2);
  }
  // A bar of four voxels, closed, and a wall where ranks 1 and 2 do not know of their left
  // neighbour.
  EXPECT_DOUBLE_EQ(area, 18.0 + 2.0);
}

TEST(Gather, ObjectsOfAllRanks)
{
  std::vector<vtkSmartPointer<vtkDataObject>> mine;
  for (int i = 0; i < rank(); ++i)
  {
    mine.push_back(squares(i + 1));
  }
  vtkNew<vtkPolyData> prototype;
  const auto all = gatherObjects(world, mine, prototype);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].process, 1);
  EXPECT_EQ(all[2].process, 2);
  EXPECT_EQ(vtkPolyData::SafeDownCast(all[2].object)->GetNumberOfCells(), 4);
}

int main(int argc, char** argv)
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  world = controller;
  testing::InitGoogleTest(&argc, argv);
  const int failed = RUN_ALL_TESTS();
  controller->Finalize();
  return failed;
}
