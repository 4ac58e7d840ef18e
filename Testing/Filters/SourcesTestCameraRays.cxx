// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SourcesTools.h"

#include "vtkLumiCameraRays.h"

#include "vtkCubeSource.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"

#include <cmath>
#include <functional>
#include <limits>

using namespace sources;

namespace
{

vtkDataArray* origins(vtkImageData* image)
{
  return image->GetPointData()->GetArray("RayOrigin");
}

/// Every point of the box is inside the image, seen from where the rays start.
void expectInView(vtkImageData* image, const Vec3& low, const Vec3& high)
{
  const vtkIdType last = image->GetNumberOfPoints() - 1;
  int size[3];
  image->GetDimensions(size);
  // The four corner rays span a pyramid that is half a pixel smaller than the image.
  const Vec3 eye = tuple(origins(image), 0);
  const std::array<Vec3, 4> corners = { tuple(directions(image), 0),
    tuple(directions(image), size[0] - 1), tuple(directions(image), last),
    tuple(directions(image), last - size[0] + 1) };
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vec3 p = { corner & 1 ? high[0] : low[0], corner & 2 ? high[1] : low[1],
      corner & 4 ? high[2] : low[2] };
    for (std::size_t k = 0; k < 4; ++k)
    {
      EXPECT_GT(dot(cross(corners[(k + 1) % 4], corners[k]), p - eye), 0.0)
        << "corner " << corner << ", side " << k;
    }
  }
}

}

TEST(CameraRays, ArraysFollowTheDataModel)
{
  vtkNew<vtkLumiCameraRays> camera;
  int resolution[2];
  camera->GetResolution(resolution);
  EXPECT_EQ(resolution[0], 640);
  EXPECT_EQ(resolution[1], 480);
  camera->Update();
  vtkImageData* image = camera->GetOutput();
  int size[3];
  image->GetDimensions(size);
  EXPECT_EQ(size[0], 640);
  EXPECT_EQ(size[1], 480);
  EXPECT_EQ(size[2], 1);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_EQ(image->GetOrigin()[k], 0.0);
    EXPECT_EQ(image->GetSpacing()[k], 1.0);
  }
  for (vtkDataArray* array : { origins(image), directions(image) })
  {
    ASSERT_TRUE(vtkDoubleArray::SafeDownCast(array));
    EXPECT_EQ(array->GetNumberOfComponents(), 3);
    EXPECT_EQ(array->GetNumberOfTuples(), 640 * 480);
  }
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    ASSERT_NEAR(length(tuple(directions(image), i)), 1.0, 1e-15);
    ASSERT_EQ(tuple(origins(image), i), (Vec3{ 0.0, 0.0, 1.0 }));
  }
}

TEST(CameraRays, MiddleRayMeetsFocalPoint)
{
  vtkNew<vtkLumiCameraRays> camera;
  camera->SetPosition(3.0, -4.0, 12.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetResolution(49, 31);
  camera->Update();
  const vtkIdType middle = 15 * 49 + 24;
  expectNear(tuple(directions(camera->GetOutput()), middle),
    { -3.0 / 13.0, 4.0 / 13.0, -12.0 / 13.0 }, 1e-15);
}

TEST(CameraRays, CornersAndRowOrder)
{
  vtkNew<vtkLumiCameraRays> camera;
  camera->SetViewAngle(90.0);
  camera->SetResolution(4, 2);
  camera->Update();
  // Half a height of 1 at distance 1: pixels are 1 x 1, the first one's middle is (-1.5, -0.5, -1).
  const auto direction = [](double x, double y) {
    return (1.0 / std::sqrt(x * x + y * y + 1.0)) * Vec3{ x, y, -1.0 };
  };
  vtkDataArray* array = directions(camera->GetOutput());
  expectNear(tuple(array, 0), direction(-1.5, -0.5));
  expectNear(tuple(array, 3), direction(1.5, -0.5));
  expectNear(tuple(array, 4), direction(-1.5, 0.5));
  expectNear(tuple(array, 7), direction(1.5, 0.5));
}

TEST(CameraRays, ParallelRaysStartInThePlaneOfTheImage)
{
  vtkNew<vtkLumiCameraRays> camera;
  camera->ParallelProjectionOn();
  camera->SetParallelScale(2.0);
  camera->SetPosition(10.0, 0.0, 5.0);
  camera->SetFocalPoint(10.0, 0.0, 0.0);
  camera->SetResolution(4, 2);
  camera->Update();
  vtkImageData* image = camera->GetOutput();
  for (vtkIdType i = 0; i < 8; ++i)
  {
    expectNear(tuple(directions(image), i), { 0.0, 0.0, -1.0 });
  }
  expectNear(tuple(origins(image), 0), { 7.0, -1.0, 5.0 });
  expectNear(tuple(origins(image), 7), { 13.0, 1.0, 5.0 });
}

TEST(CameraRays, PiecesHaveTheBitsOfTheWhole)
{
  vtkNew<vtkLumiCameraRays> camera;
  camera->SetResolution(37, 23);
  camera->SetPosition(1.0, 2.0, 3.0);
  camera->Update();
  vtkNew<vtkImageData> whole;
  whole->DeepCopy(camera->GetOutput());
  for (const int pieces : { 2, 3, 5 })
  {
    std::vector<int> seen(37 * 23, 0);
    for (int piece = 0; piece < pieces; ++piece)
    {
      camera->UpdatePiece(piece, pieces, 0);
      vtkImageData* part = camera->GetOutput();
      ASSERT_LT(part->GetNumberOfPoints(), whole->GetNumberOfPoints());
      const int* e = part->GetExtent();
      for (int j = e[2]; j <= e[3]; ++j)
      {
        for (int i = e[0]; i <= e[1]; ++i)
        {
          int ijk[3] = { i, j, 0 };
          const vtkIdType there = whole->ComputePointId(ijk);
          const vtkIdType here = part->ComputePointId(ijk);
          ++seen[there];
          ASSERT_EQ(tuple(directions(part), here), tuple(directions(whole), there));
          ASSERT_EQ(tuple(origins(part), here), tuple(origins(whole), there));
        }
      }
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 0), 0);
  }
}

