// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Surfaces on which builders fail to end, run out of memory or go wrong: none, one, all in one
// place, not finite, scales far apart, far from the origin; and options out of range.
#include "TestHelpers.h"

#include <gtest/gtest.h>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

using Corners = std::array<Vec3, 3>;

const double infinity = std::numeric_limits<double>::infinity();
const Corners unitTriangle = { Vec3{ 0, 0, 0 }, Vec3{ 1, 0, 0 }, Vec3{ 0, 1, 0 } };
const Ray throughUnitTriangle = { { 0.25, 0.25, -1 }, { 0, 0, 1 } };

template <class Check>
void forEveryStructure(const std::shared_ptr<const Surface>& surface, const Check& check)
{
  for (const auto& accelerator : accelerators(surface))
  {
    SCOPED_TRACE(label(accelerator->options()));
    EXPECT_LE(accelerator->statistics().depth, 64);
    for (const Precision precision : everyPrecision)
    {
      check(*accelerator, precision);
    }
  }
}

TEST(Builders, NoTriangleAtAll)
{
  forEveryStructure(surfaceOf<double>(std::vector<Corners>{}),
    [](const Accelerator& accelerator, Precision precision)
    {
      EXPECT_EQ(closestOf(accelerator, throughUnitTriangle, precision).primitive, noPrimitive);
      EXPECT_TRUE(allOf(accelerator, throughUnitTriangle, precision).empty());
      EXPECT_EQ(accelerator.statistics().references, 0u);
    });
}

TEST(Builders, NothingButTrianglesThatCannotBeHit)
{
  const Vec3 p = { 1, 2, 3 };
  forEveryStructure(
    surfaceOf<double>(std::vector<Corners>{ { p, p, p }, { Vec3{ infinity, 0, 0 }, p, p } }),
    [](const Accelerator& accelerator, Precision precision)
    {
      EXPECT_EQ(
        closestOf(accelerator, { { 1, 2, 0 }, { 0, 0, 1 } }, precision).primitive, noPrimitive);
    });
}

TEST(Builders, OneTriangle)
{
  forEveryStructure(surfaceOf<float>(std::vector<Corners>{ unitTriangle }),
    [](const Accelerator& accelerator, Precision precision)
    {
      const Hit hit = closestOf(accelerator, throughUnitTriangle, precision);
      EXPECT_EQ(hit.primitive, 0u);
      EXPECT_EQ(hit.t, 1.0);
    });
}

TEST(Builders, AllCentresInOnePlace)
{
  // Growing triangles around one centre, each turned a quarter further.
  std::vector<Corners> triangles;
  for (int i = 1; i <= 300; ++i)
  {
    const double r = i;
    triangles.push_back(i % 2 == 0
        ? Corners{ Vec3{ -r, -r, 0 }, Vec3{ r, -r, 0 }, Vec3{ 0, r, 0 } }
        : Corners{ Vec3{ -r, 0, -r }, Vec3{ r, 0, r }, Vec3{ 0, 0, r } });
  }
  const auto surface = surfaceOf<float>(triangles);
  const auto oracle = build(surface, optionsOf(Structure::BruteForce));
  const Rays rays = raysAround(*surface, 200, 3);
  forEveryStructure(surface,
    [&](const Accelerator& accelerator, Precision precision)
    {
      std::vector<Hit> wanted(rays.size());
      std::vector<Hit> hits(rays.size());
      oracle->closest(rays.batch(), wanted.data(), with(precision));
      accelerator.closest(rays.batch(), hits.data(), with(precision));
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        ASSERT_TRUE(sameBits(hits[i], wanted[i])) << "ray " << i;
      }
    });
}

TEST(Builders, AHundredThousandIdenticalTriangles)
{
  const auto surfaceOfMany = [](std::size_t count)
  {
    return std::make_shared<const Surface>(
      PointArray::from(std::vector<float>{ 0, 0, 0, 1, 0, 0, 0, 1, 0 }),
      std::vector<Triangle>(count, Triangle{ 0, 1, 2 }));
  };
  const auto many = surfaceOfMany(100000);
  const auto fewer = surfaceOfMany(20000); // for what cuts each of them over and over
  for (const BuildOptions& options : ownStructures())
  {
    SCOPED_TRACE(label(options));
    const bool cuts = options.bvhBuild == BvhBuild::SpatialSplits ||
      options.kdBuild == KdBuild::SpatialMedian || options.structure == Structure::Grid;
    const auto& surface = cuts ? fewer : many;
    const auto accelerator = build(surface, options);
    EXPECT_LE(accelerator->statistics().depth, 64);
    EXPECT_LT(accelerator->statistics().memory, std::size_t{ 1 } << 28);
    Rays rays;
    rays.add(throughUnitTriangle);
    for (const Precision precision : everyPrecision)
    {
      const Hit hit = closestOf(*accelerator, throughUnitTriangle, precision);
      EXPECT_EQ(hit.primitive, 0u);
      EXPECT_EQ(hit.t, 1.0);
      std::uint32_t count = 0;
      accelerator->count(rays.batch(), &count, with(precision));
      EXPECT_EQ(count, surface->size());
    }
  }
}

