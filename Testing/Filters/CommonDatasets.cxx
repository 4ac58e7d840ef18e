// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Datasets that are no polygons: their outer surface, by cell, without what is hidden.
#include "CommonFixtures.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkExplicitStructuredGrid.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkNonOverlappingAMR.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUniformGrid.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace lumitree;
using namespace lumitree::filters;

namespace
{

vtkSmartPointer<vtkPoints> pointsIn(vtkDataSet* data)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint(data->GetPoint(i));
  }
  return points;
}

} // namespace

TEST(Datasets, ImageGivesItsOuterFacesByCell)
{
  const auto input = surfaceOf(voxels(3, 2, 2));
  const auto cells = cellsOf(*input);
  EXPECT_TRUE(std::is_sorted(cells.begin(), cells.end()));
  EXPECT_EQ(input->surface->size(), 2u * 2 * (3 * 2 + 3 * 2 + 2 * 2));
  EXPECT_DOUBLE_EQ(surfaceArea(*input), 2.0 * (3 * 2 + 3 * 2 + 2 * 2));
  expectMapsBack(*input);
  EXPECT_EQ(input->primitivesOfCell(0, 0).size(), 6u) << "a corner voxel shows three faces";
}

TEST(Datasets, UnstructuredGridOfManyKinds)
{
  vtkNew<vtkUnstructuredGrid> grid;
  const auto image = voxels(2, 2, 2);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint(image->GetPoint(i));
  }
  grid->SetPoints(points);
  const vtkIdType vertex[] = { 4 };
  const vtkIdType hexahedron[] = { 0, 1, 4, 3, 9, 10, 13, 12 };
  const vtkIdType tetra[] = { 9, 10, 12, 18 }; // on top of the hexahedron
  const vtkIdType quad[] = { 4, 5, 8, 7 };
  const vtkIdType triangle[] = { 13, 14, 17 };
  grid->InsertNextCell(VTK_VERTEX, 1, vertex);
  grid->InsertNextCell(VTK_QUAD, 4, quad);
  grid->InsertNextCell(VTK_HEXAHEDRON, 8, hexahedron);
  grid->InsertNextCell(VTK_TETRA, 4, tetra);
  grid->InsertNextCell(VTK_TRIANGLE, 3, triangle);
  const auto input = surfaceOf(grid);
  std::map<std::int64_t, int> count;
  for (const std::int64_t cell : cellsOf(*input))
  {
    ++count[cell];
  }
  EXPECT_EQ(count, (std::map<std::int64_t, int>{ { 1, 2 }, { 2, 12 }, { 3, 4 }, { 4, 1 } }));
  EXPECT_EQ(input->passedOver, 1u);
  const auto cells = cellsOf(*input);
  EXPECT_TRUE(std::is_sorted(cells.begin(), cells.end()));
  expectMapsBack(*input);
}

TEST(Datasets, WhatAHiddenCellCoveredShows)
{
  // A row of three voxels without its middle: two cubes. Without the last, a duplicate: a box open
  // at the side where the other rank goes on.
  const auto image = voxels(3, 1, 1);
  setGhosts(image, { 0, vtkDataSetAttributes::HIDDENCELL, 0 });
  const auto hidden = surfaceOf(image);
  EXPECT_DOUBLE_EQ(surfaceArea(*hidden), 12.0);
  EXPECT_EQ(hidden->hiddenCells, 1u);
  expectMapsBack(*hidden);

  const auto duplicated = voxels(3, 1, 1);
  setGhosts(duplicated, { 0, 0, vtkDataSetAttributes::DUPLICATECELL });
  const auto open = surfaceOf(duplicated);
  EXPECT_DOUBLE_EQ(surfaceArea(*open), 9.0);
  EXPECT_EQ(open->duplicateCells, 1u);
  expectMapsBack(*open);
}

TEST(Datasets, BlankedStructuredGridAndHiddenPoints)
{
  vtkNew<vtkStructuredGrid> grid;
  grid->SetDimensions(4, 2, 2);
  vtkNew<vtkPoints> points;
  const auto image = voxels(3, 1, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint(image->GetPoint(i));
  }
  grid->SetPoints(points);
  grid->BlankCell(0);
  const auto blankCell = surfaceOf(grid);
  EXPECT_DOUBLE_EQ(surfaceArea(*blankCell), 10.0);
  expectMapsBack(*blankCell);

  grid->BlankPoint(3); // a corner of cell 2
  grid->GetPointData()->Modified();
  const auto blankPoint = surfaceOf(grid);
  EXPECT_DOUBLE_EQ(surfaceArea(*blankPoint), 6.0);
  EXPECT_EQ(blankPoint->hiddenCells, 2u);
}

TEST(Datasets, RectilinearGrid)
{
  vtkNew<vtkRectilinearGrid> grid;
  vtkNew<vtkDoubleArray> x;
  vtkNew<vtkDoubleArray> y;
  for (const double value : { 0.0, 1.0, 4.0 })
  {
    x->InsertNextValue(value);
  }
  y->InsertNextValue(0.0);
  y->InsertNextValue(2.0);
  grid->SetDimensions(3, 2, 2);
  grid->SetXCoordinates(x);
  grid->SetYCoordinates(y);
  grid->SetZCoordinates(y);
  const auto input = surfaceOf(grid);
  EXPECT_DOUBLE_EQ(surfaceArea(*input), 2 * 4.0 + 4 * 8.0);
  expectMapsBack(*input);
}

