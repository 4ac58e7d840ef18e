// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rays in their three forms, and rays that are none.
#include "CommonFixtures.h"

#include "LumiRayInput.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <limits>

using namespace lumitree;
using namespace lumitree::filters;

namespace
{

const double infinity = std::numeric_limits<double>::infinity();

template <class Array>
vtkSmartPointer<Array> arrayOf(const char* name, int components, const std::vector<double>& values)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetComponent(
      static_cast<vtkIdType>(i) / components, static_cast<int>(i) % components, values[i]);
  }
  return array;
}

RayInput raysOf(
  vtkDataSet* data, const char* direction = nullptr, double tMin = 0.0, double tMax = infinity)
{
  Reporter reporter;
  RayInput rays;
  EXPECT_TRUE(readRays(data, direction, tMin, tMax, rays, reporter.algorithm())) << reporter.text;
  EXPECT_EQ(reporter.errors, 0) << reporter.text;
  return rays;
}

/// Reading fails with one error that says `what`.
void expectBad(vtkDataSet* data, const char* direction, const std::string& what)
{
  Reporter reporter;
  RayInput rays;
  EXPECT_FALSE(readRays(data, direction, 0.0, 1.0, rays, reporter.algorithm()));
  EXPECT_EQ(reporter.errors, 1);
  EXPECT_NE(reporter.text.find(what), std::string::npos) << reporter.text;
  EXPECT_EQ(rays.batch.size, 0u);
}

vtkSmartPointer<vtkPolyData> twoPoints(int type = VTK_DOUBLE)
{
  return polygons({ { 1, 2, 3 }, { 4, 5, 6 } }, {}, type);
}

} // namespace

TEST(Rays, ImageWithOriginsAndDirections)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 1, 1);
  const auto origins = arrayOf<vtkDoubleArray>("RayOrigin", 3, { 0, 0, 5, 0, 1, 5 });
  const auto directions = arrayOf<vtkFloatArray>("RayDirection", 3, { 0, 0, -1, 0, 0, -2 });
  image->GetPointData()->AddArray(origins);
  image->GetPointData()->AddArray(directions);
  const RayInput rays = raysOf(image, nullptr, 0.5, 9.0);
  ASSERT_EQ(rays.size, 2);
  EXPECT_EQ(rays.batch.size, 2u);
  EXPECT_FALSE(rays.perCell);
  EXPECT_TRUE(rays.doublePoints);
  EXPECT_EQ(rays.batch[1].origin, (Vec3{ 0, 1, 5 }));
  EXPECT_EQ(rays.batch[1].direction, (Vec3{ 0, 0, -2 }));
  EXPECT_EQ(rays.batch[1].tMin, 0.5);
  EXPECT_EQ(rays.batch[1].tMax, 9.0);
  EXPECT_EQ(rays.batch.origins.data, origins->GetPointer(0)) << "not copied";
  EXPECT_EQ(rays.batch.directions.data, directions->GetPointer(0)) << "not copied";
}

TEST(Rays, PointsWithDirections)
{
  const auto data = twoPoints(VTK_FLOAT);
  data->GetPointData()->AddArray(arrayOf<vtkDoubleArray>("Sun", 3, { 0, 0, 1, 0, 1, 0 }));
  data->GetPointData()->AddArray(arrayOf<vtkDoubleArray>("RayTMin", 1, { 0.25, 0.5 }));
  data->GetPointData()->AddArray(arrayOf<vtkFloatArray>("RayTMax", 1, { 2.0, 3.0 }));
  const RayInput rays = raysOf(data, "Sun");
  ASSERT_EQ(rays.size, 2);
  EXPECT_FALSE(rays.doublePoints);
  EXPECT_EQ(rays.batch[1].origin, (Vec3{ 4, 5, 6 }));
  EXPECT_EQ(rays.batch[1].direction, (Vec3{ 0, 1, 0 }));
  EXPECT_EQ(rays.batch[1].tMin, 0.5);
  EXPECT_EQ(rays.batch[1].tMax, 3.0);
}

