// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SourcesTools.h"

#include "vtkLumiRays.h"

#include "vtkCallbackCommand.h"
#include "vtkFloatArray.h"

#include <cmath>
#include <functional>
#include <limits>

using namespace sources;

namespace
{

/// Sets each kind of rays in turn.
void setKind(vtkLumiRays* rays, int kind)
{
  rays->SetMode(std::min(kind, 2));
  rays->SetRandomOrigins(kind == 3 ? vtkLumiRays::OnSphere : vtkLumiRays::InBox);
}

}

TEST(Rays, GridRaysLeaveTheMiddlesOfCellsAlongTheNormal)
{
  vtkNew<vtkLumiRays> rays;
  rays->SetOrigin(1.0, 0.0, 0.0);
  rays->SetPoint1(5.0, 0.0, 0.0);
  rays->SetPoint2(1.0, 0.0, 2.0);
  rays->SetResolution(4, 2);
  rays->Update();
  vtkPolyData* output = rays->GetOutput();
  expectRays(output, 8);
  expectNear(point(output, 0), { 1.5, 0.0, 0.5 });
  expectNear(point(output, 1), { 2.5, 0.0, 0.5 });
  expectNear(point(output, 7), { 4.5, 0.0, 1.5 });
  expectNear(tuple(directions(output), 3), { 0.0, -1.0, 0.0 });
}

TEST(Rays, GridRaysFollowDirectionWhenAsked)
{
  vtkNew<vtkLumiRays> rays;
  rays->UsePlaneNormalOff();
  rays->SetDirection(0.0, -3.0, 4.0);
  rays->Update();
  expectRays(rays->GetOutput(), 100);
  expectNear(tuple(directions(rays->GetOutput()), 42), { 0.0, -0.6, 0.8 });
}

TEST(Rays, SphereDirectionsAreEvenlySpread)
{
  vtkNew<vtkLumiRays> rays;
  rays->SetMode(vtkLumiRays::SphereAroundPoint);
  rays->SetCenter(1.0, 2.0, 3.0);
  rays->SetNumberOfRays(2000);
  rays->Update();
  vtkPolyData* output = rays->GetOutput();
  expectRays(output, 2000);
  Vec3 mean = { 0.0, 0.0, 0.0 };
  double closest = 4.0;
  for (vtkIdType i = 0; i < 2000; ++i)
  {
    ASSERT_EQ(point(output, i), (Vec3{ 1.0, 2.0, 3.0 }));
    mean = mean + (1.0 / 2000) * tuple(directions(output), i);
    for (vtkIdType j = 0; j < i; ++j)
    {
      closest =
        std::min(closest, length(tuple(directions(output), i) - tuple(directions(output), j)));
    }
  }
  expectNear(mean, { 0.0, 0.0, 0.0 }, 1e-4);
  // Spherical Fibonacci points keep about 3.09 / sqrt(N) apart; hexagons could do 3.81.
  EXPECT_GT(closest * std::sqrt(2000.0), 3.0);
}

TEST(Rays, RandomRaysFillTheBoxAndTheSphereOfDirections)
{
  vtkNew<vtkLumiRays> rays;
  rays->SetMode(vtkLumiRays::Random);
  rays->SetBounds(0.0, 1.0, -2.0, 2.0, 5.0, 5.0);
  rays->SetNumberOfRays(100000);
  rays->Update();
  vtkPolyData* output = rays->GetOutput();
  expectRays(output, 100000);
  Vec3 position = { 0.0, 0.0, 0.0 };
  Vec3 direction = position;
  Vec3 square = position;
  for (vtkIdType i = 0; i < 100000; ++i)
  {
    const Vec3 p = point(output, i);
    ASSERT_TRUE(p[0] >= 0.0 && p[0] <= 1.0 && p[1] >= -2.0 && p[1] <= 2.0 && p[2] == 5.0);
    const Vec3 d = tuple(directions(output), i);
    position = position + 1e-5 * p;
    direction = direction + 1e-5 * d;
    square = square + 1e-5 * Vec3{ d[0] * d[0], d[1] * d[1], d[2] * d[2] };
  }
  // Five standard errors: sd / sqrt(1e5) is 0.0009 for x, 0.0037 for y, 0.0018 and 0.0009 below.
  EXPECT_NEAR(position[0], 0.5, 0.005);
  EXPECT_NEAR(position[1], 0.0, 0.02);
  expectNear(direction, { 0.0, 0.0, 0.0 }, 0.01);
  expectNear(square, { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 }, 0.005);
}

TEST(Rays, RaysFromASphereAreUniformLines)
{
  vtkNew<vtkLumiRays> rays;
  rays->SetMode(vtkLumiRays::Random);
  rays->SetRandomOrigins(vtkLumiRays::OnSphere);
  rays->SetCenter(1.0, 2.0, 3.0);
  rays->SetRadius(2.0);
  rays->SetNumberOfRays(100000);
  rays->Update();
  vtkPolyData* output = rays->GetOutput();
  expectRays(output, 100000);
  double chord = 0.0;
  for (vtkIdType i = 0; i < 100000; ++i)
  {
    const Vec3 outward = 0.5 * (point(output, i) - Vec3{ 1.0, 2.0, 3.0 });
    ASSERT_NEAR(length(outward), 1.0, 1e-14);
    const double cosine = -dot(outward, tuple(directions(output), i));
    ASSERT_GT(cosine, 0.0);
    chord += 1e-5 * 2.0 * 2.0 * cosine;
  }
  // Cauchy: the mean chord of a convex body under uniform lines is 4 V / S, of a sphere 4 R / 3.
  EXPECT_NEAR(chord, 8.0 / 3.0, 5 * 0.95 / std::sqrt(1e5));
}

