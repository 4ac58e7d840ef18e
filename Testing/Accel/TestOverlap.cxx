// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Which primitives may meet a convex region: each structure against the definition in rational
// numbers, and against brute force.
#include "RationalOracle.h"
#include "TestHelpers.h"

#include <gtest/gtest.h>

#include <numeric>
#include <thread>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

constexpr double inf = std::numeric_limits<double>::infinity();

/// The half-space below the plane through three points, on the side of a fourth.
HalfSpace sideOf(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& inside)
{
  HalfSpace half;
  half.normal = cross(b - a, c - a);
  half.offset = dot(half.normal, a);
  if (dot(half.normal, inside) > half.offset)
  {
    half.normal = -1.0 * half.normal;
    half.offset = -half.offset;
  }
  return half;
}

/// What lies between a point and a triangle, as a shadow ray's shaft.
ConvexRegion shaft(const Vec3& apex, const std::array<Vec3, 3>& base)
{
  return { sideOf(apex, base[0], base[1], base[2]), sideOf(apex, base[1], base[2], base[0]),
    sideOf(apex, base[2], base[0], base[1]), sideOf(base[0], base[1], base[2], apex) };
}

ConvexRegion boxRegion(const Vec3& lower, const Vec3& upper)
{
  ConvexRegion region;
  for (int k = 0; k < 3; ++k)
  {
    HalfSpace half;
    half.normal[k] = 1.0;
    half.offset = upper[k];
    region.push_back(half);
    half.normal[k] = -1.0;
    half.offset = -lower[k];
    region.push_back(half);
  }
  return region;
}

std::vector<ConvexRegion> regionsAround(const Surface& surface, std::size_t count)
{
  Uniform uniform(5);
  const Box bounds = surface.bounds();
  const Vec3 size = bounds.size();
  const auto point = [&](double beyond)
  {
    Vec3 p;
    for (int k = 0; k < 3; ++k)
    {
      p[k] = uniform(bounds.lower[k] - beyond * size[k], bounds.upper[k] + beyond * size[k]);
    }
    return p;
  };
  std::vector<ConvexRegion> regions;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vec3 a = point(0.5);
    const Vec3 b = point(0.1);
    const auto corners =
      surface.vertices(surface.hittable()[uniform.index(surface.hittable().size())]);
    switch (i % 4)
    {
      case 0:
        regions.push_back(shaft(a, { b, point(0.1), point(0.1) }));
        break;
      case 1: // between a point and a triangle of the surface: its vertices lie on the planes
        regions.push_back(shaft(a, corners));
        break;
      case 2: // narrow
        regions.push_back(shaft(a, { b, b + 0.01 * (point(0.0) - b), b + 0.01 * (a - b) }));
        break;
      default:
        regions.push_back(boxRegion(corners[0], corners[0] + 0.1 * size));
    }
  }
  return regions;
}

/// n · x - offset
Rational height(const HalfSpace& half, const Vec3& x)
{
  Rational sum = -rational(half.offset);
  for (int k = 0; k < 3; ++k)
  {
    sum += rational(half.normal[k]) * rational(x[k]);
  }
  return sum;
}

enum class Where
{
  Meets,
  Unsure, ///< outside a half-space by what rounding may account for
  Outside
};

Where whereIs(const Surface& surface, PrimitiveId id, const ConvexRegion& region)
{
  Where where = Where::Meets;
  Vec3 most = { 0, 0, 0 };
  for (int k = 0; k < 3; ++k)
  {
    most[k] = std::max(std::fabs(surface.bounds().lower[k]), std::fabs(surface.bounds().upper[k]));
  }
  for (const HalfSpace& half : region)
  {
    double margin = std::fabs(half.offset);
    for (int k = 0; k < 3; ++k)
    {
      margin += std::fabs(half.normal[k]) * most[k];
    }
    bool outside = true;
    bool farOutside = true;
    for (const Vec3& x : surface.vertices(id))
    {
      const Rational h = height(half, x);
      outside = outside && h > 0;
      farOutside = farOutside && h > rational(0x1p-48 * margin);
    }
    if (farOutside)
    {
      return Where::Outside;
    }
    where = outside ? Where::Unsure : where;
  }
  return where;
}

std::vector<PrimitiveId> overlapOf(const Accelerator& accelerator, const ConvexRegion& region)
{
  std::vector<PrimitiveId> found = { 7 }; // overwritten
  accelerator.overlap(region, found);
  return found;
}

