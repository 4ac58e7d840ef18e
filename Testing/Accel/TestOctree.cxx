// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// The octree: lattice-aligned rays against brute force, triangles in the planes that halve it,
// bounded depth and memory, cells that are octants.
#include "CellStructures.h"

#include <gtest/gtest.h>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

using Corners = std::array<Vec3, 3>;

TEST(Octree, ALatticeOfRaysAgainstBruteForce)
{
  // A box of 16 makes the halving planes whole numbers, so that triangles lie in them and rays run
  // along them.
  auto triangles = latticeTriangles(80, 8, 11);
  triangles.push_back({ Vec3{ 0, 0, 0 }, Vec3{ 1, 0, 0 }, Vec3{ 0, 0, 1 } });
  triangles.push_back({ Vec3{ 16, 16, 16 }, Vec3{ 15, 16, 16 }, Vec3{ 16, 15, 16 } });
  const Rays rays = latticeRays(60000, 12, 12);
  for (const auto& surface : { surfaceOf<float>(triangles), surfaceOf<double>(triangles) })
  {
    BuildOptions options = optionsOf(Structure::Octree);
    EXPECT_EQ(differences(surface, options, rays), 0u);
    options.leafSize = 1;
    EXPECT_EQ(differences(surface, options, rays), 0u);
  }
}

TEST(Octree, ATriangleInTheSplitPlaneIsFoundFromEitherSide)
{
  std::vector<Corners> triangles = { { Vec3{ 4, 1, 1 }, Vec3{ 4, 3, 1 }, Vec3{ 4, 1, 3 } } };
  for (int i = 0; i < 8; ++i)
  {
    const Vec3 p = { i & 1 ? 7.0 : 0.0, i & 2 ? 7.0 : 0.0, i & 4 ? 7.0 : 0.0 };
    triangles.push_back({ p, p + Vec3{ 1, 0, 1 }, p + Vec3{ 0, 1, 1 } });
  }
  const auto octree = build(surfaceOf<float>(triangles), optionsOf(Structure::Octree));
  ASSERT_GT(octree->statistics().leaves, 1u);
  for (const Precision precision : everyPrecision)
  {
    for (const double side : { -1.0, 1.0 })
    {
      const Hit hit = closestOf(*octree, { { 4 - 2 * side, 1.5, 1.5 }, { side, 0, 0 } }, precision);
      EXPECT_EQ(hit.primitive, 0u);
      EXPECT_EQ(hit.t, 2.0);
    }
  }
}

TEST(Octree, ScalesAndOffsets)
{
  for (const double scale : { 1e-120, 1e-30, 1e30, 1e120 })
  {
    auto mesh = data::teapot(3);
    for (double& x : mesh.points)
    {
      x *= scale;
    }
    const auto surface = surfaceOf<double>(mesh);
    Rays rays = raysAround(*surface, 100, 13);
    EXPECT_EQ(differences(surface, optionsOf(Structure::Octree), rays), 0u) << scale;
  }
  for (const double offset : { 0x1p24, 0x1p40, 0x1p50 })
  {
    const auto surface = surfaceOf<double>(data::teapot(3), { offset, -offset, offset });
    EXPECT_EQ(differences(surface, optionsOf(Structure::Octree), raysAround(*surface, 100, 14)), 0u)
      << offset;
  }
}

TEST(Octree, DepthAndMemoryAreBounded)
{
  const auto stadium = surfaceOf<double>(data::teapotInStadium(6, 1e6));
  BuildOptions options = optionsOf(Structure::Octree);
  options.leafSize = 1;
  const auto octree = build(stadium, options);
  EXPECT_LE(octree->statistics().depth, 21);
  EXPECT_LE(octree->statistics().references, 65536 + 16 * stadium->size());
  for (const int depth : { 1, 2, 5 })
  {
    options.maxDepth = depth;
    EXPECT_LE(build(stadium, options)->statistics().depth, depth);
  }
}

/// A sphere around the root's middle: its planes touch many of the few triangles.
TEST(Octree, ASmallSphereIsDivided)
{
  const auto tree = build(surfaceOf<float>(data::sphere(6)), optionsOf(Structure::Octree));
  EXPECT_GT(tree->statistics().leaves, 50u);
  EXPECT_LT(tree->statistics().duplication, 4.0);
}

TEST(Octree, CellsAreOctantsOfTheirParents)
{
  const auto surface = surfaceOf<float>(data::randomCloud(3000));
  const auto octree = build(surface, optionsOf(Structure::Octree));
  const HierarchyView view = octree->hierarchy();
  const double edge = surface->bounds().size()[surface->bounds().longestAxis()];
  ASSERT_GT(octree->statistics().depth, 2);
  for (const HierarchyNode& node : view.nodes)
  {
    for (const double size : node.box.size())
    {
      EXPECT_LE(size, edge * (std::ldexp(1.0, -node.depth) + 1e-9));
    }
  }
}

} // namespace
