// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells and split planes: triangles in the planes that divide space, hits exactly on a cell's
// border, rays along cell faces, edges and diagonals, triangles much larger than cells. Every
// structure must answer as brute force does, to the bit.
#include "TestHelpers.h"

#include <gtest/gtest.h>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

using Corners = std::array<Vec3, 3>;

/// Whether a structure looks for a primitive only where its surface is, and not wherever its box
/// is.
bool dividesSpace(Structure structure)
{
  return structure == Structure::Grid || structure == Structure::Octree ||
    structure == Structure::KdTree || structure == Structure::BspTree;
}

/// Fast and Watertight take a primitive for hit by a ray in its plane that passes it by, as long as
/// the ray meets its box. What divides space may find fewer of these, never fewer than Exact has,
/// and none that brute force has not.
void expectBetween(const AllHits& exact, const AllHits& hits, const AllHits& wanted)
{
  for (std::size_t i = 0; i + 1 < hits.offsets.size(); ++i)
  {
    const auto contains = [&](const AllHits& others, const auto& matches)
    {
      return std::any_of(others.hits.begin() + static_cast<std::ptrdiff_t>(others.offsets[i]),
        others.hits.begin() + static_cast<std::ptrdiff_t>(others.offsets[i + 1]), matches);
    };
    for (auto h = hits.offsets[i]; h < hits.offsets[i + 1]; ++h)
    {
      ASSERT_TRUE(contains(wanted, [&](const Hit& other) { return sameBits(hits.hits[h], other); }))
        << "ray " << i;
    }
    for (auto h = exact.offsets[i]; h < exact.offsets[i + 1]; ++h)
    {
      ASSERT_TRUE(contains(
        hits, [&](const Hit& other) { return exact.hits[h].primitive == other.primitive; }))
        << "ray " << i;
    }
  }
}

/// Every query of every structure and precision against brute force.
void expectBruteForce(const std::vector<Corners>& triangles, const Rays& rays)
{
  for (const auto& surface : { surfaceOf<float>(triangles), surfaceOf<double>(triangles) })
  {
    const auto oracle = build(surface, optionsOf(Structure::BruteForce));
    AllHits exact;
    oracle->all(rays.batch(), exact, with(Precision::Exact));
    for (const Precision precision : everyPrecision)
    {
      std::vector<Hit> wanted(rays.size());
      AllHits wantedAll;
      oracle->closest(rays.batch(), wanted.data(), with(precision));
      oracle->all(rays.batch(), wantedAll, with(precision));
      for (const auto& accelerator : accelerators(surface))
      {
        SCOPED_TRACE(label(accelerator->options()) + ", " + std::string(name(precision)));
        std::vector<Hit> hits(rays.size());
        std::vector<std::uint8_t> any(rays.size());
        std::vector<std::uint32_t> counts(rays.size());
        AllHits all;
        accelerator->closest(rays.batch(), hits.data(), with(precision));
        accelerator->any(rays.batch(), any.data(), with(precision));
        accelerator->count(rays.batch(), counts.data(), with(precision));
        accelerator->all(rays.batch(), all, with(precision));
        if (dividesSpace(accelerator->options().structure) && precision == Precision::Watertight)
        {
          expectBetween(exact, all, wantedAll);
          for (std::size_t i = 0; i < rays.size(); ++i)
          {
            ASSERT_EQ(counts[i], all.offsets[i + 1] - all.offsets[i]) << "ray " << i;
            ASSERT_EQ(any[i], counts[i] > 0 ? 1 : 0) << "ray " << i;
            ASSERT_EQ(hits[i].primitive != noPrimitive, counts[i] > 0) << "ray " << i;
          }
          continue;
        }
        for (std::size_t i = 0; i < rays.size(); ++i)
        {
          const Ray ray = rays.batch()[i];
          ASSERT_EQ(all.offsets[i + 1], wantedAll.offsets[i + 1])
            << "ray " << i << " from " << ::testing::PrintToString(ray.origin) << " along "
            << ::testing::PrintToString(ray.direction) << " between " << ray.tMin << " and "
            << ray.tMax;
          ASSERT_TRUE(sameBits(hits[i], wanted[i])) << "ray " << i;
          ASSERT_EQ(any[i], wanted[i].primitive != noPrimitive ? 1 : 0) << "ray " << i;
          ASSERT_EQ(counts[i], all.offsets[i + 1] - all.offsets[i]) << "ray " << i;
        }
        for (std::size_t h = 0; h < all.hits.size(); ++h)
        {
          ASSERT_TRUE(sameBits(all.hits[h], wantedAll.hits[h])) << "hit " << h;
        }
      }
    }
  }
}

