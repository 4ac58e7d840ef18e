// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// The floating-point filter keeps its promises: no edge function is further from the exact one than
// its bound, and the interval of t contains the exact t.
#include "Accel/Kernel/Crossing.h"
#include "NearDegenerate.h"
#include "RationalOracle.h"
#include "TestHelpers.h"

#include <gtest/gtest.h>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

template <class Check>
void forPairs(int each, const Check& check)
{
  for (const double scale :
    { 1.0, 1e6, 0x1p-100, 0x1p-330, 0x1p-350, 0x1p-500, 0x1p300, 0x1p340, 0x1p512 })
  {
    NearDegenerate random(29);
    for (int kind = 0; kind < NearDegenerate::kinds; ++kind)
    {
      SCOPED_TRACE("kind " + std::to_string(kind) + ", scale " + std::to_string(std::ilogb(scale)));
      for (int i = 0; i < each; ++i)
      {
        check(random(kind, scale));
        if (::testing::Test::HasFatalFailure())
        {
          return;
        }
      }
    }
  }
}

TEST(FilterBound, EdgeFunctionsErrLessThanTheirBound)
{
  double worst = 0.0;
  forPairs(150,
    [&](const Pair& p)
    {
      const EdgeValues e = edgeValues(FilterRay(p.ray), p.triangle);
      if (!std::isfinite(e.error))
      {
        return; // nothing is certain, nothing is claimed
      }
      const RationalCrossing exact(p.ray, p.triangle);
      // The filter's edge functions are the weights, up to one sign for all.
      for (int i = 0; i < 3; ++i)
      {
        const double computed = i == 0 ? e.u : (i == 1 ? e.v : e.w);
        ASSERT_TRUE(std::isfinite(computed));
        const Rational off = abs(rational(computed) - exact.weights[i]);
        const Rational otherOff = abs(rational(computed) + exact.weights[i]);
        const Rational error = off < otherOff ? off : otherOff;
        ASSERT_LE(error, rational(e.error));
        worst = std::max(worst, static_cast<double>(error / rational(e.error)));
      }
    });
  EXPECT_GT(worst, 0.01) << "the pairs do not try the bound";
  RecordProperty("WorstShareOfTheBound", std::to_string(worst));
}

TEST(FilterBound, IsAsDerived)
{
  // Docs/exactness.md: 14 u with the rounding of the bound's own operations. No input is known that
  // needs more than a part of it, so that errors alone would not show a bound that is too small.
  const double u = 0x1p-53;
  EXPECT_GE(FilterRay::edgeBound, 14 * u * (1 + 12 * u));
}

TEST(FilterBound, CertaintiesAreTrue)
{
  int certain = 0;
  int open = 0;
  forPairs(150,
    [&](const Pair& p)
    {
      const EdgeValues e = edgeValues(FilterRay(p.ray), p.triangle);
      const RationalCrossing exact(p.ray, p.triangle);
      ASSERT_FALSE(surelyHit(e) && !exact.inside);
      ASSERT_FALSE(surelyMissed(e) && exact.inside);
      (surelyHit(e) || surelyMissed(e) ? certain : open) += 1;
    });
  EXPECT_GT(certain, 1000);
  EXPECT_GT(open, 1000);
}

TEST(FilterBound, IntervalsContainTheExactT)
{
  int narrow = 0;
  forPairs(150,
    [&](const Pair& p)
    {
      const RationalCrossing exact(p.ray, p.triangle);
      if (!exact.inside)
      {
        return;
      }
      const Crossing x = crossing(FilterRay(p.ray), p.triangle);
      ASSERT_FALSE(std::isnan(x.tLow) || std::isnan(x.tHigh));
      ASSERT_TRUE(std::isinf(x.tLow) || rational(x.tLow) <= exact.t);
      ASSERT_TRUE(std::isinf(x.tHigh) || exact.t <= rational(x.tHigh));
      ASSERT_LE(x.tLow, x.t);
      ASSERT_LE(x.t, x.tHigh);
      narrow += x.tHigh - x.tLow <= 0x1p-40 * std::fabs(x.t) ? 1 : 0;
    });
  EXPECT_GT(narrow, 400);
}

