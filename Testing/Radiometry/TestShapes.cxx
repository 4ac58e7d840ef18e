// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Reference values, each computed twice with 30 digits: the closed form, and quadrature of the
// integral that defines the quantity.
#include "SourceChecks.h"

#include "Radiometry/CapLight.h"
#include "Radiometry/Constants.h"
#include "Radiometry/DiskSource.h"
#include "Radiometry/Integration/GaussLegendre.h"
#include "Radiometry/LineSource.h"
#include "Radiometry/PolygonSource.h"
#include "Radiometry/SphereSource.h"
#include "Radiometry/TubeSource.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

using namespace lumitree;
using sourcechecks::expectFluxThroughSphere;
using sourcechecks::expectRelative;
using sourcechecks::expectSamplesMeanIrradiance;
using sourcechecks::expectSane;

const Vec3 origin = { 0.0, 0.0, 0.0 };
const Vec3 up = { 0.0, 0.0, 1.0 };
const Vec3 down = { 0.0, 0.0, -1.0 };
constexpr double degree = pi / 180.0;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A regular polygon of the area of the disk: what the disk gives, to the second order.
PolygonSource polygonLike(const DiskSource& disk)
{
  constexpr int corners = 1000;
  const Frame frame = Frame::around(disk.normal());
  const double step = 2.0 * pi / corners;
  const double radius = disk.radius() * std::sqrt(step / std::sin(step));
  EmittingPolygon polygon;
  for (int i = 0; i < corners; ++i)
  {
    polygon.corners.push_back(disk.centre() + (radius * std::cos(step * i)) * frame.x +
      (radius * std::sin(step * i)) * frame.y);
  }
  polygon.radiance = 100.0;
  polygon.twoSided = disk.twoSided();
  return PolygonSource({ polygon });
}

TEST(DiskSource, OnAndBesideItsAxis)
{
  const DiskSource disk(100.0, { 0.0, 0.0, 2.0 }, down, 1.0);
  expectRelative(disk.irradiance(origin, up), 62.83185307179586);
  expectRelative(disk.irradiance({ 1.5, 0.0, 0.0 }, up), 32.13351027517011);
  expectRelative(disk.irradiance({ 1.5, 0.0, 0.0 }, { -1.0, 0.0, 0.0 }), 20.62001672736408);
  expectRelative(disk.scalarIrradiance(origin), 66.33335223470054);
  // The light vector on the axis, and the irradiance of a plane tilted by 30°.
  expectRelative(disk.irradiance(origin, { 0.5, 0.0, std::sqrt(0.75) }), 54.41398092702654);
  expectRelative(length(disk.lightVector(origin)), 62.83185307179586);
  // Ten radii away a point of the same intensity gives 1 % more.
  const double far = DiskSource(100.0, { 0.0, 0.0, 10.0 }, down, 1.0).irradiance(origin, up);
  expectRelative(pi * 100.0 / 100.0 / far - 1.0, 0.01);
}

TEST(DiskSource, CollectedByAnInfinitePlane)
{
  // ∫ E 2πr dr from 0 to infinity, r = h tan t.
  const DiskSource disk(100.0, { 0.0, 0.0, 2.0 }, down, 1.0);
  constexpr int steps = 4000;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    const double t = 0.5 * pi * (i + 0.5) / steps;
    const double r = 2.0 * std::tan(t);
    const double dr = 2.0 / (std::cos(t) * std::cos(t)) * 0.5 * pi / steps;
    sum += disk.irradiance({ r, 0.0, 0.0 }, up) * 2.0 * pi * r * dr;
  }
  expectRelative(sum, 986.9604401089359, 1e-5);
  expectRelative(*disk.flux(), 986.9604401089359);
}

TEST(DiskSource, CutByTheHorizon)
{
  for (const double height : { 0.02, 0.5, 3.0, 40.0, 150.0 })
  {
    for (const double tilt : { 88.0, 90.0, 95.0, 120.0, 150.0 })
    {
      const DiskSource disk(100.0, { 0.3 * height, 0.2, height }, { 0.1, 0.0, -1.0 }, 1.0, true);
      const PolygonSource polygon = polygonLike(disk);
      for (const double turn : { 0.0, 1.0, 2.5, 4.0 })
      {
        const Vec3 normal = { std::sin(tilt * degree) * std::cos(turn),
          std::sin(tilt * degree) * std::sin(turn), std::cos(tilt * degree) };
        const double reference = polygon.irradiance(origin, normal);
        EXPECT_NEAR(disk.irradiance(origin, normal), reference, 1e-4 * reference + 1e-8)
          << height << " " << tilt << " " << turn;
      }
      expectRelative(disk.scalarIrradiance(origin), polygon.scalarIrradiance(origin), 1e-4);
    }
  }
}

