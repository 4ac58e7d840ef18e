// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Every structure as a list of nodes.
#include "HierarchyScenes.h"

#include <algorithm>
#include <set>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

bool contains(const Box& outer, const Box& inner)
{
  for (int k = 0; k < 3; ++k)
  {
    if (inner.lower[k] < outer.lower[k] || inner.upper[k] > outer.upper[k])
    {
      return false;
    }
  }
  return true;
}

TEST(Hierarchy, ParentsComeFirstAndContainTheirChildren)
{
  forEverything(
    [](const Accelerator& accelerator)
    {
      const HierarchyView view = accelerator.hierarchy();
      ASSERT_FALSE(view.nodes.empty());
      EXPECT_EQ(view.nodes[0].parent, -1);
      EXPECT_EQ(view.nodes[0].depth, 0);
      std::vector<int> children(view.nodes.size(), 0);
      for (std::size_t i = 1; i < view.nodes.size(); ++i)
      {
        const HierarchyNode& node = view.nodes[i];
        ASSERT_GE(node.parent, 0);
        ASSERT_LT(node.parent, static_cast<std::int64_t>(i));
        const HierarchyNode& parent = view.nodes[static_cast<std::size_t>(node.parent)];
        ASSERT_FALSE(parent.leaf);
        ASSERT_EQ(node.depth, parent.depth + 1);
        // What holds nothing may show an empty box.
        ASSERT_TRUE(node.box.empty() || contains(parent.box, node.box)) << "node " << i;
        ++children[static_cast<std::size_t>(node.parent)];
      }
      for (std::size_t i = 0; i < view.nodes.size(); ++i)
      {
        ASSERT_EQ(view.nodes[i].leaf, children[i] == 0) << "node " << i;
        ASSERT_LE(view.nodes[i].splitAxis, 2);
      }
    });
}

TEST(Hierarchy, EveryPrimitiveThatCanBeHitIsReferencedAndNoOther)
{
  forEverything(
    [](const Accelerator& accelerator)
    {
      const HierarchyView view = accelerator.hierarchy();
      std::set<PrimitiveId> found;
      std::size_t references = 0;
      for (const HierarchyNode& node : view.nodes)
      {
        if (node.leaf)
        {
          ASSERT_LE(node.firstReference + node.referenceCount, view.references.size());
          references += node.referenceCount;
          for (std::uint32_t r = 0; r < node.referenceCount; ++r)
          {
            found.insert(view.references[node.firstReference + r]);
          }
        }
      }
      EXPECT_EQ(references, view.references.size());
      const auto& hittable = accelerator.surface().hittable();
      EXPECT_EQ(std::vector<PrimitiveId>(found.begin(), found.end()), hittable);
      EXPECT_EQ(view.nodes[0].referenceCount, view.references.size());
    });
}

TEST(Hierarchy, LeavesMeetThePrimitivesTheyHold)
{
  forEverything(
    [](const Accelerator& accelerator)
    {
      const HierarchyView view = accelerator.hierarchy();
      for (const HierarchyNode& node : view.nodes)
      {
        for (std::uint32_t r = 0; node.leaf && r < node.referenceCount; ++r)
        {
          const Box box = accelerator.surface().box(view.references[node.firstReference + r]);
          for (int k = 0; k < 3; ++k)
          {
            ASSERT_LE(box.lower[k], node.box.upper[k]);
            ASSERT_GE(box.upper[k], node.box.lower[k]);
          }
        }
      }
    });
}

