// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Integers without bounds against rational arithmetic: single operations, then the predicates, on
// random and nearly degenerate numbers of all magnitudes.
#include "Accel/Exact/Dyadic.h"
#include "Accel/Exact/Predicates.h"
#include "NearDegenerate.h"
#include "RationalOracle.h"

#include <gtest/gtest.h>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

int signOf(const Rational& x)
{
  return x.sign();
}

/// (a - b)(c - d) - (e - f) g, which cancels where the arguments say so.
template <class Number>
Number form(const std::array<double, 7>& x)
{
  return Number::difference(x[0], x[1]) * Number::difference(x[2], x[3]) -
    Number::difference(x[4], x[5]) * Number(x[6]);
}

Rational rationalForm(const std::array<double, 7>& x)
{
  return (rational(x[0]) - rational(x[1])) * (rational(x[2]) - rational(x[3])) -
    (rational(x[4]) - rational(x[5])) * rational(x[6]);
}

std::vector<std::array<double, 7>> forms(double scale)
{
  NearDegenerate random(3);
  std::vector<std::array<double, 7>> all;
  for (int i = 0; i < 300; ++i)
  {
    const Vec3 p = random.point(scale);
    const Vec3 q = random.point(scale);
    const double r = random.point(scale)[0];
    all.push_back({ p[0], p[1], p[2], q[0], q[1], q[2], r });
    // The two products are the same, or nearly so.
    all.push_back({ p[0], p[1], p[2], 0.0, p[0], p[1], p[2] });
    all.push_back({ p[0], p[1], p[2], 0.0, p[0], p[1], std::nextafter(p[2], HUGE_VAL) });
    all.push_back(
      { p[0], std::nextafter(p[0], 0.0), q[0], std::nextafter(q[0], 0.0), p[1], p[1], r });
    all.push_back({ p[0], 0x1p-100 * p[1], q[0], 0x1p-100 * q[1], p[0], 0.0, q[0] });
  }
  return all;
}

TEST(ExactNumbers, DyadicsAreExactEverywhere)
{
  for (const double scale : { 1.0, 0x1p-500, 0x1p-1040, 0x1p500, 0x1p900 })
  {
    for (const auto& x : forms(scale))
    {
      const Rational exact = rationalForm(x);
      const auto value = form<exact::Dyadic>(x);
      ASSERT_EQ(value.sign(), signOf(exact));
      if (exact != 0)
      {
        const auto same = exact::Dyadic::quotient(value, value);
        ASSERT_EQ(same, 1.0);
      }
    }
  }
  EXPECT_EQ(exact::Dyadic(0.0).sign(), 0);
  EXPECT_EQ(exact::Dyadic(-0.0).sign(), 0);
  EXPECT_EQ(exact::Dyadic(-0x1p-1074).sign(), -1);
  EXPECT_EQ(exact::Dyadic::quotient(exact::Dyadic(1.0), exact::Dyadic(3.0)), 1.0 / 3.0);
  EXPECT_EQ(exact::Dyadic::quotient(exact::Dyadic(0x1p1000), exact::Dyadic(0x1p-1000)), HUGE_VAL);
  EXPECT_EQ(exact::Dyadic::quotient(exact::Dyadic(-0x1p-1000), exact::Dyadic(0x1p74)), -0x1p-1074);
}

/// Scales of coordinates, from nearly subnormal ones to huge ones.
const std::vector<double> scales = { 1.0, 1e6, 0x1p-60, 0x1p-88, 0x1p-119, 0x1p148, 0x1p151,
  0x1p-150, 0x1p-900, 0x1p900 };

template <class Check>
void forPairs(int each, const Check& check)
{
  for (const double scale : scales)
  {
    NearDegenerate random(11);
    for (int kind = 0; kind < NearDegenerate::kinds; ++kind)
    {
      SCOPED_TRACE("kind " + std::to_string(kind) + ", scale " + std::to_string(std::ilogb(scale)));
      for (int i = 0; i < each; ++i)
      {
        const Pair pair = random(kind, scale);
        check(pair, random(kind, scale).triangle);
        if (::testing::Test::HasFatalFailure())
        {
          return;
        }
      }
    }
  }
}

