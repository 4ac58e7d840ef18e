// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells of grids, octrees, KD- and BSP-trees fill their box and do not overlap.
#include "Accel/Structures/GridLattice.h"
#include "Accel/Structures/OctreeCells.h"
#include "HierarchyScenes.h"

#include <algorithm>
#include <set>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

double volumeOf(const Box& box)
{
  const Vec3 size = box.size();
  return box.empty() ? 0.0 : size[0] * size[1] * size[2];
}

/// Of a convex polyhedron whose faces are seen counter-clockwise.
double volumeOf(const Polyhedron& polyhedron)
{
  double volume = 0.0;
  for (const auto& face : polyhedron.faces)
  {
    const Vec3 origin = polyhedron.points.front();
    const Vec3 a = polyhedron.points[face[0]] - origin;
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
    {
      volume +=
        dot(
          a, cross(polyhedron.points[face[i]] - origin, polyhedron.points[face[i + 1]] - origin)) /
        6.0;
    }
  }
  return volume;
}

TEST(Tiling, CellsOfABspTreeAreConvexAndTileTheBox)
{
  for (const auto& surface : surfaces())
  {
    const auto tree = build(surface, optionsOf(Structure::BspTree));
    const HierarchyView view = tree->hierarchy();
    ASSERT_EQ(view.polyhedra.size(), view.nodes.size());
    if (surface->size() == 0)
    {
      EXPECT_TRUE(view.polyhedra.front().faces.empty());
      continue;
    }
    std::vector<double> below(view.nodes.size(), 0.0);
    std::size_t slanted = 0;
    const Vec3 size = view.nodes[0].box.size();
    const double reach = length(view.nodes[0].box.lower) + length(size);
    for (std::size_t i = view.nodes.size(); i-- > 0;)
    {
      const Polyhedron& cell = view.polyhedra[i];
      const double volume = volumeOf(cell);
      below[i] += view.nodes[i].leaf ? volume : 0.0;
      if (view.nodes[i].parent >= 0)
      {
        below[static_cast<std::size_t>(view.nodes[i].parent)] += below[i];
      }
      slanted += !view.nodes[i].leaf && view.nodes[i].splitAxis < 0 ? 1 : 0;
      // Every edge belongs to two faces, once each way.
      std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
      for (const auto& face : cell.faces)
      {
        ASSERT_GE(face.size(), 3u);
        for (std::size_t k = 0; k < face.size(); ++k)
        {
          ASSERT_TRUE(edges.insert({ face[k], face[(k + 1) % face.size()] }).second);
        }
      }
      for (const auto& edge : edges)
      {
        ASSERT_EQ(edges.count({ edge.second, edge.first }), 1u) << "node " << i;
      }
      for (const Vec3& p : cell.points)
      {
        for (int k = 0; k < 3; ++k)
        {
          ASSERT_GE(p[k], view.nodes[i].box.lower[k] - 1e-14 * reach);
          ASSERT_LE(p[k], view.nodes[i].box.upper[k] + 1e-14 * reach);
        }
      }
    }
    const double whole = size[0] * size[1] * size[2];
    EXPECT_NEAR(volumeOf(view.polyhedra[0]), whole, 1e-12 * reach * reach * reach);
    EXPECT_NEAR(below[0], whole, 1e-12 * std::max(whole, 1e-3 * reach * reach * reach));
    EXPECT_TRUE(slanted > 0 || whole == 0.0);
  }
}

TEST(Tiling, CellsOfAKdTreeTileTheBox)
{
  for (const auto& surface : surfaces())
  {
    for (const KdBuild kdBuild : { KdBuild::Sah, KdBuild::SpatialMedian })
    {
      BuildOptions options = optionsOf(Structure::KdTree);
      options.kdBuild = kdBuild;
      const HierarchyView view = build(surface, options)->hierarchy();
      double sum = 0.0;
      for (const HierarchyNode& node : view.nodes)
      {
        sum += node.leaf ? volumeOf(node.box) : 0.0;
      }
      EXPECT_NEAR(sum, volumeOf(view.nodes[0].box), 1e-12 * volumeOf(view.nodes[0].box));
    }
  }
}

TEST(Tiling, CellsOfAGridTileTheBox)
{
  for (const auto& surface : surfaces())
  {
    const Box& bounds = surface->bounds();
    const GridLattice lattice(bounds, GridLattice::resolutionFor(bounds, 1000.0));
    double sum = 0.0;
    for (int z = 0; z < lattice.count(2); ++z)
    {
      for (int y = 0; y < lattice.count(1); ++y)
      {
        for (int x = 0; x < lattice.count(0); ++x)
        {
          const auto side = [&](int axis, int slab)
          {
            const std::vector<double>& planes = lattice.planes(axis);
            const auto i = static_cast<std::size_t>(slab);
            return planes[i + 1] - planes[i];
          };
          sum += side(0, x) * side(1, y) * side(2, z);
        }
      }
    }
    EXPECT_NEAR(sum, volumeOf(bounds), 1e-12 * volumeOf(bounds));
  }
}

double volumeOfOctants(const Box& cube, int depth)
{
  if (depth == 0)
  {
    return volumeOf(cube);
  }
  double sum = 0.0;
  for (int i = 0; i < 8; ++i)
  {
    sum += volumeOfOctants(OctreeCells::octantOf(cube, cube.centre(), i), depth - 1);
  }
  return sum;
}

TEST(Tiling, OctantsTileTheirCube)
{
  for (const auto& surface : surfaces())
  {
    const OctreeCells cells(surface->bounds());
    const double whole = volumeOf(cells.root());
    EXPECT_NEAR(volumeOfOctants(cells.root(), 4), whole, 1e-12 * whole);
  }
}

/// Empty octants are left out, and cells have a hair around them inside the bounds: those that are
/// there are as large together as the part of the bounds that they stand for.
TEST(Tiling, NoTwoLeavesOfAnOctreeOverlap)
{
  for (const auto& surface : surfaces())
  {
    const HierarchyView view = build(surface, optionsOf(Structure::Octree))->hierarchy();
    double sum = 0.0;
    for (const HierarchyNode& node : view.nodes)
    {
      sum += node.leaf ? volumeOf(node.box) : 0.0;
    }
    EXPECT_LE(sum, volumeOf(surface->bounds()) * (1.0 + 1e-6));
  }
}

} // namespace
