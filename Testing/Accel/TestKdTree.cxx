// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// KD-trees where they fail: triangles in the planes, rays in the planes, hits beyond the cell they
// were found in, clipping that rounds inward, splitting that never ends.
#include "Accel/Structures/KdTreeClip.h"
#include "TestHelpers.h"

#include <gtest/gtest.h>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

using Corners = std::array<Vec3, 3>;

/// Cells as small as they come, so that there are many planes.
std::vector<BuildOptions> kdTrees()
{
  std::vector<BuildOptions> all(2, optionsOf(Structure::KdTree));
  all[0].kdBuild = KdBuild::SpatialMedian;
  all[0].leafSize = 1;
  return all;
}

Vec3 turned(const Vec3& p, int axis)
{
  return { p[(3 - axis) % 3], p[(4 - axis) % 3], p[(5 - axis) % 3] };
}

void expectAllQueriesAgree(
  const std::shared_ptr<const Surface>& surface, const Rays& rays, Precision precision)
{
  const auto oracle = build(surface, optionsOf(Structure::BruteForce));
  const RayBatch batch = rays.batch();
  std::vector<Hit> wanted(rays.size());
  AllHits wantedAll;
  oracle->closest(batch, wanted.data(), with(precision));
  oracle->all(batch, wantedAll, with(precision));
  for (const BuildOptions& options : kdTrees())
  {
    SCOPED_TRACE(label(options) + ", " + std::string(name(precision)));
    const auto tree = build(surface, options);
    std::vector<Hit> hits(rays.size());
    std::vector<std::uint8_t> any(rays.size());
    std::vector<std::uint32_t> counts(rays.size());
    AllHits all;
    tree->closest(batch, hits.data(), with(precision));
    tree->any(batch, any.data(), with(precision));
    tree->count(batch, counts.data(), with(precision));
    tree->all(batch, all, with(precision));
    std::size_t differences = 0;
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      const bool hit = wanted[i].primitive != noPrimitive;
      const auto count = wantedAll.offsets[i + 1] - wantedAll.offsets[i];
      differences +=
        sameBits(hits[i], wanted[i]) && any[i] == (hit ? 1 : 0) && counts[i] == count ? 0 : 1;
    }
    EXPECT_EQ(differences, 0u);
    EXPECT_EQ(all.offsets, wantedAll.offsets);
    ASSERT_EQ(all.hits.size(), wantedAll.hits.size());
    for (std::size_t i = 0; i < all.hits.size(); ++i)
    {
      ASSERT_TRUE(sameBits(all.hits[i], wantedAll.hits[i])) << "hit " << i;
    }
  }
}

/// Triangles between points of a lattice, as many of them in planes of the lattice as not.
std::shared_ptr<const Surface> latticeCloud(
  std::size_t count, unsigned seed, double scale = 1.0, const Vec3& offset = { 0, 0, 0 })
{
  Uniform uniform(seed);
  std::vector<Corners> triangles;
  while (triangles.size() < count)
  {
    Corners corners;
    Vec3 base;
    for (double& x : base)
    {
      x = static_cast<double>(uniform.index(7));
    }
    for (Vec3& corner : corners)
    {
      for (int k = 0; k < 3; ++k)
      {
        corner[k] = base[k] + static_cast<double>(uniform.index(3));
      }
    }
    if (triangles.size() % 2 == 0)
    {
      const std::size_t flat = uniform.index(3);
      corners[1][flat] = corners[2][flat] = corners[0][flat];
    }
    for (Vec3& corner : corners)
    {
      corner = scale * corner + offset;
    }
    triangles.push_back(corners);
  }
  return surfaceOf<double>(triangles);
}