/// Unit right triangles in all three orientations at lattice points: they lie in, and touch, every
/// plane that divides a power of two cells.
std::vector<Corners> lattice(int n)
{
  std::vector<Corners> triangles;
  for (int x = 0; x < n; ++x)
  {
    for (int y = 0; y < n; ++y)
    {
      for (int z = 0; z < n; ++z)
      {
        const Vec3 p = { double(x), double(y), double(z) };
        const int axis = (x + 2 * y + 3 * z) % 3;
        Vec3 a = p;
        Vec3 b = p;
        a[(axis + 1) % 3] += 1;
        b[(axis + 2) % 3] += 1;
        triangles.push_back({ p, a, b });
      }
    }
  }
  return triangles;
}

/// Rays between lattice points and half-way points: along edges, faces and diagonals of cells, many
/// with a component of ±0, ending or beginning exactly on borders.
Rays latticeRays(int n, std::size_t count)
{
  Uniform uniform(13);
  Rays rays;
  for (std::size_t i = 0; i < count; ++i)
  {
    Ray ray;
    for (int k = 0; k < 3; ++k)
    {
      ray.origin[k] =
        static_cast<double>(uniform.index(2 * static_cast<std::size_t>(n) + 5)) / 2 - 1;
      ray.direction[k] = static_cast<double>(uniform.index(3)) - 1;
    }
    if (i % 5 == 0)
    {
      ray.direction = { 1, 1, 1 };
    }
    if (i % 5 == 1)
    {
      ray.direction[uniform.index(3)] = -0.0;
    }
    if (i % 7 == 0)
    {
      ray.direction[uniform.index(3)] *= 0x1p-1030; // all but along a plane
    }
    if (i % 3 == 0)
    {
      ray.tMin = static_cast<double>(uniform.index(3));
      ray.tMax = ray.tMin + static_cast<double>(uniform.index(4));
    }
    rays.add(ray);
  }
  return rays;
}

TEST(Cells, TrianglesInSplitPlanesAndRaysAlongThem)
{
  expectBruteForce(lattice(4), latticeRays(4, 1500));
}

TEST(Cells, DiagonalThroughEveryLatticePoint)
{
  Rays rays;
  for (const Vec3& d : { Vec3{ 1, 1, 1 }, Vec3{ 1, 1, 0 }, Vec3{ 0, -1, 1 }, Vec3{ -1, 1, -1 } })
  {
    for (const double start : { -1.0, 0.0, 0.5, 8.0 })
    {
      for (const double scale : { 1.0, 0x1p-40, 0x1p40, 1.0 / 3.0 })
      {
        rays.add({ start, start, start }, scale * d);
        rays.add({ start, 8 - start, start }, scale * d);
      }
    }
  }
  expectBruteForce(lattice(8), rays);
}

