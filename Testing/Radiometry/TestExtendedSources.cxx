// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Reference values, each computed twice with 30 digits: the closed form, and quadrature of the
// integral that defines the quantity.
#include "SourceChecks.h"

#include "Radiometry/Constants.h"
#include "Radiometry/PolygonSource.h"
#include "Radiometry/SkySource.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

using namespace lumitree;
using sourcechecks::expectRelative;
using sourcechecks::expectSamplesMeanIrradiance;

const Vec3 origin = { 0.0, 0.0, 0.0 };
const Vec3 up = { 0.0, 0.0, 1.0 };

/// A rectangle at that height that shines down.
PolygonSource ceiling(double x0, double x1, double y0, double y1, double height)
{
  return PolygonSource(
    { { { { x0, y0, height }, { x0, y1, height }, { x1, y1, height }, { x1, y0, height } }, {},
      100.0, false } });
}

PolygonSource triangle(const Vec3& a, const Vec3& b, const Vec3& c)
{
  return PolygonSource({ { { a, b, c }, {}, 100.0, true } });
}

TEST(PolygonSource, RectanglesOverAndBesideAReceiver)
{
  expectRelative(ceiling(0.0, 2.0, 0.0, 3.0, 1.5).irradiance(origin, up), 59.0882481095204);
  // Upright, at a distance of 1.5: height 2, width 3.
  const PolygonSource window(
    { { { { 1.5, 0.0, 0.0 }, { 1.5, 0.0, 2.0 }, { 1.5, 3.0, 2.0 }, { 1.5, 3.0, 0.0 } }, {}, 100.0,
      true } });
  expectRelative(window.irradiance(origin, up), 29.07569437175872);
}

TEST(PolygonSource, SquareNearAndFar)
{
  expectRelative(ceiling(-0.5, 0.5, -0.5, 0.5, 1.0).irradiance(origin, up), 75.22746884541075);
  expectRelative(ceiling(-0.5, 0.5, -0.5, 0.5, 1e-3).irradiance(origin, up), 314.1582370439335);
  expectRelative(ceiling(-0.5, 0.5, -0.5, 0.5, 1e6).irradiance(origin, up), 9.999999999996667e-11);
}

TEST(PolygonSource, TrianglesObliqueAndCutByTheHorizon)
{
  expectRelative(
    triangle({ 1.0, 0.2, 1.5 }, { -0.5, 1.2, 2.0 }, { -0.3, -0.9, 1.0 }).irradiance(origin, up),
    54.49364922819212);
  expectRelative(
    triangle({ 2.0, 0.0, 1.0 }, { 2.0, 2.0, -1.0 }, { 2.0, -1.0, -0.5 }).irradiance(origin, up),
    2.917415718833383);
}

TEST(PolygonSource, FromNearToFarWithoutAStep)
{
  // Where one way of computing takes over from another, both give the same.
  for (const double tilt : { 0.0, 0.5, 1.4 })
  {
    const Vec3 normal = { std::sin(tilt), 0.0, std::cos(tilt) };
    for (const double sizes : { 99.0, 100.0, 101.0, 4.9e5, 5.1e5, 1e6, 1e9 })
    {
      const double h = sizes * std::sqrt(2.0);
      const PolygonSource square = ceiling(-0.5, 0.5, -0.5, 0.5, h);
      // The series of the rectangle's closed form in 1 / h, on its axis.
      const double expected = 100.0 / (h * h) * (1.0 - 1.0 / (3.0 * h * h)) * std::cos(tilt);
      sourcechecks::expectRelative(square.irradiance(origin, normal), expected, 1e-8);
      sourcechecks::expectRelative(
        dot(square.lightVector(origin), normal), square.irradiance(origin, normal), 1e-11);
      sourcechecks::expectRelative(square.scalarIrradiance(origin), 100.0 / (h * h), 1e-4);
    }
  }
}

