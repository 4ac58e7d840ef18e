// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Counters of rays, nodes and primitives, and that they agree with each other.
#include "HierarchyScenes.h"

#include <algorithm>
#include <numeric>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

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

TEST(Counters, WhatIsRememberedIsNotTestedAgain)
{
  // A few large triangles in many cells, among small ones.
  Uniform uniform(21);
  std::vector<std::array<Vec3, 3>> triangles;
  const auto point = [&](double size) -> Vec3 {
    return { uniform(0, size), uniform(0, size), uniform(0, size) };
  };
  for (int i = 0; i < 2000; ++i)
  {
    const Vec3 p = point(10);
    triangles.push_back({ p, p + point(0.2), p + point(0.2) });
  }
  for (int i = 0; i < 20; ++i)
  {
    triangles.push_back({ point(10), point(10), point(10) });
  }
  const auto surface = surfaceOf<float>(triangles);
  const Rays rays = raysAround(*surface, 500, 22);
  for (const Structure structure :
    { Structure::Grid, Structure::Octree, Structure::KdTree, Structure::BspTree })
  {
    for (const Precision precision : everyPrecision)
    {
      for (int query = 0; query < queryKindCount; ++query)
      {
        SCOPED_TRACE(std::string(name(structure)) + ", query " + std::to_string(query));
        if (query == static_cast<int>(QueryKind::Crossings) && precision != Precision::Exact)
        {
          continue;
        }
        std::array<RayCounters, 2> sums;
        std::array<std::vector<Hit>, 2> closest;
        std::array<std::vector<std::uint64_t>, 2> perNode;
        for (const bool remember : { false, true })
        {
          BuildOptions options = optionsOf(structure);
          options.mailboxing = remember;
          const auto accelerator = build(surface, options);
          EXPECT_EQ(accelerator->options().mailboxing, remember);
          std::vector<RayCounters> counters(rays.size());
          const std::size_t k = remember ? 1 : 0;
          perNode[k].resize(accelerator->statistics().nodes);
          QueryOptions counting = with(precision);
          counting.perRay = counters.data();
          counting.perNode = perNode[k].data();
          askAll(*accelerator, rays.batch(), counting, query);
          for (const RayCounters& c : counters)
          {
            sums[k].nodes += c.nodes;
            sums[k].leaves += c.leaves;
            sums[k].primitives += c.primitives;
          }
          closest[k].resize(rays.size());
          accelerator->closest(rays.batch(), closest[k].data(), with(precision));
        }
        EXPECT_EQ(perNode[1], perNode[0]);
        EXPECT_EQ(sums[1].nodes, sums[0].nodes);
        EXPECT_LE(sums[1].leaves, sums[0].leaves);
        EXPECT_LT(sums[1].primitives, sums[0].primitives);
        for (std::size_t i = 0; i < rays.size(); ++i)
        {
          ASSERT_TRUE(sameBits(closest[1][i], closest[0][i])) << "ray " << i;
        }
      }
    }
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
