// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// The uniform grid: lattice-aligned rays against brute force, resolutions asked for and automatic,
// bounded memory, scales and offsets, counts of cells.
#include "CellStructures.h"

#include <gtest/gtest.h>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

using Corners = std::array<Vec3, 3>;

BuildOptions gridOf(const std::array<int, 3>& resolution)
{
  BuildOptions options = optionsOf(Structure::Grid);
  options.gridResolution = resolution;
  return options;
}

TEST(Grid, ALatticeOfRaysAgainstBruteForce)
{
  const auto triangles = latticeTriangles(80, 8, 1);
  const Rays rays = latticeRays(60000, 10, 2);
  for (const auto& surface : { surfaceOf<float>(triangles), surfaceOf<double>(triangles) })
  {
    EXPECT_EQ(differences(surface, optionsOf(Structure::Grid), rays), 0u);
    const Vec3 size = surface->bounds().size();
    // Planes at whole numbers: rays run in faces, along edges and through corners of cells.
    EXPECT_EQ(
      differences(surface,
        gridOf({ static_cast<int>(size[0]), static_cast<int>(size[1]), static_cast<int>(size[2]) }),
        rays),
      0u);
  }
}

TEST(Grid, WhatIsBehindEmptyBlocksIsFound)
{
  // Few small triangles in 64³ cells of length 1, so that most blocks of 8³ are empty; many lie on
  // planes and corners of blocks. Rays run in those planes, along their edges, through corners.
  Uniform uniform(9);
  const auto whole = [&](double step, std::size_t n)
  { return step * static_cast<double>(uniform.index(n)); };
  std::vector<Corners> triangles = { { Vec3{ 0, 0, 0 }, Vec3{ 1, 0, 0 }, Vec3{ 0, 1, 0 } },
    { Vec3{ 64, 64, 64 }, Vec3{ 63, 64, 64 }, Vec3{ 64, 63, 64 } } };
  for (int i = 0; i < 120; ++i)
  {
    const double step = i % 2 == 0 ? 8 : 1;
    const std::size_t n = i % 2 == 0 ? 8 : 63;
    const Vec3 p = { whole(step, n), whole(step, n), whole(step, n) };
    const auto edge = [&] { return Vec3{ whole(1, 3) - 1, whole(1, 3) - 1, whole(1, 3) - 1 }; };
    triangles.push_back({ p, p + edge(), p + edge() });
  }
  const auto surface = surfaceOf<double>(triangles);
  Rays rays;
  for (int i = 0; i < 40000; ++i)
  {
    const auto& corners = triangles[uniform.index(triangles.size())];
    const Vec3 target =
      i % 3 == 0 ? corners[0] : (1.0 / 4) * (corners[0] + corners[1]) + 0.5 * corners[2];
    Ray ray = { { whole(8, 9), whole(8, 9), whole(8, 9) }, {} };
    ray.direction = i % 2 == 0
      ? target - ray.origin
      : Vec3{ whole(1, 3) - 1, whole(1, 3) - 1, whole(1, 3) - (i % 4 == 1 ? 1 : 1.000000001) };
    ray.tMin = i % 5 == 0 ? whole(0.125, 9) : 0;
    ray.tMax = i % 7 == 0 ? ray.tMin + whole(0.125, 9) : ray.tMax;
    rays.add(ray);
  }
  EXPECT_EQ(differences(surface, gridOf({ 64, 64, 64 }), rays), 0u);
  EXPECT_EQ(differences(surface, gridOf({ 61, 64, 9 }), rays), 0u);
}

TEST(Grid, EmptyBlocksAreLeftAtOneStride)
{
  // Eighty cells with a triangle at either end: of eight of the blocks only the first cell is
  // stepped through, and where the next one begins.
  const auto surface =
    surfaceOf<double>(std::vector<Corners>{ { Vec3{ 0, 0, 0 }, Vec3{ 0, 1, 0 }, Vec3{ 0, 0, 1 } },
      { Vec3{ 80, 0, 0 }, Vec3{ 80, 1, 0 }, Vec3{ 80, 0, 1 } } });
  const auto grid = build(surface, gridOf({ 80, 1, 1 }));
  Rays rays;
  rays.add({ 0.5, 0.25, 0.25 }, { 1, 0, 0 });
  rays.add({ 79.5, 0.25, 0.25 }, { -1, 0, 0 });
  std::vector<RayCounters> counters(2);
  QueryOptions options = with(Precision::Exact);
  options.perRay = counters.data();
  std::vector<Hit> hits(2);
  grid->closest(rays.batch(), hits.data(), options);
  for (int i = 0; i < 2; ++i)
  {
    EXPECT_EQ(hits[static_cast<std::size_t>(i)].t, 79.5);
    EXPECT_EQ(counters[static_cast<std::size_t>(i)].cells, 8u + 8u + 8u);
  }
}