/// Rays from lattice points and half-way between them, in directions of small whole numbers:
/// through corners and edges of cells, in planes, along edges; some end or begin exactly on a
/// plane.
Rays latticeRays(
  std::size_t count, unsigned seed, double scale = 1.0, const Vec3& offset = { 0, 0, 0 })
{
  Uniform uniform(seed);
  Rays rays;
  while (rays.size() < count)
  {
    Ray ray;
    for (int k = 0; k < 3; ++k)
    {
      ray.origin[k] = scale * (0.5 * static_cast<double>(uniform.index(21)) - 1.0) + offset[k];
      const double d = static_cast<double>(uniform.index(5)) - 2.0;
      ray.direction[k] = d == 0.0 && uniform.index(2) == 0 ? -0.0 : scale * d;
    }
    ray.tMin = uniform.index(4) == 0 ? 0.5 * static_cast<double>(uniform.index(4)) - 1.0 : 0.0;
    if (uniform.index(4) == 0)
    {
      ray.tMax = ray.tMin + 0.5 * static_cast<double>(uniform.index(8));
    }
    if (isValid(ray))
    {
      rays.add(ray);
    }
  }
  return rays;
}

TEST(KdClip, BoundsHoldEveryPointOfTheTriangleInTheCell)
{
  Uniform uniform(1);
  std::size_t inside = 0;
  std::size_t smaller = 0;
  for (int i = 0; i < 2000; ++i)
  {
    Corners triangle;
    Box whole;
    for (Vec3& corner : triangle)
    {
      corner = { std::floor(uniform(-9, 9)), std::floor(uniform(-9, 9)),
        std::floor(uniform(-9, 9)) };
      whole.extend(corner);
    }
    Box cell;
    cell.extend(Vec3{ uniform(-9, 9), std::floor(uniform(-9, 9)), uniform(-9, 9) });
    cell.extend(Vec3{ uniform(-9, 9), uniform(-9, 9), std::floor(uniform(-9, 9)) });
    const Box bounds = clippedBounds(triangle, cell);
    smaller += bounds.empty() || bounds.size() != commonBox(whole, cell).size() ? 1 : 0;
    const auto holds = [](const Box& box, const Vec3& p)
    {
      return box.lower[0] <= p[0] && p[0] <= box.upper[0] && box.lower[1] <= p[1] &&
        p[1] <= box.upper[1] && box.lower[2] <= p[2] && p[2] <= box.upper[2];
    };
    // Sixteenths of whole numbers: these points are exactly on the triangle.
    for (int a = 0; a <= 16; ++a)
    {
      for (int b = 0; a + b <= 16; ++b)
      {
        const Vec3 p =
          (a / 16.0) * triangle[0] + (b / 16.0) * triangle[1] + ((16 - a - b) / 16.0) * triangle[2];
        if (holds(cell, p))
        {
          ++inside;
          ASSERT_TRUE(holds(bounds, p)) << "triangle " << i;
        }
      }
    }
  }
  EXPECT_GT(inside, 10000u);
  EXPECT_GT(smaller, 500u);
}

TEST(KdClip, ATouchInAPointOrAnEdgeIsKept)
{
  Box cell;
  cell.extend(Vec3{ 0, 0, 0 });
  cell.extend(Vec3{ 1, 1, 1 });
  // The corner of the cell lies inside the triangle, on its edge, at its corner; a whole edge of
  // the cell; its face.
  const std::vector<Corners> touching = {
    { Vec3{ 3, 0, 0 }, Vec3{ 0, 3, 0 }, Vec3{ 0, 0, 3 } },
    { Vec3{ 1, 1, 1 }, Vec3{ 3, 1, 1 }, Vec3{ 1, 3, 1 } },
    { Vec3{ 0, 2, 1 }, Vec3{ 2, 0, 1 }, Vec3{ 2, 2, 4 } },
    { Vec3{ -1, 1, 1 }, Vec3{ 2, 1, 1 }, Vec3{ 0, 2, 2 } },
    { Vec3{ 1, -5, -5 }, Vec3{ 1, 5, -5 }, Vec3{ 1, 0, 9 } },
  };
  for (const Corners& triangle : touching)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const Corners t = { turned(triangle[0], axis), turned(triangle[1], axis),
        turned(triangle[2], axis) };
      EXPECT_FALSE(clippedBounds(t, cell).empty());
    }
  }
  EXPECT_TRUE(
    clippedBounds({ Vec3{ 3.1, 0, 0 }, Vec3{ 0, 3.1, 0 }, Vec3{ 0, 0, 3.1 } }, cell).empty());
}

