// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Single triangles and few: borders, slivers, parallel planes, ties, limits of t.
#include "RationalOracle.h"
#include "TestHelpers.h"

#include <gtest/gtest.h>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

using Corners = std::array<Vec3, 3>;

const Corners unitTriangle = { Vec3{ 0, 0, 0 }, Vec3{ 1, 0, 0 }, Vec3{ 0, 1, 0 } };
const double infinity = std::numeric_limits<double>::infinity();

double up(double x)
{
  return std::nextafter(x, infinity);
}

double down(double x)
{
  return std::nextafter(x, -infinity);
}

/// Runs a check for every structure over float and double triangles, for the precisions given.
template <class Check>
void forEvery(const std::vector<Corners>& triangles, const std::vector<Precision>& precisions,
  const Check& check)
{
  for (const auto& surface : { surfaceOf<float>(triangles), surfaceOf<double>(triangles) })
  {
    for (const auto& accelerator : accelerators(surface))
    {
      for (const Precision precision : precisions)
      {
        SCOPED_TRACE(label(accelerator->options()) + ", " + std::string(name(precision)));
        check(*accelerator, precision);
      }
    }
  }
}

const std::vector<Precision> allPrecisions(everyPrecision.begin(), everyPrecision.end());
const std::vector<Precision> exactOnly = { Precision::Exact };

TEST(Triangles, BordersBelongToTheTriangleToTheLastUlp)
{
  struct Probe
  {
    double x, y;
    bool inside;
  };
  const std::vector<Probe> probes = { { 0, 0, true }, { 1, 0, true }, { 0, 1, true },
    { 0.5, 0.5, true }, { 0.25, 0.75, true }, { 0.5, 0, true }, { 0, 0.5, true },
    { up(0.0), 0.5, true }, { down(0.0), 0.5, false }, { 0.5, up(0.0), true },
    { 0.5, down(0.0), false }, { 0.5, down(0.5), true }, { 0.5, up(0.5), false },
    { down(0.25), 0.75, true }, { up(0.25), 0.75, false }, { down(1.0), 0, true },
    { up(1.0), 0, false }, { 0.1, 0.9, false }, { 0.3, 0.7, false } };
  forEvery({ unitTriangle }, exactOnly,
    [&](const Accelerator& accelerator, Precision precision)
    {
      for (const Probe& p : probes)
      {
        for (const Vec3& direction : { Vec3{ 0, 0, 1 }, Vec3{ 0, 0, 3 } })
        {
          const Ray ray = { { p.x, p.y, -1 }, direction };
          // 0.1 + 0.9 and 0.3 + 0.7 as stored are decided by their last bits: ask the rationals.
          const bool inside = rationallyHits(ray, RationalCrossing(ray, unitTriangle));
          if (p.x != 0.1 && p.x != 0.3)
          {
            EXPECT_EQ(inside, p.inside) << p.x << " " << p.y;
          }
          EXPECT_EQ(closestOf(accelerator, ray, precision).primitive != noPrimitive, inside)
            << p.x << " " << p.y;
        }
      }
    });
}

TEST(Triangles, WatertightNeverLosesTheBorder)
{
  forEvery({ unitTriangle }, { Precision::Watertight },
    [&](const Accelerator& accelerator, Precision precision)
    {
      for (int i = 0; i <= 64; ++i)
      {
        const double x = i / 64.0;
        for (const Vec3& target : { Vec3{ x, 0, 0 }, Vec3{ 0, x, 0 }, Vec3{ x, 1 - x, 0 } })
        {
          const Vec3 origin = { 0.3, 0.7, -3 };
          EXPECT_NE(
            closestOf(accelerator, { origin, target - origin }, precision).primitive, noPrimitive);
        }
      }
    });
}

TEST(Triangles, ZeroAreaIsNeverHit)
{
  const Vec3 p = { 0.25, 0.25, 0 };
  const std::vector<Corners> triangles = { { p, p, p }, { p, p, Vec3{ 1, 1, 0 } },
    { Vec3{ 0, 0, 0 }, p, Vec3{ 0.5, 0.5, 0 } },
    { Vec3{ 1, 0, 1 }, Vec3{ 2, 0, 1 }, Vec3{ 1, 1, 1 } } };
  forEvery(triangles, allPrecisions,
    [&](const Accelerator& accelerator, Precision precision)
    {
      EXPECT_EQ(accelerator.surface().zeroAreaCount(), 3u);
      for (const Vec3& direction : { Vec3{ 0, 0, 1 }, Vec3{ 1, 1, 0 }, Vec3{ 1, 2, 3 } })
      {
        EXPECT_EQ(
          closestOf(accelerator, { p - direction, direction }, precision).primitive, noPrimitive);
      }
      EXPECT_EQ(
        closestOf(accelerator, { { 1.25, 0.25, 0 }, { 0, 0, 1 } }, precision).primitive, 3u);
    });
}

