// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// What is hit at the least t, and t to the nearest double.
#include "RationalOracle.h"
#include "TestHelpers.h"

#include <gtest/gtest.h>

#include <map>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

QueryOptions rounded()
{
  QueryOptions options = with(Precision::Exact);
  options.roundedT = true;
  return options;
}

/// The primitives at the least exact t among some, ascending.
std::vector<PrimitiveId> nearestOf(
  const Surface& surface, const Ray& ray, const std::vector<Hit>& hits)
{
  std::map<PrimitiveId, Rational> exact;
  for (const Hit& hit : hits)
  {
    exact[hit.primitive] = RationalCrossing(ray, surface.vertices(hit.primitive)).t;
  }
  std::vector<PrimitiveId> nearest;
  for (const auto& hit : exact)
  {
    if (std::all_of(exact.begin(), exact.end(),
          [&](const auto& other) { return hit.second <= other.second; }))
    {
      nearest.push_back(hit.first);
    }
  }
  return nearest;
}

/// Whether no double is nearer, and none as near unless x is the even one.
bool isNearest(double x, const Rational& exact)
{
  const Rational error = abs(rational(x) - exact);
  for (const double other : { std::nextafter(x, -HUGE_VAL), std::nextafter(x, HUGE_VAL) })
  {
    const Rational otherError = abs(rational(other) - exact);
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof(bits));
    if (otherError < error || (otherError == error && (bits & 1u) != 0))
    {
      return false;
    }
  }
  return true;
}

std::vector<std::shared_ptr<const Surface>> scenes()
{
  // Slabs around the middle: many planes that nearly coincide along a ray.
  Uniform uniform(7);
  std::vector<std::array<Vec3, 3>> fan;
  for (int i = 0; i < 60; ++i)
  {
    const double tilt = 1e-9 * static_cast<double>(i / 2);
    fan.push_back({ Vec3{ -9, -9, 1 + tilt }, Vec3{ 9, -9, 1 - tilt * 0.3 },
      Vec3{ uniform(-1, 1), 9, 1 + 1e-8 * uniform(-1, 1) } });
  }
  return { surfaceOf<float>(data::teapot(2)), surfaceOf<float>(data::cornellBox()),
    surfaceOf<double>(fan), surfaceOf<double>(data::slivers(60)) };
}

/// Rays around, and nearly along the planes of triangles.
Rays raysOver(const Surface& surface)
{
  Rays rays = raysAround(surface, 300, 19);
  Uniform uniform(3);
  for (int i = 0; i < 100; ++i)
  {
    const auto v = surface.vertices(static_cast<PrimitiveId>(uniform.index(surface.size())));
    const Vec3 target = 0.4 * v[0] + (0.3 * v[1] + 0.3 * v[2]);
    const Vec3 normal = cross(v[1] - v[0], v[2] - v[0]);
    const Vec3 d = (v[1] - v[0]) + uniform(-1e-7, 1e-7) * normal;
    rays.add(target - 2.0 * d, d);
  }
  return rays;
}

TEST(Ties, AreWhatRationalNumbersSay)
{
  std::size_t several = 0;
  for (const auto& surface : scenes())
  {
    const Rays rays = raysOver(*surface);
    std::vector<std::vector<PrimitiveId>> wanted(rays.size());
    const auto oracle = build(surface, optionsOf(Structure::BruteForce));
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      const Ray ray = rays.batch()[i];
      wanted[i] = nearestOf(*surface, ray, allOf(*oracle, ray, Precision::Exact));
      several += wanted[i].size() > 1 ? 1 : 0;
    }
    auto trees = accelerators(surface);
    if (Registry::instance().has(Structure::Cgal))
    {
      trees.push_back(build(surface, optionsOf(Structure::Cgal)));
    }
    for (const auto& tree : trees)
    {
      SCOPED_TRACE(label(tree->options()));
      AllHits ties;
      std::vector<Hit> closest(rays.size());
      tree->ties(rays.batch(), ties, with(Precision::Exact));
      tree->closest(rays.batch(), closest.data(), with(Precision::Exact));
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        std::vector<PrimitiveId> found;
        for (auto h = ties.offsets[i]; h < ties.offsets[i + 1]; ++h)
        {
          found.push_back(ties.hits[h].primitive);
          EXPECT_EQ(ties.hits[h].t, closest[i].t);
        }
        ASSERT_EQ(found, wanted[i]) << "ray " << i;
        EXPECT_TRUE(found.empty() || sameBits(ties.hits[ties.offsets[i]], closest[i]));
      }
    }
  }
  EXPECT_GT(several, 100u);
}

TEST(Ties, AThousandAlike)
{
  std::vector<std::array<Vec3, 3>> alike(
    1000, { Vec3{ 0, 0, 1 }, Vec3{ 1, 0, 1 }, Vec3{ 0, 1, 1 } });
  alike[3] = { Vec3{ 0, 0, 2 }, Vec3{ 1, 0, 2 }, Vec3{ 0, 1, 2 } };
  const auto surface = surfaceOf<float>(alike);
  Rays rays;
  rays.add({ 0.1, 0.2, 0 }, { 0, 0, 1 });
  for (const auto& tree : accelerators(surface))
  {
    for (const Precision precision : everyPrecision)
    {
      AllHits ties;
      tree->ties(rays.batch(), ties, with(precision));
      ASSERT_EQ(ties.hits.size(), 999u);
      for (std::size_t i = 0; i < ties.hits.size(); ++i)
      {
        EXPECT_EQ(ties.hits[i].primitive, i < 3 ? i : i + 1);
        EXPECT_EQ(ties.hits[i].t, 1.0);
      }
    }
  }
}