TEST(KdTree, TrianglesInThePlanesAreFoundFromEitherSide)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    // Five walls across the longest axis, each forty times, so that cutting pays: the middle one
    // lies in the first plane of the spatial median, the outer ones in faces of the root.
    std::vector<Corners> walls;
    for (int i = 0; i < 200; ++i)
    {
      const double x = 4.0 * (i % 5) - 8.0;
      walls.push_back(
        { turned({ x, -1, -1 }, axis), turned({ x, 3, -1 }, axis), turned({ x, -1, 3 }, axis) });
    }
    const auto surface = surfaceOf<float>(walls);
    for (const BuildOptions& options : kdTrees())
    {
      const auto tree = build(surface, options);
      EXPECT_GT(tree->statistics().leaves, 4u);
      for (const Precision precision : everyPrecision)
      {
        for (const double sign : { -1.0, 1.0 })
        {
          const Vec3 d = turned({ sign, 0, 0 }, axis);
          for (int wall = 0; wall < 5; ++wall)
          {
            const double x = 4.0 * wall - 8.0;
            const auto id = static_cast<PrimitiveId>(wall);
            Ray ray{ turned({ x - sign, 0.25, 0.25 }, axis), d };
            EXPECT_EQ(closestOf(*tree, ray, precision).primitive, id);
            ray.tMax = 1.0;
            EXPECT_EQ(closestOf(*tree, ray, precision).primitive, id) << "ends in the plane";
            ray.tMin = 1.0;
            EXPECT_EQ(closestOf(*tree, ray, precision).primitive, id) << "is a point of the plane";
            ray.tMax = std::nextafter(1.0, 0.0);
            ray.tMin = 0.0;
            if (precision == Precision::Exact)
            {
              EXPECT_EQ(closestOf(*tree, ray, precision).primitive, noPrimitive);
            }
            EXPECT_EQ(closestOf(*tree, { turned({ x, 0.25, 0.25 }, axis), d }, precision).t, 0.0);
          }
        }
      }
    }
  }
}

TEST(KdTree, AHitBeyondTheCellLosesToANearerOneInTheNextAndIsNotForgotten)
{
  // A large sloping triangle reaches into every cell; small ones far apart make the cells.
  std::vector<Corners> triangles = { { Vec3{ 0, -40, -9 }, Vec3{ 0, 40, -9 }, Vec3{ 64, 0, 9 } } };
  for (int i = 0; i < 17 * 24; ++i)
  {
    const double x = 4.0 * (i % 17);
    triangles.push_back({ Vec3{ x, 6, -9 }, Vec3{ x, 8, -9 }, Vec3{ x, 7, -7 } });
  }
  const auto surface = surfaceOf<float>(triangles);
  auto blocked = triangles;
  blocked.push_back({ Vec3{ 30, -1, -1 }, Vec3{ 30, 1, -1 }, Vec3{ 30, 0, 1 } });
  const auto withBlocker = surfaceOf<float>(blocked);
  const Ray ray = { { 0, 0, 0 }, { 1, 0, 0 } };
  for (const BuildOptions& options : kdTrees())
  {
    for (const Precision precision : everyPrecision)
    {
      SCOPED_TRACE(label(options));
      const auto open = build(surface, options);
      EXPECT_GT(open->statistics().duplication, 1.0);
      const Hit far = closestOf(*open, ray, precision);
      EXPECT_EQ(far.primitive, 0u);
      EXPECT_EQ(far.t, 32.0);
      const auto closed = build(withBlocker, options);
      EXPECT_EQ(closestOf(*closed, ray, precision).t, 30.0);
      const auto all = allOf(*closed, ray, precision);
      ASSERT_EQ(all.size(), 2u);
      EXPECT_EQ(all[1].primitive, 0u);
    }
  }
}

