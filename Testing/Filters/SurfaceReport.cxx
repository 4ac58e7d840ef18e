// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surface reports: known surfaces, each defect by itself, unwelded meshes, bad input.
#include "RaysFixtures.h"

#include "vtkLumiSurfaceReport.h"

#include "vtkCellData.h"
#include "vtkCleanPolyData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>

using namespace lumitree::testing;

namespace
{

const double notANumber = std::numeric_limits<double>::quiet_NaN();

/// A tetrahedron, faces outward, as corners given one after the other.
std::vector<Point> tetrahedron(const Point& shift = { 0, 0, 0 })
{
  const Point p[] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  std::vector<Point> corners;
  for (const int i : { 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3 })
  {
    corners.push_back({ p[i][0] + shift[0], p[i][1] + shift[1], p[i][2] + shift[2] });
  }
  return corners;
}

class SurfaceReport : public ::testing::Test
{
protected:
  vtkDataSetAttributes* row(vtkDataObject* surface)
  {
    this->filter_->SetInputDataObject(0, surface);
    this->filter_->Update();
    return vtkTable::SafeDownCast(this->filter_->GetOutputDataObject(2))->GetRowData();
  }

  vtkDataSetAttributes* row(const std::vector<Point>& corners)
  {
    return this->row(triangles(corners));
  }

  vtkPolyData* output(int port)
  {
    return vtkPolyData::SafeDownCast(this->filter_->GetOutputDataObject(port));
  }

  double defect(vtkIdType triangle)
  {
    return value(this->output(0)->GetCellData(), "Defect", triangle);
  }

  /// Every column that is named, and no defect besides.
  static void expect(vtkDataSetAttributes* row, std::map<std::string, double> wanted)
  {
    for (const char* count :
      { "BoundaryEdges", "BoundaryLoops", "NonManifoldEdges", "NonManifoldPoints",
        "InconsistentEdges", "NonFinite", "Degenerate", "Duplicate", "Refused", "Flipped" })
    {
      wanted.emplace(count, 0.0);
    }
    for (const auto& [name, number] : wanted)
    {
      EXPECT_EQ(value(row, name.c_str(), 0), number) << name;
    }
  }

  vtkNew<vtkLumiSurfaceReport> filter_;
};

} // namespace

#ifdef LUMITREE_HAVE_OPENMESH

TEST_F(SurfaceReport, AClosedSurfaceKeepsBothPromises)
{
  expect(this->row(tetrahedron()),
    { { "Closed", 1 }, { "Manifold", 1 }, { "ConsistentlyOriented", 1 }, { "Orientable", 1 },
      { "WatertightApplies", 1 }, { "InsideOutsideApplies", 1 }, { "Triangles", 4 },
      { "Points", 4 }, { "MergedPoints", 8 }, { "Edges", 6 }, { "Components", 1 },
      { "EulerCharacteristic", 2 } });
  vtkDataSetAttributes* row = this->row(tetrahedron());
  EXPECT_NEAR(value(row, "Volume", 0), 1.0 / 6.0, 1e-15);
  EXPECT_NEAR(value(row, "Area", 0), 1.5 + std::sqrt(3.0) / 2.0, 1e-15);
  EXPECT_EQ(this->output(0)->GetNumberOfCells(), 4);
  EXPECT_EQ(this->output(1)->GetNumberOfCells(), 0);
}

TEST_F(SurfaceReport, BuiltInScenesAreWhatTheyAre)
{
  expect(this->row(polyData(lumitree::data::sphere(6))),
    { { "Closed", 1 }, { "EulerCharacteristic", 2 }, { "Components", 1 } });
  expect(this->row(polyData(lumitree::data::torus(16, 8))),
    { { "Closed", 1 }, { "EulerCharacteristic", 0 }, { "InsideOutsideApplies", 1 } });
  vtkDataSetAttributes* terrain = this->row(polyData(lumitree::data::terrain(5)));
  EXPECT_EQ(value(terrain, "Closed", 0), 0);
  EXPECT_EQ(value(terrain, "BoundaryLoops", 0), 1);
  EXPECT_EQ(value(terrain, "EulerCharacteristic", 0), 1);
}

TEST_F(SurfaceReport, AHoleIsOneLoop)
{
  std::vector<Point> open = tetrahedron();
  open.resize(9);
  expect(this->row(open),
    { { "Closed", 0 }, { "Manifold", 1 }, { "ConsistentlyOriented", 1 }, { "WatertightApplies", 0 },
      { "InsideOutsideApplies", 0 }, { "BoundaryEdges", 3 }, { "BoundaryLoops", 1 } });
  EXPECT_TRUE(std::isnan(value(this->row(open), "Volume", 0)));
  ASSERT_EQ(this->output(1)->GetNumberOfCells(), 1);
  EXPECT_EQ(this->output(1)->GetNumberOfPoints(), 3);
  EXPECT_EQ(this->output(1)->GetCell(0)->GetNumberOfPoints(), 4); // back to its first
  EXPECT_EQ(value(this->output(1)->GetCellData(), "Closed", 0), 1);
  EXPECT_EQ(value(this->output(1)->GetCellData(), "Kind", 0), vtkLumiSurfaceReport::Boundary);
  EXPECT_EQ(value(this->output(1)->GetCellData(), "Faces", 0), 1);
}