TEST(PolygonSource, PartsAddUp)
{
  // An L, as one polygon that is not convex and as two rectangles; seen from many places.
  const PolygonSource whole({ { { { 0.0, 0.0, 2.0 }, { 0.0, 2.0, 2.0 }, { 1.0, 2.0, 2.0 },
                                  { 1.0, 1.0, 2.0 }, { 3.0, 1.0, 2.0 }, { 3.0, 0.0, 2.0 } },
    {}, 100.0, false } });
  const PolygonSource parts(
    { { { { 0.0, 0.0, 2.0 }, { 0.0, 2.0, 2.0 }, { 1.0, 2.0, 2.0 }, { 1.0, 0.0, 2.0 } }, {}, 100.0,
        false },
      { { { 1.0, 0.0, 2.0 }, { 1.0, 1.0, 2.0 }, { 3.0, 1.0, 2.0 }, { 3.0, 0.0, 2.0 } }, {}, 100.0,
        false } });
  EXPECT_NEAR(*whole.flux(), 400.0 * pi, 1e-9);
  for (const double x : { -3.0, 0.5, 2.0, 6.0 })
  {
    for (const double z : { -4.0, 1.0, 1.999, 1.999999 })
    {
      const Vec3 position = { x, 1.7 * x - 0.3, z };
      for (const Vec3& normal : { up, Vec3{ 0.6, 0.0, 0.8 }, Vec3{ 0.0, -1.0, 0.0 } })
      {
        EXPECT_NEAR(whole.irradiance(position, normal), parts.irradiance(position, normal), 1e-10);
      }
      EXPECT_NEAR(whole.scalarIrradiance(position), parts.scalarIrradiance(position), 1e-10);
    }
  }
  expectSamplesMeanIrradiance(whole, { 0.5, 0.5, 1.0 }, { 0.6, 0.0, 0.8 }, 1e-2);
  expectSamplesMeanIrradiance(parts, { 5.0, 0.5, 0.0 }, up, 1e-3);
}

TEST(PolygonSource, OneSidedAndTwoSided)
{
  const std::vector<Vec3> corners = { { -1.0, -1.0, 0.0 }, { 1.0, -1.0, 0.0 }, { 1.0, 1.0, 0.0 },
    { -1.0, 1.0, 0.0 } };
  const PolygonSource one({ { corners, {}, 5.0, false } });
  const PolygonSource two({ { corners, {}, 5.0, true } });
  const Vec3 below = { 0.2, 0.1, -1.0 };
  const Vec3 above = { 0.2, 0.1, 1.0 };
  const Vec3 down = { 0.0, 0.0, -1.0 };
  EXPECT_EQ(one.irradiance(below, up), 0.0);
  EXPECT_EQ(one.scalarIrradiance(below), 0.0);
  EXPECT_EQ(one.lightVector(below), origin);
  EXPECT_EQ(one.radiance(below, up), 0.0);
  EXPECT_EQ(one.sample(below, 0.3, 0.4).weight, 0.0);
  EXPECT_GT(one.irradiance(above, down), 0.0);
  EXPECT_NEAR(two.irradiance(below, up), one.irradiance(above, down), 1e-14);
  EXPECT_EQ(two.radiance(below, up), 5.0);
  EXPECT_EQ(two.radiance(below, { 2.0, 0.0, 1.0 }), 0.0);
  EXPECT_EQ(*two.flux(), 2.0 * *one.flux());
  EXPECT_NEAR(*one.intensity(up), 20.0, 1e-13);
  EXPECT_EQ(*one.intensity(down), 0.0);
  EXPECT_NEAR(*two.intensity(down), 20.0, 1e-13);
  EXPECT_TRUE(one.extended());
  EXPECT_EQ(one.polygons()->front().normal, up);
}

TEST(PolygonSource, SamplesAreWhatTheySay)
{
  const PolygonSource near = ceiling(-0.5, 0.5, -0.5, 0.5, 0.05);
  expectSamplesMeanIrradiance(near, { 0.1, 0.2, 0.0 }, up, 1e-2);
  const PolygonSource far = ceiling(-0.5, 0.5, -0.5, 0.5, 500.0);
  expectSamplesMeanIrradiance(far, origin, up, 1e-5);
  // More triangles than are weighed one by one.
  std::vector<EmittingPolygon> strip;
  for (int i = 0; i < 100; ++i)
  {
    const double x = 0.1 * i;
    strip.push_back(
      { { { x, 0.0, 2.0 }, { x, 1.0, 2.0 }, { x + 0.1, 1.0, 2.0 } }, {}, 1.0 + i % 3, false });
  }
  expectSamplesMeanIrradiance(PolygonSource(strip), { 1.0, 0.0, 0.0 }, up, 2e-2);
}

