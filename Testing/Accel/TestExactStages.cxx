// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Every stage of the exact predicates against rational arithmetic, on numbers of even and uneven
// magnitude, and t rounded correctly. Other numbers each time: --gtest_shuffle --gtest_repeat=1000.
#include "Accel/Exact/Limits.h"
#include "Accel/Exact/Predicates.h"
#include "Accel/Exact/Stages.h"
#include "NearDegenerate.h"
#include "RationalOracle.h"

#include <gtest/gtest.h>

#include <random>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

using Corners = std::array<Vec3, 3>;

unsigned seed()
{
  return 17u + static_cast<unsigned>(::testing::UnitTest::GetInstance()->random_seed());
}

/// How the numbers of a NearDegenerate pair are made harder or easier to hold.
enum class Shape
{
  AsMade,
  Full,     // 53 bits, of any exponent
  Floats,   // 24 bits, of any exponent
  Snapped,  // multiples of 2^-10 of the scale: vertices and edges are met exactly
  Uneven,   // some coordinates down to 2^-60 of the others
  Subnormal // some coordinates subnormal
};
constexpr std::array<Shape, 6> shapes = { Shape::AsMade, Shape::Full, Shape::Floats, Shape::Snapped,
  Shape::Uneven, Shape::Subnormal };

class Shaper
{
public:
  explicit Shaper(Shape shape, double scale)
    : shape_(shape)
    , scale_(scale)
    , random_(seed())
  {
  }

  Corners operator()(const Corners& t) { return { (*this)(t[0]), (*this)(t[1]), (*this)(t[2]) }; }

  Vec3 operator()(const Vec3& p)
  {
    Vec3 q = p;
    for (double& x : q)
    {
      x = this->shaped(x);
    }
    return q;
  }

private:
  double shaped(double x)
  {
    const auto draw = this->random_();
    int e = 0;
    switch (this->shape_)
    {
      case Shape::Full:
        return x * (1.0 - 0x1p-33 * static_cast<double>(draw));
      case Shape::Floats:
      {
        const double m = std::frexp(x, &e);
        return std::ldexp(static_cast<double>(static_cast<float>(m)), e);
      }
      case Shape::Snapped:
        return std::nearbyint(x / this->scale_ * 0x1p10) * (this->scale_ * 0x1p-10);
      case Shape::Uneven:
        return draw % 4 == 0 ? std::ldexp(x, -static_cast<int>(draw / 4 % 60)) : x;
      case Shape::Subnormal:
        return draw % 4 == 0 ? std::ldexp(static_cast<double>(draw % 1000), -1074) : x;
      default:
        return x;
    }
  }

  Shape shape_;
  double scale_;
  std::mt19937 random_;
};

/// check(ray, triangle, second triangle) on pairs of every kind, shape and scale. Half of the rays
/// aim at a vertex or the middle of an edge; those of snapped triangles meet it exactly.
template <class Check>
void forQuestions(int each, const Check& check)
{
  for (const double scale : { 1.0, 0x1p20, 0x1p150, 0x1p-150, 0x1p-1000, 0x1p990 })
  {
    for (const Shape shape : shapes)
    {
      SCOPED_TRACE("shape " + std::to_string(static_cast<int>(shape)) + ", scale " +
        std::to_string(std::ilogb(scale)));
      NearDegenerate random(seed());
      Shaper shaped(shape, scale);
      for (int i = 0; i < each * NearDegenerate::kinds; ++i)
      {
        const Pair p = random(i % NearDegenerate::kinds, scale);
        const Corners t = shaped(p.triangle);
        Ray ray = { shaped(p.ray.origin), p.ray.direction };
        const Corners other = shaped(random(0, scale).triangle);
        if (shape != Shape::AsMade && i % 2 == 0)
        {
          ray.direction = i % 4 == 0 ? t[0] - ray.origin : 0.5 * (t[0] + t[1]) - ray.origin;
        }
        else if (shape != Shape::AsMade)
        {
          ray.direction = shaped(ray.direction);
        }
        if (isValid(ray))
        {
          check(ray, t, i % 3 == 0 ? other : Corners{ t[1], t[0], other[2] });
        }
        if (::testing::Test::HasFatalFailure())
        {
          return;
        }
      }
    }
  }
}

#if defined(LUMITREE_HAS_FIXED_INTEGERS)

using exact::FixedInteger;
using exact::Int128;
using Integer = boost::multiprecision::cpp_int;

/// Limbs that carry and borrow often.
template <std::size_t N>
FixedInteger<N> randomInteger(std::mt19937_64& random)
{
  FixedInteger<N> x;
  for (std::size_t i = 0; i < N; ++i)
  {
    const std::uint64_t r = random();
    const std::uint64_t special[] = { 0, 1, ~0ull, 1ull << 63, ~0ull >> 1, r, r, r };
    x.set(i, special[random() % 8]);
  }
  return x;
}

