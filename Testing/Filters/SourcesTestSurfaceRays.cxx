// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SourcesTools.h"

#include "vtkLumiSurfaceRays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"

#include <cmath>
#include <set>

using namespace sources;

namespace
{

/// The unit square in the plane z = height, facing up, without normals: two triangles on four
/// points.
vtkSmartPointer<vtkPolyData> square(double height = 0.0)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 4; ++i)
  {
    points->InsertNextPoint(i % 2, i / 2, height);
  }
  surface->SetPoints(points);
  surface->AllocateExact(2, 6);
  surface->InsertNextCell(VTK_TRIANGLE, 3, std::array<vtkIdType, 3>{ 0, 1, 2 }.data());
  surface->InsertNextCell(VTK_TRIANGLE, 3, std::array<vtkIdType, 3>{ 1, 3, 2 }.data());
  return surface;
}

vtkIdType id(vtkPolyData* rays, const char* name, vtkIdType i)
{
  return static_cast<vtkIdType>(rays->GetPointData()->GetArray(name)->GetTuple1(i));
}

/// Means of cos and cos^2 of the angle to +z.
std::array<double, 2> moments(vtkPolyData* rays)
{
  std::array<double, 2> sums = { 0.0, 0.0 };
  const auto count = static_cast<double>(rays->GetNumberOfPoints());
  for (vtkIdType i = 0; i < rays->GetNumberOfPoints(); ++i)
  {
    const double cosine = tuple(directions(rays), i)[2];
    sums[0] += cosine / count;
    sums[1] += cosine * cosine / count;
  }
  return sums;
}

}

TEST(SurfaceRays, PointsSendRaysAsTheDataModelSays)
{
  vtkNew<vtkLumiSurfaceRays> rays;
  rays->SetInputData(square());
  rays->SetRaysPerSource(8);
  rays->Update();
  vtkPolyData* output = rays->GetOutput();
  expectRays(output, 32);
  vtkPointData* data = output->GetPointData();
  EXPECT_EQ(data->GetArray("SourceCellId")->GetDataType(), VTK_ID_TYPE);
  EXPECT_EQ(data->GetArray("SourcePointId")->GetDataType(), VTK_ID_TYPE);
  EXPECT_EQ(data->GetArray("SourceCompositeIndex")->GetDataType(), VTK_INT);
  for (vtkIdType i = 0; i < 32; ++i)
  {
    EXPECT_EQ(id(output, "SourcePointId", i), i / 8);
    EXPECT_EQ(id(output, "SourceCellId", i), -1);
    EXPECT_EQ(id(output, "SourceCompositeIndex", i), 0);
    EXPECT_EQ(point(output, i), (Vec3{ double(i / 8 % 2), double(i / 16), 0.0 }));
    EXPECT_GT(tuple(directions(output), i)[2], 0.0);
  }
}

TEST(SurfaceRays, CellsSendRaysFromTheirCentroids)
{
  vtkNew<vtkLumiSurfaceRays> rays;
  rays->SetInputData(square());
  rays->SetSourceLocation(vtkLumiSurfaceRays::Cells);
  rays->SetDistribution(vtkLumiSurfaceRays::Normal);
  rays->SetRaysPerSource(5);
  rays->SetOffset(0.5);
  rays->Update();
  vtkPolyData* output = rays->GetOutput();
  expectRays(output, 2);
  expectNear(point(output, 0), { 1.0 / 3.0, 1.0 / 3.0, 0.5 });
  expectNear(point(output, 1), { 2.0 / 3.0, 2.0 / 3.0, 0.5 });
  for (vtkIdType i = 0; i < 2; ++i)
  {
    EXPECT_EQ(tuple(directions(output), i), (Vec3{ 0.0, 0.0, 1.0 }));
    EXPECT_EQ(id(output, "SourceCellId", i), i);
    EXPECT_EQ(id(output, "SourcePointId", i), -1);
  }
}

