// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// How often rays pass through surfaces, where they pass through edges and vertices, along edges and
// faces, and start on them.
#include "RationalOracle.h"
#include "TestHelpers.h"

#include "Accel/Exact/Predicates.h"

#include <gtest/gtest.h>

#include <cfenv>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

constexpr double inf = std::numeric_limits<double>::infinity();

/// (e, e^2, e^3). e is to be so small that it decides only what is 0 without it: below the unit in
/// which the test's polynomials are whole numbers, divided by their size.
RationalVector move(double e)
{
  const Rational x = rational(e);
  return { x, x * x, x * x * x };
}

/// How many triangles the moved ray crosses between its limits, in rational numbers.
std::uint32_t passagesOf(const Surface& surface, const Ray& ray, const RationalVector& moved)
{
  std::uint32_t count = 0;
  for (const PrimitiveId id : surface.hittable())
  {
    const RationalCrossing x(ray, surface.vertices(id), moved);
    count += rationallyHits(ray, x) ? 1 : 0;
  }
  return count;
}

std::vector<std::uint32_t> crossingsOf(const Accelerator& accelerator, const Rays& rays)
{
  std::vector<std::uint32_t> counts(rays.size(), 99);
  accelerator.crossings(rays.batch(), counts.data(), with(Precision::Exact));
  return counts;
}

using Soup = std::vector<std::array<Vec3, 3>>;

/// A box, two triangles a face, no points shared.
void addBox(Soup& soup, const Vec3& lower, const Vec3& upper)
{
  const auto corner = [&](int i)
  {
    return Vec3{ (i & 1 ? upper : lower)[0], (i & 2 ? upper : lower)[1],
      (i & 4 ? upper : lower)[2] };
  };
  constexpr int faces[6][4] = { { 0, 2, 6, 4 }, { 1, 5, 7, 3 }, { 0, 4, 5, 1 }, { 2, 3, 7, 6 },
    { 0, 1, 3, 2 }, { 4, 6, 7, 5 } };
  for (const auto& f : faces)
  {
    soup.push_back({ corner(f[0]), corner(f[1]), corner(f[2]) });
    soup.push_back({ corner(f[0]), corner(f[2]), corner(f[3]) });
  }
}

bool insideBox(const Vec3& p, const Vec3& lower, const Vec3& upper)
{
  bool inside = true;
  for (int k = 0; k < 3; ++k)
  {
    // The move is upward on every axis.
    inside = inside && lower[k] <= p[k] && p[k] < upper[k];
  }
  return inside;
}

/// A mesh on a grid of floats, so that differences of its coordinates are exact, and with corners
/// of its own for each triangle if so.
std::shared_ptr<const Surface> closed(
  data::Mesh mesh, double radius, double grid, const Vec3& offset, bool welded)
{
  for (double& x : mesh.points)
  {
    x = std::nearbyint(x * radius / grid) * grid;
  }
  const auto surface = surfaceOf<float>(mesh, offset);
  if (welded)
  {
    return surface;
  }
  Soup soup;
  for (PrimitiveId id = 0; id < surface->size(); ++id)
  {
    auto corners = surface->vertices(id);
    std::rotate(corners.begin(), corners.begin() + id % 3, corners.end());
    if (id % 5 == 0)
    {
      std::swap(corners[0], corners[1]);
    }
    soup.push_back(corners);
  }
  return surfaceOf<float>(soup);
}

/// Rays from a point exactly through vertices and edge midpoints, nearly through them, and any.
Rays raysFrom(const Surface& surface, const Vec3& origin, std::size_t count, unsigned seed)
{
  Uniform uniform(seed);
  Rays rays;
  while (rays.size() < count)
  {
    const auto corners = surface.vertices(static_cast<PrimitiveId>(uniform.index(surface.size())));
    Ray ray;
    ray.origin = origin;
    ray.direction = { uniform(-1, 1), uniform(-1, 1), uniform(-1, 1) };
    switch (rays.size() % 4)
    {
      case 0:
        ray.direction = corners[0] - origin;
        break;
      case 1:
        ray.direction = (corners[0] - origin) + (corners[1] - origin);
        break;
      case 2:
        ray.direction = corners[1] - origin;
        ray.direction = (1.0 / length(ray.direction)) * ray.direction;
        break;
      default:
        break;
    }
    if (isValid(ray))
    {
      rays.add(ray);
    }
    else
    {
      rays.add(origin, { uniform(-1, 1), uniform(-1, 1), uniform(-1, 1) });
    }
  }
  return rays;
}

struct Placed
{
  double offset;
  double grid;
};
constexpr Placed places[] = { { 0.0, 0x1p-10 }, { 1e4, 0x1p-10 }, { 1e6, 0x1p-4 } };