TEST(DiskSource, SolidAngleWithoutAStep)
{
  // Where the elliptic integrals give way to cubature; over the edge; close to the plane.
  for (const double angle : { 0.0, 0.4, 1.2 })
  {
    const auto at = [&](double d) {
      return Vec3{ d * std::sin(angle), 0.0, -d * std::cos(angle) };
    };
    const DiskSource disk(1.0, origin, down, 1.0);
    expectRelative(disk.scalarIrradiance(at(20.0 + 1e-9)), disk.scalarIrradiance(at(20.0)), 1e-9);
  }
  const DiskSource disk(1.0, origin, down, 1.0);
  expectRelative(disk.scalarIrradiance({ 1.0, 0.0, -0.5 }),
    disk.scalarIrradiance({ 1.0 + 1e-12, 0.0, -0.5 }), 1e-9);
  EXPECT_NEAR(disk.scalarIrradiance({ 0.3, 0.0, -1e-9 }), 2.0 * pi, 1e-7);
  EXPECT_NEAR(disk.scalarIrradiance({ 1.3, 0.0, -1e-9 }), 0.0, 1e-7);
}

TEST(DiskSource, SaneAndSampled)
{
  const DiskSource disk(100.0, { 0.2, 0.1, 0.5 }, { 0.3, 0.0, -1.0 }, 1.0);
  expectSamplesMeanIrradiance(disk, { 0.0, 0.0, -1.0 }, { 0.6, 0.0, 0.8 }, 1e-3);
  expectSane(DiskSource(100.0, origin, { 1.0, 2.0, 3.0 }, 1.0, true), origin, 1.0);
  expectSane(DiskSource(100.0, { 5e6, -5e6, 5e6 }, down, 1.0), { 5e6, -5e6, 5e6 }, 1.0);
  expectFluxThroughSphere(DiskSource(100.0, origin, up, 1.0, true), origin, 3.0, 1e-3);
  EXPECT_EQ(disk.radiance({ 0.0, 0.0, -1.0 }, up), 100.0);
  EXPECT_EQ(disk.radiance({ 0.0, 0.0, -1.0 }, down), 0.0);
  EXPECT_EQ(disk.radiance({ 0.0, 0.0, -1.0 }, { 3.0, 0.0, 1.0 }), 0.0);
  EXPECT_THROW(DiskSource(1.0, origin, up, 0.0), std::invalid_argument);
  EXPECT_THROW(DiskSource(1.0, origin, origin, 1.0), std::invalid_argument);
  EXPECT_THROW(DiskSource(-1.0, origin, up, 1.0), std::invalid_argument);
}

TEST(SphereSource, AboveAndCutByTheHorizon)
{
  const SphereSource sphere(100.0, { 0.0, 0.0, 3.0 }, 1.0);
  const auto tilted = [](double degrees) {
    return Vec3{ std::sin(degrees * degree), 0.0, std::cos(degrees * degree) };
  };
  expectRelative(sphere.irradiance(origin, tilted(40.0)), 26.73999549806517);
  expectRelative(sphere.irradiance(origin, tilted(100.0)), 0.4607194023451867);
  expectRelative(sphere.scalarIrradiance(origin), 35.93413896350981);
  EXPECT_EQ(sphere.irradiance(origin, tilted(120.0)), 0.0);
  // At the limits of the two formulas nothing jumps.
  const double limit = std::acos(1.0 / 3.0) / degree;
  expectRelative(sphere.irradiance(origin, tilted(limit + 1e-7)),
    sphere.irradiance(origin, tilted(limit - 1e-7)), 1e-7);
}