TEST(Builders, TriangleThatIsNotFiniteLeavesTheOthersAlone)
{
  for (const double bad : { std::nan(""), infinity, -infinity, 1e301 })
  {
    std::vector<Corners> triangles(50, unitTriangle);
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
      for (Vec3& p : triangles[i])
      {
        p[2] = static_cast<double>(i);
      }
    }
    triangles[7][2][1] = bad;
    triangles[8][0] = { bad, bad, bad };
    const auto surface = surfaceOf<double>(triangles);
    EXPECT_EQ(surface->nonFiniteCount(), 2u);
    forEveryStructure(surface,
      [](const Accelerator& accelerator, Precision precision)
      {
        const auto hits = allOf(accelerator, throughUnitTriangle, precision);
        ASSERT_EQ(hits.size(), 48u);
        EXPECT_EQ(hits[6].primitive, 6u);
        EXPECT_EQ(hits[7].primitive, 9u);
      });
  }
}

TEST(Builders, LongThinTrianglesThroughEverything)
{
  Uniform uniform(9);
  std::vector<Corners> triangles;
  for (int i = 0; i < 400; ++i)
  {
    const Vec3 a = { uniform(0, 1), uniform(0, 1), 0 };
    const Vec3 b = { uniform(0, 1), uniform(0, 1), 1 };
    triangles.push_back({ a, b, b + Vec3{ 1e-3, 1e-3, 0 } });
  }
  const auto surface = surfaceOf<float>(triangles);
  const auto oracle = build(surface, optionsOf(Structure::BruteForce));
  const Rays rays = raysAround(*surface, 500, 4);
  forEveryStructure(surface,
    [&](const Accelerator& accelerator, Precision precision)
    {
      EXPECT_LT(accelerator.statistics().memory, std::size_t{ 1 } << 26);
      std::vector<Hit> wanted(rays.size());
      std::vector<Hit> hits(rays.size());
      oracle->closest(rays.batch(), wanted.data(), with(precision));
      accelerator.closest(rays.batch(), hits.data(), with(precision));
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        ASSERT_TRUE(sameBits(hits[i], wanted[i])) << "ray " << i;
      }
    });
}

TEST(Builders, TeapotInAStadiumTwentyMillionTimesItsSize)
{
  const auto surface = surfaceOf<double>(data::teapotInStadium(6, 1e6));
  const auto oracle = build(surface, optionsOf(Structure::BruteForce));
  // Rays at the teapot, from near and from afar.
  Rays rays;
  Uniform uniform(2);
  for (int i = 0; i < 200; ++i)
  {
    const auto corners =
      surface->vertices(static_cast<PrimitiveId>(uniform.index(surface->size() - 12)));
    const double distance = i % 2 == 0 ? 1.0 : 1e5;
    const Vec3 origin = { distance * uniform(-1, 1), distance * uniform(-1, 1), distance };
    rays.add(origin, (1 / 3.0) * (corners[0] + corners[1] + corners[2]) - origin);
  }
  forEveryStructure(surface,
    [&](const Accelerator& accelerator, Precision precision)
    {
      EXPECT_LT(accelerator.statistics().memory, std::size_t{ 1 } << 26);
      std::vector<Hit> wanted(rays.size());
      std::vector<Hit> hits(rays.size());
      oracle->closest(rays.batch(), wanted.data(), with(precision));
      accelerator.closest(rays.batch(), hits.data(), with(precision));
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        ASSERT_TRUE(sameBits(hits[i], wanted[i])) << "ray " << i;
        ASSERT_NE(hits[i].primitive, noPrimitive);
      }
    });
}