TEST(Grid, EveryResolutionGivesTheSameAnswers)
{
  const auto surface = surfaceOf<float>(data::teapot(3));
  const Rays rays = raysAround(*surface, 500, 3);
  for (const std::array<int, 3>& resolution :
    { std::array<int, 3>{ 1, 1, 1 }, { 1, 1, 200 }, { 2, 3, 5 }, { 64, 64, 64 }, { 4096, 1, 1 } })
  {
    EXPECT_EQ(differences(surface, gridOf(resolution), rays), 0u)
      << ::testing::PrintToString(resolution);
  }
}

TEST(Grid, ScalesAndOffsets)
{
  const auto triangles = latticeTriangles(60, 8, 4);
  const Rays rays = latticeRays(300, 10, 5);
  const auto placed = [&](double scale, double offset)
  {
    auto moved = triangles;
    for (Corners& t : moved)
    {
      for (Vec3& p : t)
      {
        p = scale * p + Vec3{ offset, -offset, offset };
      }
    }
    Rays movedRays = rays;
    for (std::size_t i = 0; i < movedRays.origins.size(); ++i)
    {
      movedRays.origins[i] = scale * movedRays.origins[i] + (i % 3 == 1 ? -offset : offset);
      movedRays.directions[i] *= scale;
    }
    return differences(surfaceOf<double>(moved), optionsOf(Structure::Grid), movedRays);
  };
  EXPECT_EQ(placed(0x1p-400, 0), 0u);
  EXPECT_EQ(placed(0x1p-120, 0), 0u);
  EXPECT_EQ(placed(0x1p120, 0), 0u);
  EXPECT_EQ(placed(0x1p400, 0), 0u);
  EXPECT_EQ(placed(1, 0x1p24), 0u);
  EXPECT_EQ(placed(1, 0x1p52), 0u);
}

TEST(Grid, AFlatSceneIsNotDividedAcross)
{
  std::vector<Corners> triangles;
  for (int i = 0; i < 400; ++i)
  {
    const Vec3 p = { static_cast<double>(i % 20), static_cast<double>(i / 20), 3 };
    triangles.push_back({ p, p + Vec3{ 1, 0, 0 }, p + Vec3{ 0, 1, 0 } });
  }
  const auto surface = surfaceOf<float>(triangles);
  EXPECT_EQ(differences(surface, optionsOf(Structure::Grid), raysAround(*surface, 3000, 6)), 0u);
  const auto grid = build(surface, optionsOf(Structure::Grid));
  EXPECT_GT(grid->statistics().leaves, 50u);
  for (const HierarchyNode& node : grid->hierarchy().nodes)
  {
    EXPECT_EQ(node.box.lower[2], node.box.upper[2]);
  }
}

TEST(Grid, MemoryIsBounded)
{
  const auto stadium = surfaceOf<double>(data::teapotInStadium(10, 1e6));
  BuildOptions options = optionsOf(Structure::Grid);
  options.gridDensity = 100;
  const auto grid = build(stadium, options);
  EXPECT_LE(grid->statistics().references, 65536 + 16 * stadium->size());
  EXPECT_LT(grid->statistics().memory, std::size_t{ 1 } << 28);

  EXPECT_THROW((void)build(stadium, gridOf({ 1024, 1024, 1024 })), std::invalid_argument);
}