/// Triangles nearly across the dominant axis, where weights hardly matter: what is left are the
/// roundings of differences, shares and sums, which seldom add up.
TEST(FilterBound, IntervalsHoldWhereOnlyRoundingCounts)
{
  Uniform uniform(21);
  int inside = 0;
  for (int i = 0; i < 6000; ++i)
  {
    const double z = uniform(1, 2);
    const auto corner = [&] {
      return Vec3{ uniform(-1, 1), uniform(-1, 1), z + 0x1p-49 * uniform(-1, 1) };
    };
    const std::array<Vec3, 3> triangle = { corner(), corner(), corner() };
    const Vec3 origin = { uniform(-0.1, 0.1), uniform(-0.1, 0.1), uniform(-0.1, 0) };
    const Vec3 target =
      uniform(0.3, 0.35) * triangle[0] + uniform(0.3, 0.35) * triangle[1] + (1 / 3.0) * triangle[2];
    const Ray ray = { origin, uniform(0.5, 1) * (target - origin) };
    const RationalCrossing exact(ray, triangle);
    if (!exact.inside)
    {
      continue;
    }
    ++inside;
    const Crossing x = crossing(FilterRay(ray), triangle);
    ASSERT_LE(rational(x.tLow), exact.t) << i;
    ASSERT_LE(exact.t, rational(x.tHigh)) << i;
  }
  EXPECT_GT(inside, 3000);
}

/// Needles along the ray: the weights err most in proportion, and t hangs on them alone. All
/// components are large, so that rounding is as near to its bound as it seems to get.
TEST(FilterBound, IntervalsHoldWhereWeightsErrMost)
{
  Uniform uniform(22);
  int inside = 0;
  int certain = 0;
  for (int i = 0; i < 4000; ++i)
  {
    const auto diagonal = [&] { return Vec3{ uniform(0.9, 1), uniform(0.9, 1), uniform(0.9, 1) }; };
    const Vec3 along = diagonal();
    const Vec3 a = Vec3{ -1, 1, -1 } + 0.1 * diagonal();
    const Vec3 side = std::ldexp(1.0, -25 - i % 20) * Vec3{ uniform(-1, 1), uniform(-1, 1), 1 };
    const std::array<Vec3, 3> triangle = { a, a + along, a + uniform(0.2, 0.8) * along + side };
    const Vec3 target = (1 / 3.0) * (triangle[0] + triangle[1] + triangle[2]);
    const Vec3 origin = target - along + uniform(0.02, 0.2) * Vec3{ 1, -1, uniform(-1, 1) };
    const Ray ray = { origin, target - origin };
    const RationalCrossing exact(ray, triangle);
    if (!exact.inside)
    {
      continue;
    }
    ++inside;
    const Crossing x = crossing(FilterRay(ray), triangle);
    ASSERT_LE(rational(x.tLow), exact.t) << i;
    ASSERT_LE(exact.t, rational(x.tHigh)) << i;
    // No input is known whose error comes near what is derived: it is asked for by itself.
    const EdgeValues& e = x.edges;
    if (surelyHit(e))
    {
      ++certain;
      const FilterRay filter(ray);
      const Along at = lumitree::along(filter, triangle);
      const double first = *std::min_element(at.begin(), at.end());
      const double last = *std::max_element(at.begin(), at.end());
      const double off = 3 * e.error * (last - first) / (std::fabs(e.u + e.v + e.w) - 3 * e.error);
      const double derived = (1 - 1e-9) * off / ray.direction[filter.axis];
      ASSERT_LE(x.tLow, std::max(x.t - derived, filter.parameter(first - ray.origin[filter.axis])));
      ASSERT_GE(x.tHigh, std::min(x.t + derived, filter.parameter(last - ray.origin[filter.axis])));
    }
  }
  EXPECT_GT(inside, 2000);
  EXPECT_GT(certain, 2000);
}

