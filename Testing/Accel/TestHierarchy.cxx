// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Every structure as a list of nodes, and the counters that refer to it.
#include "TestHelpers.h"

#include "Accel/EndPointOverlap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

const std::vector<std::shared_ptr<const Surface>>& surfaces()
{
  static const std::vector<std::shared_ptr<const Surface>> all = {
    surfaceOf<float>(data::teapot(5)),
    surfaceOf<double>(data::teapotInStadium(3), { 5e5, 4.6e6, 100 }),
    surfaceOf<float>(data::randomCloud(1000, 2, 0.3)),
    surfaceOf<float>(data::terrain(8, 1, 0.0)),
    surfaceOf<float>(std::vector<std::array<Vec3, 3>>{}),
  };
  return all;
}

template <class Check>
void forEverything(const Check& check)
{
  for (std::size_t i = 0; i < surfaces().size(); ++i)
  {
    for (const auto& accelerator : accelerators(surfaces()[i]))
    {
      SCOPED_TRACE("surface " + std::to_string(i) + ", " + label(accelerator->options()));
      check(*accelerator);
    }
  }
}

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

TEST(Hierarchy, CellsOfABspTreeAreConvexAndTileTheBox)
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
        cost +=
          rootArea > 0.0 ? node.box.area() / rootArea * (node.leaf ? node.referenceCount : 1) : 0.0;
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
  EXPECT_EQ(brute, static_cast<double>(teapot->hittable().size()));
}

/// A query by its number; Crossings is for Exact alone.
void askAll(
  const Accelerator& accelerator, const RayBatch& batch, const QueryOptions& options, int query)
{
  std::vector<Hit> hits(batch.size);
  std::vector<std::uint8_t> any(batch.size);
  std::vector<std::uint32_t> counts(batch.size);
  AllHits all;
  switch (query)
  {
    case 0:
      accelerator.closest(batch, hits.data(), options);
      break;
    case 1:
      accelerator.any(batch, any.data(), options);
      break;
    case 2:
      accelerator.all(batch, all, options);
      break;
    case 3:
      accelerator.count(batch, counts.data(), options);
      break;
    case 4:
      accelerator.crossings(batch, counts.data(), options);
      break;
    default:
      accelerator.ties(batch, all, options);
      break;
  }
}

TEST(Overlap, OfTwoBoxesIsWhatLiesInBoth)
{
  // Two unit squares in z = 0 that share a quarter, as two leaves under a root of their own.
  const auto square = [](double x, double y)
  {
    const Vec3 a{ x, y, 0 };
    const Vec3 b{ x + 1, y, 0 };
    const Vec3 c{ x + 1, y + 1, 0 };
    const Vec3 d{ x, y + 1, 0 };
    return std::vector<std::array<Vec3, 3>>{ { a, b, c }, { a, c, d } };
  };
  std::vector<std::array<Vec3, 3>> triangles = square(0, 0);
  for (const auto& triangle : square(0.5, 0.5))
  {
    triangles.push_back(triangle);
  }
  const auto surface = surfaceOf<double>(triangles);
  HierarchyView view;
  view.references = { 0, 1, 2, 3 };
  view.nodes.resize(3);
  view.nodes[0].box = surface->bounds();
  for (std::uint32_t leaf : { 1u, 2u })
  {
    HierarchyNode& node = view.nodes[leaf];
    node.box = surface->box(2 * leaf - 2);
    node.parent = 0;
    node.depth = 1;
    node.leaf = true;
    node.firstReference = 2 * leaf - 2;
    node.referenceCount = 2;
  }
  completeHierarchy(view);
  // A quarter of each square lies in the other's leaf, which costs 2; the squares have area 2.
  EXPECT_NEAR(endPointOverlap(view, *surface), 2 * (2 * 0.25) / 2.0, 1e-15);
  EXPECT_EQ(endPointOverlap({}, *surface), 0.0);
}