TEST(Builders, FarFromTheOriginTheHitsStayTheSame)
{
  // Moved by whole numbers, so that coordinates on a grid of 2^-20 stay what they are.
  auto mesh = data::teapot(4);
  for (double& x : mesh.points)
  {
    x = std::nearbyint(x * 0x1p20) * 0x1p-20;
  }
  const Vec3 utm = { 448262, 5411932, 312 };
  const auto near = surfaceOf<double>(mesh);
  const auto far = surfaceOf<double>(mesh, utm);
  Uniform uniform(6);
  Rays nearRays;
  Rays farRays;
  for (int i = 0; i < 500; ++i)
  {
    Vec3 origin;
    Vec3 direction;
    for (int k = 0; k < 3; ++k)
    {
      origin[k] = std::nearbyint(uniform(-5, 5) * 1024) / 1024;
      direction[k] = uniform(-1, 1) - 0.2 * origin[k];
    }
    nearRays.add(origin, direction);
    farRays.add(origin + utm, direction);
  }
  const auto oracle = build(near, optionsOf(Structure::BruteForce));
  for (const Precision precision : { Precision::Fast, Precision::Exact })
  {
    std::vector<Hit> wanted(nearRays.size());
    oracle->closest(nearRays.batch(), wanted.data(), with(precision));
    for (const auto& accelerator : accelerators(far))
    {
      SCOPED_TRACE(label(accelerator->options()) + ", " + std::string(name(precision)));
      std::vector<Hit> hits(farRays.size());
      accelerator->closest(farRays.batch(), hits.data(), with(precision));
      for (std::size_t i = 0; i < hits.size(); ++i)
      {
        ASSERT_EQ(hits[i].primitive, wanted[i].primitive) << "ray " << i;
        ASSERT_EQ(hits[i].t, wanted[i].t) << "ray " << i;
      }
    }
  }
}

TEST(Builders, FloatsWhoseUlpIsOneOrTwo)
{
  const double offset = 0x1p24;
  const auto mesh = []
  {
    auto sphere = data::sphere(8);
    for (double& x : sphere.points)
    {
      x = std::nearbyint(x * 1000);
    }
    return sphere;
  }();
  const auto surface = surfaceOf<float>(mesh, { offset, -offset, offset });
  const Vec3 centre = { offset, -offset, offset };
  Uniform uniform(8);
  forEveryStructure(surface,
    [&](const Accelerator& accelerator, Precision precision)
    {
      for (int i = 0; i < 100; ++i)
      {
        const Vec3 direction = { uniform(-1, 1), uniform(-1, 1), uniform(-1, 1) };
        const Hit hit = closestOf(accelerator, { centre, direction }, precision);
        ASSERT_NE(hit.primitive, noPrimitive);
        ASSERT_NEAR(hit.t * length(direction), 1000, 15);
      }
    });
}

TEST(Builders, OptionsOutOfRangeAreRefusedByName)
{
  const auto surface = surfaceOf<float>(std::vector<Corners>{ unitTriangle });
  const auto refusal = [&](const BuildOptions& options) -> std::string
  {
    try
    {
      (void)build(surface, options);
    }
    catch (const std::invalid_argument& error)
    {
      return error.what();
    }
    return "accepted";
  };
  BuildOptions options;
  for (const int leafSize : { 0, -1, 1025 })
  {
    options = {};
    options.leafSize = leafSize;
    EXPECT_NE(refusal(options).find("leaf size"), std::string::npos) << leafSize;
  }
  for (const int depth : { 0, 65, -7 })
  {
    options = {};
    options.maxDepth = depth;
    EXPECT_NE(refusal(options).find("depth"), std::string::npos) << depth;
  }
  options = {};
  options.bvhBuild = static_cast<BvhBuild>(99);
  EXPECT_NE(refusal(options).find("BVH build"), std::string::npos);
  EXPECT_THROW((void)build(nullptr), std::invalid_argument);
}

TEST(Builders, DepthAndLeafSizeAreKept)
{
  const auto surface = surfaceOf<float>(data::randomCloud(2000));
  for (BuildOptions options : ownStructures())
  {
    if (options.structure == Structure::BruteForce || options.structure == Structure::Grid)
    {
      continue;
    }
    SCOPED_TRACE(label(options));
    for (const int depth : { 1, 3 })
    {
      options.maxDepth = depth;
      EXPECT_LE(build(surface, options)->statistics().depth, depth);
    }
    options.maxDepth = 64;
    if (options.structure == Structure::Bvh)
    {
      options.leafSize = 1;
      const auto fine = build(surface, options);
      EXPECT_EQ(fine->statistics().references, 2000u);
      options.leafSize = 1024;
      EXPECT_GT(fine->statistics().leaves, build(surface, options)->statistics().leaves);
    }
  }
}

/// Small triangles, and large ones among them whose boxes are nearly empty.
std::shared_ptr<const Surface> mixedSizes(int count)
{
  Uniform uniform(3);
  const auto vector = [&](double low, double high) -> Vec3
  {
    const double x = uniform(low, high);
    const double y = uniform(low, high);
    return { x, y, uniform(low, high) };
  };
  std::vector<Corners> triangles;
  for (int i = 0; i < count; ++i)
  {
    const Vec3 p = vector(0, 10);
    const double size = i % 20 == 0 ? 8.0 : 0.1;
    const Vec3 a = size * vector(-1, 1);
    triangles.push_back({ p, p + a, p + size * vector(-1, 1) });
  }
  return surfaceOf<double>(triangles);
}