std::vector<std::shared_ptr<const Surface>> scenes()
{
  return { surfaceOf<float>(data::teapot(2)), surfaceOf<double>(data::city(1), { 1e6, -2e6, 10 }),
    surfaceOf<float>(data::randomCloud(200)), surfaceOf<double>(data::slivers(60)) };
}

std::vector<std::shared_ptr<const Accelerator>> allOver(const std::shared_ptr<const Surface>& s)
{
  auto all = accelerators(s);
  for (const Structure reference : { Structure::Embree, Structure::Cgal })
  {
    if (Registry::instance().has(reference))
    {
      all.push_back(build(s, optionsOf(reference)));
    }
  }
  return all;
}

TEST(Overlap, StopsAtItsLimit)
{
  const auto surface = surfaceOf<float>(data::randomCloud(200));
  for (const auto& accelerator : allOver(surface))
  {
    std::vector<PrimitiveId> found;
    accelerator->overlap({}, found, 200);
    EXPECT_EQ(found.size(), 200u);
    accelerator->overlap({}, found, 20);
    EXPECT_GT(found.size(), 20u);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
  }
}

TEST(Overlap, BruteForceKeepsTheDefinition)
{
  for (const auto& surface : scenes())
  {
    const auto accelerator = build(surface, optionsOf(Structure::BruteForce));
    std::size_t kept = 0;
    std::size_t outside = 0;
    for (const ConvexRegion& region : regionsAround(*surface, 12))
    {
      const std::vector<PrimitiveId> found = overlapOf(*accelerator, region);
      EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
      for (const PrimitiveId id : surface->hittable())
      {
        const bool is = std::binary_search(found.begin(), found.end(), id);
        const Where where = whereIs(*surface, id, region);
        EXPECT_TRUE(is || where != Where::Meets) << id;
        EXPECT_FALSE(is && where == Where::Outside) << id;
        kept += is ? 1 : 0;
        outside += where == Where::Outside ? 1 : 0;
      }
    }
    EXPECT_GT(kept, 0u);
    EXPECT_GT(outside, 0u);
  }
}

TEST(Overlap, EveryStructureGivesTheSameList)
{
  auto surfaces = scenes();
  surfaces.push_back(surfaceOf<float>(data::teapotInStadium(4)));
  surfaces.push_back(surfaceOf<float>(data::terrain(24)));
  for (const auto& surface : surfaces)
  {
    const auto all = allOver(surface);
    for (const ConvexRegion& region : regionsAround(*surface, 400))
    {
      const std::vector<PrimitiveId> wanted = overlapOf(*all.front(), region);
      for (const auto& accelerator : all)
      {
        ASSERT_EQ(overlapOf(*accelerator, region), wanted) << label(accelerator->options());
      }
    }
  }
}

TEST(Overlap, DegenerateRegions)
{
  const auto surface = surfaceOf<float>(data::teapot(2));
  const std::vector<PrimitiveId>& everything = surface->hittable();
  const Vec3 middle = surface->bounds().centre();
  for (const auto& accelerator : allOver(surface))
  {
    SCOPED_TRACE(label(accelerator->options()));
    EXPECT_EQ(overlapOf(*accelerator, {}), everything);
    // Half-spaces that are all of space, or nothing.
    EXPECT_EQ(overlapOf(*accelerator, { { { 0, 0, 0 }, 0.0 } }), everything);
    EXPECT_EQ(overlapOf(*accelerator, { { { 1, 2, 3 }, inf } }), everything);
    EXPECT_EQ(overlapOf(*accelerator, { { { 1e-300, 0, 0 }, 1e300 } }), everything);
    EXPECT_TRUE(overlapOf(*accelerator, { { { 0, 0, 0 }, -1.0 } }).empty());
    EXPECT_TRUE(overlapOf(*accelerator, { { { 1, 2, 3 }, -inf } }).empty());
    EXPECT_TRUE(overlapOf(*accelerator, { { { 1e-300, 0, 0 }, -1e300 } }).empty());
    // No point lies in the region; only what reaches across all of it may be named.
    EXPECT_TRUE(
      overlapOf(*accelerator, { { { 1, 0, 0 }, middle[0] - 9.0 }, { { -1, 0, 0 }, -middle[0] } })
        .empty());
    // A plane, a line, a point.
    EXPECT_FALSE(
      overlapOf(*accelerator, boxRegion({ -inf, -inf, middle[2] }, { inf, inf, middle[2] }))
        .empty());
    const Vec3 vertex = surface->vertices(everything.front())[0];
    EXPECT_FALSE(overlapOf(*accelerator, boxRegion(vertex, vertex)).empty());
  }
}