TEST(SurfaceRays, MomentsOfTheDistributions)
{
  vtkNew<vtkLumiSurfaceRays> rays;
  rays->SetInputData(square());
  rays->SetRaysPerSource(4096);
  rays->Update();
  // Cosine: E[cos] = 2/3, E[cos^2] = 1/2; uniform: 1/2 and 1/3. Stratified points are far closer
  // than the 0.002 of plain random ones.
  EXPECT_NEAR(moments(rays->GetOutput())[0], 2.0 / 3.0, 1e-5);
  EXPECT_NEAR(moments(rays->GetOutput())[1], 1.0 / 2.0, 1e-5);
  rays->SetDistribution(vtkLumiSurfaceRays::Uniform);
  rays->Update();
  EXPECT_NEAR(moments(rays->GetOutput())[0], 1.0 / 2.0, 1e-5);
  EXPECT_NEAR(moments(rays->GetOutput())[1], 1.0 / 3.0, 1e-5);
}

TEST(SurfaceRays, DirectionsAreStratifiedAndDifferByPoint)
{
  constexpr int count = 64;
  vtkNew<vtkLumiSurfaceRays> rays;
  rays->SetInputData(square());
  rays->SetDistribution(vtkLumiSurfaceRays::Uniform);
  rays->SetRaysPerSource(count);
  rays->Update();
  vtkDataArray* array = directions(rays->GetOutput());
  std::set<Vec3> different;
  for (int source = 0; source < 4; ++source)
  {
    // Every box of 1/columns by columns/64 of (height, azimuth) has one direction.
    for (int columns = 1; columns <= count; columns *= 2)
    {
      std::set<int> boxes;
      for (int k = 0; k < count; ++k)
      {
        const Vec3 d = tuple(array, source * count + k);
        different.insert(d);
        const double turns = std::atan2(d[1], d[0]) / (2.0 * 3.14159265358979324);
        const double azimuth = turns - std::floor(turns);
        const int rows = count / columns;
        boxes.insert(static_cast<int>(d[2] * columns) * rows + static_cast<int>(azimuth * rows));
      }
      EXPECT_EQ(boxes.size(), static_cast<std::size_t>(count)) << source << " " << columns;
    }
  }
  EXPECT_EQ(different.size(), static_cast<std::size_t>(4 * count));
}

TEST(SurfaceRays, SeedChoosesTheDirections)
{
  vtkNew<vtkLumiSurfaceRays> rays;
  rays->SetInputData(square());
  rays->SetRaysPerSource(1);
  rays->Update();
  const Vec3 first = tuple(directions(rays->GetOutput()), 3);
  rays->SetSeed(1);
  rays->Update();
  EXPECT_NE(tuple(directions(rays->GetOutput()), 3), first);
  rays->SetSeed(0);
  rays->Update();
  EXPECT_EQ(tuple(directions(rays->GetOutput()), 3), first);
}

TEST(SurfaceRays, DirectionsAreFixed)
{
  // Written down from one machine: another one must find the same bits.
  vtkNew<vtkLumiSurfaceRays> rays;
  rays->SetInputData(square());
  rays->Update();
  EXPECT_EQ(tuple(directions(rays->GetOutput()), 37),
    (Vec3{ -0x1.9dd91b2be91aep-2, -0x1.311b87eeea2a4p-2, 0x1.bac795107b3eap-1 }));
}

TEST(SurfaceRays, GivenNormalsAreUsed)
{
  const vtkSmartPointer<vtkPolyData> surface = square();
  for (vtkDataSetAttributes* data : { static_cast<vtkDataSetAttributes*>(surface->GetPointData()),
         static_cast<vtkDataSetAttributes*>(surface->GetCellData()) })
  {
    vtkNew<vtkDoubleArray> normals;
    normals->SetNumberOfComponents(3);
    for (int i = 0; i < 4; ++i)
    {
      normals->InsertNextTuple3(-2.0, 0.0, 0.0);
    }
    normals->SetNumberOfTuples(data == surface->GetPointData() ? 4 : 2);
    normals->SetName("Normals");
    data->SetNormals(normals);
  }
  vtkNew<vtkLumiSurfaceRays> rays;
  rays->SetInputData(surface);
  for (const int location : { vtkLumiSurfaceRays::Points, vtkLumiSurfaceRays::Cells })
  {
    rays->SetSourceLocation(location);
    rays->Update();
    for (vtkIdType i = 0; i < rays->GetOutput()->GetNumberOfPoints(); ++i)
    {
      EXPECT_LT(tuple(directions(rays->GetOutput()), i)[0], 0.0);
    }
  }
}