TEST_F(SurfaceReport, AnUnweldedMeshFallsApartUnlessMerged)
{
  this->filter_->MergeCoincidentPointsOff();
  expect(this->row(tetrahedron()),
    { { "Closed", 0 }, { "Points", 12 }, { "MergedPoints", 0 }, { "Components", 4 },
      { "BoundaryEdges", 12 }, { "BoundaryLoops", 4 } });
}

TEST_F(SurfaceReport, AFlippedTriangleIsNamed)
{
  std::vector<Point> corners = tetrahedron();
  std::swap(corners[4], corners[5]);
  expect(this->row(corners),
    { { "Closed", 1 }, { "Manifold", 1 }, { "ConsistentlyOriented", 0 }, { "Orientable", 1 },
      { "InsideOutsideApplies", 1 }, { "InconsistentEdges", 3 }, { "Flipped", 1 } });
  EXPECT_EQ(this->defect(1), vtkLumiSurfaceReport::Flipped);
  EXPECT_EQ(this->output(1)->GetNumberOfCells(), 3);
  EXPECT_EQ(value(this->output(1)->GetCellData(), "Kind", 0), vtkLumiSurfaceReport::Inconsistent);
}

TEST_F(SurfaceReport, ASurfaceThatIsInsideOutHasANegativeVolume)
{
  std::vector<Point> corners = tetrahedron();
  for (std::size_t i = 0; i < corners.size(); i += 3)
  {
    std::swap(corners[i], corners[i + 1]);
  }
  EXPECT_NEAR(value(this->row(corners), "Volume", 0), -1.0 / 6.0, 1e-15);
}

TEST_F(SurfaceReport, AFinIsRefusedAndTheRestIsClosed)
{
  std::vector<Point> corners = tetrahedron();
  corners.insert(corners.end(), { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, -1, -1 } });
  expect(this->row(corners),
    { { "Closed", 0 }, { "Manifold", 0 }, { "InsideOutsideApplies", 0 }, { "NonManifoldEdges", 1 },
      { "NonManifoldPoints", 2 }, { "BoundaryEdges", 2 }, { "BoundaryLoops", 2 },
      { "Refused", 1 } });
  EXPECT_EQ(this->defect(4), vtkLumiSurfaceReport::Refused);
}

TEST_F(SurfaceReport, ADoubledTriangleIsADuplicateAndBreaksParity)
{
  std::vector<Point> corners = tetrahedron();
  corners.insert(corners.end(), { corners[1], corners[0], corners[2] });
  vtkDataSetAttributes* row = this->row(corners);
  EXPECT_EQ(value(row, "Duplicate", 0), 1);
  EXPECT_EQ(value(row, "Closed", 0), 1);
  EXPECT_EQ(value(row, "InsideOutsideApplies", 0), 0);
  EXPECT_EQ(this->defect(0), vtkLumiSurfaceReport::Sound);
  EXPECT_EQ(this->defect(4), vtkLumiSurfaceReport::Duplicate);
}

TEST_F(SurfaceReport, BodiesThatTouchInAPointAreClosedButNotManifold)
{
  std::vector<Point> corners = tetrahedron();
  const std::vector<Point> other = tetrahedron({ 1, 0, 0 });
  corners.insert(corners.end(), other.begin(), other.end());
  vtkDataSetAttributes* row = this->row(corners);
  EXPECT_EQ(value(row, "Closed", 0), 1);
  EXPECT_EQ(value(row, "Manifold", 0), 0);
  EXPECT_EQ(value(row, "InsideOutsideApplies", 0), 1);
  EXPECT_EQ(value(row, "NonManifoldPoints", 0), 1);
  EXPECT_EQ(value(row, "Components", 0), 2);
  EXPECT_EQ(value(row, "Refused", 0), 3); // around the point
}

TEST_F(SurfaceReport, ZeroAreaClosesTheGapItWasMadeFor)
{
  // The edge from 0 to 1 is cut at its middle on one side only; a triangle of no area is between.
  std::vector<Point> corners = tetrahedron();
  const Point a = corners[3];
  const Point b = corners[4];
  const Point top = corners[5];
  const Point middle{ 0.5, 0, 0 };
  corners.erase(corners.begin() + 3, corners.begin() + 6);
  corners.insert(corners.end(), { a, middle, top, middle, b, top });
  EXPECT_EQ(value(this->row(corners), "Closed", 0), 0);
  corners.insert(corners.end(), { a, b, middle });
  expect(this->row(corners),
    { { "Closed", 1 }, { "Manifold", 1 }, { "ConsistentlyOriented", 1 }, { "Degenerate", 1 } });
}