TEST(Rays, ImagePointsAreOrigins)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 1, 1);
  image->SetSpacing(3, 1, 1);
  image->GetPointData()->AddArray(arrayOf<vtkDoubleArray>("RayDirection", 3, { 0, 0, 1, 0, 0, 1 }));
  EXPECT_EQ(raysOf(image).batch[1].origin, (Vec3{ 3, 0, 0 }));
}

TEST(Rays, SegmentsOfLines)
{
  vtkNew<vtkPolyData> data;
  data->SetPoints(
    polygons({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 2, 0 }, { 5, 5, 5 } }, {}, VTK_FLOAT)->GetPoints());
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 3 });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1, 2 });
  lines->InsertNextCell({ 3, 0 });
  data->SetVerts(verts);
  data->SetLines(lines);
  const RayInput rays = raysOf(data);
  ASSERT_EQ(rays.size, 3);
  EXPECT_TRUE(rays.perCell);
  EXPECT_FALSE(rays.doublePoints);
  EXPECT_EQ(rays.batch[1].origin, (Vec3{ 1, 0, 0 }));
  EXPECT_EQ(rays.batch[1].direction, (Vec3{ 0, 2, 0 }));
  EXPECT_EQ(rays.batch[1].tMin, 0.0);
  EXPECT_EQ(rays.batch[1].tMax, 1.0);
  EXPECT_EQ(rays.segmentCells, (std::vector<vtkIdType>{ 1, 1, 2 }));
  EXPECT_EQ(rays.segmentPoints[2], (std::array<vtkIdType, 2>{ 3, 0 }));

  const RayInput narrow = raysOf(data, "RayDirection", 0.125, 0.5);
  EXPECT_EQ(narrow.batch[0].tMin, 0.125);
  EXPECT_EQ(narrow.batch[0].tMax, 0.5);
}

TEST(Rays, LinesOfAnUnstructuredGrid)
{
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(twoPoints()->GetPoints());
  const vtkIdType ids[] = { 0, 1 };
  grid->InsertNextCell(VTK_VERTEX, 1, ids);
  grid->InsertNextCell(VTK_LINE, 2, ids);
  const RayInput rays = raysOf(grid);
  ASSERT_EQ(rays.size, 1);
  EXPECT_EQ(rays.segmentCells[0], 1);
  EXPECT_EQ(rays.batch[0].direction, (Vec3{ 3, 3, 3 }));
}

TEST(Rays, DirectionsComeBeforeLines)
{
  const auto data = twoPoints();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  data->SetLines(lines);
  data->GetPointData()->AddArray(arrayOf<vtkDoubleArray>("RayDirection", 3, { 0, 0, 1, 0, 0, 1 }));
  EXPECT_FALSE(raysOf(data).perCell);
}

TEST(Rays, NoneIsNoError)
{
  vtkNew<vtkPolyData> data;
  EXPECT_EQ(raysOf(data).size, 0);
  EXPECT_EQ(raysOf(data).batch.size, 0u);
}

TEST(Rays, BadInputIsOneError)
{
  expectBad(nullptr, nullptr, "no dataset");
  expectBad(twoPoints(), nullptr, "RayDirection");
  const auto lines = twoPoints();
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1 });
  lines->SetLines(cells);
  expectBad(lines, "Wind", "Wind"); // a name that was asked for must be there
  vtkNew<vtkCellArray> broken;
  broken->InsertNextCell({ 0, 9 });
  lines->SetLines(broken);
  expectBad(lines, nullptr, "does not exist");

  const auto wrong = [](vtkAbstractArray* array)
  {
    const auto data = twoPoints();
    data->GetPointData()->AddArray(array);
    expectBad(data, nullptr, "RayDirection must be float or double, with 3 components");
  };
  wrong(arrayOf<vtkIntArray>("RayDirection", 3, { 0, 0, 1, 0, 0, 1 }));
  wrong(arrayOf<vtkDoubleArray>("RayDirection", 2, { 0, 0, 1, 0 }));
  wrong(arrayOf<vtkDoubleArray>("RayDirection", 3, { 0, 0, 1 }));
  vtkNew<vtkStringArray> strings;
  strings->SetName("RayDirection");
  wrong(strings);
}