TEST(Hierarchy, StatisticsDescribeTheNodes)
{
  forEverything(
    [](const Accelerator& accelerator)
    {
      const HierarchyView view = accelerator.hierarchy();
      const BuildStatistics& s = accelerator.statistics();
      EXPECT_EQ(s.nodes, view.nodes.size());
      std::size_t leaves = 0;
      int depth = 0;
      double cost = 0.0;
      double stated = 0.0;
      const double rootArea = view.nodes[0].box.area();
      for (const HierarchyNode& node : view.nodes)
      {
        leaves += node.leaf ? 1 : 0;
        depth = std::max(depth, static_cast<int>(node.depth));
        stated += node.cost;
        double weight = std::ceil(node.referenceCount / 4.0);
        if (!node.leaf)
        {
          weight = accelerator.options().structure == Structure::KdTree ? 2.0 : 1.0;
        }
        if (accelerator.options().structure == Structure::Grid && !node.leaf)
        {
          // The cells' areas by the root's.
          const Vec3 size = node.box.size();
          const auto& n = view.gridResolution;
          const double face[3] = { size[1] * size[2], size[2] * size[0], size[0] * size[1] };
          weight =
            (face[0] * n[0] + face[1] * n[1] + face[2] * n[2]) / (face[0] + face[1] + face[2]);
        }
        cost += rootArea > 0.0 ? node.box.area() / rootArea * weight : 0.0;
      }
      EXPECT_EQ(s.leaves, leaves);
      EXPECT_EQ(s.depth, depth);
      EXPECT_NEAR(s.sahCost, stated, 1e-12 * stated);
      // A BSP-tree's cells are smaller than the boxes that bound them.
      if (accelerator.options().structure != Structure::BspTree)
      {
        EXPECT_NEAR(s.sahCost, cost, 1e-9 * cost);
      }
      EXPECT_EQ(s.references, view.references.size());
      const std::size_t hittable = accelerator.surface().hittable().size();
      EXPECT_DOUBLE_EQ(s.duplication,
        hittable == 0 ? 1.0 : static_cast<double>(s.references) / static_cast<double>(hittable));
      EXPECT_GE(s.duplication, 1.0);
      EXPECT_GE(s.buildSeconds, 0.0);
      if (accelerator.options().structure != Structure::BruteForce && hittable > 0)
      {
        EXPECT_GT(s.memory, 0u);
      }
    });
}

/// By what builders minimise, and in one unit, so that what traces faster also says so.
TEST(Hierarchy, TheHeuristicExpectsLessThanTheMedian)
{
  const std::pair<const char*, data::Mesh> scenes[] = { { "torus", data::torus(96, 48, 0.05) },
    { "city", data::city(4) }, { "stadium", data::teapotInStadium(6) },
    { "teapot", data::teapot(6) } };
  for (const auto& [name, mesh] : scenes)
  {
    SCOPED_TRACE(name);
    const auto surface = surfaceOf<float>(mesh);
    const auto cost = [&](const BuildOptions& options)
    { return build(surface, options)->statistics().sahCost; };
    BuildOptions kdTree = optionsOf(Structure::KdTree);
    const double sah = cost(kdTree);
    kdTree.kdBuild = KdBuild::SpatialMedian;
    EXPECT_LE(sah, cost(kdTree));
    for (const Structure structure : { Structure::Bvh, Structure::WideBvh })
    {
      const double median = cost(optionsOf(structure, BvhBuild::LongestAxisMedian));
      for (const BvhBuild way :
        { BvhBuild::BinnedSah, BvhBuild::SweepSah, BvhBuild::SpatialSplits })
      {
        EXPECT_LE(cost(optionsOf(structure, way)), median) << lumitree::name(way);
      }
    }
    const double bruteForce = cost(optionsOf(Structure::BruteForce));
    EXPECT_EQ(bruteForce, std::ceil(static_cast<double>(surface->hittable().size()) / 4));
    EXPECT_LT(cost(optionsOf(Structure::Octree)), bruteForce);
    EXPECT_LT(cost(optionsOf(Structure::Grid)), bruteForce);
  }
}

TEST(Hierarchy, BetterBuildsCostLess)
{
  const auto& teapot = surfaces().front();
  const double median =
    build(teapot, optionsOf(Structure::Bvh, BvhBuild::LongestAxisMedian))->statistics().sahCost;
  const double sah =
    build(teapot, optionsOf(Structure::Bvh, BvhBuild::BinnedSah))->statistics().sahCost;
  const double brute = build(teapot, optionsOf(Structure::BruteForce))->statistics().sahCost;
  EXPECT_LT(sah, median);
  EXPECT_LT(median, brute);
  EXPECT_EQ(brute, std::ceil(static_cast<double>(teapot->hittable().size()) / 4));
}

} // namespace
