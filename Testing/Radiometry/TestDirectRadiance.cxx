// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Radiance along rays, and its integral over directions against irradiance in closed form.
#include "Radiometry/Constants.h"
#include "Radiometry/DirectRadiance.h"
#include "Radiometry/DirectionGrid.h"
#include "Radiometry/DirectionalSource.h"
#include "Radiometry/DiskSource.h"
#include "Radiometry/GeneralSky.h"
#include "Radiometry/IsotropicPointSource.h"
#include "Radiometry/PolygonSource.h"
#include "Radiometry/SkySource.h"
#include "Radiometry/SphereSource.h"
#include "Radiometry/SunDiskSource.h"
#include "Radiometry/TubeSource.h"
#include "Testing/Accel/TestHelpers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

namespace
{

using namespace lumitree;
using lumitree::testing::surfaceOf;

using Triangles = std::vector<std::array<Vec3, 3>>;

void addQuad(Triangles& to, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  to.push_back({ a, b, c });
  to.push_back({ a, c, d });
}

double along(const std::vector<const Source*>& sources, const Vec3& origin, const Vec3& direction,
  const RadianceOptions& options = {}, double tMax = std::numeric_limits<double>::infinity())
{
  RayBatch rays;
  rays.size = 1;
  rays.origins = origin.data();
  rays.directions = direction.data();
  rays.tMax = tMax;
  double result = -1.0;
  directRadiance(rays, sources, &result, options);
  return result;
}

PolygonSource square(double z, double radiance, bool twoSided = false)
{
  return PolygonSource(
    { { { { -1, -1, z }, { -1, 1, z }, { 1, 1, z }, { 1, -1, z } }, {}, radiance, twoSided } });
}

TEST(DirectRadiance, DoesNotChangeAlongARay)
{
  const PolygonSource light = square(3.0, 7.0);
  const SphereSource ball(11.0, { 4.0, 0.0, 3.0 }, 1.0);
  const UniformSky sky(2.0);
  const Vec3 towards = { 0.1, 0.2, 1.5 };
  for (const double moved : { 0.0, 0.5, 1.0, 1.9 })
  {
    EXPECT_EQ(along({ &light }, moved * towards, towards), 7.0);
    EXPECT_EQ(along({ &light }, moved * towards, 1e-3 * towards), 7.0);
    EXPECT_EQ(along({ &ball }, moved * Vec3{ 1.0, 0.0, 0.75 }, { 4.0, 0.0, 3.0 }), 11.0);
    EXPECT_EQ(along({ &light, &sky }, moved * towards, towards), 9.0);
  }
  EXPECT_EQ(along({ &light }, 2.1 * towards, towards), 0.0) << "behind the light";
  EXPECT_EQ(along({ &light }, { 0, 0, 0 }, -1.0 * towards), 0.0);
}

TEST(DirectRadiance, ManyPolygonsAreFoundAsFewAre)
{
  // A wavy sheet of quads, some of them not flat, each with a radiance of its own; rays also along
  // its edges and through its corners.
  constexpr int side = 12;
  const auto at = [](int i, int j) -> Vec3
  {
    const double z = 3.0 + 0.2 * std::sin(1.3 * i) + 0.1 * (j % 3) + 0.01 * ((i * j) % 5);
    return { i - 0.5 * side, j - 0.5 * side, z };
  };
  std::vector<EmittingPolygon> polygons;
  for (int i = 0; i < side; ++i)
  {
    for (int j = 0; j < side; ++j)
    {
      polygons.push_back({ { at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j) }, {},
        1.0 + i + 100.0 * j, (i + j) % 2 == 0 });
    }
  }
  const PolygonSource all(polygons);
  std::vector<std::unique_ptr<PolygonSource>> parts; // few at a time are looked at one by one
  std::vector<const Source*> apart;
  for (std::size_t first = 0; first < polygons.size(); first += 16)
  {
    parts.push_back(std::make_unique<PolygonSource>(
      std::vector<EmittingPolygon>(&polygons[first], &polygons[first] + 16)));
    apart.push_back(parts.back().get());
  }
  int seen = 0;
  for (int ray = 0; ray < 4000; ++ray)
  {
    const Vec3 origin = { 0.1 * (ray % 7) - 0.3, 0.2 * (ray % 5) - 0.4, 0.02 * (ray % 400) };
    const Vec3 target = ray % 3 == 0
      ? at(ray % side, (ray / side) % side)
      : Vec3{ 5.0 * std::sin(0.7 * ray), 5.0 * std::cos(1.1 * ray), 3.0 };
    const Vec3 direction = (ray % 4 == 0 ? 1e-6 : 2.0) * (target - origin);
    const double value = along({ &all }, origin, direction);
    EXPECT_EQ(value, along(apart, origin, direction)) << ray;
    seen += value > 0.0 ? 1 : 0;
  }
  EXPECT_GT(seen, 1500);
  EXPECT_LT(seen, 4000);
}

