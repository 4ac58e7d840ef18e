// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkLumiSurfaceRays on what is no plain triangle mesh: composites, ghosts, volumes, and nothing at
// all.
#include "SourcesTools.h"

#include "vtkLumiSurfaceRays.h"

#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlaneSource.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <map>
#include <set>

using namespace sources;

namespace
{

/// A grid of count x count quads in the plane z = 0, facing up.
vtkSmartPointer<vtkPolyData> plane(int count)
{
  vtkNew<vtkPlaneSource> source;
  source->SetResolution(count, count);
  source->Update();
  return source->GetOutput();
}

void addGhosts(
  vtkDataSetAttributes* data, const std::map<vtkIdType, unsigned char>& marks, vtkIdType count)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(count);
  ghosts->FillValue(0);
  for (const auto& mark : marks)
  {
    ghosts->SetValue(mark.first, mark.second);
  }
  data->AddArray(ghosts);
}

/// Cell normals along +z.
void addNormals(vtkDataSet* data, vtkIdType cells)
{
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < cells; ++i)
  {
    normals->InsertNextTuple3(0.0, 0.0, 1.0);
  }
  data->GetCellData()->SetNormals(normals);
}

std::multiset<vtkIdType> ids(vtkPolyData* rays, const char* name)
{
  std::multiset<vtkIdType> result;
  vtkDataArray* array = rays->GetPointData()->GetArray(name);
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    result.insert(static_cast<vtkIdType>(array->GetTuple1(i)));
  }
  return result;
}

}

TEST(SurfaceRays, LeavesOfACompositeAreToldByTheirFlatIndex)
{
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, plane(1));
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, plane(2));
  blocks->SetBlock(2, inner);
  vtkNew<vtkLumiSurfaceRays> rays;
  rays->SetInputData(blocks);
  rays->SetSourceLocation(vtkLumiSurfaceRays::Cells);
  rays->SetRaysPerSource(1);
  rays->Update();
  // Flat indices: 0 the root, 1 the first block, 2 the empty one, 3 the inner composite, 4 its
  // block.
  ASSERT_EQ(rays->GetOutput()->GetNumberOfPoints(), 5);
  const std::multiset<vtkIdType> expected = { 1, 1, 1, 1, 4 };
  EXPECT_EQ(ids(rays->GetOutput(), "SourceCompositeIndex"), expected);
  // The same place in another leaf sends other rays.
  EXPECT_NE(tuple(directions(rays->GetOutput()), 0), tuple(directions(rays->GetOutput()), 4));
}

TEST(SurfaceRays, GhostsSendNoRays)
{
  const vtkSmartPointer<vtkPolyData> surface = plane(2);
  addGhosts(surface->GetCellData(),
    { { 0, vtkDataSetAttributes::DUPLICATECELL }, { 3, vtkDataSetAttributes::HIDDENCELL } }, 4);
  addGhosts(surface->GetPointData(), { { 0, vtkDataSetAttributes::DUPLICATEPOINT } }, 9);
  vtkNew<vtkLumiSurfaceRays> rays;
  vtkNew<Messages> messages;
  messages->watch(rays);
  rays->SetInputData(surface);
  rays->SetRaysPerSource(1);
  rays->SetSourceLocation(vtkLumiSurfaceRays::Cells);
  rays->Update();
  EXPECT_EQ(ids(rays->GetOutput(), "SourceCellId"), (std::multiset<vtkIdType>{ 1, 2 }));
  EXPECT_EQ(messages->warnings, 0);

  // Point 8 belongs to the hidden cell alone: without normals in the data it has none.
  rays->SetSourceLocation(vtkLumiSurfaceRays::Points);
  rays->Update();
  EXPECT_EQ(
    ids(rays->GetOutput(), "SourcePointId"), (std::multiset<vtkIdType>{ 1, 2, 3, 4, 5, 6, 7, 8 }));
  EXPECT_EQ(messages->warnings, 0);
  surface->GetPointData()->SetNormals(nullptr);
  surface->Modified();
  rays->Update();
  EXPECT_EQ(
    ids(rays->GetOutput(), "SourcePointId"), (std::multiset<vtkIdType>{ 1, 2, 3, 4, 5, 6, 7 }));
  EXPECT_EQ(messages->warnings, 1);
}