template <std::size_t N>
Integer integer(const FixedInteger<N>& x)
{
  Integer sum = x.negative() ? -1 : 0;
  for (std::size_t i = N; i-- > 0;)
  {
    sum = sum * (Integer(1) << 64) + Integer(x.limb(i));
  }
  return sum;
}

/// x modulo 2^(64 N), in two's complement.
template <std::size_t N>
Integer wrapped(const Integer& x)
{
  const Integer period = Integer(1) << static_cast<unsigned>(64 * N);
  Integer r = x % period;
  r += r < 0 ? period : Integer(0);
  return r >= period / 2 ? Integer(r - period) : r;
}

template <std::size_t N, std::size_t M>
void checkArithmetic()
{
  std::mt19937_64 random(seed());
  for (int i = 0; i < 2000; ++i)
  {
    const auto a = randomInteger<N>(random);
    const auto b = randomInteger<N>(random);
    const auto c = randomInteger<M>(random);
    ASSERT_EQ(integer(a + b), wrapped<N>(integer(a) + integer(b)));
    ASSERT_EQ(integer(a - b), wrapped<N>(integer(a) - integer(b)));
    ASSERT_EQ(integer(a * c), integer(a) * integer(c));
    ASSERT_EQ(a.sign(), integer(a).sign());
    ASSERT_EQ((a - a).sign(), 0);
  }
}

TEST(ExactStages, FixedIntegersAreIntegers)
{
  checkArithmetic<1, 1>();
  checkArithmetic<2, 1>();
  checkArithmetic<2, 2>();
  checkArithmetic<3, 3>();
  checkArithmetic<4, 2>();
  checkArithmetic<6, 1>();
  checkArithmetic<6, 6>();
}

template <class I>
void checkLattice()
{
  std::mt19937_64 random(seed());
  int placed = 0;
  int refused = 0;
  for (int i = 0; i < 20000; ++i)
  {
    Vec3 v;
    const int middle = static_cast<int>(random() % 2000) - 1030;
    for (double& x : v)
    {
      const auto mantissa =
        static_cast<double>(static_cast<std::int64_t>(random()) >> (random() % 64));
      x = std::ldexp(mantissa, std::min(middle + static_cast<int>(random() % 100), 960));
    }
    const exact::Lattice<I> lattice(exact::largest(v));
    typename exact::Lattice<I>::Point p;
    const bool exact = lattice.place(v, p);
    (exact ? placed : refused) += 1;
    bool all = true;
    for (int k = 0; k < 3; ++k)
    {
      const Rational scaled = lattice.exponent() >= 0
        ? Rational(rational(v[k]) * Rational(Integer(1) << lattice.exponent()))
        : Rational(rational(v[k]) / Rational(Integer(1) << -lattice.exponent()));
      const bool whole = denominator(scaled) == 1;
      all = all && whole;
      ASSERT_LT(abs(scaled), Rational(Integer(1) << exact::Lattice<I>::bits));
      if (exact)
      {
        ASSERT_EQ(scaled, Rational(integer(typename exact::Lattice<I>::Number(p[k]))));
      }
    }
    ASSERT_EQ(exact, all);
  }
  EXPECT_GT(placed, 2000);
  EXPECT_GT(refused, 500);
}

TEST(ExactStages, LatticesHoldWhatIsOnThem)
{
  checkLattice<std::int64_t>();
  checkLattice<Int128>();
}

struct Truth
{
  RationalCrossing x;
  RationalCrossing y;
  double limit;
};

/// The answers of one stage against the truth; false where it does not take the question.
template <class I>
bool checkStage(const Ray& ray, const Corners& t, const Corners& other, const Truth& truth)
{
  exact::LatticeScene<I, 2> two;
  if (!exact::place<I>(exact::Question<2>{ ray, { &t, &other } }, two))
  {
    return false;
  }
  EXPECT_EQ(meets(two), truth.x.inside);
  if (!truth.x.parallel)
  {
    if (!truth.y.parallel)
    {
      EXPECT_EQ(compare(two), truth.x.t.compare(truth.y.t));
    }
    for (const double limit : { truth.limit, std::nextafter(truth.limit, 1e9), 0.0, 1.0, -0.75 })
    {
      const auto order = compareToLimit(two, limit);
      EXPECT_TRUE(!order || *order == truth.x.t.compare(rational(limit)));
    }
  }
  return !::testing::Test::HasFailure();
}