TEST(Grid, OptionsOutOfRangeAreRefused)
{
  const auto surface = surfaceOf<float>(data::cornellBox());
  for (const double density : { 0.0, -1.0, 1001.0, std::nan("") })
  {
    BuildOptions options;
    options.gridDensity = density;
    EXPECT_THROW((void)build(surface, options), std::invalid_argument) << density;
  }
  for (const std::array<int, 3>& resolution :
    { std::array<int, 3>{ 0, 1, 1 }, { 1, -1, 1 }, { 1, 1, (1 << 20) + 1 } })
  {
    EXPECT_THROW((void)build(surface, gridOf(resolution)), std::invalid_argument);
  }
  BuildOptions a = gridOf({ 1, 2, 3 });
  BuildOptions b = a;
  EXPECT_TRUE(a == b);
  b.gridResolution[2] = 4;
  EXPECT_FALSE(a == b);
  a = b;
  b.gridDensity = 2;
  EXPECT_FALSE(a == b);
}

TEST(Grid, CellsSteppedAreThoseOnTheWay)
{
  // A triangle at either end of ten cells.
  const auto surface =
    surfaceOf<double>(std::vector<Corners>{ { Vec3{ 0, 0, 0 }, Vec3{ 0, 1, 0 }, Vec3{ 0, 0, 1 } },
      { Vec3{ 10, 0, 0 }, Vec3{ 10, 1, 0 }, Vec3{ 10, 0, 1 } } });
  const auto grid = build(surface, gridOf({ 10, 1, 1 }));
  const auto cells = [&](const Ray& ray)
  {
    Rays rays;
    rays.add(ray);
    RayCounters counters;
    QueryOptions options = with(Precision::Exact);
    options.perRay = &counters;
    Hit hit;
    grid->closest(rays.batch(), &hit, options);
    return counters.cells;
  };
  EXPECT_EQ(cells({ { 0.5, 0.25, 0.25 }, { 1, 0, 0 } }), 10u);
  EXPECT_EQ(cells({ { -1, 0.25, 0.25 }, { 1, 0, 0 } }), 1u); // stops at the first hit
  EXPECT_EQ(cells({ { 0.5, 0.25, 0.25 }, { 1, 0, 0 }, 0, 2 }), 3u);
  EXPECT_EQ(cells({ { 0.5, 0.25, 0.25 }, { 1, 0, 0 }, 0, 2.5 }), 4u); // ends on a plane: both sides
  EXPECT_EQ(cells({ { 5, 0.25, 0.25 }, { 0, 1, 0 } }), 2u);           // runs in a plane: both sides
  EXPECT_EQ(cells({ { 5.5, 0.25, 0.25 }, { 0, -1, 0 } }), 1u);
  EXPECT_EQ(cells({ { 5, 2, 0.25 }, { 1, 0, 0 } }), 0u); // passes beside
}

/// Refused before anything is inserted: the memory and a minute that it would take are not spent.
TEST(Grid, TooManyReferencesAreRefusedAtOnce)
{
  std::vector<std::array<Vec3, 3>> triangles(
    20000, { Vec3{ 0, 0, 0 }, Vec3{ 1, 0, 1 }, Vec3{ 0, 1, 1 } });
  BuildOptions options = optionsOf(Structure::Grid);
  options.gridResolution = { 500, 500, 500 };
  int asked = 0;
  JobControl control;
  control.onProgress = [&](double)
  {
    ++asked;
    return true;
  };
  EXPECT_THROW((void)build(surfaceOf<float>(triangles), options, &control), std::length_error);
  EXPECT_EQ(asked, 1);
}

TEST(Grid, OneHugeTriangleDoesNotSpoilTheGridOfTheOthers)
{
  Uniform uniform(5);
  std::vector<std::array<Vec3, 3>> triangles = { { Vec3{ 0, 0, 5 }, Vec3{ 10, 0, 5 },
    Vec3{ 0, 10, 6 } } };
  for (int i = 0; i < 4000; ++i)
  {
    const Vec3 p = { uniform(0, 10), uniform(0, 10), uniform(0, 10) };
    triangles.push_back({ p, p + Vec3{ 0.1, 0, 0.05 }, p + Vec3{ 0, 0.1, 0.05 } });
  }
  const auto with = build(surfaceOf<float>(triangles), optionsOf(Structure::Grid));
  const std::size_t leaves = with->statistics().leaves;
  triangles.erase(triangles.begin());
  const auto without = build(surfaceOf<float>(triangles), optionsOf(Structure::Grid));
  EXPECT_GE(leaves, without->statistics().leaves);
}

} // namespace