TEST(Overlap, IsLessWithTheHeuristicThanWithTheMedian)
{
  const auto surface = surfaceOf<float>(data::teapot(8));
  BuildOptions options;
  options.structure = Structure::Bvh;
  const double heuristic = endPointOverlap(build(surface, options)->hierarchy(), *surface);
  options.bvhBuild = BvhBuild::LongestAxisMedian;
  const double median = endPointOverlap(build(surface, options)->hierarchy(), *surface);
  EXPECT_GT(heuristic, 0.0);
  EXPECT_LT(heuristic, median);
  options.structure = Structure::BruteForce;
  EXPECT_EQ(endPointOverlap(build(surface, options)->hierarchy(), *surface), 0.0);
}

TEST(Counters, NodesPerRayAndVisitsPerNodeAreOneSum)
{
  forEverything(
    [](const Accelerator& accelerator)
    {
      if (accelerator.surface().size() == 0)
      {
        return;
      }
      const Rays rays = raysAround(accelerator.surface(), 1500, 5);
      const HierarchyView view = accelerator.hierarchy();
      for (const Precision precision : everyPrecision)
      {
        for (int query = 0; query < queryKindCount; ++query)
        {
          SCOPED_TRACE(std::string(name(precision)) + ", query " + std::to_string(query));
          if (query == static_cast<int>(QueryKind::Crossings) && precision != Precision::Exact)
          {
            continue;
          }
          std::vector<RayCounters> perRay(rays.size());
          std::vector<std::uint64_t> perNode(view.nodes.size());
          QueryOptions options = with(precision);
          options.perRay = perRay.data();
          options.perNode = perNode.data();
          std::vector<PrimitiveCounters> perPrimitive(accelerator.surface().size());
          options.perPrimitive = perPrimitive.data();
          askAll(accelerator, rays.batch(), options, query);
          std::uint64_t nodes = 0;
          std::uint64_t leaves = 0;
          std::uint64_t primitives = 0;
          for (const RayCounters& c : perRay)
          {
            nodes += c.nodes;
            leaves += c.leaves;
            primitives += c.primitives;
          }
          EXPECT_EQ(nodes, std::accumulate(perNode.begin(), perNode.end(), std::uint64_t{ 0 }));
          EXPECT_GT(primitives, 0u);
          std::uint64_t tested = 0;
          for (const PrimitiveCounters& c : perPrimitive)
          {
            tested += c.tested;
            ASSERT_LE(c.hit, c.tested);
          }
          EXPECT_EQ(tested, primitives);
          if (accelerator.options().structure != Structure::Grid)
          {
            std::uint64_t leafVisits = 0;
            std::uint64_t held = 0;
            for (std::size_t i = 0; i < view.nodes.size(); ++i)
            {
              leafVisits += view.nodes[i].leaf && view.nodes[i].referenceCount > 0 ? perNode[i] : 0;
              held += view.nodes[i].leaf ? perNode[i] * view.nodes[i].referenceCount : 0;
              // Who enters a node has entered its parent.
              ASSERT_TRUE(perNode[i] == 0 || view.nodes[i].parent < 0 ||
                perNode[static_cast<std::size_t>(view.nodes[i].parent)] > 0);
            }
            EXPECT_LE(leaves, leafVisits);
            EXPECT_LE(primitives, held);
          }
        }
      }
    });
}

TEST(Counters, HitsPerPrimitiveAreThoseOfTheAnswers)
{
  forEverything(
    [](const Accelerator& accelerator)
    {
      if (accelerator.surface().size() == 0)
      {
        return;
      }
      const Rays rays = raysAround(accelerator.surface(), 1500, 7);
      std::vector<std::uint64_t> expected(accelerator.surface().size(), 0);
      std::vector<PrimitiveCounters> counted(accelerator.surface().size());
      QueryOptions options = with(Precision::Exact);
      options.perPrimitive = counted.data();
      std::vector<Hit> hits(rays.size());
      accelerator.closest(rays.batch(), hits.data(), options);
      for (const Hit& hit : hits)
      {
        if (hit.primitive != noPrimitive)
        {
          ++expected[hit.primitive];
        }
      }
      AllHits all;
      accelerator.all(rays.batch(), all, options); // added to what is there
      for (const Hit& hit : all.hits)
      {
        ++expected[hit.primitive];
      }
      for (std::size_t i = 0; i < expected.size(); ++i)
      {
        ASSERT_EQ(counted[i].hit, expected[i]) << "primitive " << i;
      }
    });
}

