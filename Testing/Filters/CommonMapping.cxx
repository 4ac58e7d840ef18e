// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From primitives back to the cells and points of any dataset and of composites; ghosts; kinds of
// points.
#include "CommonFixtures.h"

#include "vtkCellArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPoints.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkTable.h"
#include "vtkTree.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <set>

using namespace lumitree;
using namespace lumitree::filters;

TEST(Mapping, PrimitivesOfCellsAndAroundPoints)
{
  const auto input = surfaceOf(squares(3));
  EXPECT_EQ(input->primitivesOfCell(0, 4), (std::vector<PrimitiveId>{ 8, 9 }));
  EXPECT_TRUE(input->primitivesOfCell(0, 9).empty());
  EXPECT_TRUE(input->primitivesOfCell(0, -1).empty());
  // A point inside belongs to four cells, with all their triangles; a corner to one.
  EXPECT_EQ(
    input->primitivesAroundPoint(0, 5), (std::vector<PrimitiveId>{ 0, 1, 2, 3, 6, 7, 8, 9 }));
  EXPECT_EQ(input->primitivesAroundPoint(0, 0), (std::vector<PrimitiveId>{ 0, 1 }));
  EXPECT_TRUE(input->primitivesAroundPoint(0, 16).empty());
  EXPECT_TRUE(input->primitivesAroundPoint(0, -1).empty());
}

TEST(Mapping, PointsInsideAVolumeHaveNoPrimitives)
{
  const auto input = surfaceOf(voxels(2, 2, 2));
  EXPECT_TRUE(input->primitivesAroundPoint(0, 13).empty());
  EXPECT_EQ(input->primitivesAroundPoint(0, 0).size(), 6u);
}

TEST(Mapping, MultiBlockHasFlatIndices)
{
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, squares(1, 1.0));
  inner->SetBlock(1, nullptr);
  inner->SetBlock(2, squares(2, 2.0, VTK_FLOAT));
  vtkNew<vtkMultiBlockDataSet> outer;
  outer->SetBlock(0, squares(1, 0.0));
  outer->SetBlock(1, inner);
  vtkNew<vtkTable> table;
  outer->SetBlock(2, table);
  vtkNew<vtkPolyData> nothing;
  outer->SetBlock(3, nothing);
  const auto input = surfaceOf(outer);
  ASSERT_EQ(input->leaves.size(), 4u) << "tables have no geometry, empty blocks count";
  const std::int64_t flat[] = { 1, 3, 5, 7 };
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_EQ(input->leaves[i].compositeIndex, flat[i]);
    EXPECT_EQ(input->findLeaf(flat[i]), i);
  }
  EXPECT_FALSE(input->findLeaf(4));
  ASSERT_EQ(input->surface->size(), 2u + 2 + 8);
  EXPECT_EQ(input->surface->source(1).composite, 1);
  EXPECT_EQ(input->surface->source(2).composite, 3);
  EXPECT_EQ(input->surface->source(2).cell, 0) << "ids are local to the leaf";
  EXPECT_EQ(input->surface->source(11).composite, 5);
  EXPECT_EQ(input->surface->source(11).cell, 3);
  EXPECT_EQ(input->surface->scalar(), ArrayView::Scalar::Double) << "float and double mixed";
  EXPECT_EQ(input->leafOf(1), 0u);
  EXPECT_EQ(input->leafOf(11), 2u);
  expectMapsBack(*input);
  EXPECT_EQ(input->primitivesOfCell(2, 1), (std::vector<PrimitiveId>{ 6, 7 }));
  EXPECT_EQ(input->primitivesAroundPoint(2, 0), (std::vector<PrimitiveId>{ 4, 5 }));
  EXPECT_TRUE(input->primitivesOfCell(3, 0).empty());
  EXPECT_TRUE(input->primitivesAroundPoint(3, 0).empty());
}

TEST(Mapping, PartitionedCollection)
{
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartition(0, 0, squares(1, 0.0, VTK_FLOAT));
  collection->SetPartition(0, 1, voxels(1, 1, 1));
  collection->SetPartition(1, 0, squares(1, 5.0, VTK_FLOAT));
  const auto input = surfaceOf(collection);
  ASSERT_EQ(input->leaves.size(), 3u);
  EXPECT_EQ(input->surface->size(), 2u + 12 + 2);
  expectMapsBack(*input);
  std::set<std::int64_t> different;
  for (const SurfaceLeaf& leaf : input->leaves)
  {
    EXPECT_EQ(leaf.data->GetNumberOfCells() > 0, true);
    different.insert(leaf.compositeIndex);
  }
  EXPECT_EQ(different.size(), 3u);
}