TEST(Crossings, PredicatesAgreeWithRationalNumbers)
{
  // Few different coordinates: nearly every question is degenerate.
  Uniform uniform(17);
  const auto coordinate = [&](double scale, double shift)
  { return shift + scale * (static_cast<double>(uniform.index(4)) - 1.0); };
  const RationalVector moved = move(0x1p-240);
  std::size_t met = 0;
  for (int i = 0; i < 6000; ++i)
  {
    const double scale = i % 3 == 0 ? 1.0 : (i % 3 == 1 ? 0x1p-30 : 0.1);
    const double shift = i % 5 == 0 ? 1e6 : 0.0;
    const auto point = [&] {
      return Vec3{ coordinate(scale, shift), coordinate(scale, shift), coordinate(scale, shift) };
    };
    Ray ray;
    ray.origin = point();
    ray.direction = { coordinate(1.0, 0), coordinate(1.0, 0), coordinate(1.0, 0) };
    const std::array<Vec3, 3> triangle = { point(), point(), point() };
    if (ray.direction == Vec3{ 0, 0, 0 })
    {
      continue;
    }
    const RationalCrossing x(ray, triangle, moved);
    ASSERT_EQ(exact::movedLineMeetsTriangle(ray, triangle), x.inside) << i;
    if (x.inside)
    {
      ++met;
      for (const double limit : { 0.0, scale, -scale, 0.5 * scale, inf, -inf })
      {
        const int wanted =
          std::isinf(limit) ? (limit > 0 ? -1 : 1) : (x.t > rational(limit) ? 1 : -1);
        ASSERT_EQ(exact::compareMovedCrossing(ray, triangle, limit), wanted) << i << " " << limit;
      }
    }
  }
  EXPECT_GT(met, 100u);
}

TEST(Crossings, OnceAtEdgesAndVertices)
{
  // From the middle of a ball every ray leaves once; from outside it enters and leaves or does not.
  for (const Placed& place : places)
  {
    for (const bool welded : { true, false })
    {
      SCOPED_TRACE("offset " + std::to_string(place.offset) + (welded ? "" : ", unwelded"));
      const Vec3 centre = { place.offset, place.offset, place.offset };
      const auto surface = closed(data::sphere(8), 100.0, place.grid, centre, welded);
      const Rays out = raysFrom(*surface, centre + Vec3{ 3, -5, 7 }, 4000, 3);
      const Rays through = raysFrom(*surface, centre + Vec3{ 300, 220, 7 }, 4000, 4);
      for (const auto& accelerator : accelerators(surface))
      {
        SCOPED_TRACE(label(accelerator->options()));
        const auto once = crossingsOf(*accelerator, out);
        EXPECT_EQ(std::count(once.begin(), once.end(), 1u), 4000);
        const auto twice = crossingsOf(*accelerator, through);
        const auto passed = std::count(twice.begin(), twice.end(), 2u);
        EXPECT_EQ(passed + std::count(twice.begin(), twice.end(), 0u), 4000);
        EXPECT_GT(passed, 2500);
      }
    }
  }
}

TEST(Crossings, EveryDirectionAgreesOnTheSide)
{
  for (const Placed& place : places)
  {
    for (const bool welded : { true, false })
    {
      const Vec3 centre = { place.offset, place.offset, place.offset };
      const auto surface = closed(data::torus(40, 20, 0.3), 100.0, place.grid, centre, welded);
      const auto accelerator = build(surface, optionsOf(Structure::WideBvh));
      struct Point
      {
        Vec3 place;
        bool inside;
      };
      for (const Point& p :
        { Point{ { 100, 0, 0 }, true }, Point{ { 0, -100, 3 }, true }, Point{ { 0, 0, 0 }, false },
          Point{ { 30, 250, 0 }, false }, Point{ { 100, 0, 300 }, false } })
      {
        const Rays rays = raysFrom(*surface, centre + p.place, 4000, 11);
        for (const std::uint32_t count : crossingsOf(*accelerator, rays))
        {
          ASSERT_EQ(count % 2 == 1, p.inside) << place.offset << (welded ? "" : ", unwelded");
        }
      }
      // On the surface one side is as good as the other, but it is the same in every direction.
      for (PrimitiveId id = 0; id < surface->size(); id += 97)
      {
        const auto corners = surface->vertices(id);
        for (const Vec3& origin : { corners[0], 0.5 * (corners[0] + corners[1]) })
        {
          const auto counts = crossingsOf(*accelerator, raysFrom(*surface, origin, 60, id));
          for (const std::uint32_t count : counts)
          {
            ASSERT_EQ(count % 2, counts.front() % 2);
          }
        }
      }
    }
  }
}

