// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays that start in one point are traced together; what each hits is what it hits alone.
#include "TestHelpers.h"

#include <gtest/gtest.h>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The pixels of a picture, row by row.
Rays picture(const Vec3& eye, const Vec3& target, int width, int height, double view)
{
  Rays rays;
  const Vec3 forward = target - eye;
  const Vec3 right = view * cross(forward, Vec3{ 0.1, 0.3, 1 });
  const Vec3 up = (view / length(forward)) * cross(right, forward);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      rays.add(
        eye, forward + ((x - 0.5 * width) / width * right + (y - 0.5 * height) / width * up));
    }
  }
  return rays;
}

/// From one point in all directions, to vertices and to middles of edges, in the planes of the
/// axes and along them.
Rays fan(const Surface& surface, const Vec3& eye, std::size_t count)
{
  Uniform uniform(3);
  Rays rays;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto c = surface.vertices(static_cast<PrimitiveId>(uniform.index(surface.size())));
    rays.add(eye, c[uniform.index(3)] - eye);
    rays.add(eye, 0.5 * (c[0] + c[1]) - eye);
    Vec3 d = { uniform(-1, 1), uniform(-1, 1), uniform(-1, 1) };
    rays.add(eye, d);
    d[i % 3] = 0;
    rays.add(eye, d);
    d[(i + 1) % 3] = i % 2 == 0 ? 0.0 : -0.0;
    rays.add(eye, d);
  }
  return rays;
}

/// A ray that is counted is traced alone. Returns how many rays hit.
std::size_t expectAsAlone(const Accelerator& accelerator, const RayBatch& rays, Precision precision)
{
  QueryOptions together;
  together.precision = precision;
  std::vector<RayCounters> counters(rays.size);
  QueryOptions alone = together;
  alone.perRay = counters.data();
  std::vector<Hit> wanted(rays.size);
  std::vector<Hit> got(rays.size);
  const QueryReport a = accelerator.closest(rays, wanted.data(), alone);
  const QueryReport b = accelerator.closest(rays, got.data(), together);
  EXPECT_EQ(a.invalidRays, b.invalidRays);
  std::size_t hits = 0;
  for (std::size_t i = 0; i < rays.size; ++i)
  {
    hits += wanted[i].primitive != noPrimitive;
    EXPECT_TRUE(sameBits(wanted[i], got[i]))
      << "ray " << i << ": " << got[i].primitive << " at " << got[i].t << ", alone "
      << wanted[i].primitive << " at " << wanted[i].t;
    if (::testing::Test::HasFailure())
    {
      return 0;
    }
  }
  std::vector<std::uint8_t> anyWanted(rays.size);
  std::vector<std::uint8_t> anyGot(rays.size);
  accelerator.any(rays, anyWanted.data(), alone);
  accelerator.any(rays, anyGot.data(), together);
  EXPECT_EQ(anyWanted, anyGot);
  return hits;
}

struct Seen
{
  std::string name;
  std::shared_ptr<const Surface> surface;
};

std::vector<Seen> surfaces()
{
  return { { "teapot of floats", surfaceOf<float>(data::teapot(4)) },
    { "torus of floats", surfaceOf<float>(data::torus(90, 40, 0.3)) },
    { "torus of doubles", surfaceOf<double>(data::torus(60, 30, 0.3), { 5e5, 4649776, 100 }) },
    { "room", surfaceOf<float>(data::cornellBox(6)) } };
}

class Bundles : public ::testing::TestWithParam<Precision>
{
};

TEST_P(Bundles, HitWhatTheirRaysHitAlone)
{
  for (const Seen& seen : surfaces())
  {
    SCOPED_TRACE(seen.name);
    const Surface& surface = *seen.surface;
    const auto accelerator = build(seen.surface, optionsOf(Structure::WideBvh));
    const Box box = surface.bounds();
    const Vec3 size = box.size();
    Uniform uniform(11);
    std::size_t hits = 0;
    for (int place = 0; place < 6; ++place)
    {
      SCOPED_TRACE(place);
      // Outside, inside, on a vertex, far away, with other lengths of the direction.
      Vec3 eye = box.centre() +
        Vec3{ uniform(-1, 1) * size[0], uniform(-1, 1) * size[1], uniform(-1, 1) * size[2] };
      eye = place == 2 ? box.centre() + 0.01 * size : eye;
      eye = place == 3 ? surface.vertices(0)[0] : eye;
      eye = place == 4 ? box.centre() + 1e5 * (eye - box.centre()) : eye;
      Rays rays = picture(eye, box.centre(), 97, 61, place == 4 ? 1e-5 : 0.6);
      const double scale = place == 5 ? 0x1p-40 : 1.0;
      for (double& d : rays.directions)
      {
        d *= scale;
      }
      hits += expectAsAlone(*accelerator, rays.batch(), GetParam());
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        rays.tMins[i] = uniform(0, 0.7) / scale;
        rays.tMaxs[i] = rays.tMins[i] + uniform(0, 1) / scale;
      }
      expectAsAlone(*accelerator, rays.batch(), GetParam());
      expectAsAlone(*accelerator, fan(surface, eye, 700).batch(), GetParam());
    }
    EXPECT_GT(hits, 3000u);
  }
}