TEST(SurfaceRays, OfAVolumeTheOuterSurfaceSendsRaysWithTheVolumesIds)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 4);
  addNormals(image, 27); // which cannot be the normals of the faces
  vtkNew<vtkLumiSurfaceRays> rays;
  rays->SetInputData(image);
  rays->SetDistribution(vtkLumiSurfaceRays::Normal);
  rays->SetSourceLocation(vtkLumiSurfaceRays::Cells);
  rays->Update();
  // 54 faces; a corner cell has three of them, and the one in the middle none.
  vtkPolyData* output = rays->GetOutput();
  const std::multiset<vtkIdType> cells = ids(output, "SourceCellId");
  EXPECT_EQ(cells.size(), 54u);
  EXPECT_EQ(cells.count(0), 3u);
  EXPECT_EQ(cells.count(13), 0u);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const Vec3 outward = point(output, i) - Vec3{ 1.5, 1.5, 1.5 };
    EXPECT_NEAR(dot(outward, tuple(directions(output), i)), 1.5, 1e-12);
  }

  rays->SetSourceLocation(vtkLumiSurfaceRays::Points);
  rays->Update();
  const std::multiset<vtkIdType> points = ids(output, "SourcePointId");
  EXPECT_EQ(points.size(), 56u);
  EXPECT_EQ(points.count(0), 1u);
  EXPECT_EQ(points.count(21), 0u);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const auto source =
      static_cast<vtkIdType>(output->GetPointData()->GetArray("SourcePointId")->GetTuple1(i));
    EXPECT_EQ(point(output, i), point(image, source));
  }
}

TEST(SurfaceRays, FacesOfOneCellSendDifferentRays)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  vtkNew<vtkLumiSurfaceRays> rays;
  rays->SetInputData(image);
  rays->SetSourceLocation(vtkLumiSurfaceRays::Cells);
  rays->SetRaysPerSource(1);
  rays->Update();
  vtkPolyData* output = rays->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), 6);
  std::set<double> cosines;
  for (vtkIdType i = 0; i < 6; ++i)
  {
    const Vec3 outward = 2.0 * (point(output, i) - Vec3{ 0.5, 0.5, 0.5 });
    cosines.insert(dot(outward, tuple(directions(output), i)));
  }
  EXPECT_EQ(cosines.size(), 6u);
  EXPECT_GT(*cosines.begin(), 0.0);
}

TEST(SurfaceRays, SourcesWithoutNormalAreCountedInOneWarning)
{
  vtkNew<vtkPolyData> surface;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  points->InsertNextPoint(0.0, 1.0, 0.0);
  points->InsertNextPoint(2.0, 0.0, 0.0);
  points->InsertNextPoint(0.0, std::nan(""), 0.0);
  surface->SetPoints(points);
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 2 });
  polygons->InsertNextCell({ 0, 1, 3 }); // no area
  polygons->InsertNextCell({ 0, 1, 4 }); // not finite
  surface->SetPolys(polygons);
  vtkNew<vtkLumiSurfaceRays> rays;
  vtkNew<Messages> messages;
  messages->watch(rays);
  rays->SetInputData(surface);
  rays->SetRaysPerSource(1);
  rays->Update();
  // Points 3 and 4 have no cell with an area; the others keep the normal of the good triangle.
  EXPECT_EQ(ids(rays->GetOutput(), "SourcePointId"), (std::multiset<vtkIdType>{ 0, 1, 2 }));
  EXPECT_EQ(messages->warnings, 1);
  rays->SetSourceLocation(vtkLumiSurfaceRays::Cells);
  rays->Update();
  EXPECT_EQ(ids(rays->GetOutput(), "SourceCellId"), (std::multiset<vtkIdType>{ 0 }));
  EXPECT_EQ(messages->warnings, 2);

  // With normals in the data a cell needs no area, but still a place.
  addNormals(surface, 3);
  rays->Update();
  EXPECT_EQ(ids(rays->GetOutput(), "SourceCellId"), (std::multiset<vtkIdType>{ 0, 1 }));
  expectNear(point(rays->GetOutput(), 1), { 1.0, 0.0, 0.0 });
  EXPECT_EQ(messages->warnings, 3);
  EXPECT_EQ(messages->errors, 0);
}

TEST(SurfaceRays, AnEmptySurfaceIsNoError)
{
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkMultiBlockDataSet> emptyBlocks;
  for (vtkDataObject* input :
    { static_cast<vtkDataObject*>(empty), static_cast<vtkDataObject*>(emptyBlocks) })
  {
    vtkNew<vtkLumiSurfaceRays> rays;
    vtkNew<Messages> messages;
    messages->watch(rays);
    rays->SetInputData(input);
    rays->Update();
    EXPECT_EQ(rays->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_TRUE(directions(rays->GetOutput()));
    EXPECT_EQ(messages->errors + messages->warnings, 0);
  }
}

TEST(SurfaceRays, ATableAmongTheLeavesIsOneError)
{
  vtkNew<vtkTable> table;
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, plane(1));
  blocks->SetBlock(1, table);
  vtkNew<vtkLumiSurfaceRays> rays;
  vtkNew<Messages> messages;
  messages->watch(rays);
  rays->SetInputData(blocks);
  rays->Update();
  EXPECT_EQ(messages->errors, 1) << messages->last;
  EXPECT_EQ(rays->GetOutput()->GetNumberOfPoints(), 0);
}