TEST(Ties, OfFastAndWatertightAreTheSameFromEveryStructure)
{
  for (const auto& surface : scenes())
  {
    const Rays rays = raysOver(*surface);
    for (const Precision precision : { Precision::Fast, Precision::Watertight })
    {
      AllHits wanted;
      std::vector<Hit> closest(rays.size());
      const auto oracle = build(surface, optionsOf(Structure::BruteForce));
      oracle->ties(rays.batch(), wanted, with(precision));
      oracle->closest(rays.batch(), closest.data(), with(precision));
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        ASSERT_EQ(wanted.offsets[i] < wanted.offsets[i + 1], closest[i].primitive != noPrimitive);
        ASSERT_TRUE(closest[i].primitive == noPrimitive ||
          sameBits(wanted.hits[wanted.offsets[i]], closest[i]));
      }
      for (const auto& tree : accelerators(surface))
      {
        AllHits ties;
        tree->ties(rays.batch(), ties, with(precision));
        ASSERT_EQ(ties.offsets, wanted.offsets) << label(tree->options());
        for (std::size_t h = 0; h < ties.hits.size(); ++h)
        {
          ASSERT_TRUE(sameBits(ties.hits[h], wanted.hits[h])) << label(tree->options());
        }
      }
    }
  }
}

TEST(Ties, FromEmbree)
{
  if (!Registry::instance().has(Structure::Embree))
  {
    GTEST_SKIP() << "built without Embree";
  }
  const auto surface = surfaceOf<float>(data::teapot(3));
  const auto embree = build(surface, optionsOf(Structure::Embree));
  const Rays rays = raysAround(*surface, 500, 3);
  AllHits ties;
  std::vector<Hit> closest(rays.size());
  embree->ties(rays.batch(), ties, with(Precision::Fast));
  embree->closest(rays.batch(), closest.data(), with(Precision::Fast));
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    ASSERT_EQ(ties.offsets[i] < ties.offsets[i + 1], closest[i].primitive != noPrimitive);
    for (auto h = ties.offsets[i]; h < ties.offsets[i + 1]; ++h)
    {
      EXPECT_EQ(ties.hits[h].t, closest[i].t);
    }
  }
}

TEST(RoundedT, IsTheNearestDouble)
{
  for (const auto& surface : scenes())
  {
    const Rays rays = raysOver(*surface);
    for (const auto& tree : accelerators(surface))
    {
      SCOPED_TRACE(label(tree->options()));
      AllHits all;
      AllHits ties;
      std::vector<Hit> closest(rays.size());
      const QueryReport report = tree->all(rays.batch(), all, rounded());
      EXPECT_EQ(report.exactParameters, all.hits.size());
      tree->ties(rays.batch(), ties, rounded());
      tree->closest(rays.batch(), closest.data(), rounded());
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        const Ray ray = rays.batch()[i];
        for (auto h = all.offsets[i]; h < all.offsets[i + 1]; ++h)
        {
          const Hit& hit = all.hits[h];
          EXPECT_TRUE(h == all.offsets[i] || all.hits[h - 1].t <= hit.t);
          if (i % 16 == 0)
          {
            ASSERT_TRUE(
              isNearest(hit.t, RationalCrossing(ray, surface->vertices(hit.primitive)).t));
          }
        }
        if (all.offsets[i] < all.offsets[i + 1])
        {
          EXPECT_TRUE(sameBits(all.hits[all.offsets[i]], closest[i]));
          EXPECT_TRUE(sameBits(ties.hits[ties.offsets[i]], closest[i]));
        }
      }
    }
  }
}

TEST(RoundedT, OnlyExactKnowsIt)
{
  const auto surface = surfaceOf<float>(data::teapot(2));
  const Rays rays = raysAround(*surface, 4, 3);
  Hit hits[4];
  auto trees = accelerators(surface);
  if (Registry::instance().has(Structure::Embree))
  {
    trees.push_back(build(surface, optionsOf(Structure::Embree)));
  }
  for (const auto& tree : trees)
  {
    for (const Precision precision : { Precision::Fast, Precision::Watertight })
    {
      QueryOptions options = with(precision);
      options.roundedT = true;
      EXPECT_THROW(tree->closest(rays.batch(), hits, options), UnsupportedQuery);
    }
  }
}

TEST(All, TNeverDescendsAndStaysNear)
{
  std::size_t close = 0;
  for (const auto& surface : scenes())
  {
    const Rays rays = raysOver(*surface);
    const auto tree = build(surface, optionsOf(Structure::WideBvh));
    for (const Precision precision : everyPrecision)
    {
      AllHits all;
      tree->all(rays.batch(), all, with(precision));
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        for (auto h = all.offsets[i] + 1; h < all.offsets[i + 1]; ++h)
        {
          ASSERT_LE(all.hits[h - 1].t, all.hits[h].t);
          close += all.hits[h - 1].t >= all.hits[h].t * (1 - 0x1p-26) ? 1 : 0;
        }
      }
      if (precision == Precision::Exact)
      {
        for (std::size_t i = 0; i < rays.size(); i += 3)
        {
          for (auto h = all.offsets[i]; h < all.offsets[i + 1]; ++h)
          {
            const Hit& hit = all.hits[h];
            const Rational t =
              RationalCrossing(rays.batch()[i], surface->vertices(hit.primitive)).t;
            ASSERT_LE(abs(rational(hit.t) - t), abs(t) * rational(0x1.01p-26));
          }
        }
      }
    }
  }
  EXPECT_GT(close, 100u);
}

} // namespace