TEST(PolygonSource, InItsPlaneAndOnIt)
{
  const PolygonSource square = ceiling(-0.5, 0.5, -0.5, 0.5, 0.0);
  for (const Vec3& position : { origin, Vec3{ 0.5, 0.5, 0.0 }, Vec3{ 0.5, 0.0, 0.0 },
         Vec3{ 2.0, 0.0, 0.0 }, Vec3{ 1e6, 1e6, 0.0 } })
  {
    EXPECT_EQ(square.irradiance(position, up), 0.0);
    EXPECT_EQ(square.scalarIrradiance(position), 0.0);
    EXPECT_EQ(square.lightVector(position), origin);
    EXPECT_EQ(square.sample(position, 0.5, 0.5).weight, 0.0);
  }
}

TEST(PolygonSource, NeverNegativeNorNaN)
{
  sourcechecks::expectSane(ceiling(-0.5, 0.5, -0.5, 0.5, 0.0), origin, 1.0);
  const double far = 5e6;
  sourcechecks::expectSane(
    PolygonSource(
      { { { { far, far, far }, { far + 1.0, far + 0.3, far }, { far, far + 1.0, far + 0.7 } }, {},
        100.0, true } }),
    { far, far, far }, 1.0);
}

TEST(PolygonSource, LengthsAreMetres)
{
  const std::vector<Vec3> corners = { { 0.0, 0.0, 0.0 }, { 1000.0, 0.0, 0.0 },
    { 0.0, 1000.0, 0.0 } };
  const PolygonSource source({ { corners, {}, 1.0, false } }, 1e-3);
  EXPECT_NEAR(*source.flux(), 0.5 * pi, 1e-14);
  EXPECT_NEAR(*source.intensity(up), 0.5, 1e-14);
}

TEST(PolygonSource, RefusesWhatIsNoSource)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto make = [](std::vector<Vec3> corners, double radiance) {
    PolygonSource({ { std::move(corners), {}, radiance, false } });
  };
  EXPECT_THROW(make({ origin, up }, 1.0), std::invalid_argument);
  EXPECT_THROW(make({ origin, up, { nan, 0.0, 0.0 } }, 1.0), std::invalid_argument);
  EXPECT_THROW(make({ origin, up, { 1.0, 0.0, 0.0 } }, -1.0), std::invalid_argument);
  EXPECT_THROW(make({ origin, up, { 1.0, 0.0, 0.0 } }, nan), std::invalid_argument);
  EXPECT_NO_THROW(PolygonSource({}));
  const PolygonSource flat({ { { origin, up, { 0.0, 0.0, 2.0 } }, {}, 1.0, false } });
  EXPECT_EQ(flat.irradiance({ 1.0, 0.0, 0.0 }, { -1.0, 0.0, 0.0 }), 0.0);
  EXPECT_EQ(flat.sample({ 1.0, 0.0, 0.0 }, 0.5, 0.5).weight, 0.0);
}

TEST(UniformSky, HorizontalVerticalAndTilted)
{
  const UniformSky sky(1.0);
  expectRelative(sky.irradiance(origin, up), pi);
  expectRelative(sky.irradiance(origin, { 1.0, 0.0, 0.0 }), pi / 2.0);
  const double b = 36.0 * pi / 180.0;
  expectRelative(sky.irradiance(origin, { std::sin(b), 0.0, std::cos(b) }), 2.841597249873712);
  expectRelative(sky.scalarIrradiance(origin), 2.0 * pi);
  EXPECT_EQ(sky.radiance(origin, { 0.0, 3.0, 0.1 }), 1.0);
  EXPECT_EQ(sky.radiance(origin, { 0.0, 3.0, -0.1 }), 0.0);
  expectSamplesMeanIrradiance(sky, origin, { 0.6, 0.0, 0.8 }, 1e-2);
}

TEST(UniformSky, WithAGround)
{
  const UniformSky sky(2.0, { 0.0, 3.0, 0.0 }, 0.5);
  expectRelative(sky.irradiance(origin, { 0.0, -1.0, 0.0 }), pi / 2.0);
  expectRelative(sky.irradiance(origin, { 1.0, 0.0, 0.0 }), pi * 1.25);
  expectRelative(sky.lightVector(origin)[1], 1.5 * pi);
  expectRelative(sky.scalarIrradiance(origin), 5.0 * pi);
  expectSamplesMeanIrradiance(sky, origin, { 1.0, 0.0, 0.0 }, 1e-2);
  EXPECT_THROW(UniformSky(-1.0), std::invalid_argument);
  EXPECT_THROW(UniformSky(1.0, origin), std::invalid_argument);
}

} // namespace