TEST(ExactPredicates, LineMeetsTriangleAsTheRationalsSay)
{
  int hits = 0;
  forPairs(60,
    [&](const Pair& p, const std::array<Vec3, 3>&)
    {
      const RationalCrossing x(p.ray, p.triangle);
      ASSERT_EQ(exact::lineMeetsTriangle(p.ray, p.triangle), x.inside);
      hits += x.inside ? 1 : 0;
      // Neither the winding nor the direction matters.
      const std::array<Vec3, 3> turned = { p.triangle[2], p.triangle[1], p.triangle[0] };
      ASSERT_EQ(exact::lineMeetsTriangle(p.ray, turned), x.inside);
      const Ray back = { p.ray.origin, -1.0 * p.ray.direction };
      ASSERT_EQ(exact::lineMeetsTriangle(back, p.triangle), x.inside);
    });
  EXPECT_GT(hits, 300);
}

TEST(ExactPredicates, CrossingsCompareAsTheRationalsSay)
{
  int ties = 0;
  forPairs(30,
    [&](const Pair& p, const std::array<Vec3, 3>& other)
    {
      const RationalCrossing x(p.ray, p.triangle);
      // Another triangle, one through the same point of the plane, and the same plane.
      const auto& [a, b, c] = p.triangle;
      for (const std::array<Vec3, 3>& second : { other, std::array<Vec3, 3>{ a, b, other[2] },
             std::array<Vec3, 3>{ a, other[1], other[2] }, std::array<Vec3, 3>{ b, c, a } })
      {
        const RationalCrossing y(p.ray, second);
        if (!x.parallel && !y.parallel)
        {
          ASSERT_EQ(exact::compareCrossings(p.ray, p.triangle, second), x.t.compare(y.t));
          ASSERT_EQ(exact::compareCrossings(p.ray, second, p.triangle), y.t.compare(x.t));
          ties += x.t == y.t ? 1 : 0;
        }
      }
    });
  EXPECT_GT(ties, 500);
}

TEST(ExactPredicates, CrossingsCompareWithLimitsAsTheRationalsSay)
{
  forPairs(30,
    [&](const Pair& p, const std::array<Vec3, 3>&)
    {
      const RationalCrossing x(p.ray, p.triangle);
      if (x.parallel)
      {
        return;
      }
      const double near = exact::crossingParameter(p.ray, p.triangle);
      for (const double limit : { near, std::nextafter(near, HUGE_VAL),
             std::nextafter(near, -HUGE_VAL), 0.0, 1.0, -0x1p-1070 })
      {
        if (std::isfinite(limit))
        {
          ASSERT_EQ(exact::compareCrossing(p.ray, p.triangle, limit), x.t.compare(rational(limit)));
        }
      }
      ASSERT_EQ(exact::compareCrossing(p.ray, p.triangle, HUGE_VAL), -1);
      ASSERT_EQ(exact::compareCrossing(p.ray, p.triangle, -HUGE_VAL), 1);
    });
}

TEST(ExactPredicates, CrossingParameterIsWithinHalfAnUlp)
{
  double worst = 0.0;
  forPairs(60,
    [&](const Pair& p, const std::array<Vec3, 3>&)
    {
      const RationalCrossing x(p.ray, p.triangle);
      const double t = x.parallel ? 0.0 : exact::crossingParameter(p.ray, p.triangle);
      if (!x.parallel && x.t != 0 && std::isnormal(t))
      {
        worst = std::max(worst, errorInUlps(t, x.t));
      }
      else if (!x.parallel && x.t == 0)
      {
        ASSERT_EQ(t, 0.0);
      }
    });
  EXPECT_LE(worst, 0.5);
  RecordProperty("WorstUlps", std::to_string(worst));
}

TEST(ExactPredicates, ZeroAreaAsTheRationalsSay)
{
  int zero = 0;
  forPairs(60,
    [&](const Pair& p, const std::array<Vec3, 3>&)
    {
      const auto& [a, b, c] = p.triangle;
      Vec3 nudged = b;
      nudged[1] = std::nextafter(nudged[1], HUGE_VAL);
      for (const std::array<Vec3, 3>& t : { p.triangle, std::array<Vec3, 3>{ a, a, b },
             std::array<Vec3, 3>{ a, b, a + 2.0 * (b - a) },
             std::array<Vec3, 3>{ 0.5 * a, a, 2.0 * a }, std::array<Vec3, 3>{ b, nudged, c },
             std::array<Vec3, 3>{ 0.5 * b, 2.0 * b, nudged } })
      {
        const RationalVector e = difference(rational(t[1]), rational(t[0]));
        const RationalVector f = difference(rational(t[2]), rational(t[0]));
        const bool flat =
          e[0] * f[1] == e[1] * f[0] && e[1] * f[2] == e[2] * f[1] && e[2] * f[0] == e[0] * f[2];
        ASSERT_EQ(exact::isZeroArea(t), flat);
        zero += flat ? 1 : 0;
      }
    });
  EXPECT_GT(zero, 5000);
}

} // namespace
