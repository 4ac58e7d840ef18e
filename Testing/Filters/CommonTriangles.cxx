// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cells become triangles that cover them, keep their winding and know their cell.
#include "CommonFixtures.h"

#include "vtkCellArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace lumitree;
using namespace lumitree::filters;

namespace
{

double polygonArea(const std::vector<Vec3>& points, const Vec3& normal)
{
  Vec3 sum = { 0.0, 0.0, 0.0 };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    sum = sum + cross(points[i] - points[0], points[(i + 1) % points.size()] - points[0]);
  }
  return dot(sum, normal);
}

/// One polygon in a plane of that normal becomes n − 2 triangles that face its way and fill its
/// area: then they neither overlap nor stick out.
void expectFilled(const std::vector<Vec3>& points, const Vec3& normal)
{
  Cell cell;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    cell.push_back(static_cast<vtkIdType>(i));
  }
  const auto input = surfaceOf(polygons(points, { cell }));
  ASSERT_EQ(input->surface->size(), points.size() - 2);
  double area = 0.0;
  for (PrimitiveId i = 0; i < input->surface->size(); ++i)
  {
    const double part = dot(areaVector(*input->surface, i), normal);
    EXPECT_GT(part, 0.0) << "triangle " << i;
    area += part;
    EXPECT_EQ(input->surface->source(i).cell, 0);
  }
  const double whole = polygonArea(points, normal);
  EXPECT_NEAR(area, whole, 1e-9 * whole);
}

std::vector<Vec3> rotated(std::vector<Vec3> points, std::size_t by)
{
  std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(by), points.end());
  return points;
}

const Vec3 up = { 0.0, 0.0, 1.0 };
const double notANumber = std::numeric_limits<double>::quiet_NaN();

} // namespace

TEST(Triangles, KeepTheirPointsAndOrder)
{
  const auto input = surfaceOf(
    polygons({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } }, { { 0, 1, 2 }, { 3, 2, 1 } }));
  ASSERT_EQ(input->surface->size(), 2u);
  EXPECT_EQ(input->surface->triangle(0), (Triangle{ 0, 1, 2 }));
  EXPECT_EQ(input->surface->triangle(1), (Triangle{ 3, 2, 1 }));
  EXPECT_TRUE(input->surface->sources().cells.empty()) << "the identity needs no list";
}

TEST(Triangles, ConvexQuadIsCutAlongItsShorterDiagonal)
{
  const std::vector<Vec3> points = { { 0, 0, 0 }, { 3, 0, 0 }, { 4, 1, 0 }, { 1, 1, 0 } };
  const auto input = surfaceOf(polygons(points, { { 0, 1, 2, 3 } }));
  EXPECT_EQ(input->surface->triangle(0), (Triangle{ 0, 1, 3 }));
  EXPECT_EQ(input->surface->triangle(1), (Triangle{ 1, 2, 3 }));
}

TEST(Triangles, ConcaveQuadIsCutInside)
{
  // An arrowhead; its shorter diagonal runs outside.
  const std::vector<Vec3> arrow = { { 0, 0, 0 }, { 2, 1, 0 }, { 0, 2, 0 }, { 1.5, 1, 0 } };
  for (std::size_t first = 0; first < 4; ++first)
  {
    SCOPED_TRACE(first);
    expectFilled(rotated(arrow, first), up);
  }
}

TEST(Triangles, ConcavePolygonsAreFilled)
{
  const std::vector<Vec3> letterL = { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 1, 0 }, { 1, 1, 0 },
    { 1, 3, 0 }, { 0, 3, 0 } };
  const std::vector<Vec3> comb = { { 0, 0, 0 }, { 5, 0, 0 }, { 5, 4, 0 }, { 4, 1, 0 }, { 3, 4, 0 },
    { 2, 1, 0 }, { 1, 4, 0 } };
  std::vector<Vec3> star;
  for (int i = 0; i < 14; ++i)
  {
    const double r = i % 2 ? 0.3 : 1.0;
    star.push_back({ r * std::cos(i * M_PI / 7), r * std::sin(i * M_PI / 7), 0.0 });
  }
  for (const auto& polygon : { letterL, comb, star })
  {
    for (std::size_t first = 0; first < polygon.size(); ++first)
    {
      SCOPED_TRACE(std::to_string(polygon.size()) + " points from " + std::to_string(first));
      expectFilled(rotated(polygon, first), up);
    }
  }
}

TEST(Triangles, ConcavePolygonFarFromTheOriginIsFilled)
{
  std::vector<Vec3> letterL = { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 1, 0 }, { 1, 1, 0 }, { 1, 3, 0 },
    { 0, 3, 0 } };
  for (Vec3& p : letterL)
  {
    p = p + Vec3{ 4.5e6, -5.4e6, 1e7 };
  }
  expectFilled(letterL, up);
}

