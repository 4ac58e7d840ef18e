// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// No ray leaves a closed surface: rays exactly through vertices and edge midpoints, normalised
// directions to vertices and random ones, from inside; at the origin and far from it, floats and
// doubles. And Exact names the lowest primitive of those that share the point.
#include "TestHelpers.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

enum class Aim
{
  Vertex,
  Edge,
  NormalisedVertex,
  Random
};

struct Closed
{
  std::string name;
  std::shared_ptr<const Surface> surface;
  Vec3 offset;
  double grid;        ///< coordinates are multiples of it; 0: full mantissas
  bool torus = false; ///< else a sphere
};

constexpr double radius = 100.0;

data::Mesh scaled(data::Mesh mesh, double grid)
{
  for (double& x : mesh.points)
  {
    x = grid > 0.0 ? std::nearbyint(x * radius / grid) * grid : x * radius;
  }
  return mesh;
}

const std::vector<Closed>& surfaces()
{
  static const std::vector<Closed> all = []
  {
    std::vector<Closed> made;
    const auto add =
      [&](const std::string& name, bool torus, bool floats, const Vec3& offset, double grid)
    {
      const data::Mesh mesh = scaled(torus ? data::torus(96, 48, 0.3) : data::sphere(20), grid);
      made.push_back({ (torus ? "torus " : "sphere ") + name,
        floats ? surfaceOf<float>(mesh, offset) : surfaceOf<double>(mesh, offset), offset, grid,
        torus });
    };
    for (const bool torus : { false, true })
    {
      add("of floats", torus, true, { 0, 0, 0 }, 0x1p-10);
      add("of floats at 1e4", torus, true, { 1e4, 1e4, 1e4 }, 0x1p-10);
      add("of floats at 1e6", torus, true, { 1e6, 1e6, 1e6 }, 0x1p-4);
      add("of doubles", torus, false, { 0, 0, 0 }, 0.0);
      add("of doubles at UTM coordinates", torus, false, { 500000, 4649776, 100 }, 0.0);
    }
    return made;
  }();
  return all;
}

/// A point well inside, on the surface's grid.
Vec3 inside(const Closed& c, Uniform& uniform)
{
  Vec3 p = { uniform(-20, 20), uniform(-20, 20), uniform(-20, 20) };
  if (c.torus)
  {
    // On the ring, within half of the thinnest tube.
    const double angle = uniform(0, 6.28);
    p = { radius * std::cos(angle) + p[0] / 4, radius * std::sin(angle) + p[1] / 4, p[2] / 4 };
  }
  const double grid = c.grid > 0.0 ? c.grid : 0x1p-20;
  for (double& x : p)
  {
    x = std::nearbyint(x / grid) * grid;
  }
  return p + c.offset;
}

Rays rays(const Closed& c, Aim aim, std::size_t count)
{
  Uniform uniform(41);
  Rays all;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vec3 o = inside(c, uniform);
    const auto corners =
      c.surface->vertices(static_cast<PrimitiveId>(uniform.index(c.surface->size())));
    const std::size_t k = uniform.index(3);
    Vec3 d = { uniform(-1, 1), uniform(-1, 1), uniform(-1, 1) };
    switch (aim)
    {
      case Aim::Vertex:
        d = corners[k] - o;
        break;
      case Aim::Edge:
        d = (corners[k] - o) + (corners[(k + 1) % 3] - o);
        break;
      case Aim::NormalisedVertex:
        d = corners[k] - o;
        d = (1 / length(d)) * d;
        for (double& x : d)
        {
          x = static_cast<float>(x);
        }
        break;
      case Aim::Random:
        break;
    }
    all.add(o, d);
  }
  return all;
}

TEST(Watertight, NothingLeavesAClosedSurface)
{
  std::uint64_t traced = 0;
  for (const Closed& c : surfaces())
  {
    for (const auto& accelerator : accelerators(c.surface))
    {
      // Brute force, six thousand triangles a ray, gets by with fewer.
      const bool slow = accelerator->options().structure == Structure::BruteForce;
      for (const Aim aim : { Aim::Vertex, Aim::Edge, Aim::NormalisedVertex, Aim::Random })
      {
        const Rays all = rays(c, aim, slow ? 50 : 5000);
        for (const Precision precision : { Precision::Watertight, Precision::Exact })
        {
          SCOPED_TRACE(c.name + ", " + label(accelerator->options()) + ", " +
            std::string(name(precision)) + ", aim " + std::to_string(static_cast<int>(aim)));
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
  for (const Closed& c : surfaces())
  {
    // From inside a sphere about its centre every ray meets the surface once, so that a vertex
    // aimed at is what is hit; its coordinates on a grid make the aim exact.
    if (c.torus || c.grid == 0.0)
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
  const Closed& c = surfaces().front();
  const auto accelerator = build(c.surface);
  const Rays all = rays(c, Aim::Edge, 2000);
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
  for (const Closed& c : surfaces())
  {
    const auto accelerator = build(c.surface);
    const Rays all = rays(c, Aim::Random, 3000);
    std::vector<std::uint32_t> counts(all.size());
    accelerator->count(all.batch(), counts.data(), with(Precision::Exact));
    EXPECT_TRUE(
      std::all_of(counts.begin(), counts.end(), [](std::uint32_t n) { return n % 2 == 1; }))
      << c.name;
  }
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