/// Half-spaces that a triangle touches with one vertex: the smallest double that is not below its
/// exact n · x is the offset, so that floating point may well find all three beyond.
TEST(Overlap, WhatAPlaneTouchesObliquelyIsKept)
{
  for (const auto& surface : scenes())
  {
    const auto all = allOver(surface);
    const std::vector<PrimitiveId>& hittable = surface->hittable();
    Uniform uniform(9);
    for (int i = 0; i < 60; ++i)
    {
      const PrimitiveId id = hittable[uniform.index(hittable.size())];
      HalfSpace half = { { uniform(-1, 1), uniform(-1, 1), uniform(-1, 1) }, 0.0 };
      const auto corners = surface->vertices(id);
      const Rational least =
        std::min({ height(half, corners[0]), height(half, corners[1]), height(half, corners[2]) });
      half.offset = least.convert_to<double>();
      while (rational(half.offset) < least)
      {
        half.offset = std::nextafter(half.offset, inf);
      }
      for (const auto& accelerator : all)
      {
        const std::vector<PrimitiveId> found = overlapOf(*accelerator, { half });
        EXPECT_TRUE(std::binary_search(found.begin(), found.end(), id))
          << label(accelerator->options());
      }
    }
  }
}

TEST(Overlap, MoreHalfSpacesThanNodesAreTestedAgainst)
{
  const auto surface = surfaceOf<float>(data::teapot(3));
  const auto all = allOver(surface);
  Uniform uniform(3);
  const Vec3 middle = surface->bounds().centre();
  for (const std::size_t planes : { 63u, 64u, 65u, 200u })
  {
    ConvexRegion region;
    while (region.size() < planes)
    {
      const Vec3 n = { uniform(-1, 1), uniform(-1, 1), uniform(-1, 1) };
      region.push_back({ n, dot(n, middle) + 0.5 * length(n) * surface->bounds().size()[2] });
    }
    const std::vector<PrimitiveId> wanted = overlapOf(*all.front(), region);
    EXPECT_FALSE(wanted.empty());
    EXPECT_LT(wanted.size(), surface->hittable().size());
    for (const auto& accelerator : all)
    {
      EXPECT_EQ(overlapOf(*accelerator, region), wanted) << label(accelerator->options());
    }
  }
}

TEST(Overlap, TheLengthOfNormalsDoesNotMatter)
{
  const auto surface = surfaceOf<float>(data::teapot(3));
  const auto accelerator = build(surface, optionsOf(Structure::WideBvh));
  for (const ConvexRegion& region : regionsAround(*surface, 50))
  {
    const std::vector<PrimitiveId> wanted = overlapOf(*accelerator, region);
    for (const double factor : { 0x1p-900, 0x1p900 })
    {
      ConvexRegion scaled = region;
      for (HalfSpace& half : scaled)
      {
        half.normal = factor * half.normal;
        half.offset *= factor;
      }
      EXPECT_EQ(overlapOf(*accelerator, scaled), wanted);
    }
  }
}

TEST(Overlap, WhatTouchesIsKept)
{
  const auto surface =
    surfaceOf<double>({ { Vec3{ 0.1, 0, 0 }, Vec3{ 1.1, 0, 0 }, Vec3{ 0.1, 1, 0 } },
      { Vec3{ 0.1, 0, 0 }, Vec3{ -1, 0, 0 }, Vec3{ 0, -1, 0 } } });
  for (const auto& accelerator : allOver(surface))
  {
    SCOPED_TRACE(label(accelerator->options()));
    using Ids = std::vector<PrimitiveId>;
    EXPECT_EQ(overlapOf(*accelerator, { { { 1, 0, 0 }, 0.1 } }), (Ids{ 0, 1 }));
    EXPECT_EQ(overlapOf(*accelerator, { { { 1, 0, 0 }, 0.1 - 0x1p-40 } }), (Ids{ 1 }));
    EXPECT_EQ(overlapOf(*accelerator, { { { -1, 0, 0 }, -0.1 } }), (Ids{ 0, 1 }));
    EXPECT_EQ(overlapOf(*accelerator, { { { -1, 0, 0 }, -0.1 - 0x1p-40 } }), (Ids{ 0 }));
    EXPECT_EQ(overlapOf(*accelerator, { { { 0, 0, 1 }, -0x1p-40 } }), Ids{});
  }
}