TEST(Triangles, RayInThePlaneDoesNotHit)
{
  forEvery({ unitTriangle }, { Precision::Fast, Precision::Exact },
    [&](const Accelerator& accelerator, Precision precision)
    {
      for (const Ray& ray : { Ray{ { -1, 0.25, 0 }, { 1, 0, 0 } }, Ray{ { -1, 0, 0 }, { 1, 0, 0 } },
             Ray{ { -1, -1, 0 }, { 1, 1, 0 } }, Ray{ { 0.25, 0.25, 0 }, { 1, 2, 0 } },
             Ray{ { -1, 2, 0 }, { 1, -1, 0 } }, Ray{ { -1, 1, 0 }, { 1, 0, 0 } } })
      {
        EXPECT_EQ(closestOf(accelerator, ray, precision).primitive, noPrimitive);
      }
    });
}

TEST(Triangles, RayInAFaceOfAClosedBoxHitsItsNeighboursOnly)
{
  const auto box = surfaceOf<float>(data::cornellBox());
  const Box bounds = box->bounds();
  // In the plane of the wall at the lower x, which two triangles form.
  const Ray ray = { { bounds.lower[0], bounds.lower[1] - 1, 0.375 }, { 0, 1, 0 } };
  for (const auto& accelerator : accelerators(box))
  {
    const auto hits = allOf(*accelerator, ray, Precision::Exact);
    ASSERT_FALSE(hits.empty());
    EXPECT_EQ(hits.front().t, 1.0);
    for (const Hit& hit : hits)
    {
      EXPECT_FALSE(RationalCrossing(ray, box->vertices(hit.primitive)).parallel);
    }
  }
}

TEST(Triangles, NeedleIsHitWithinItsWidth)
{
  const double half = 0.5e-6;
  forEvery({ { Vec3{ 0, -half, 0 }, Vec3{ 1, 0, 0 }, Vec3{ 0, half, 0 } } }, allPrecisions,
    [&](const Accelerator& accelerator, Precision precision)
    {
      for (const double x : { 0.0, 0.25, 0.5, 0.9 })
      {
        for (const double side : { -1.0, 1.0 })
        {
          const double y = side * (1 - x) * half;
          const Vec3 d = { 0.5, 0.25, 1 };
          EXPECT_NE(closestOf(accelerator, { Vec3{ x, 0.5 * y, 0 } - d, d }, precision).primitive,
            noPrimitive);
          EXPECT_EQ(closestOf(accelerator, { Vec3{ x, 1.2 * y, 0 } - d, d }, precision).primitive,
            noPrimitive);
        }
      }
    });
}

TEST(Triangles, NearlyParallelRaysAreExact)
{
  Uniform uniform(3);
  for (int i = 0; i < 400; ++i)
  {
    Corners corners;
    for (Vec3& p : corners)
    {
      p = { uniform(-1, 1), uniform(-1, 1), 1e-3 * uniform(-1, 1) };
    }
    const double angle = std::pow(10.0, uniform(-5, 0));
    const Ray ray = { { uniform(-2, 2), uniform(-2, 2), uniform(-1, 1) * angle },
      { uniform(-1, 1), uniform(-1, 1), uniform(-1, 1) * angle } };
    const RationalCrossing x(ray, corners);
    const auto surface = surfaceOf<double>(std::vector<Corners>{ corners });
    for (const auto& accelerator : accelerators(surface))
    {
      const Hit hit = closestOf(*accelerator, ray, Precision::Exact);
      ASSERT_EQ(hit.primitive != noPrimitive, rationallyHits(ray, x));
      if (hit.primitive != noPrimitive)
      {
        ASSERT_LE(
          static_cast<double>(abs(rational(hit.t) - x.t)), static_cast<double>(abs(x.t)) * 0x1p-24);
      }
    }
  }
}