TEST(ViewFactors, FromASphereAndFromADiskToADisk)
{
  // ∫ E dA / Φ over rings of the receiving disk.
  const SphereSource sphere(100.0, { 0.0, 0.0, 3.0 }, 0.5);
  const double caught = integrate<40>(0.0, 2.0,
    [&](double r) {
      return 2.0 * pi * r * sphere.irradiance({ r, 0.0, 0.0 }, up);
    });
  expectRelative(caught / *sphere.flux(), 0.08397485283107816);
  const DiskSource disk(100.0, { 0.0, 0.0, 1.5 }, down, 1.0);
  const double onDisk = integrate<60>(0.0, 2.0,
    [&](double r) {
      return 2.0 * pi * r * disk.irradiance({ r, 0.0, 0.0 }, up);
    });
  expectRelative(onDisk / *disk.flux(), 0.6016533443880439);
}

TEST(ViewFactors, BetweenParallelRectangles)
{
  const auto factor = [](double a, double b)
  {
    const PolygonSource source(
      { { { { 0.0, 0.0, 1.0 }, { 0.0, b, 1.0 }, { a, b, 1.0 }, { a, 0.0, 1.0 } }, {}, 100.0,
        false } });
    const double caught = integrate<40>(0.0, a,
      [&](double x) {
        return integrate<40>(0.0, b,
          [&](double y) {
            return source.irradiance({ x, y, 0.0 }, up);
          });
      });
    return caught / *source.flux();
  };
  expectRelative(factor(1.0, 1.0), 0.1998248956983874);
  expectRelative(factor(3.0, 2.0), 0.4755764365329529);
}

TEST(ViewFactors, BetweenRectanglesWithACommonEdge)
{
  // The irradiance is not smooth at the edge, where both meet: x = s⁴.
  const auto factor = [](double width, double floor, double wall)
  {
    const PolygonSource source(
      { { { { 0.0, 0.0, 0.0 }, { 0.0, width, 0.0 }, { 0.0, width, wall }, { 0.0, 0.0, wall } }, {},
        100.0, true } });
    const double caught = 2.0 *
      integrate<60>(0.0, std::pow(floor, 0.25),
        [&](double s)
        {
          const double x = s * s * s * s;
          return 4.0 * s * s * s *
            integrate<60>(0.0, std::pow(0.5 * width, 0.25),
              [&](double t)
              {
                const double y = t * t * t * t;
                return 4.0 * t * t * t * source.irradiance({ x, y, 0.0 }, up);
              });
        });
    return caught / (pi * 100.0 * width * floor);
  };
  expectRelative(factor(1.0, 1.0, 1.0), 0.2000437760754032, 1e-6);
  // From the floor to the wall; the areas exchange the factors.
  expectRelative(factor(1.0, 2.0, 0.5), 0.07865027050598076, 1e-6);
}

TEST(SphereSource, SmallCapsKeepTheirDigits)
{
  // Half of a cap is above the horizon: E → 2/3 sin³α for small α.
  for (const double k : { 1e-1, 1e-3, 1e-6, 1e-12 })
  {
    expectRelative(capIrradiance(k, 0.0), 2.0 / 3.0 * k * k * k, 0.6 * k * k + 1e-14);
    expectRelative(capIrradiance(k, k), pi * k * k * k, 1e-14);
    expectRelative(capIrradiance(k, k * (1.0 - 1e-12)), pi * k * k * k, 1e-11);
    EXPECT_EQ(capIrradiance(k, -k), 0.0);
  }
  EXPECT_NEAR(capIrradiance(1.0, 0.0), 0.5 * pi, 1e-15); // a hemisphere, edge on
}