/// Boxes that touch in faces, edges and corners, with lattice points for corners.
Soup touchingBoxes(std::vector<std::pair<Vec3, Vec3>>& boxes)
{
  boxes = { { { 0, 0, 0 }, { 2, 2, 2 } }, { { 2, 0, 0 }, { 4, 2, 2 } },
    { { 0, 2, 0 }, { 1, 4, 2 } }, { { 2, 2, 2 }, { 3, 3, 4 } }, { { 1, 1, 2 }, { 2, 2, 3 } },
    { { 3, 2, 0 }, { 4, 4, 2 } } };
  Soup soup;
  for (const auto& box : boxes)
  {
    addBox(soup, box.first, box.second);
  }
  return soup;
}

TEST(Crossings, AlongEdgesAndInFacesOfTouchingBoxes)
{
  std::vector<std::pair<Vec3, Vec3>> boxes;
  const auto surface = surfaceOf<float>(touchingBoxes(boxes));
  const auto trees = accelerators(surface);
  Uniform uniform(23);
  const auto lattice = [&](double low, std::size_t steps)
  {
    Vec3 p;
    for (double& x : p)
    {
      x = low + 0.5 * static_cast<double>(uniform.index(steps));
    }
    return p;
  };
  const RationalVector moved = move(0x1p-40);
  Rays rays;
  std::vector<std::uint32_t> wanted;
  while (rays.size() < 600)
  {
    Ray ray;
    ray.origin = lattice(-1.0, 13);
    ray.direction = lattice(-1.0, 5);
    if (rays.size() % 3 == 1)
    {
      // Limits that lie on faces, too.
      ray.tMin = 0.5 * static_cast<double>(uniform.index(4)) - 1.0;
      ray.tMax = ray.tMin + static_cast<double>(uniform.index(4));
    }
    if (isValid(ray))
    {
      rays.add(ray);
      wanted.push_back(passagesOf(*surface, ray, moved));
    }
  }
  for (const auto& tree : trees)
  {
    EXPECT_EQ(crossingsOf(*tree, rays), wanted) << label(tree->options());
  }
}

TEST(Crossings, EachPointBelongsToOneOfTouchingBoxes)
{
  std::vector<std::pair<Vec3, Vec3>> boxes;
  const auto surface = surfaceOf<double>(touchingBoxes(boxes));
  Rays rays;
  std::vector<bool> inside;
  for (int i = 0; i < 11 * 11 * 11; ++i)
  {
    const Vec3 origin = { 0.5 * (i % 11), 0.5 * (i / 11 % 11), 0.5 * (i / 121) };
    const auto within = [&](const auto& box) { return insideBox(origin, box.first, box.second); };
    for (const Vec3& d : { Vec3{ 1, 0, 0 }, Vec3{ 0, -1, 0 }, Vec3{ 0, 1, 1 }, Vec3{ -1, 1, -1 },
           Vec3{ 1, -2, 0 }, Vec3{ 0.3, 0.1, -0.7 } })
    {
      rays.add(origin, d);
      inside.push_back(std::any_of(boxes.begin(), boxes.end(), within));
    }
  }
  for (const auto& tree : accelerators(surface))
  {
    const auto counts = crossingsOf(*tree, rays);
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      ASSERT_EQ(counts[i] % 2 == 1, inside[i]) << "ray " << i << ", " << label(tree->options());
    }
  }
}

TEST(Crossings, SegmentsOfALineAddUp)
{
  std::vector<std::pair<Vec3, Vec3>> boxes;
  const auto surface = surfaceOf<double>(touchingBoxes(boxes));
  const auto tree = build(surface, optionsOf(Structure::WideBvh));
  for (const Vec3& d : { Vec3{ 1, 0, 0 }, Vec3{ 1, 1, 0 }, Vec3{ 1, 1, 1 }, Vec3{ 2, 1, 1 } })
  {
    Rays whole;
    whole.add({ { 0, 0, 0 }, d, -3.0, 5.0 });
    Rays parts;
    for (double t = -3.0; t < 5.0; t += 0.5)
    {
      parts.add({ { 0, 0, 0 }, d, t, t + 0.5 });
      parts.add({ { 0, 0, 0 }, d, t, t });
    }
    std::uint32_t sum = 0;
    for (const std::uint32_t count : crossingsOf(*tree, parts))
    {
      sum += count;
    }
    EXPECT_EQ(crossingsOf(*tree, whole).front(), sum);
  }
}