TEST(Triangles, NearerOfTwoPlanesAnUlpApartWins)
{
  const auto at = [](double z) {
    return Corners{ Vec3{ 0, 0, z }, Vec3{ 1, 0, z }, Vec3{ 0, 1, z } };
  };
  const double next = std::nextafter(1.0f, 2.0f);
  forEvery({ at(next), at(1) }, allPrecisions,
    [](const Accelerator& a, Precision precision)
    {
      EXPECT_EQ(closestOf(a, { { 0.25, 0.25, 0 }, { 0, 0, 1 } }, precision).primitive, 1u);
      EXPECT_EQ(closestOf(a, { { 0.25, 0.25, 2 }, { 0, 0, -1 } }, precision).primitive, 0u);
    });
  const auto surface = surfaceOf<double>(std::vector<Corners>{ at(up(1.0)), at(1) });
  for (const auto& accelerator : accelerators(surface))
  {
    EXPECT_EQ(
      closestOf(*accelerator, { { 0.25, 0.25, -1 / 3.0 }, { 0.1, 0.1, 1 } }, Precision::Exact)
        .primitive,
      1u);
    EXPECT_EQ(closestOf(*accelerator, { { 0.25, 0.25, 7 }, { 0.01, 0.01, -1 } }, Precision::Exact)
                .primitive,
      0u);
  }
}

TEST(Triangles, ObliquePlanesThatCrossOnTheRayTieToTheLowest)
{
  // Both contain the point (0, 0, 1); seven more are further away.
  std::vector<Corners> triangles;
  for (int i = 0; i < 7; ++i)
  {
    triangles.push_back({ Vec3{ -3, -3, 2.0 + i }, Vec3{ 3, -3, 2.0 + i }, Vec3{ 0, 3, 2.0 + i } });
  }
  triangles.push_back({ Vec3{ -3, -3, -2 }, Vec3{ 3, -3, -2 }, Vec3{ 0, 3, 4 } });
  triangles.push_back({ Vec3{ -3, -3, -2 }, Vec3{ -3, 3, -2 }, Vec3{ 3, 0, 4 } });
  const Vec3 crossing = { 0, 0, 1 };
  forEvery(triangles, exactOnly,
    [&](const Accelerator& accelerator, Precision precision)
    {
      for (const Vec3& d : { Vec3{ 0, 0, 1 }, Vec3{ 0.125, -0.25, 1 }, Vec3{ 0.5, 0.25, 3 } })
      {
        const auto hits = allOf(accelerator, { crossing - d, d }, precision);
        ASSERT_GE(hits.size(), 2u);
        EXPECT_EQ(hits[0].primitive, 7u);
        EXPECT_EQ(hits[1].primitive, 8u);
        EXPECT_EQ(hits[0].t, 1.0);
      }
    });
}

TEST(Triangles, OfManyIdenticalTrianglesTheLowestWins)
{
  std::vector<Corners> triangles;
  Uniform uniform(5);
  for (int i = 0; i < 1000; ++i)
  {
    Corners c = unitTriangle;
    std::swap(c[0], c[uniform.index(3)]);
    std::swap(c[1], c[1 + uniform.index(2)]);
    triangles.push_back(c);
  }
  forEvery(triangles, allPrecisions,
    [](const Accelerator& accelerator, Precision precision)
    {
      for (const Vec3& target : { Vec3{ 0.25, 0.25, 0 }, Vec3{ 0.5, 0.5, 0 }, Vec3{ 0, 0, 0 } })
      {
        const Ray ray = { { target[0], target[1], 1 }, { 0, 0, -1 } };
        EXPECT_EQ(closestOf(accelerator, ray, precision).primitive, 0u);
        EXPECT_EQ(allOf(accelerator, ray, precision).size(), 1000u);
      }
    });
}

TEST(Triangles, LimitsOfTBelongToTheSegment)
{
  forEvery({ unitTriangle }, { Precision::Fast, Precision::Exact },
    [](const Accelerator& accelerator, Precision precision)
    {
      const auto hits = [&](double tMin, double tMax)
      {
        const Hit hit =
          closestOf(accelerator, { { 0.25, 0.25, -1 }, { 0, 0, 1 }, tMin, tMax }, precision);
        return hit.primitive != noPrimitive && hit.t == 1.0;
      };
      EXPECT_TRUE(hits(1, 2));
      EXPECT_TRUE(hits(0, 1));
      EXPECT_TRUE(hits(1, 1));
      EXPECT_TRUE(hits(down(1.0), up(1.0)));
      EXPECT_FALSE(hits(up(1.0), 2));
      EXPECT_FALSE(hits(0, down(1.0)));
      EXPECT_TRUE(hits(-infinity, infinity));
      EXPECT_FALSE(hits(infinity, infinity));
      EXPECT_FALSE(hits(-infinity, -infinity));
    });
  // Where t is no double, either side of it decides: t = 1/3.
  forEvery({ unitTriangle }, exactOnly,
    [](const Accelerator& accelerator, Precision precision)
    {
      const auto hits = [&](double tMin, double tMax)
      {
        return closestOf(accelerator, { { 0.25, 0.25, -1 }, { 0, 0, 3 }, tMin, tMax }, precision)
                 .primitive != noPrimitive;
      };
      const double third = 1.0 / 3.0; // below the true third
      EXPECT_TRUE(hits(third, 1));
      EXPECT_FALSE(hits(up(third), 1));
      EXPECT_FALSE(hits(0, third));
      EXPECT_TRUE(hits(0, up(third)));
    });
}