TEST(DirectRadiance, LimitsOfARayHold)
{
  const PolygonSource light = square(3.0, 7.0);
  const UniformSky sky(2.0);
  EXPECT_EQ(along({ &light, &sky }, { 0, 0, 0 }, { 0, 0, 1 }, {}, 2.9), 0.0);
  EXPECT_EQ(along({ &light, &sky }, { 0, 0, 0 }, { 0, 0, 1 }, {}, 3.1), 7.0);
  EXPECT_EQ(along({ &light, &sky }, { 0, 0, 0 }, { 0, 0, 1 }, {}, 1e299), 9.0);
}

TEST(DirectRadiance, WhatIsInTheWayHidesWhatLiesBehindIt)
{
  Triangles wall;
  addQuad(wall, { -5, -5, 2 }, { 5, -5, 2 }, { 5, 5, 2 }, { -5, 5, 2 });
  const auto occluders = build(surfaceOf<double>(wall));
  RadianceOptions options;
  options.estimate.occluders = occluders.get();
  const PolygonSource before = square(1.5, 3.0);
  const PolygonSource touching = square(2.0, 5.0); // a lamp on the ceiling
  const PolygonSource after = square(2.5, 7.0);
  const UniformSky sky(2.0);
  const SunDiskSource sun(1000.0, { 0, 0, -1 }, 0.5 * 0.533 * pi / 180.0);
  EXPECT_EQ(
    along({ &before, &touching, &after, &sky, &sun }, { 0, 0, 0 }, { 0, 0, 1 }, options), 8.0);
  EXPECT_EQ(along({ &before, &touching, &after, &sky }, { 6, 0, 0 }, { 0, 0, 1 }, options), 2.0);
}

TEST(DirectRadiance, OfASurfaceThatReflects)
{
  Triangles floor;
  addQuad(floor, { -9, -9, 0 }, { 9, -9, 0 }, { 9, 9, 0 }, { -9, 9, 0 });
  const auto occluders = build(surfaceOf<double>(floor));
  const IsotropicPointSource lamp(1000.0, { 0, 0, 2 });
  RadianceOptions options;
  options.estimate.occluders = occluders.get();
  options.reflectance = 0.6;
  const double expected = 0.6 * lamp.irradiance({ 0.5, 0, 0 }, { 0, 0, 1 }) / pi;
  for (const Vec3& from : { Vec3{ 0.5, 0, 1 }, Vec3{ 1.5, 0, 1 }, Vec3{ 2.5, 1, 2 } })
  {
    EXPECT_NEAR(along({ &lamp }, from, Vec3{ 0.5, 0, 0 } - from, options), expected, 1e-12);
  }
  EXPECT_EQ(along({ &lamp }, { 0.5, 0, -1 }, { 0, 0, 1 }, options), 0.0) << "the dark side";
  EXPECT_EQ(along({ &lamp }, { 0.5, 0, 1 }, { 0, 0, 1 }, options), 0.0) << "a point is not seen";
  const std::vector<double> each = { 0.25, 0.25 };
  options.reflectances = each.data();
  EXPECT_NEAR(along({ &lamp }, { 0.5, 0, 1 }, { 0, 0, -1 }, options), expected * 0.25 / 0.6, 1e-12);
}