TEST(FilterBound, IntervalsHoldForDirectionsWithoutAReciprocal)
{
  const std::array<Vec3, 3> triangle = { Vec3{ 0, 0, 0 }, Vec3{ 1, 0, 0 }, Vec3{ 0, 1, 0 } };
  for (const double d : { 0x1p-1020, 0x1p-1024, 0x1p-1030, 0x1p-1074 })
  {
    for (const double z : { 0.0, -0x1p-60, -0x1p-10, -1.0, 0x1p-40 })
    {
      const Ray ray = { { 0.25, 0.25, z }, { 0, 0, d } };
      const RationalCrossing exact(ray, triangle);
      ASSERT_TRUE(exact.inside);
      const Crossing x = crossing(FilterRay(ray), triangle);
      ASSERT_TRUE(std::isinf(x.tLow) || rational(x.tLow) <= exact.t) << d << " " << z;
      ASSERT_TRUE(std::isinf(x.tHigh) || exact.t <= rational(x.tHigh)) << d << " " << z;
      ASSERT_LE(x.tLow, x.tHigh) << d << " " << z;
    }
  }
}

TEST(FilterBound, TStaysWithinTheTriangleHoweverGrazingTheRay)
{
  forPairs(100,
    [&](const Pair& p)
    {
      const Crossing x = crossing(FilterRay(p.ray), p.triangle);
      ASSERT_GE(x.u, 0.0);
      ASSERT_GE(x.v, 0.0);
      ASSERT_LE(x.u + x.v, 1.0 + 0x1p-50);
    });
}

/// Four triangles side by side, one a millionth as far from the rays' origin as the others: its
/// bound is not theirs, and theirs not its.
TEST(FilterBound, TrianglesOfOneBlockHaveEachItsOwn)
{
  Uniform uniform(6);
  for (int i = 0; i < 400; ++i)
  {
    const auto point = [&](double size) {
      return Vec3{ uniform(-size, size), uniform(-size, size), uniform(-size, size) };
    };
    const Vec3 origin = point(1e-3);
    std::vector<std::array<Vec3, 3>> triangles;
    for (int lane = 0; lane < 4; ++lane)
    {
      const double size = lane == i % 4 ? 1e-3 : 1e3;
      triangles.push_back({ point(size), point(size), point(size) });
    }
    const auto accelerator = build(surfaceOf<double>(triangles), optionsOf(Structure::BruteForce));
    for (const std::array<Vec3, 3>& aim : triangles)
    {
      const double share = uniform(0, 1);
      const Ray ray = { origin, share * aim[0] + (1 - share) * aim[1] - origin };
      std::vector<PrimitiveId> wanted;
      for (PrimitiveId id = 0; id < triangles.size(); ++id)
      {
        if (rationallyHits(ray, RationalCrossing(ray, triangles[id])))
        {
          wanted.push_back(id);
        }
      }
      std::vector<PrimitiveId> found;
      for (const Hit& hit : allOf(*accelerator, ray, Precision::Exact))
      {
        found.push_back(hit.primitive);
      }
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, wanted);
    }
  }
}

TEST(FilterBound, FarAwayTheEdgeFormStillDecides)
{
  // From a hundred thousand radii away nearly no ray at a triangle's inside needs exact arithmetic.
  NearDegenerate random(5);
  int undecided = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const Vec3 a = random.point(1.0);
    const std::array<Vec3, 3> triangle = { a, a + random.point(0.01), a + random.point(0.01) };
    const Vec3 origin = { 6e4, -7e4, 5e4 };
    const Vec3 centre = (1 / 3.0) * (triangle[0] + triangle[1] + triangle[2]);
    const EdgeValues e = edgeValues(FilterRay({ origin, centre - origin }), triangle);
    undecided += surelyHit(e) || surelyMissed(e) ? 0 : 1;
  }
  EXPECT_LE(undecided, 2);
}

} // namespace