TEST(Counters, DoNotDependOnThreadsBatchesOrBeingAsked)
{
  forEverything(
    [](const Accelerator& accelerator)
    {
      if (accelerator.surface().size() == 0)
      {
        return;
      }
      const Rays rays = raysAround(accelerator.surface(), 2500, 6);
      const std::size_t nodes = accelerator.statistics().nodes;
      std::vector<Hit> uncounted(rays.size());
      accelerator.closest(rays.batch(), uncounted.data(), with(Precision::Exact));

      const auto counted = [&](int threads, std::size_t step)
      {
        std::vector<RayCounters> perRay(rays.size());
        std::vector<std::uint64_t> perNode(nodes);
        std::vector<Hit> hits(rays.size());
        for (std::size_t first = 0; first < rays.size(); first += step)
        {
          RayBatch part = rays.batch();
          part.size = std::min(step, rays.size() - first);
          part.origins = ArrayView(rays.origins.data() + 3 * first);
          part.directions = ArrayView(rays.directions.data() + 3 * first);
          part.tMins = ArrayView(rays.tMins.data() + first);
          part.tMaxs = ArrayView(rays.tMaxs.data() + first);
          QueryOptions options = with(Precision::Exact);
          options.threads = threads;
          options.perRay = perRay.data() + first;
          options.perNode = perNode.data();
          accelerator.closest(part, hits.data() + first, options);
        }
        for (std::size_t i = 0; i < hits.size(); ++i)
        {
          EXPECT_TRUE(sameBits(hits[i], uncounted[i])) << "ray " << i;
        }
        std::vector<std::uint64_t> all(perNode);
        for (const RayCounters& c : perRay)
        {
          all.insert(all.end(), { c.nodes, c.cells, c.leaves, c.primitives });
        }
        return all;
      };
      const auto wanted = counted(1, rays.size());
      EXPECT_EQ(counted(2, rays.size()), wanted);
      EXPECT_EQ(counted(4, rays.size()), wanted);
      EXPECT_EQ(counted(1, 100), wanted);
    });
}

TEST(Counters, VisitsAreAddedToWhatIsThere)
{
  const auto accelerator = build(surfaces().front(), optionsOf(Structure::Bvh));
  const Rays rays = raysAround(accelerator->surface(), 100, 7);
  std::vector<std::uint64_t> once(accelerator->statistics().nodes);
  std::vector<Hit> hits(rays.size());
  QueryOptions options = with(Precision::Fast);
  options.perNode = once.data();
  accelerator->closest(rays.batch(), hits.data(), options);
  std::vector<std::uint64_t> twice = once;
  options.perNode = twice.data();
  accelerator->closest(rays.batch(), hits.data(), options);
  for (std::size_t i = 0; i < once.size(); ++i)
  {
    ASSERT_EQ(twice[i], 2 * once[i]);
  }
}

TEST(Counters, ATreeSavesWork)
{
  const auto& teapot = surfaces().front();
  const Rays rays = raysAround(*teapot, 500, 8);
  const auto tests = [&](const BuildOptions& options)
  {
    const auto accelerator = build(teapot, options);
    std::vector<RayCounters> perRay(rays.size());
    std::vector<Hit> hits(rays.size());
    QueryOptions query = with(Precision::Fast);
    query.perRay = perRay.data();
    accelerator->closest(rays.batch(), hits.data(), query);
    return std::accumulate(perRay.begin(), perRay.end(), std::uint64_t{ 0 },
      [](std::uint64_t sum, const RayCounters& c) { return sum + c.primitives; });
  };
  const std::uint64_t brute = tests(optionsOf(Structure::BruteForce));
  EXPECT_EQ(brute, rays.size() * teapot->hittable().size());
  for (const BuildOptions& options : ownStructures())
  {
    if (options.structure != Structure::BruteForce)
    {
      EXPECT_LT(tests(options), brute / 5) << label(options);
    }
  }
}

} // namespace