TEST(DirectRadiance, CosineIntegralIsTheIrradiance)
{
  const DirectionGrid grid = makeDirectionGrid({ 0, 0, 1 }, { 1, 0, 0 }, 512, 1024);
  double whole = 0.0;
  for (const double solidAngle : grid.solidAngles)
  {
    whole += solidAngle;
  }
  EXPECT_NEAR(whole, 4.0 * pi, 1e-10);
  const PolygonSource polygon = square(1.0, 10.0);
  const SphereSource ball(10.0, { 0.5, 0, 2 }, 1.0);
  const DiskSource disk(10.0, { 0.3, 0.2, 1.0 }, { 0, 0.6, -0.8 }, 0.8);
  const TubeSource tube(10.0, { -1, 0.5, 1 }, { 1, 0.5, 1.5 }, 0.3);
  const UniformSky sky(1.0);
  const OvercastSky overcast({ SkyLevel::Kind::ZenithRadiance, 1.0 });
  const Vec3 place = { 0.1, 0.0, 0.0 };
  const Vec3 normal = { 0.0, 0.6, 0.8 };
  const Source* const sources[] = { &polygon, &ball, &disk, &tube, &sky, &overcast };
  for (const Source* source : sources)
  {
    Receivers places;
    places.size = 1;
    places.positions = place.data();
    places.normals = normal.data();
    std::vector<double> radiance(grid.directions.size());
    radianceAround(places, grid.directions, { source }, radiance.data());
    double sum = 0.0;
    for (std::size_t d = 0; d < radiance.size(); ++d)
    {
      sum += radiance[d] * grid.solidAngles[d] * std::max(0.0, dot(normal, grid.directions[d]));
    }
    const double expected = source->irradiance(place, normal);
    EXPECT_NEAR(sum, expected, 1e-3 * expected);
  }
}

TEST(DirectRadiance, SameSumBehindAnOccluderAsTheEstimate)
{
  Triangles blocker;
  addQuad(blocker, { 0, -5, 0.5 }, { 5, -5, 0.5 }, { 5, 5, 0.5 }, { 0, 5, 0.5 });
  const auto occluders = build(surfaceOf<double>(blocker));
  const PolygonSource light = square(1.0, 10.0);
  const DirectionGrid grid = makeDirectionGrid({ 0, 0, 1 }, { 1, 0, 0 }, 512, 512);
  const Vec3 place = { 0.1, 0.0, 0.0 };
  const Vec3 normal = { 0.0, 0.0, 1.0 };
  Receivers places;
  places.size = 1;
  places.positions = place.data();
  places.normals = normal.data();
  RadianceOptions options;
  options.estimate.occluders = occluders.get();
  std::vector<double> radiance(grid.directions.size());
  std::vector<double> again(grid.directions.size());
  radianceAround(places, grid.directions, { &light }, radiance.data(), options);
  options.estimate.threads = 1;
  radianceAround(places, grid.directions, { &light }, again.data(), options);
  EXPECT_EQ(radiance, again) << "whatever the threads";
  double sum = 0.0;
  for (std::size_t d = 0; d < radiance.size(); ++d)
  {
    sum += radiance[d] * grid.solidAngles[d] * std::max(0.0, dot(normal, grid.directions[d]));
  }
  double expected = 0.0;
  EstimateOutputs outputs;
  outputs.irradiance = &expected;
  EstimateOptions estimate;
  estimate.occluders = occluders.get();
  estimateLight(places, { &light }, outputs, estimate);
  EXPECT_NEAR(sum, expected, 2e-3 * expected);
}

TEST(DirectRadiance, BadInput)
{
  const UniformSky sky(1.0);
  const DirectionalSource parallel(1.0, { 0, 0, -1 });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(along({ &sky }, { nan, 0, 0 }, { 0, 0, 1 })));
  EXPECT_TRUE(std::isnan(along({ &sky }, { 0, 0, 0 }, { 0, 0, 0 })));
  EXPECT_TRUE(std::isnan(along({ &sky }, { 0, 0, 0 }, { 0, 0, 1 }, {}, -1.0)));
  EXPECT_EQ(along({ &parallel }, { 0, 0, 0 }, { 0, 0, 1 }), 0.0);
  EXPECT_EQ(along({}, { 0, 0, 0 }, { 0, 0, 1 }), 0.0);
  RadianceOptions options;
  options.reflectance = 1.5;
  EXPECT_THROW(along({ &sky }, { 0, 0, 0 }, { 0, 0, 1 }, options), std::invalid_argument);
  EXPECT_THROW((void)makeDirectionGrid({ 0, 0, 1 }, { 0, 0, 2 }, 4, 4), std::invalid_argument);
  EXPECT_THROW((void)makeDirectionGrid({ 0, 0, 0 }, { 0, 0, 2 }, 4, 4), std::invalid_argument);
  EXPECT_THROW((void)makeDirectionGrid({ 0, 0, 1 }, { 1, 0, 0 }, 0, 4), std::invalid_argument);
  EXPECT_EQ(directRadiance(RayBatch{}, { &sky }, nullptr).invalidRays, 0u);
  EXPECT_TRUE(radianceAround(Receivers{}, { { 0, 0, 1 } }, { &sky }, nullptr).completed);
}

} // namespace
