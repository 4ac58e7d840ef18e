// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// No ray leaves a closed surface: rays exactly through vertices and edge midpoints, normalised
// directions to vertices and random ones, from inside; at the origin and far from it, floats and
// doubles. And Exact names the lowest primitive of those that share the point.
#include "ClosedScenes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

const std::vector<ClosedScene>& surfaces()
{
  static const std::vector<ClosedScene> all = []
  {
    std::vector<ClosedScene> made;
    for (const bool torus : { false, true })
    {
      for (const Place& place : closedPlaces())
      {
        made.push_back(closedScene(torus, place, 20));
      }
    }
    for (const Place& place : closedPlaces())
    {
      made.push_back(closedRoom(place));
    }
    return made;
  }();
  return all;
}

TEST(Watertight, NothingLeavesAClosedSurface)
{
  std::uint64_t traced = 0;
  for (const ClosedScene& c : surfaces())
  {
    unsigned seed = 41;
    for (const auto& accelerator : accelerators(c.surface))
    {
      // Brute force, six thousand triangles a ray, gets by with fewer. Others have rays of their
      // own each: the test of a triangle is the same, so all are rays for it.
      const bool slow = accelerator->options().structure == Structure::BruteForce;
      ++seed;
      for (const Aim aim : everyAim)
      {
        const Rays all = raysFromInside(c, aim, slow ? 50 : 1500, seed);
        for (const Precision precision : { Precision::Watertight, Precision::Exact })
        {
          SCOPED_TRACE(c.name + ", " + label(accelerator->options()) + ", " +
            std::string(name(precision)) + ", aim " + name(aim));
          std::vector<Hit> hits(all.size());
          std::vector<std::uint8_t> any(all.size());
          accelerator->closest(all.batch(), hits.data(), with(precision));
          accelerator->any(all.batch(), any.data(), with(precision));
          EXPECT_EQ(std::count_if(hits.begin(), hits.end(),
                      [](const Hit& hit) { return hit.primitive == noPrimitive; }),
            0);
          EXPECT_EQ(std::count(any.begin(), any.end(), 0), 0);
          traced += all.size();
        }
      }
    }
  }
  RecordProperty("Rays", std::to_string(traced));
}

/// Triangles around each vertex, ascending.
std::vector<std::vector<PrimitiveId>> trianglesAround(const Surface& surface)
{
  std::vector<std::vector<PrimitiveId>> around(surface.pointCount());
  for (PrimitiveId i = 0; i < surface.size(); ++i)
  {
    for (const std::uint32_t p : surface.triangle(i))
    {
      around[p].push_back(i);
    }
  }
  return around;
}

TEST(Watertight, ExactNamesTheLowestTriangleAroundTheVertexHit)
{
  for (const ClosedScene& c : surfaces())
  {
    // From inside a sphere about its centre every ray meets the surface once, so that a vertex
    // aimed at is what is hit; its coordinates on a grid make the aim exact.
    if (c.torus || c.grid == 0.0 || c.surface->pointCount() == 3 * c.surface->size())
    {
      continue;
    }
    const auto around = trianglesAround(*c.surface);
    Uniform uniform(43);
    Rays all;
    std::vector<std::uint32_t> targets;
    for (int i = 0; i < 2000; ++i)
    {
      const Vec3 o = inside(c, uniform);
      targets.push_back(static_cast<std::uint32_t>(uniform.index(c.surface->pointCount())));
      all.add(o, c.surface->point(targets.back()) - o);
    }
    for (const auto& accelerator : accelerators(c.surface))
    {
      if (accelerator->options().structure == Structure::BruteForce)
      {
        continue;
      }
      SCOPED_TRACE(c.name + ", " + label(accelerator->options()));
      std::vector<Hit> hits(all.size());
      AllHits every;
      accelerator->closest(all.batch(), hits.data(), with(Precision::Exact));
      accelerator->all(all.batch(), every, with(Precision::Exact));
      for (std::size_t i = 0; i < hits.size(); ++i)
      {
        ASSERT_EQ(hits[i].primitive, around[targets[i]].front()) << "ray " << i;
        ASSERT_NEAR(hits[i].t, 1.0, 0x1p-24) << "ray " << i;
        ASSERT_EQ(every.offsets[i + 1] - every.offsets[i], around[targets[i]].size())
          << "ray " << i;
      }
    }
  }
}

TEST(Watertight, EdgesExactlyHitBelongToBothTriangles)
{
  const ClosedScene& c = surfaces().front();
  const auto accelerator = build(c.surface);
  const Rays all = raysFromInside(c, Aim::Edge, 2000);
  std::vector<std::uint32_t> counts(all.size());
  AllHits every;
  accelerator->count(all.batch(), counts.data(), with(Precision::Exact));
  accelerator->all(all.batch(), every, with(Precision::Exact));
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    ASSERT_EQ(counts[i], 2u) << "ray " << i;
    const Hit& first = every.hits[every.offsets[i]];
    const Hit& second = every.hits[every.offsets[i] + 1];
    ASSERT_LT(first.primitive, second.primitive);
    ASSERT_NEAR(first.t, 0.5, 0x1p-24);
    ASSERT_NEAR(second.t, 0.5, 0x1p-24);
  }
}