TEST(SurfaceRays, MissingPointNormalsAreWeightedByArea)
{
  // Point 0 has a triangle of area 1/2 facing +z and one of area 1 facing +x.
  vtkNew<vtkPolyData> surface;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  points->InsertNextPoint(0.0, 1.0, 0.0);
  points->InsertNextPoint(0.0, 0.0, 2.0);
  surface->SetPoints(points);
  surface->AllocateExact(2, 6);
  surface->InsertNextCell(VTK_TRIANGLE, 3, std::array<vtkIdType, 3>{ 0, 1, 2 }.data());
  surface->InsertNextCell(VTK_TRIANGLE, 3, std::array<vtkIdType, 3>{ 0, 2, 3 }.data());
  vtkNew<vtkLumiSurfaceRays> rays;
  rays->SetInputData(surface);
  rays->SetDistribution(vtkLumiSurfaceRays::Normal);
  rays->Update();
  ASSERT_EQ(rays->GetOutput()->GetNumberOfPoints(), 4);
  const double s = std::sqrt(5.0);
  expectNear(tuple(directions(rays->GetOutput()), 0), { 2.0 / s, 0.0, 1.0 / s });
  expectNear(tuple(directions(rays->GetOutput()), 1), { 0.0, 0.0, 1.0 });
  expectNear(tuple(directions(rays->GetOutput()), 3), { 1.0, 0.0, 0.0 });
}

TEST(SurfaceRays, StripsAndPolygonsThatAreNotConvex)
{
  vtkNew<vtkPolyData> surface;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  // An L of three unit squares, and a strip of three triangles beside it.
  const double corners[][2] = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 },
    { 5, 0 }, { 6, 0 }, { 5, 1 }, { 6, 1 }, { 5, 2 } };
  for (const auto& c : corners)
  {
    points->InsertNextPoint(c[0], c[1], 0.0);
  }
  surface->SetPoints(points);
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 2, 3, 4, 5 });
  surface->SetPolys(polygons);
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 6, 7, 8, 9, 10 });
  surface->SetStrips(strips);

  vtkNew<vtkLumiSurfaceRays> rays;
  rays->SetInputData(surface);
  rays->SetDistribution(vtkLumiSurfaceRays::Normal);
  rays->Update();
  ASSERT_EQ(rays->GetOutput()->GetNumberOfPoints(), 11);
  for (vtkIdType i = 0; i < 11; ++i)
  {
    expectNear(tuple(directions(rays->GetOutput()), i), { 0.0, 0.0, 1.0 });
  }
  rays->SetSourceLocation(vtkLumiSurfaceRays::Cells);
  rays->Update();
  ASSERT_EQ(rays->GetOutput()->GetNumberOfPoints(), 2);
  expectNear(point(rays->GetOutput(), 0), { 5.0 / 6.0, 5.0 / 6.0, 0.0 });
  expectNear(point(rays->GetOutput(), 1), { 17.0 / 3.0, 2.0 / 3.0, 0.0 });
  expectNear(tuple(directions(rays->GetOutput()), 1), { 0.0, 0.0, 1.0 });
  EXPECT_EQ(id(rays->GetOutput(), "SourceCellId", 1), 1);
}

TEST(SurfaceRays, PropertiesOutOfRangeAreOneErrorAndAnEmptyOutput)
{
  for (const bool offset : { true, false })
  {
    vtkNew<vtkLumiSurfaceRays> rays;
    vtkNew<Messages> messages;
    messages->watch(rays);
    rays->SetInputData(square());
    rays->Update();
    EXPECT_EQ(rays->GetOutput()->GetNumberOfPoints(), 64);
    offset ? rays->SetOffset(std::nan("")) : rays->SetRaysPerSource(0);
    rays->Update();
    EXPECT_EQ(messages->errors, 1) << messages->last;
    EXPECT_EQ(rays->GetOutput()->GetNumberOfPoints(), 0);
  }
}