TEST_F(SurfaceReport, WhatIsNotFiniteIsAHole)
{
  std::vector<Point> corners = tetrahedron();
  corners[4][1] = notANumber;
  expect(this->row(corners),
    { { "Closed", 0 }, { "NonFinite", 1 }, { "BoundaryEdges", 3 }, { "BoundaryLoops", 1 } });
  EXPECT_EQ(this->defect(1), vtkLumiSurfaceReport::NonFinite);
  EXPECT_EQ(value(this->output(0)->GetCellData(), "Component", 1), -1);
}

TEST_F(SurfaceReport, AMobiusStripIsNotOrientable)
{
  std::vector<Point> corners;
  constexpr int n = 12;
  const auto at = [](int i, int side) -> Point
  {
    // After one turn the two sides have changed places.
    const int turn = (i / n) % 2;
    const double angle = 2 * 3.141592653589793 * (i % n) / n;
    const double half = 0.3 * ((side + turn) % 2 ? 1 : -1);
    return { (1 + half * std::cos(angle / 2)) * std::cos(angle),
      (1 + half * std::cos(angle / 2)) * std::sin(angle), half * std::sin(angle / 2) };
  };
  for (int i = 0; i < n; ++i)
  {
    corners.insert(
      corners.end(), { at(i, 0), at(i + 1, 0), at(i + 1, 1), at(i, 0), at(i + 1, 1), at(i, 1) });
  }
  vtkDataSetAttributes* row = this->row(corners);
  EXPECT_EQ(value(row, "Orientable", 0), 0);
  EXPECT_EQ(value(row, "ConsistentlyOriented", 0), 0);
  EXPECT_EQ(value(row, "EulerCharacteristic", 0), 0);
  EXPECT_EQ(value(row, "NonManifoldPoints", 0), 0);
  EXPECT_GT(value(row, "Refused", 0), 0);
}

TEST_F(SurfaceReport, CellsAreThoseOfTheDatasetsAndJoinAcrossThem)
{
  const std::vector<Point> corners = tetrahedron();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, triangles({ corners.begin(), corners.begin() + 6 }));
  blocks->SetBlock(1, triangles({ corners.begin() + 6, corners.end() }));
  EXPECT_EQ(value(this->row(blocks), "Closed", 0), 1);
  vtkCellData* cells = this->output(0)->GetCellData();
  EXPECT_EQ(shape(cells, "CellId"), "id 1");
  EXPECT_EQ(shape(cells, "CompositeIndex"), "int 1");
  EXPECT_EQ(shape(cells, "Component"), "id 1");
  EXPECT_EQ(shape(cells, "Defect"), "int 1");
  EXPECT_STREQ(cells->GetScalars()->GetName(), "Defect");
  EXPECT_EQ(shape(this->output(0)->GetPointData(), "Boundary"), "unsigned char 1");
  EXPECT_EQ(shape(this->output(0)->GetPointData(), "NonManifold"), "unsigned char 1");
  EXPECT_EQ(value(cells, "CellId", 3), 1);
  EXPECT_EQ(value(cells, "CompositeIndex", 3), 2);
}

TEST_F(SurfaceReport, AnEmptySurfaceKeepsNoPromise)
{
  const Messages messages(this->filter_);
  expect(this->row(vtkNew<vtkPolyData>()),
    { { "Closed", 0 }, { "Manifold", 0 }, { "ConsistentlyOriented", 0 }, { "WatertightApplies", 0 },
      { "InsideOutsideApplies", 0 }, { "Triangles", 0 }, { "Area", 0 } });
  EXPECT_EQ(messages.errors, 0);
  EXPECT_EQ(value(this->row({ { notANumber, notANumber, notANumber }, { 0, 0, 0 }, { 1, 0, 0 } }),
              "Closed", 0),
    0);
  EXPECT_EQ(value(this->row({ { 0, 0, 0 }, { 0, 0, 0 }, { 1, 0, 0 } }), "Closed", 0), 0);
  EXPECT_EQ(messages.errors, 0);
}

#else

TEST_F(SurfaceReport, WithoutOpenMeshItIsOneError)
{
  const Messages messages(this->filter_);
  EXPECT_EQ(this->row(tetrahedron())->GetNumberOfArrays(), 0);
  EXPECT_EQ(messages.errors, 1);
  EXPECT_NE(messages.text.find("OpenMesh"), std::string::npos);
}

#endif

TEST_F(SurfaceReport, ABlockThatIsNoSurfaceIsOneError)
{
  vtkNew<vtkPolyData> broken;
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2 });
  broken->SetPolys(cells); // of points that are not there
  const Messages messages(this->filter_);
  EXPECT_EQ(this->row(broken)->GetNumberOfArrays(), 0);
  EXPECT_EQ(messages.errors, 1);
  EXPECT_EQ(this->output(0)->GetNumberOfCells(), 0);
}

TEST_F(SurfaceReport, PrintsItself)
{
  std::ostringstream text;
  this->filter_->Print(text);
  for (const char* name : { "MergeCoincidentPoints", "Controller" })
  {
    EXPECT_NE(text.str().find(std::string(name) + ": "), std::string::npos) << name;
  }
}