TEST(Builders, SpatialSplitsCutWhereItPaysAndKeepToTheirBounds)
{
  const auto surface = mixedSizes(4000);
  const auto oracle = build(surface, optionsOf(Structure::BruteForce));
  const Rays rays = raysAround(*surface, 300, 4);
  AllHits wanted;
  oracle->all(rays.batch(), wanted, with(Precision::Exact));
  for (const Structure structure : { Structure::Bvh, Structure::WideBvh })
  {
    const auto whole = build(surface, optionsOf(structure, BvhBuild::BinnedSah));
    const auto cut = build(surface, optionsOf(structure, BvhBuild::SpatialSplits));
    EXPECT_LT(cut->statistics().sahCost, 0.7 * whole->statistics().sahCost);
    EXPECT_GT(cut->statistics().duplication, 1.0);
    EXPECT_LE(cut->statistics().duplication, 1.5);
    AllHits all;
    cut->all(rays.batch(), all, with(Precision::Exact));
    ASSERT_EQ(all.offsets, wanted.offsets);
    for (std::size_t i = 0; i < all.hits.size(); ++i)
    {
      ASSERT_TRUE(sameBits(all.hits[i], wanted.hits[i])) << "hit " << i;
    }
    std::vector<std::uint32_t> counts(rays.size());
    cut->count(rays.batch(), counts.data(), with(Precision::Exact));
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      ASSERT_EQ(counts[i], wanted.offsets[i + 1] - wanted.offsets[i]);
    }
  }
}

TEST(Builders, EveryWayToBuildABvhAnswersAsBruteForceDoes)
{
  const std::vector<std::shared_ptr<const Surface>> surfaces = { mixedSizes(600),
    surfaceOf<float>(data::teapot(4)), surfaceOf<float>(data::terrain(8, 1, 0.0)) };
  for (const auto& surface : surfaces)
  {
    const Rays rays = raysAround(*surface, 300, 4);
    std::vector<Hit> wanted(rays.size());
    build(surface, optionsOf(Structure::BruteForce))
      ->closest(rays.batch(), wanted.data(), with(Precision::Exact));
    for (const Structure structure : { Structure::Bvh, Structure::WideBvh })
    {
      for (int way = 0; way < bvhBuildCount; ++way)
      {
        for (const int leafSize : { 1, 3, 4, 16 })
        {
          BuildOptions options = optionsOf(structure, static_cast<BvhBuild>(way));
          options.leafSize = leafSize;
          SCOPED_TRACE(label(options) + ", leaves of " + std::to_string(leafSize));
          const auto tree = build(surface, options);
          std::vector<Hit> hits(rays.size());
          tree->closest(rays.batch(), hits.data(), with(Precision::Exact));
          for (std::size_t i = 0; i < rays.size(); ++i)
          {
            ASSERT_TRUE(sameBits(hits[i], wanted[i])) << "ray " << i;
          }
          for (const HierarchyNode& node : tree->hierarchy().nodes)
          {
            ASSERT_TRUE(!node.leaf || node.referenceCount <= static_cast<std::uint32_t>(leafSize));
          }
        }
      }
    }
  }
}

void expectSameStructure(const Accelerator& a, const Accelerator& b)
{
  const HierarchyView x = a.hierarchy();
  const HierarchyView y = b.hierarchy();
  EXPECT_EQ(x.references, y.references);
  ASSERT_EQ(x.nodes.size(), y.nodes.size());
  for (std::size_t i = 0; i < x.nodes.size(); ++i)
  {
    ASSERT_EQ(x.nodes[i].box.lower, y.nodes[i].box.lower);
    ASSERT_EQ(x.nodes[i].box.upper, y.nodes[i].box.upper);
    ASSERT_EQ(x.nodes[i].parent, y.nodes[i].parent);
    ASSERT_EQ(x.nodes[i].firstReference, y.nodes[i].firstReference);
  }
}

TEST(Builders, SameInputSameStructureWhateverTheThreads)
{
  const auto small = surfaceOf<float>(data::teapot(6));
  // What threads share among them (from 65536 on).
  const auto large = surfaceOf<double>(data::terrain(182));
  for (BuildOptions options : ownStructures())
  {
    SCOPED_TRACE(label(options));
    for (const auto& surface : { small, large })
    {
      if (surface == large && options.structure == Structure::BspTree)
      {
        continue; // it is slow to build, on one thread always
      }
      options.threads = 1;
      const auto one = build(surface, options);
      options.threads = 2;
      expectSameStructure(*one, *build(surface, options));
      if (surface == small)
      {
        options.threads = 0;
        expectSameStructure(*one, *build(surface, options));
      }
    }
  }
}

} // namespace