TEST(Crossings, TrianglesWithoutAreaDoNotMatter)
{
  // One face of the box is cut where the other side of the edge is not, with a triangle without
  // area between.
  Soup soup;
  addBox(soup, { 0, 0, 0 }, { 2, 2, 2 });
  const std::array<Vec3, 3> whole = soup[10]; // of the face z = 2
  const Vec3 middle = 0.5 * (whole[0] + whole[1]);
  soup[10] = { whole[0], middle, whole[2] };
  soup.push_back({ middle, whole[1], whole[2] });
  soup.push_back({ whole[0], middle, whole[1] });
  const auto surface = surfaceOf<float>(soup);
  ASSERT_EQ(surface->zeroAreaCount(), 1u);
  for (const auto& tree : accelerators(surface))
  {
    for (const Vec3& origin : { Vec3{ 1, 1, 1 }, Vec3{ 0.5, 1, 0.5 }, middle - Vec3{ 0, 0, 1 } })
    {
      const auto counts = crossingsOf(*tree, raysFrom(*surface, origin, 300, 5));
      for (const std::uint32_t count : counts)
      {
        ASSERT_EQ(count % 2, insideBox(origin, { 0, 0, 0 }, { 2, 2, 2 }) ? 1u : 0u);
      }
    }
  }
}

TEST(Crossings, TheHostsRoundingDoesNotMatter)
{
  const auto surface = closed(data::torus(40, 20, 0.3), 100.0, 0x1p-10, { 1e4, 1e4, 1e4 }, false);
  const auto tree = build(surface, optionsOf(Structure::WideBvh));
  const Vec3 origin = { 10100, 10000, 10001 };
  const Rays rays = raysFrom(*surface, origin, 3000, 2);
  const auto wanted = crossingsOf(*tree, rays);
  std::vector<PrimitiveId> wantedNear;
  const ConvexRegion region = { { { 1, 0.3, 0 }, 13000.7 }, { { -0.1, 0, 1 }, 9000.1 } };
  tree->overlap(region, wantedNear);
  EXPECT_FALSE(wantedNear.empty());
  for (const int mode : { FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO })
  {
    std::vector<PrimitiveId> near;
    std::fesetround(mode);
    const auto counts = crossingsOf(*tree, rays);
    tree->overlap(region, near);
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(counts, wanted);
    EXPECT_EQ(near, wantedNear);
  }
}

TEST(Crossings, ManyMagnitudes)
{
  for (const double scale : { 1e-290, 1e-150, 1e-30, 1e30, 1e150, 1e290 })
  {
    Soup soup;
    addBox(soup, { -scale, -scale, -scale }, { scale, scale, scale });
    const auto surface = surfaceOf<double>(soup);
    for (const auto& tree : accelerators(surface))
    {
      const auto counts = crossingsOf(*tree, raysFrom(*surface, { 0.25 * scale, 0, 0 }, 60, 9));
      EXPECT_EQ(std::count(counts.begin(), counts.end(), 1u), 60)
        << scale << " " << label(tree->options());
    }
  }
}

TEST(Crossings, WhatOtherQueriesDoAsWell)
{
  Soup soup;
  addBox(soup, { -1, -1, -1 }, { 1, 1, 1 });
  const auto surface = surfaceOf<float>(soup);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Rays rays;
  rays.add({ 0, 0, 0 }, { 1, 1, 1 });
  rays.add({ nan, 0, 0 }, { 1, 1, 1 });
  rays.add({ 0, 0, 0 }, { 0, 0, 0 });
  rays.add({ 0, 0, -5 }, { 0, 0, 1 });
  for (const auto& tree : accelerators(surface))
  {
    SCOPED_TRACE(label(tree->options()));
    std::vector<std::uint32_t> counts(rays.size(), 7);
    QueryReport report = tree->crossings(rays.batch(), counts.data(), with(Precision::Exact));
    EXPECT_EQ(counts, (std::vector<std::uint32_t>{ 1, 0, 0, 2 }));
    EXPECT_EQ(report.invalidRays, 2u);
    EXPECT_GT(report.exactTests, 0u);

    // Skipped primitives are not passed.
    RayBatch batch = rays.batch();
    std::vector<std::uint32_t> all(surface->size());
    for (std::uint32_t i = 0; i < all.size(); ++i)
    {
      all[i] = i;
    }
    const std::vector<std::uint64_t> offsets = { 0, all.size() };
    const std::vector<std::uint32_t> sets(rays.size(), 0);
    batch.skip = { sets.data(), offsets.data(), all.data() };
    report = tree->crossings(batch, counts.data(), with(Precision::Exact));
    EXPECT_EQ(counts, std::vector<std::uint32_t>(4, 0));

    for (const Precision precision : { Precision::Fast, Precision::Watertight })
    {
      EXPECT_THROW(tree->crossings(rays.batch(), counts.data(), with(precision)), UnsupportedQuery);
    }
  }
  if (Registry::instance().has(Structure::Embree))
  {
    std::vector<std::uint32_t> counts(rays.size());
    EXPECT_THROW(build(surface, optionsOf(Structure::Embree))
                   ->crossings(rays.batch(), counts.data(), with(Precision::Exact)),
      UnsupportedQuery);
  }
}

} // namespace