TEST(Triangles, OriginOnTheTriangleHitsAtZero)
{
  forEvery({ unitTriangle }, allPrecisions,
    [](const Accelerator& accelerator, Precision precision)
    {
      for (const Vec3& origin : { Vec3{ 0.25, 0.25, 0 }, Vec3{ 0, 0, 0 }, Vec3{ 0.5, 0.5, 0 } })
      {
        for (const Vec3& direction : { Vec3{ 0, 0, 1 }, Vec3{ 1, 2, -1 } })
        {
          const Hit hit = closestOf(accelerator, { origin, direction }, precision);
          EXPECT_EQ(hit.primitive, 0u);
          EXPECT_EQ(hit.t, 0.0);
        }
      }
    });
}

TEST(Triangles, NegativeLimitsReachBackward)
{
  forEvery({ unitTriangle }, allPrecisions,
    [](const Accelerator& accelerator, Precision precision)
    {
      const Ray ray = { { 0.25, 0.25, 2 }, { 0, 0, 1 }, -4, 0 };
      EXPECT_EQ(closestOf(accelerator, ray, precision).t, -2.0);
      EXPECT_EQ(
        closestOf(accelerator, { ray.origin, ray.direction }, precision).primitive, noPrimitive);
    });
}

TEST(Triangles, TScalesWithTheDirection)
{
  forEvery({ unitTriangle }, allPrecisions,
    [](const Accelerator& accelerator, Precision precision)
    {
      for (const double scale : { 0x1p-66, 0x1p-20, 1.0, 0x1p20, 0x1p66 })
      {
        const Ray ray = { { 0.3, 0.2, -1.7 }, scale * Vec3{ 0.01, 0.07, 0.9 } };
        const Ray unit = { ray.origin, { 0.01, 0.07, 0.9 } };
        const Hit expected = closestOf(accelerator, unit, precision);
        ASSERT_EQ(expected.primitive, 0u);
        EXPECT_EQ(closestOf(accelerator, ray, precision).t, expected.t / scale);
      }
    });
}

TEST(Triangles, DirectionsWithoutAFiniteReciprocalStillHit)
{
  forEvery({ unitTriangle }, { Precision::Watertight, Precision::Exact },
    [](const Accelerator& accelerator, Precision precision)
    {
      for (const double z : { 0.0, 0x1p-60, 0x1p-10 })
      {
        const Ray ray = { { 0.25, 0.25, -z }, { 0, 0, 0x1p-1030 } };
        const Hit hit = closestOf(accelerator, ray, precision);
        EXPECT_EQ(hit.primitive, 0u) << z;
        EXPECT_EQ(hit.t, z * 0x1p515 * 0x1p515);
      }
    });
}

TEST(Triangles, BarycentricCoordinatesGiveTheHitPoint)
{
  const Corners corners = { Vec3{ 1, 2, 3 }, Vec3{ 4, 1, 2 }, Vec3{ 2, 5, 4 } };
  forEvery({ corners }, allPrecisions,
    [&](const Accelerator& accelerator, Precision precision)
    {
      const Vec3 origin = { 0.5, 0.25, 9 };
      for (const auto& [u, v] :
        std::vector<std::pair<double, double>>{ { 0.25, 0.5 }, { 0.1, 0.1 }, { 0.8, 0.1 } })
      {
        const Vec3 point = (1 - u - v) * corners[0] + u * corners[1] + v * corners[2];
        const Hit hit = closestOf(accelerator, { origin, 0.5 * (point - origin) }, precision);
        EXPECT_NEAR(hit.t, 2.0, 1e-14);
        EXPECT_NEAR(hit.u, u, 1e-14);
        EXPECT_NEAR(hit.v, v, 1e-14);
      }
    });
}

} // namespace