/// Rays that begin or end at what they hit, or one number beside it.
TEST_P(Bundles, WithLimitsAtTheHits)
{
  for (const Seen& seen : surfaces())
  {
    SCOPED_TRACE(seen.name);
    const auto accelerator = build(seen.surface, optionsOf(Structure::WideBvh));
    const Box box = seen.surface->bounds();
    Rays rays = picture(box.centre() + 1.3 * box.size(), box.centre(), 64, 48, 0.6);
    std::vector<Hit> hits(rays.size());
    accelerator->closest(rays.batch(), hits.data(), with(GetParam()));
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      const double t = hits[i].primitive == noPrimitive ? 1.0 : hits[i].t;
      const double limits[] = { t, std::nextafter(t, 0.0), std::nextafter(t, HUGE_VAL) };
      (i % 2 == 0 ? rays.tMins : rays.tMaxs)[i] = limits[i / 2 % 3];
    }
    expectAsAlone(*accelerator, rays.batch(), GetParam());
  }
}

/// Along the ground, so that t is not known well without exact arithmetic.
TEST_P(Bundles, OfGrazingRays)
{
  const auto surface = surfaceOf<double>(data::terrain(24, 1, 1e-9), { 5e5, 4649776, 100 });
  const auto accelerator = build(surface, optionsOf(Structure::WideBvh));
  const Box box = surface->bounds();
  for (const double height : { 1e-8, 1e-6, 1e-4 })
  {
    const Vec3 eye = { box.lower[0] - 0.5 * box.size()[0], box.centre()[1], box.upper[2] + height };
    expectAsAlone(*accelerator, picture(eye, box.centre(), 128, 40, 2e-8).batch(), GetParam());
    Rays low = picture(eye, box.centre(), 128, 40, 0.3);
    for (std::size_t i = 0; i < low.size(); ++i)
    {
      low.directions[3 * i + 2] = -height * (0.7 + static_cast<double>(i % 128) / 128);
    }
    expectAsAlone(*accelerator, low.batch(), GetParam());
  }
}

/// Needles with their length along the rays, each in a plane across an axis: t from the weights is
/// vague, the plane that is the needle's box says where it is.
TEST_P(Bundles, OfNeedlesInPlanesOfTheAxes)
{
  Uniform uniform(8);
  const Vec3 eye = { -0.1, -0.2, -1 };
  std::vector<std::array<Vec3, 3>> needles;
  std::vector<Vec3> targets;
  for (int i = 0; i < 600; ++i)
  {
    const std::size_t across = i % 2;
    const Vec3 from = { uniform(0.5, 1), uniform(0.5, 1), uniform(1, 2) };
    Vec3 along = { uniform(0.1, 0.3), uniform(0.1, 0.3), uniform(0.5, 1) };
    along[across] = 0;
    Vec3 width{};
    width[1 - across] = std::ldexp(1.0, -20 - i % 24);
    needles.push_back({ from, from + 0.5 * along + width, from + along });
    for (int ray = 0; ray < 8; ++ray)
    {
      const double s = uniform(0.1, 0.9);
      const double share = uniform(0.2, 0.8) * std::min(2 * s, 2 - 2 * s);
      targets.push_back(from + s * along + share * width);
    }
  }
  Rays rays;
  for (const Vec3& target : targets)
  {
    rays.add(eye, target - eye);
  }
  const auto accelerator = build(surfaceOf<double>(needles), optionsOf(Structure::WideBvh));
  EXPECT_GT(expectAsAlone(*accelerator, rays.batch(), GetParam()), 1000u);
}