TEST(KdTree, RaysInThePlanesAndAlmost)
{
  const auto surface = latticeCloud(300, 3);
  Uniform uniform(4);
  Rays rays;
  for (int i = 0; i < 3000; ++i)
  {
    // On a plane of the lattice, along it or leaving it by as little as there is.
    Ray ray;
    for (int k = 0; k < 3; ++k)
    {
      ray.origin[k] = uniform(0, 8);
      ray.direction[k] = uniform(-1, 1);
    }
    const std::size_t axis = uniform.index(3);
    const std::array<double, 8> tiny = { 0.0, -0.0, 5e-324, -5e-324, 1e-300, -1e-300, 1e-17,
      -1e-17 };
    ray.origin[axis] = static_cast<double>(uniform.index(9));
    ray.direction[axis] = tiny[uniform.index(tiny.size())];
    if (i % 3 == 0) // on two planes
    {
      ray.origin[(axis + 1) % 3] = static_cast<double>(uniform.index(9));
      ray.direction[(axis + 1) % 3] = tiny[uniform.index(tiny.size())];
    }
    rays.add(ray);
  }
  expectAllQueriesAgree(surface, rays, Precision::Exact);
}

TEST(KdTree, TwoHundredThousandRaysOfTheLatticeAgreeExactly)
{
  expectAllQueriesAgree(latticeCloud(250, 5), latticeRays(100000, 6), Precision::Exact);
  expectAllQueriesAgree(
    surfaceOf<float>(data::cornellBox()), latticeRays(100000, 7), Precision::Exact);
}

TEST(KdTree, ScalesAndOffsetsFarFromOne)
{
  for (const int exponent : { -900, -500, -100, 100, 300 })
  {
    SCOPED_TRACE(exponent);
    const double scale = std::ldexp(1.0, exponent);
    expectAllQueriesAgree(
      latticeCloud(100, 8, scale), latticeRays(1000, 9, scale), Precision::Exact);
  }
  for (const double offset : { 5e6, 0x1p40, -0x1p50 })
  {
    SCOPED_TRACE(offset);
    const Vec3 moved = { offset, -offset, 0.5 * offset };
    expectAllQueriesAgree(
      latticeCloud(100, 10, 1.0, moved), latticeRays(1000, 11, 1.0, moved), Precision::Exact);
  }
}

TEST(KdTree, AllTrianglesInOnePlane)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<Corners> triangles;
    for (int i = 0; i < 20; ++i)
    {
      for (int j = 0; j < 20; ++j)
      {
        const double x = i;
        const double y = j;
        triangles.push_back({ turned({ x, y, 5 }, axis), turned({ x + 1, y, 5 }, axis),
          turned({ x, y + 1, 5 }, axis) });
        triangles.push_back({ turned({ x + 1, y + 1, 5 }, axis), turned({ x, y + 1, 5 }, axis),
          turned({ x + 1, y, 5 }, axis) });
      }
    }
    Rays rays;
    Uniform uniform(12);
    for (int i = 0; i < 2000; ++i)
    {
      const Vec3 target = i % 2 == 0
        ? Vec3{ std::floor(uniform(0, 21)), std::floor(uniform(0, 21)), 5 }
        : Vec3{ uniform(-1, 21), uniform(-1, 21), 5 };
      const Vec3 origin = { std::floor(uniform(-5, 25)), std::floor(uniform(-5, 25)),
        i % 3 == 0 ? 5.0 : 9.0 };
      rays.add(turned(origin, axis), turned(target - origin, axis));
    }
    Rays valid;
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      const Ray ray = rays.batch()[i];
      if (isValid(ray))
      {
        valid.add(ray);
      }
    }
    expectAllQueriesAgree(surfaceOf<float>(triangles), valid, Precision::Exact);
  }
}