TEST(CameraRays, AutomaticCameraSeesTheWholeScene)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(4.0, 5.0, -3.0, 7.0, 100.0, 101.0);
  cube->Update();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(2, cube->GetOutput());

  for (const std::array<int, 2> resolution : { std::array<int, 2>{ 64, 48 }, { 10, 90 } })
  {
    vtkNew<vtkLumiCameraRays> camera;
    camera->AutomaticCameraOn();
    camera->SetResolution(resolution[0], resolution[1]);
    camera->SetPosition(1.0, 1.0, 1.0);
    camera->SetSceneConnection(cube->GetOutputPort());
    camera->Update();
    expectInView(camera->GetOutput(), { 4.0, -3.0, 100.0 }, { 5.0, 7.0, 101.0 });
    const Vec3 origin = tuple(origins(camera->GetOutput()), 0);

    camera->SetSceneData(blocks);
    camera->Update();
    EXPECT_EQ(tuple(origins(camera->GetOutput()), 0), origin);
  }
}

TEST(CameraRays, AutomaticParallelCameraSpansTheScene)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0);
  vtkNew<vtkLumiCameraRays> camera;
  camera->AutomaticCameraOn();
  camera->ParallelProjectionOn();
  camera->SetResolution(100, 200);
  camera->SetSceneConnection(cube->GetOutputPort());
  camera->Update();
  // Half the width, which is the narrower way, is the radius of the sphere around the cube.
  const double half = std::sqrt(3.0);
  const Vec3 first = tuple(origins(camera->GetOutput()), 0);
  EXPECT_NEAR(first[0], -half * 0.99, 1e-12);
  EXPECT_NEAR(first[1], -2.0 * half * 0.995, 1e-12);
  EXPECT_GT(first[2], half);
}

TEST(CameraRays, AutomaticCameraTakesAnImageAsScene)
{
  // A structured scene has an extent of its own, which is not that of the rays.
  vtkNew<vtkImageData> scene;
  scene->SetExtent(-2, 2, -2, 2, -2, 2);
  vtkNew<vtkLumiCameraRays> camera;
  vtkNew<Messages> messages;
  messages->watch(camera);
  camera->AutomaticCameraOn();
  camera->SetResolution(30, 20);
  camera->SetSceneData(scene);
  camera->Update();
  EXPECT_EQ(messages->errors, 0);
  expectInView(camera->GetOutput(), { -2.0, -2.0, -2.0 }, { 2.0, 2.0, 2.0 });
}

TEST(CameraRays, WithoutASceneTheCameraIsAsGiven)
{
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkLumiCameraRays> camera;
  vtkNew<Messages> messages;
  messages->watch(camera);
  camera->AutomaticCameraOn();
  camera->SetResolution(3, 3);
  camera->Update();
  EXPECT_EQ(tuple(origins(camera->GetOutput()), 4), (Vec3{ 0.0, 0.0, 1.0 }));
  camera->SetSceneData(empty);
  camera->Update();
  EXPECT_EQ(tuple(origins(camera->GetOutput()), 4), (Vec3{ 0.0, 0.0, 1.0 }));
  EXPECT_EQ(messages->errors + messages->warnings, 0);
}

TEST(CameraRays, BadPropertiesAreOneErrorAndAnEmptyImage)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  using Break = std::function<void(vtkLumiCameraRays*)>;
  const Break breaks[] = {
    [](auto* c) { c->SetResolution(0, 10); },
    [](auto* c) { c->SetResolution(10, -1); },
    [=](auto* c) { c->SetPosition(nan, 0.0, 0.0); },
    [=](auto* c) { c->SetFocalPoint(0.0, inf, 0.0); },
    [=](auto* c) { c->SetViewUp(0.0, nan, 0.0); },
    [](auto* c) { c->SetFocalPoint(0.0, 0.0, 1.0); },
    [](auto* c) { c->SetViewUp(0.0, 0.0, 0.0); },
    [](auto* c) { c->SetViewUp(0.0, 0.0, -3.0); },
    [](auto* c) { c->SetViewAngle(0.0); },
    [](auto* c) { c->SetViewAngle(180.0); },
    [=](auto* c) { c->SetViewAngle(nan); },
    [](auto* c)
    {
      c->ParallelProjectionOn();
      c->SetParallelScale(-1.0);
    },
  };
  int number = 0;
  for (const Break& spoil : breaks)
  {
    SCOPED_TRACE(number++);
    vtkNew<vtkLumiCameraRays> camera;
    vtkNew<Messages> messages;
    messages->watch(camera);
    camera->SetResolution(5, 5);
    camera->Update();
    EXPECT_EQ(camera->GetOutput()->GetNumberOfPoints(), 25);
    spoil(camera);
    camera->Update();
    EXPECT_EQ(messages->errors, 1) << messages->last;
    EXPECT_EQ(camera->GetOutput()->GetNumberOfPoints(), 0);
  }
}