TEST_P(Bundles, OfRaysOfFloats)
{
  const auto surface = surfaceOf<float>(data::torus(60, 30, 0.3));
  const auto accelerator = build(surface, optionsOf(Structure::WideBvh));
  const Rays rays = picture({ 1.5, 2.5, 2 }, { 0, 0, 0 }, 80, 80, 0.6);
  const std::vector<float> origins(rays.origins.begin(), rays.origins.end());
  const std::vector<float> directions(rays.directions.begin(), rays.directions.end());
  RayBatch batch;
  batch.size = rays.size();
  batch.origins = ArrayView(origins.data());
  batch.directions = ArrayView(directions.data());
  expectAsAlone(*accelerator, batch, GetParam());
}

TEST_P(Bundles, AmongRaysOfManyPointsAndRaysThatAreNone)
{
  const auto surface = surfaceOf<double>(data::torus(60, 30, 0.3));
  const auto accelerator = build(surface, optionsOf(Structure::WideBvh));
  Rays rays;
  Uniform uniform(4);
  for (int i = 0; i < 40; ++i)
  {
    const Vec3 eye = { uniform(-2, 2), uniform(-2, 2), uniform(-2, 2) };
    const Rays some = picture(eye, { 0, 0, 0 }, static_cast<int>(1 + uniform.index(40)), 9, 0.9);
    for (std::size_t r = 0; r < some.size(); ++r)
    {
      rays.add(some.batch()[r]);
    }
  }
  for (std::size_t i = 5; i < rays.size(); i += 7)
  {
    rays.directions[3 * i + i % 3] = i % 2 == 0 ? nan : 1e308;
    rays.tMins[i - 1] = i % 3 == 0 ? nan : -1;
    rays.tMaxs[i - 2] = i % 3 == 0 ? -1 : 0x1p-1070;
    std::fill_n(rays.directions.begin() + static_cast<std::ptrdiff_t>(3 * (i - 3)), 3, 0.0);
  }
  expectAsAlone(*accelerator, rays.batch(), GetParam());
}

TEST_P(Bundles, SkipWhatTheirRaysSkip)
{
  const auto surface = surfaceOf<float>(data::torus(60, 30, 0.3));
  const auto accelerator = build(surface, optionsOf(Structure::WideBvh));
  const Rays rays = picture({ 1.5, 2.5, 2 }, { 0, 0, 0 }, 80, 80, 0.6);
  std::vector<Hit> hits(rays.size());
  accelerator->closest(rays.batch(), hits.data(), with(GetParam()));
  // Each ray skips what it hit, or its neighbour did.
  std::vector<std::uint64_t> offsets = { 0 };
  std::vector<PrimitiveId> skipped;
  for (std::size_t i = 0; i < hits.size(); ++i)
  {
    const PrimitiveId id = hits[i % 3 == 0 ? i : i / 2].primitive;
    if (id != noPrimitive)
    {
      skipped.push_back(id);
    }
    offsets.push_back(skipped.size());
  }
  RayBatch batch = rays.batch();
  batch.skip.offsets = offsets.data();
  batch.skip.primitives = skipped.data();
  EXPECT_GT(expectAsAlone(*accelerator, batch, GetParam()), 1000u);
}

/// Tiles that see thousands of triangles are given up and traced ray by ray.
TEST_P(Bundles, OfFewRaysOverManyTriangles)
{
  const auto surface = surfaceOf<float>(data::torus(400, 200, 0.3));
  const auto accelerator = build(surface, optionsOf(Structure::WideBvh));
  expectAsAlone(
    *accelerator, picture({ 1.5, 2.5, 2 }, { 0, 0, 0 }, 24, 24, 0.7).batch(), GetParam());
}

TEST_P(Bundles, OverDuplicatesDegeneratesAndOneCell)
{
  std::vector<std::array<Vec3, 3>> triangles;
  for (int i = 0; i < 40; ++i)
  {
    const double z = i / 8;
    triangles.push_back({ Vec3{ -1, -1, z }, Vec3{ 1, -1, z }, Vec3{ 0, 1, z } });
    triangles.push_back({ Vec3{ -1, -1, z }, Vec3{ -1, -1, z }, Vec3{ 0, 1, z } });
  }
  const auto many = surfaceOf<double>(triangles);
  expectAsAlone(*build(many, optionsOf(Structure::WideBvh)),
    picture({ 0, -0.2, -3 }, { 0, -0.2, 0 }, 64, 64, 0.5).batch(), GetParam());
  triangles.resize(1);
  expectAsAlone(*build(surfaceOf<float>(triangles), optionsOf(Structure::WideBvh)),
    picture({ 0, -0.2, -3 }, { 0, -0.2, 0 }, 64, 64, 0.5).batch(), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Each, Bundles, ::testing::ValuesIn(everyPrecision),
  [](const auto& precision) { return std::string(name(precision.param)); });

} // namespace