TEST(SphereSource, SaneAndSampled)
{
  const SphereSource sphere(100.0, { 0.0, 0.5, 2.0 }, 1.0);
  expectSamplesMeanIrradiance(sphere, origin, { 0.0, 0.6, 0.8 }, 1e-4);
  expectSamplesMeanIrradiance(sphere, origin, { 0.0, 0.9600, -0.28 }, 1e-2);
  expectSane(SphereSource(100.0, { 5e6, 5e6, 5e6 }, 1.0), { 5e6, 5e6, 5e6 }, 1.0);
  expectSane(SphereSource(100.0, origin, 1.0), origin, 1.0);
  EXPECT_EQ(sphere.irradiance({ 0.0, 0.5, 2.2 }, up), 0.0); // within
  EXPECT_EQ(sphere.sample({ 0.0, 0.5, 2.2 }, 0.5, 0.5).weight, 0.0);
  EXPECT_EQ(sphere.radiance(origin, { 0.0, 0.5, 2.0 }), 100.0);
  EXPECT_EQ(sphere.radiance(origin, { 0.0, -0.5, -2.0 }), 0.0);
  expectFluxThroughSphere(SphereSource(100.0, { 0.2, 0.1, 0.3 }, 0.5), origin, 3.0, 1e-4);
  EXPECT_THROW(SphereSource(1.0, origin, -1.0), std::invalid_argument);
  EXPECT_THROW(SphereSource(nan, origin, 1.0), std::invalid_argument);
}

TEST(LineSource, UnderItsEnd)
{
  const Vec3 begin = { 0.0, 0.0, 2.0 };
  const Vec3 end = { 1.2, 0.0, 2.0 };
  expectRelative(LineSource(100.0, begin, end).irradiance(origin, up), 24.53989927147049);
  expectRelative(
    LineSource(100.0, begin, end, LineSource::Distribution::Isotropic).irradiance(origin, up),
    25.72478777137633);
}