TEST(ExactStages, EachStageAnswersAsTheRationalsSay)
{
  int narrow = 0;
  int wide = 0;
  int neither = 0;
  int zero = 0;
  forQuestions(8,
    [&](const Ray& ray, const Corners& t, const Corners& other)
    {
      Truth truth = { { ray, t }, { ray, other }, 0.0 };
      truth.limit = truth.x.parallel ? 0.0 : exact::crossingParameter(ray, t);
      truth.limit = std::isinf(truth.limit) ? 3.0 : truth.limit;
      const bool first = checkStage<std::int64_t>(ray, t, other, truth);
      const bool second = checkStage<Int128>(ray, t, other, truth);
      ASSERT_TRUE(second || !first) << "the wide lattice holds what the narrow one does";
      (first ? narrow : second ? wide : neither) += 1;
      const auto stored = exact::asStored(exact::Question<2>{ ray, { &t, &other } });
      ASSERT_EQ(meets(stored), truth.x.inside);
      ASSERT_EQ(exact::lineMeetsTriangle(ray, t), truth.x.inside);
      if (!truth.x.parallel && !truth.y.parallel)
      {
        ASSERT_EQ(compare(stored), truth.x.t.compare(truth.y.t));
        ASSERT_EQ(exact::compareCrossings(ray, t, other), truth.x.t.compare(truth.y.t));
        ASSERT_EQ(
          exact::compareCrossing(ray, t, truth.limit), truth.x.t.compare(rational(truth.limit)));
      }
      zero += truth.x.inside && (truth.x.weights[0] == 0 || truth.x.weights[2] == 0) ? 1 : 0;
    });
  EXPECT_GT(narrow, 700);
  EXPECT_GT(wide, 300);
  EXPECT_GT(neither, 300);
  EXPECT_GT(zero, 100);
}

#endif

/// Whether x is the double nearest to exact, of two the even one; infinite from the middle beyond
/// the largest on.
bool isNearest(double x, const Rational& exact)
{
  const Rational beyond = rational(std::numeric_limits<double>::max()) * 2 -
    rational(std::nextafter(std::numeric_limits<double>::max(), 0.0));
  const auto value = [&](double y)
  { return std::isinf(y) ? Rational(y > 0 ? beyond : -beyond) : rational(y); };
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof(bits));
  const bool even = bits % 2 == 0;
  const Rational low = (value(x) + value(std::nextafter(x, -HUGE_VAL))) / 2;
  const Rational high = (value(x) + value(std::nextafter(x, HUGE_VAL))) / 2;
  const bool above = low < exact || (even && low == exact) || x == -HUGE_VAL;
  const bool below = exact < high || (even && high == exact) || x == HUGE_VAL;
  return above && below;
}

TEST(ExactStages, TIsTheNearestDouble)
{
  int checked = 0;
  forQuestions(4,
    [&](const Ray& ray, const Corners& t, const Corners&)
    {
      const RationalCrossing x(ray, t);
      if (!x.parallel)
      {
        const double rounded = exact::crossingParameter(ray, t);
        ASSERT_TRUE(isNearest(rounded, x.t)) << rounded;
        ++checked;
      }
    });
  EXPECT_GT(checked, 500);
}

/// t of a ray along z from -before with direction d, to the plane z = at.
double alongZ(double at, double before, double d)
{
  const Corners plane = { Vec3{ 0, 0, at }, Vec3{ 1, 0, at }, Vec3{ 0, 1, at } };
  return exact::crossingParameter({ { 0, 0, -before }, { 0, 0, d } }, plane);
}

TEST(ExactStages, MiddlesGoToTheEvenDouble)
{
  const double u = 0x1p-53;
  EXPECT_EQ(alongZ(1, u, 1), 1.0);
  EXPECT_EQ(alongZ(1, std::nextafter(u, 1.0), 1), 1.0 + 2 * u);
  EXPECT_EQ(alongZ(1, std::nextafter(u, 0.0), 1), 1.0);
  EXPECT_EQ(alongZ(1, u, -1), -1.0);
  EXPECT_EQ(alongZ(1, 3 * u, 1), 1.0 + 4 * u);
  EXPECT_EQ(alongZ(1 + 2 * u, u, 1), 1.0 + 4 * u);
}

TEST(ExactStages, TOfAnyMagnitudeIsRounded)
{
  // Subnormal t: rounded once, at the last place that there is.
  EXPECT_EQ(alongZ(0x1p-600, 0, 0x1p474), 0x1p-1074);
  EXPECT_EQ(alongZ(0x1p-600, 0, 0x1p475), 0.0);
  EXPECT_EQ(alongZ(std::nextafter(0x1p-600, 1.0), 0, 0x1p475), 0x1p-1074);
  EXPECT_EQ(alongZ(3 * 0x1p-600, 0, 0x1p475), 0x1p-1073);
  EXPECT_EQ(alongZ(0x1p-600, 0, 0x1p900), 0.0);
  EXPECT_EQ(alongZ(0, 0, 5), 0.0);
  // The largest t, the middle beyond it, and far beyond.
  const double most = std::numeric_limits<double>::max();
  EXPECT_EQ(alongZ(most * 0x1p-40, 0, 0x1p-40), most);
  EXPECT_EQ(alongZ(most * 0x1p-40, 0x1p930 * 0.99, 0x1p-40), most);
  EXPECT_EQ(alongZ(most * 0x1p-40, 0x1p929, 0x1p-40), most);
  EXPECT_EQ(alongZ(most * 0x1p-40, 0x1p930, 0x1p-40), HUGE_VAL);
  EXPECT_EQ(alongZ(0x1p900, 0, -0x1p-900), -HUGE_VAL);
}

} // namespace