TEST(Cells, ATriangleAcrossAllCellsDoesNotHideANearerOne)
{
  // The large triangle is in the first cell a ray enters, and hit in the last; small ones lie in
  // between.
  std::vector<Corners> triangles = { { Vec3{ 0, 0, 0 }, Vec3{ 16, 0, 16 }, Vec3{ 16, 16, 16 } },
    { Vec3{ 0, 0, 0 }, Vec3{ 16, 16, 16 }, Vec3{ 0, 16, 0 } } };
  Uniform uniform(15);
  for (int i = 0; i < 300; ++i)
  {
    const Vec3 p = { uniform(0, 16), uniform(0, 16), uniform(0, 16) };
    triangles.push_back({ p, p + Vec3{ 0.5, 0, 0.1 }, p + Vec3{ 0, 0.5, 0.2 } });
  }
  Rays rays;
  for (int i = 0; i < 800; ++i)
  {
    const Vec3 o = { uniform(-2, 18), uniform(-2, 18), uniform(-2, 18) };
    rays.add(o, Vec3{ uniform(0, 16), uniform(0, 16), uniform(0, 16) } - o);
  }
  expectBruteForce(triangles, rays);
}

TEST(Cells, AMillionCellsLengthsAway)
{
  // Two clusters far apart along one axis: positions along the ray must not drift.
  std::vector<Corners> triangles;
  for (int i = 0; i < 200; ++i)
  {
    const double x = (i < 100 ? 0.0 : 1e6) + 0.25 * (i % 100);
    triangles.push_back({ Vec3{ x, 0, 0 }, Vec3{ x, 1, 0 }, Vec3{ x, 0, 1 } });
  }
  Rays rays;
  Uniform uniform(19);
  for (int i = 0; i < 400; ++i)
  {
    const double y = static_cast<double>(uniform.index(9)) / 8;
    const double z = static_cast<double>(uniform.index(9)) / 8;
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    rays.add({ side > 0 ? 30.0 : 999990.0, y, z }, { side, 0, 0 });
    rays.add(
      { side > 0 ? 30.0 : 999990.0, y, z }, { side, uniform(-1e-7, 1e-7), uniform(-1e-7, 1e-7) });
    rays.add(Ray{ { 0, y, z }, { 1, 0, 0 }, 20, 1e6 });
    rays.add(Ray{ { 0, y, z }, { 0.125, 0, 0 }, 8e6, 8e6 });
  }
  expectBruteForce(triangles, rays);
}

TEST(Cells, OneCellAndFlatScenes)
{
  Rays rays = latticeRays(1, 400);
  expectBruteForce(lattice(1), rays);
  expectBruteForce({ { Vec3{ 0, 0, 0 }, Vec3{ 1, 0, 0 }, Vec3{ 0, 1, 0 } },
                     { Vec3{ 1, 1, 0 }, Vec3{ 1, 0, 0 }, Vec3{ 0, 1, 0 } } },
    rays);
  std::vector<Corners> flat;
  for (int x = 0; x < 8; ++x)
  {
    for (int y = 0; y < 8; ++y)
    {
      const Vec3 p = { double(x), double(y), 2 };
      flat.push_back({ p, p + Vec3{ 1, 0, 0 }, p + Vec3{ 1, 1, 0 } });
      flat.push_back({ p, p + Vec3{ 1, 1, 0 }, p + Vec3{ 0, 1, 0 } });
    }
  }
  expectBruteForce(flat, latticeRays(8, 800));
}

TEST(Cells, TrianglesThatTouchCellsInAPointOrAnEdge)
{
  std::vector<Corners> triangles;
  for (int i = 0; i < 64; ++i)
  {
    const Vec3 p = { double(i % 4) * 2, double(i / 4 % 4) * 2, double(i / 16) * 2 };
    // Tips on lattice points, bodies leaning away from the diagonal.
    triangles.push_back({ p, p + Vec3{ 0.75, -0.5, 0.25 }, p + Vec3{ -0.5, 0.75, 0.25 } });
    triangles.push_back({ p, p + Vec3{ 0, 0, 2 }, p + Vec3{ 0.5, 0.5, 1 } });
  }
  expectBruteForce(triangles, latticeRays(8, 1500));
}

} // namespace