TEST(LineSource, IsTheSumOfItsParts)
{
  for (const auto distribution :
    { LineSource::Distribution::Lambertian, LineSource::Distribution::Isotropic })
  {
    for (const Vec3& position : { Vec3{ 0.3, 0.2, 0.0 }, Vec3{ -5.0, 1e-4, 2.0 },
           Vec3{ -400.0, 3.0, 20.0 }, Vec3{ 0.5, 0.0, 1.999 } })
    {
      const LineSource line(100.0, { 0.0, 0.0, 2.0 }, { 1.2, 0.4, 2.5 }, distribution);
      for (const Vec3& normal : { up, Vec3{ 1.0, 0.0, 0.0 }, Vec3{ 0.6, -0.64, 0.48 } })
      {
        constexpr int parts = 20000;
        double sum = 0.0;
        double scalar = 0.0;
        for (int i = 0; i < parts; ++i)
        {
          const SourceSample s = line.sample(position, (i + 0.5) / parts, 0.5);
          const double cosine = dot(normal, s.sightline.direction) / length(s.sightline.direction);
          sum += s.radiance * s.weight * std::max(0.0, cosine) / parts;
          scalar += s.radiance * s.weight / parts;
        }
        EXPECT_NEAR(line.irradiance(position, normal), sum, 2e-5 * scalar);
        expectRelative(line.scalarIrradiance(position), scalar, 2e-5);
      }
    }
    const LineSource line(100.0, { -1.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, distribution);
    expectFluxThroughSphere(line, { 0.2, 0.0, 0.0 }, 3.0, 1e-3);
  }
}

TEST(LineSource, OnItsProlongationAndOnIt)
{
  const LineSource lambertian(100.0, { 0.0, 0.0, 1.0 }, { 0.0, 0.0, 2.0 });
  const LineSource isotropic(
    100.0, { 0.0, 0.0, 1.0 }, { 0.0, 0.0, 2.0 }, LineSource::Distribution::Isotropic);
  EXPECT_EQ(lambertian.irradiance(origin, up), 0.0);
  EXPECT_EQ(lambertian.scalarIrradiance(origin), 0.0);
  expectRelative(isotropic.irradiance(origin, up), 100.0 * (1.0 - 0.5)); // ∫ dl / l²
  expectRelative(isotropic.scalarIrradiance(origin), 50.0);
  for (const LineSource* line : { &lambertian, &isotropic })
  {
    EXPECT_TRUE(std::isnan(line->irradiance({ 0.0, 0.0, 1.5 }, up)));
    EXPECT_TRUE(std::isnan(line->scalarIrradiance({ 0.0, 0.0, 1.0 })));
    EXPECT_FALSE(line->radiance(origin, up));
  }
  expectSane(LineSource(100.0, { 5e6, 5e6, 5e6 }, { 5e6 + 1.0, 5e6, 5e6 + 1.0 }),
    { 5e6, 5e6 + 0.5, 5e6 }, 1.0);
  EXPECT_THROW(LineSource(1.0, up, up), std::invalid_argument);
}

TEST(TubeSource, InfiniteAndFinite)
{
  // Very long: E = π L (R / h) cosβ.
  const TubeSource endless(100.0, { 0.0, -1e5, 2.0 }, { 0.0, 1e5, 2.0 }, 0.25);
  expectRelative(endless.irradiance(origin, { 0.5, 0.0, std::sqrt(0.75) }), 34.00873807939158);
  // Under its end, h from the axis.
  const TubeSource tube(100.0, { 0.0, 0.0, 2.0 }, { 1.2, 0.0, 2.0 }, 0.25);
  expectRelative(tube.irradiance(origin, up), 13.12872732613554);
}

TEST(TubeSource, IsTheSumOfItsStrips)
{
  // Against flat strips around it, which are inside of it to the second order.
  constexpr int strips = 2000;
  const Vec3 begin = { -0.5, 0.2, 1.0 };
  const Vec3 end = { 0.7, -0.1, 1.6 };
  const double radius = 0.4;
  const Frame frame = Frame::around((1.0 / length(end - begin)) * (end - begin));
  std::vector<EmittingPolygon> polygons;
  for (int i = 0; i < strips; ++i)
  {
    const auto at = [&](int k)
    {
      const double phi = 2.0 * pi * k / strips;
      return (radius * std::cos(phi)) * frame.x + (radius * std::sin(phi)) * frame.y;
    };
    polygons.push_back(
      { { begin + at(i), begin + at(i + 1), end + at(i + 1), end + at(i) }, {}, 100.0, false });
  }
  const PolygonSource reference(polygons);
  const TubeSource tube(100.0, begin, end, radius);
  expectRelative(*tube.flux(), *reference.flux(), 1e-5);
  for (const Vec3& position : { origin, Vec3{ 0.2, 0.9, 1.3 }, Vec3{ 3.0, -1.0, 3.0 },
         Vec3{ -2.0, 0.4, 0.3 }, Vec3{ 20.0, 0.0, 11.0 }, Vec3{ 500.0, 0.0, 11.0 } })
  {
    const double scalar = tube.scalarIrradiance(position);
    expectRelative(scalar, reference.scalarIrradiance(position), 1e-4);
    for (const Vec3& normal : { up, down, Vec3{ 1.0, 0.0, 0.0 }, Vec3{ -0.6, -0.64, 0.48 },
           Vec3{ 0.0, -0.8, -0.6 }, Vec3{ 0.28, 0.96, 0.0 } })
    {
      EXPECT_NEAR(
        tube.irradiance(position, normal), reference.irradiance(position, normal), 1e-4 * scalar);
    }
  }
  expectSamplesMeanIrradiance(tube, origin, { 0.0, 0.6, 0.8 }, 1e-3);
}

TEST(TubeSource, Sane)
{
  expectSane(TubeSource(100.0, { -0.5, 0.0, 0.0 }, { 0.5, 0.0, 0.0 }, 0.1), { 0.0, 0.2, 0.0 }, 1.0);
  expectSane(
    TubeSource(100.0, { 5e6, 5e6, 5e6 }, { 5e6 + 1.0, 5e6, 5e6 }, 0.1), { 5e6, 5e6, 5e6 }, 1.0);
  const TubeSource tube(100.0, { -0.5, 0.0, 0.0 }, { 0.5, 0.0, 0.0 }, 0.1);
  EXPECT_EQ(tube.irradiance({ 0.1, 0.05, 0.0 }, up), 0.0);                // within
  EXPECT_EQ(tube.irradiance({ 2.0, 0.0, 0.0 }, { -1.0, 0.0, 0.0 }), 0.0); // on its axis
  EXPECT_EQ(tube.radiance({ 0.0, 0.0, -1.0 }, up), 100.0);
  EXPECT_EQ(tube.radiance({ 0.0, 0.0, -1.0 }, { 0.7, 0.0, 1.0 }), 0.0);
  EXPECT_EQ(tube.radiance({ 0.0, 0.2, -1.0 }, up), 0.0);
  EXPECT_THROW(TubeSource(1.0, up, up, 1.0), std::invalid_argument);
  EXPECT_THROW(TubeSource(1.0, origin, up, 0.0), std::invalid_argument);
}

} // namespace