TEST(KdTree, ReferencesAndDepthAreBounded)
{
  const std::vector<std::shared_ptr<const Surface>> surfaces = {
    std::make_shared<const Surface>(
      PointArray::from(std::vector<float>{ 0, 0, 0, 1, 0, 0, 0, 1, 0 }),
      std::vector<Triangle>(100000, Triangle{ 0, 1, 2 })),
    surfaceOf<double>(data::slivers(2000)), surfaceOf<float>(data::randomCloud(2000)),
    surfaceOf<double>(data::teapotInStadium(6, 1e6))
  };
  for (const auto& surface : surfaces)
  {
    for (const BuildOptions& options : kdTrees())
    {
      SCOPED_TRACE(label(options));
      const BuildStatistics s = build(surface, options)->statistics();
      EXPECT_LE(s.duplication, 8.0);
      EXPECT_GE(s.duplication, 1.0);
      EXPECT_LE(s.depth, 8 + 1.3 * std::log2(static_cast<double>(surface->size())));
      EXPECT_EQ(s.nodes, 2 * s.leaves - 1);
    }
  }
}

TEST(KdTree, TheSurfaceAreaHeuristicCostsLess)
{
  const auto surface = surfaceOf<float>(data::teapotInStadium(8));
  auto options = kdTrees();
  options[0].leafSize = 4;
  const auto median = build(surface, options[0])->statistics();
  const auto sah = build(surface, options[1])->statistics();
  EXPECT_LT(sah.sahCost, median.sahCost);
}

TEST(KdTree, TheViewIsAPartitionOfSpace)
{
  const auto surface = surfaceOf<float>(data::teapot(4));
  for (const BuildOptions& options : kdTrees())
  {
    SCOPED_TRACE(label(options));
    const HierarchyView view = build(surface, options)->hierarchy();
    EXPECT_EQ(view.nodes[0].box.lower, surface->bounds().lower);
    EXPECT_EQ(view.nodes[0].box.upper, surface->bounds().upper);
    std::vector<int> children(view.nodes.size(), 0);
    for (std::size_t i = 1; i < view.nodes.size(); ++i)
    {
      const HierarchyNode& node = view.nodes[i];
      ASSERT_LT(node.parent, static_cast<std::int64_t>(i));
      const HierarchyNode& parent = view.nodes[static_cast<std::size_t>(node.parent)];
      const auto axis = static_cast<std::size_t>(parent.splitAxis);
      Box cell = parent.box;
      (children[static_cast<std::size_t>(node.parent)]++ == 0 ? cell.upper : cell.lower)[axis] =
        parent.splitPosition;
      EXPECT_EQ(node.box.lower, cell.lower);
      EXPECT_EQ(node.box.upper, cell.upper);
      EXPECT_EQ(node.depth, parent.depth + 1);
    }
    // Each vertex of a triangle lies in a closed leaf that holds the triangle.
    std::vector<std::uint8_t> found(3 * surface->size(), 0);
    for (const HierarchyNode& node : view.nodes)
    {
      for (std::uint32_t r = 0; node.leaf && r < node.referenceCount; ++r)
      {
        const PrimitiveId id = view.references[node.firstReference + r];
        const auto corners = surface->vertices(id);
        for (std::size_t c = 0; c < 3; ++c)
        {
          Box grown = node.box;
          grown.extend(corners[c]);
          if (grown.lower == node.box.lower && grown.upper == node.box.upper)
          {
            found[3 * id + c] = 1;
          }
        }
      }
    }
    for (const PrimitiveId id : surface->hittable())
    {
      ASSERT_TRUE(found[3 * id] && found[3 * id + 1] && found[3 * id + 2]) << "triangle " << id;
    }
  }
}

TEST(KdTree, AnUnknownBuildIsRefusedByName)
{
  BuildOptions options = optionsOf(Structure::KdTree);
  EXPECT_EQ(name(options.kdBuild), "sah");
  EXPECT_EQ(name(KdBuild::SpatialMedian), "spatial_median");
  for (const int value : { -1, kdBuildCount })
  {
    options.kdBuild = static_cast<KdBuild>(value);
    EXPECT_EQ(name(options.kdBuild), "unknown");
    try
    {
      (void)build(surfaceOf<float>(data::cornellBox()), options);
      FAIL() << "built an unknown way";
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_NE(std::string(error.what()).find("KD-tree build"), std::string::npos);
    }
  }
  BuildOptions other = optionsOf(Structure::KdTree);
  other.kdBuild = KdBuild::SpatialMedian;
  EXPECT_FALSE(other == optionsOf(Structure::KdTree));
}

} // namespace