TEST(Datasets, ExplicitStructuredGrid)
{
  vtkNew<vtkExplicitStructuredGrid> grid;
  const auto image = voxels(2, 1, 1);
  grid->SetDimensions(3, 2, 2);
  grid->SetPoints(pointsIn(image));
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 4, 3, 6, 7, 10, 9 });
  cells->InsertNextCell({ 1, 2, 5, 4, 7, 8, 11, 10 });
  grid->SetCells(cells);
  grid->ComputeFacesConnectivityFlagsArray();
  const auto input = surfaceOf(grid);
  EXPECT_DOUBLE_EQ(surfaceArea(*input), 10.0);
  expectMapsBack(*input);
  const auto found = cellsOf(*input);
  EXPECT_EQ(std::count(found.begin(), found.end(), 1), 10);
}

TEST(Datasets, Polyhedron)
{
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(pointsIn(voxels(1, 1, 1)));
  const vtkIdType points[] = { 0, 1, 2, 3, 4, 5, 6, 7 };
  const vtkIdType faces[] = { 4, 0, 2, 3, 1, 4, 4, 5, 7, 6, 4, 0, 1, 5, 4, 4, 2, 6, 7, 3, 4, 0, 4,
    6, 2, 4, 1, 3, 7, 5 };
  const vtkIdType vertex[] = { 0 };
  grid->InsertNextCell(VTK_VERTEX, 1, vertex);
  grid->InsertNextCell(VTK_POLYHEDRON, 8, points, 6, faces);
  const auto input = surfaceOf(grid);
  EXPECT_DOUBLE_EQ(surfaceArea(*input), 6.0);
  EXPECT_EQ(cellsOf(*input), std::vector<std::int64_t>(12, 1));
  expectMapsBack(*input);
}

TEST(Datasets, QuadraticFacesUseTheirMiddles)
{
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const double corners[4][3] = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 2 } };
  for (const auto& p : corners)
  {
    points->InsertNextPoint(p);
  }
  const int edges[6][2] = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 1, 3 }, { 2, 3 } };
  for (const auto& edge : edges)
  {
    const double* a = corners[edge[0]];
    const double* b = corners[edge[1]];
    points->InsertNextPoint((a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2);
  }
  grid->SetPoints(points);
  const vtkIdType ids[] = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 };
  grid->InsertNextCell(VTK_QUADRATIC_TETRA, 10, ids);
  const auto input = surfaceOf(grid);
  EXPECT_EQ(input->surface->size(), 16u) << "four triangles a face";
  EXPECT_NEAR(surfaceArea(*input), 6.0 + 2.0 * std::sqrt(3.0), 1e-12);
  expectMapsBack(*input);
  EXPECT_EQ(input->primitivesAroundPoint(0, 4).size(), 16u);
}

TEST(Datasets, PointsOfImagesAreNotRounded)
{
  const auto image = voxels(3, 2, 2);
  image->SetSpacing(0.1, 0.1, 0.1);
  image->SetOrigin(1e7, 1.0 / 3.0, 0.0);
  const auto input = surfaceOf(image);
  EXPECT_EQ(input->surface->scalar(), ArrayView::Scalar::Double);
  expectMapsBack(*input);
}

TEST(Datasets, PlaneImageAndFlatGridsAreSurfaces)
{
  const auto image = voxels(3, 2, 0);
  EXPECT_EQ(surfaceOf(image)->surface->size(), 12u);
  expectMapsBack(*surfaceOf(image));
  vtkNew<vtkStructuredGrid> grid;
  grid->SetDimensions(4, 3, 1);
  grid->SetPoints(pointsIn(image));
  EXPECT_EQ(surfaceOf(grid)->surface->size(), 12u);
}

TEST(Datasets, IdArraysOfTheInputAreNotMistaken)
{
  // Arrays that another extraction left behind have the names that VTK gives by default.
  const auto image = voxels(2, 1, 1);
  vtkNew<vtkIdTypeArray> stale;
  stale->SetName("vtkOriginalCellIds");
  stale->InsertNextValue(70);
  stale->InsertNextValue(71);
  image->GetCellData()->AddArray(stale);
  expectMapsBack(*surfaceOf(image));
}

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 5, 20250101)
TEST(Datasets, RefinedCellsOfAnAmrAreHidden)
{
  vtkNew<vtkNonOverlappingAMR> amr;
  const int blocks[] = { 1, 1 };
  amr->Initialize(2, blocks);
  vtkNew<vtkUniformGrid> coarse;
  coarse->SetDimensions(3, 2, 2);
  setGhosts(coarse, { 0, vtkDataSetAttributes::REFINEDCELL });
  vtkNew<vtkUniformGrid> fine;
  fine->SetDimensions(3, 3, 3);
  fine->SetSpacing(0.5, 0.5, 0.5);
  fine->SetOrigin(1.0, 0.0, 0.0);
  amr->SetDataSet(0, 0, coarse);
  amr->SetDataSet(1, 0, fine);
  const auto input = surfaceOf(amr);
  ASSERT_EQ(input->leaves.size(), 2u);
  EXPECT_EQ(input->hiddenCells, 1u);
  EXPECT_DOUBLE_EQ(surfaceArea(*input), 12.0);
  EXPECT_EQ(input->surface->size(), 12u + 48u);
  expectMapsBack(*input);
}
#endif