TEST(Triangles, PolygonThatCannotBeCutBecomesAFan)
{
  // A pentagram crosses itself: whatever comes out, it must be n − 2 triangles of the cell.
  std::vector<Vec3> pentagram;
  for (int i = 0; i < 5; ++i)
  {
    pentagram.push_back({ std::cos(i * 4 * M_PI / 5), std::sin(i * 4 * M_PI / 5), 0.0 });
  }
  const auto crossed = surfaceOf(polygons(pentagram, { { 0, 1, 2, 3, 4 } }));
  EXPECT_EQ(crossed->surface->size(), 3u);

  const std::vector<Vec3> line = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 },
    { 4, 0, 0 } };
  const auto flat = surfaceOf(polygons(line, { { 0, 1, 2, 3, 4 } }));
  EXPECT_EQ(flat->surface->size(), 3u);
  EXPECT_EQ(flat->surface->zeroAreaCount(), 3u);
}

TEST(Triangles, StripsAlternate)
{
  vtkNew<vtkPolyData> data;
  data->SetPoints(
    polygons({ { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 2, 0, 0 } }, {})->GetPoints());
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 2, 1, 3 });
  strips->InsertNextCell({ 2, 4, 3 });
  data->SetStrips(strips);
  const auto input = surfaceOf(data);
  ASSERT_EQ(input->surface->size(), 3u);
  EXPECT_EQ(cellsOf(*input), (std::vector<std::int64_t>{ 0, 0, 1 }));
  for (PrimitiveId i = 0; i < 3; ++i)
  {
    EXPECT_GT(areaVector(*input->surface, i)[2], 0.0);
  }
}

TEST(Triangles, CellWithANonFinitePointIsNeverHitAsAWhole)
{
  const std::vector<Vec3> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { notANumber, 1, 0 },
    { 0, 2, 0 } };
  for (const Cell& cell : { Cell{ 0, 1, 3 }, Cell{ 0, 1, 2, 3 }, Cell{ 0, 1, 2, 3, 4 } })
  {
    const auto input = surfaceOf(polygons(points, { cell }));
    EXPECT_TRUE(input->surface->hittable().empty()) << cell.size() << " points";
    EXPECT_EQ(input->surface->nonFiniteCount(), 1u) << "counted as one cell";
  }
  vtkNew<vtkPolyData> strip;
  strip->SetPoints(polygons(points, {})->GetPoints());
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 1, 4, 2, 3 });
  strip->SetStrips(strips);
  EXPECT_TRUE(surfaceOf(strip)->surface->hittable().empty());
}

TEST(Triangles, VerticesAndLinesArePassedOverAndShiftTheIds)
{
  const auto data = squares(2);
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 0 });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  lines->InsertNextCell({ 1, 2 });
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 1, 3 });
  data->SetVerts(verts);
  data->SetLines(lines);
  data->SetStrips(strips);
  const auto input = surfaceOf(data);
  EXPECT_EQ(input->passedOver, 3u);
  EXPECT_EQ(cellsOf(*input), (std::vector<std::int64_t>{ 3, 3, 4, 4, 5, 5, 6, 6, 7 }));
}

TEST(Triangles, CellsInsertedInMixedOrderKeepTheirIds)
{
  vtkNew<vtkPolyData> data;
  data->SetPoints(squares(1)->GetPoints());
  data->AllocateEstimate(4, 4);
  const vtkIdType strip[] = { 0, 1, 2 };
  const vtkIdType triangle[] = { 1, 3, 2 };
  const vtkIdType line[] = { 0, 3 };
  data->InsertNextCell(VTK_TRIANGLE_STRIP, 3, strip);
  data->InsertNextCell(VTK_TRIANGLE, 3, triangle);
  data->InsertNextCell(VTK_LINE, 2, line);
  data->InsertNextCell(VTK_TRIANGLE, 3, strip);
  const auto input = surfaceOf(data);
  ASSERT_EQ(cellsOf(*input), (std::vector<std::int64_t>{ 0, 1, 3 }));
  EXPECT_EQ(input->surface->triangle(1), (Triangle{ 1, 3, 2 })) << "cell 1 is the first triangle";
}

TEST(Triangles, TooFewPointsArePassedOver)
{
  const auto input =
    surfaceOf(polygons({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1 }, { 0, 1, 2 }, {} }));
  EXPECT_EQ(input->passedOver, 2u);
  EXPECT_EQ(cellsOf(*input), (std::vector<std::int64_t>{ 1 }));
}

TEST(Triangles, PointsThatDoNotExistAreOneError)
{
  Reporter reporter;
  const auto bad =
    polygons({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 1, 7 } });
  EXPECT_FALSE(surfaceFor(bad, nullptr, reporter.algorithm()));
  EXPECT_EQ(reporter.errors, 1);
  EXPECT_NE(reporter.text.find("cell 1 uses point 7 of 3"), std::string::npos) << reporter.text;
}