TEST(Mapping, WhatHasNoSurfaceIsOneError)
{
  vtkNew<vtkTree> tree;
  vtkNew<vtkTable> table;
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, squares(1));
  blocks->SetBlock(1, tree);
  for (vtkDataObject* data : { static_cast<vtkDataObject*>(tree),
         static_cast<vtkDataObject*>(table), static_cast<vtkDataObject*>(blocks) })
  {
    Reporter reporter;
    EXPECT_FALSE(surfaceFor(data, nullptr, reporter.algorithm()));
    EXPECT_EQ(reporter.errors, 1);
    const std::string name = data == table ? "vtkTable" : "vtkTree";
    EXPECT_NE(reporter.text.find(name), std::string::npos) << reporter.text;
  }
}

TEST(Mapping, EmptyInputsAreEmptySurfaces)
{
  vtkNew<vtkPolyData> polydata;
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkImageData> image;
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (vtkDataObject* data : { static_cast<vtkDataObject*>(polydata),
         static_cast<vtkDataObject*>(grid), static_cast<vtkDataObject*>(image),
         static_cast<vtkDataObject*>(blocks), static_cast<vtkDataObject*>(nullptr) })
  {
    SCOPED_TRACE(data ? data->GetClassName() : "null");
    const auto input = surfaceOf(data);
    EXPECT_EQ(input->surface->size(), 0u);
    Reporter reporter;
    const auto tree = treeFor(data, {}, nullptr, reporter.algorithm());
    EXPECT_TRUE(tree);
    EXPECT_EQ(reporter.errors, 0) << reporter.text;
  }
}

TEST(Mapping, GhostsDoNotOcclude)
{
  const auto data = squares(2);
  setGhosts(data,
    { 0, vtkDataSetAttributes::HIDDENCELL, vtkDataSetAttributes::DUPLICATECELL,
      vtkDataSetAttributes::HIGHCONNECTIVITYCELL });
  const auto input = surfaceOf(data);
  EXPECT_EQ(cellsOf(*input), (std::vector<std::int64_t>{ 0, 0, 3, 3 }));
  EXPECT_EQ(input->hiddenCells, 1u);
  EXPECT_EQ(input->duplicateCells, 1u);
}

TEST(Mapping, PointsKeepTheirTypeAndMemory)
{
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    const auto data = squares(1, 0.0, type);
    const auto input = surfaceOf(data);
    EXPECT_EQ(input->surface->scalar(),
      type == VTK_FLOAT ? ArrayView::Scalar::Float : ArrayView::Scalar::Double);
    // Nothing is copied: a change of the array shows (which a user has to announce by Modified).
    data->GetPoints()->SetPoint(0, 7.0, 8.0, 9.0);
    EXPECT_EQ(input->surface->point(0), (Vec3{ 7.0, 8.0, 9.0 }));
  }
}

TEST(Mapping, SharedMemoryOutlivesTheDataset)
{
  auto data = squares(1);
  const auto surface = surfaceOf(data)->surface;
  data = nullptr;
  EXPECT_EQ(surface->point(3), (Vec3{ 1.0, 1.0, 0.0 }));
}

TEST(Mapping, OtherPointArraysAreCopied)
{
  vtkNew<vtkSOADataArrayTemplate<float>> soa;
  soa->SetNumberOfComponents(3);
  vtkNew<vtkIntArray> integers;
  integers->SetNumberOfComponents(3);
  const double xyz[3][3] = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 3, 0 } };
  for (const auto& p : xyz)
  {
    soa->InsertNextTuple(p);
    integers->InsertNextTuple(p);
  }
  for (vtkDataArray* array :
    { static_cast<vtkDataArray*>(soa), static_cast<vtkDataArray*>(integers) })
  {
    const auto data = polygons({ { 0, 0, 0 }, { 2, 0, 0 }, { 0, 3, 0 } }, { { 0, 1, 2 } });
    vtkNew<vtkPoints> points;
    points->SetData(array);
    data->SetPoints(points);
    const auto input = surfaceOf(data);
    EXPECT_EQ(input->surface->scalar(),
      array == soa ? ArrayView::Scalar::Float : ArrayView::Scalar::Double);
    EXPECT_EQ(input->surface->point(2), (Vec3{ 0, 3, 0 }));
  }
}

TEST(Mapping, SmallOffsetsAreRead)
{
  const auto data = squares(2);
  data->GetPolys()->ConvertTo32BitStorage();
  EXPECT_EQ(surfaceOf(data)->surface->size(), 8u);
}

TEST(Mapping, ManyCellsAreTheSameForAnyNumberOfThreads)
{
  const auto data = squares(150); // several chunks
  const auto input = surfaceOf(data);
  ASSERT_EQ(input->surface->size(), 2u * 150 * 150);
  for (PrimitiveId i = 0; i < input->surface->size(); ++i)
  {
    ASSERT_EQ(input->surface->source(i).cell, i / 2);
  }
}