TEST(Watertight, RandomRaysCrossAClosedSurfaceAnOddNumberOfTimes)
{
  for (const ClosedScene& c : surfaces())
  {
    const auto accelerator = build(c.surface);
    const Rays all = raysFromInside(c, Aim::Random, 3000);
    std::vector<std::uint32_t> counts(all.size());
    accelerator->count(all.batch(), counts.data(), with(Precision::Exact));
    EXPECT_TRUE(
      std::all_of(counts.begin(), counts.end(), [](std::uint32_t n) { return n % 2 == 1; }))
      << c.name;
  }
}

std::size_t misses(const Accelerator& accelerator, const Rays& rays, Precision precision)
{
  std::vector<Hit> hits(rays.size());
  accelerator.closest(rays.batch(), hits.data(), with(precision));
  return static_cast<std::size_t>(std::count_if(
    hits.begin(), hits.end(), [](const Hit& hit) { return hit.primitive == noPrimitive; }));
}

TEST(Watertight, FastLosesNoRandomRay)
{
  for (const ClosedScene& c : surfaces())
  {
    const Rays all = raysFromInside(c, Aim::Random, 20000, 53);
    for (const Structure structure : { Structure::WideBvh, Structure::KdTree })
    {
      EXPECT_EQ(misses(*build(c.surface, optionsOf(structure)), all, Precision::Fast), 0u)
        << c.name;
    }
  }
}

TEST(Watertight, RandomRaysDoNotGoToExactArithmetic)
{
  // 375,000 rays. Fewer than one in a million is promised.
  for (const ClosedScene& c : surfaces())
  {
    const Rays all = raysFromInside(c, Aim::Random, 25000, 59);
    std::vector<Hit> hits(all.size());
    EXPECT_EQ(
      build(c.surface)->closest(all.batch(), hits.data(), with(Precision::Exact)).exactTests, 0u)
      << c.name;
  }
}

/// A scene at UTM coordinates, moved to the origin in doubles, then cast to floats.
TEST(Watertight, RecentredFloatsNameTheSameTriangleOnRandomRays)
{
  std::size_t rays = 0;
  std::size_t others = 0;
  for (const bool torus : { false, true })
  {
    const Place& utm = closedPlaces().back();
    const ClosedScene c = closedScene(torus, utm, 20);
    const auto moved = surfaceOf<float>(
      [&]
      {
        std::vector<std::array<Vec3, 3>> triangles;
        for (PrimitiveId i = 0; i < c.surface->size(); ++i)
        {
          const auto v = c.surface->vertices(i);
          triangles.push_back({ v[0] - c.offset, v[1] - c.offset, v[2] - c.offset });
        }
        return triangles;
      }());
    const Rays there = raysFromInside(c, Aim::Random, 100000, 61);
    Rays here;
    for (std::size_t i = 0; i < there.size(); ++i)
    {
      const Ray ray = there.batch()[i];
      here.add(ray.origin - c.offset, ray.direction);
    }
    std::vector<Hit> truth(there.size());
    std::vector<Hit> found(there.size());
    build(c.surface)->closest(there.batch(), truth.data(), with(Precision::Exact));
    build(moved)->closest(here.batch(), found.data(), with(Precision::Fast));
    for (std::size_t i = 0; i < truth.size(); ++i)
    {
      others += truth[i].primitive == found[i].primitive ? 0 : 1;
    }
    rays += truth.size();
  }
  // One in 100,000.
  EXPECT_LE(others * 100000, rays);
}

TEST(Watertight, SliversAreAsTightAsAnythingElse)
{
  const auto surface = surfaceOf<double>(data::slivers(200, 1e6));
  const Box box = surface->bounds();
  for (const auto& accelerator : accelerators(surface))
  {
    Uniform uniform(47);
    for (int i = 0; i < 500; ++i)
    {
      const Vec3 o =
        0.5 * (box.lower + box.upper) + Vec3{ 0.01 * uniform(-1, 1), 0.01 * uniform(-1, 1), 0 };
      const auto corners =
        surface->vertices(static_cast<PrimitiveId>(uniform.index(surface->size())));
      const Ray ray = { o,
        i % 2 == 0 ? corners[uniform.index(3)] - o
                   : Vec3{ uniform(-1, 1), uniform(-1, 1), uniform(-1e6, 1e6) } };
      for (const Precision precision : { Precision::Watertight, Precision::Exact })
      {
        ASSERT_NE(closestOf(*accelerator, ray, precision).primitive, noPrimitive)
          << label(accelerator->options()) << ", " << name(precision) << ", ray " << i;
      }
    }
  }
}

} // namespace