TEST(Rays, PiecesInOrderAreTheWhole)
{
  for (int kind = 0; kind < 4; ++kind)
  {
    SCOPED_TRACE(kind);
    vtkNew<vtkLumiRays> rays;
    setKind(rays, kind);
    rays->SetNumberOfRays(101);
    rays->SetResolution(7, 5);
    rays->Update();
    vtkNew<vtkPolyData> whole;
    whole->DeepCopy(rays->GetOutput());
    for (const int pieces : { 2, 3, 200 })
    {
      vtkIdType i = 0;
      for (int piece = 0; piece < pieces; ++piece)
      {
        rays->UpdatePiece(piece, pieces, 0);
        vtkPolyData* part = rays->GetOutput();
        EXPECT_EQ(part->GetNumberOfVerts(), part->GetNumberOfPoints());
        for (vtkIdType j = 0; j < part->GetNumberOfPoints(); ++j, ++i)
        {
          ASSERT_EQ(point(part, j), point(whole, i));
          ASSERT_EQ(tuple(directions(part), j), tuple(directions(whole), i));
        }
      }
      EXPECT_EQ(i, whole->GetNumberOfPoints());
    }
  }
}

TEST(Rays, SeedChoosesTheSet)
{
  vtkNew<vtkLumiRays> first;
  vtkNew<vtkLumiRays> second;
  for (vtkLumiRays* rays : { first.Get(), second.Get() })
  {
    rays->SetMode(vtkLumiRays::Random);
    rays->SetNumberOfRays(10);
    rays->SetSeed(7);
    rays->Update();
  }
  EXPECT_EQ(point(first->GetOutput(), 9), point(second->GetOutput(), 9));
  second->SetSeed(-7);
  second->Update();
  for (vtkIdType i = 0; i < 10; ++i)
  {
    EXPECT_NE(point(first->GetOutput(), i), point(second->GetOutput(), i));
    EXPECT_NE(tuple(directions(first->GetOutput()), i), tuple(directions(second->GetOutput()), i));
  }
}

TEST(Rays, PrecisionOfTheOutputCanBeChosen)
{
  vtkNew<vtkLumiRays> rays;
  rays->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  rays->Update();
  EXPECT_EQ(rays->GetOutput()->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_TRUE(vtkFloatArray::SafeDownCast(directions(rays->GetOutput())));
}

TEST(Rays, AbortLeavesAnEmptyOutput)
{
  vtkNew<vtkLumiRays> rays;
  vtkNew<Messages> messages;
  messages->watch(rays);
  rays->SetMode(vtkLumiRays::Random);
  rays->SetNumberOfRays(200000);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  rays->AddObserver(vtkCommand::ProgressEvent, stop);
  rays->Update();
  EXPECT_EQ(rays->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(messages->errors, 0);
}

TEST(Rays, ValuesAreFixed)
{
  // Written down from one machine: another one must find the same bits.
  vtkNew<vtkLumiRays> rays;
  rays->SetMode(vtkLumiRays::Random);
  rays->SetSeed(7);
  rays->SetNumberOfRays(5);
  rays->Update();
  EXPECT_EQ(point(rays->GetOutput(), 4),
    (Vec3{ 0x1.1b258d1bdd3eap-2, -0x1.4b40256ad8c32p-2, 0x1.6718d3bd09e58p-4 }));
  EXPECT_EQ(tuple(directions(rays->GetOutput()), 4),
    (Vec3{ -0x1.c6a48ec4a0046p-1, 0x1.832be7f57539ap-3, -0x1.ad4d52706be64p-2 }));
}

TEST(Rays, BadPropertiesAreOneErrorAndAnEmptyOutput)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using Break = std::function<void(vtkLumiRays*)>;
  struct Case
  {
    int kind;
    Break spoil;
  };
  const Case cases[] = {
    { 0, [](auto* r) { r->SetResolution(0, 3); } },
    { 0, [](auto* r) { r->SetPoint1(-0.5, -0.5, 0.0); } },
    { 0, [](auto* r) { r->SetPoint2(3.5, -0.5, 0.0); } },
    { 0, [=](auto* r) { r->SetOrigin(nan, 0.0, 0.0); } },
    { 0,
      [](auto* r)
      {
        r->UsePlaneNormalOff();
        r->SetDirection(0.0, 0.0, 0.0);
      } },
    { 1, [](auto* r) { r->SetNumberOfRays(0); } },
    { 1, [=](auto* r) { r->SetCenter(0.0, 0.0, nan); } },
    { 2, [](auto* r) { r->SetBounds(1.0, 0.0, 0.0, 1.0, 0.0, 1.0); } },
    { 2, [=](auto* r) { r->SetBounds(0.0, 1.0, 0.0, nan, 0.0, 1.0); } },
    { 2, [](auto* r) { r->SetNumberOfRays(-5); } },
    { 3, [](auto* r) { r->SetRadius(0.0); } },
    { 3, [=](auto* r) { r->SetRadius(nan); } },
  };
  int number = 0;
  for (const Case& c : cases)
  {
    SCOPED_TRACE(number++);
    vtkNew<vtkLumiRays> rays;
    vtkNew<Messages> messages;
    messages->watch(rays);
    setKind(rays, c.kind);
    rays->Update();
    EXPECT_GT(rays->GetOutput()->GetNumberOfPoints(), 0);
    c.spoil(rays);
    rays->Update();
    EXPECT_EQ(messages->errors, 1) << messages->last;
    EXPECT_EQ(rays->GetOutput()->GetNumberOfPoints(), 0);
  }
}