TEST(Overlap, ExtremeCoordinates)
{
  for (const double scale : { 1e-300, 1e-30, 1e30, 1e299 })
  {
    std::vector<std::array<Vec3, 3>> triangles;
    for (int i = 0; i < 40; ++i)
    {
      const Vec3 p = { scale * i * 0.1, scale * (i % 7), scale };
      triangles.push_back({ p, p + Vec3{ scale, 0, 0 }, p + Vec3{ 0, scale, scale } });
    }
    const auto surface = surfaceOf<double>(triangles);
    const ConvexRegion region = { { { scale, 0.5 * scale, 0 }, 2 * scale * scale },
      { { 1, 1, 1 }, 4 * scale }, { { 1e300, 1e-20, 0 }, inf } };
    const auto all = allOver(surface);
    const std::vector<PrimitiveId> wanted = overlapOf(*all.front(), region);
    for (const PrimitiveId id : surface->hittable())
    {
      const bool meets = std::isfinite(scale * scale) && scale * scale > 0 &&
        whereIs(*surface, id, { region[0], region[1] }) == Where::Meets;
      EXPECT_TRUE(!meets || std::binary_search(wanted.begin(), wanted.end(), id));
    }
    for (const auto& accelerator : all)
    {
      EXPECT_EQ(overlapOf(*accelerator, region), wanted) << label(accelerator->options());
    }
  }
}

TEST(Overlap, OnlyWhatCanBeHit)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto surface = surfaceOf<double>({ { Vec3{ 0, 0, 0 }, Vec3{ 1, 0, 0 }, Vec3{ 2, 0, 0 } },
    { Vec3{ 0, 0, 0 }, Vec3{ nan, 0, 0 }, Vec3{ 2, 1, 0 } },
    { Vec3{ 0, 0, 0 }, Vec3{ 1, 0, 0 }, Vec3{ 0, 1, 0 } } });
  const auto nothing = surfaceOf<float>(std::vector<std::array<Vec3, 3>>{});
  for (const auto& accelerator : accelerators(surface))
  {
    EXPECT_EQ(overlapOf(*accelerator, {}), std::vector<PrimitiveId>{ 2 });
  }
  for (const auto& accelerator : accelerators(nothing))
  {
    EXPECT_TRUE(overlapOf(*accelerator, {}).empty());
    EXPECT_TRUE(overlapOf(*accelerator, { { { 1, 0, 0 }, 1.0 } }).empty());
  }
}

TEST(Overlap, NumbersThatAreNoneAreRefused)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto surface = surfaceOf<float>(data::teapot(2));
  std::vector<PrimitiveId> found;
  for (const auto& accelerator : allOver(surface))
  {
    for (const HalfSpace& half : { HalfSpace{ { nan, 0, 0 }, 1 }, HalfSpace{ { 0, 0, 1 }, nan },
           HalfSpace{ { 0, inf, 0 }, 1 }, HalfSpace{ { 0, 0, -inf }, 1 } })
    {
      EXPECT_THROW(
        accelerator->overlap({ { { 1, 0, 0 }, 1 }, half }, found), std::invalid_argument);
    }
  }
}

TEST(Overlap, FromSeveralThreadsAtOnce)
{
  const auto surface = surfaceOf<float>(data::city(1));
  const auto regions = regionsAround(*surface, 40);
  const auto oracle = build(surface, optionsOf(Structure::BruteForce));
  const auto accelerator = build(surface, optionsOf(Structure::WideBvh));
  std::vector<std::size_t> differences(4, 0);
  std::vector<std::thread> threads;
  for (std::size_t& count : differences)
  {
    threads.emplace_back(
      [&]
      {
        for (const ConvexRegion& region : regions)
        {
          count += overlapOf(*accelerator, region) == overlapOf(*oracle, region) ? 0 : 1;
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(std::accumulate(differences.begin(), differences.end(), std::size_t{ 0 }), 0u);
}

} // namespace
