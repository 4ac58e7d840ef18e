// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_Accel_QuadricOracle_h
#define Lumitree_Testing_Accel_QuadricOracle_h

#include "RationalOracle.h"

#include "Accel/Surface.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <vector>

/// The definition of a quadric's hits, once more and without haste: polynomials by interpolation in
/// rational numbers, the number of roots by a rational discriminant, roots to 2200 bits. What
/// differs by less than 2^-1100 is taken for equal, far below what different roots of the tests'
/// forms can be apart. It shares no code with Accel/Exact.
namespace lumitree::testing
{

using Long = boost::multiprecision::number<
  boost::multiprecision::cpp_bin_float<2200, boost::multiprecision::digit_base_2>>;

inline Long asLong(const Rational& x)
{
  return Long(numerator(x)) / Long(denominator(x));
}

inline Rational rationalValue(const QuadricForm& form, const RationalVector& x)
{
  const RationalVector y = difference(x, rational(form.centre));
  std::array<Rational, 10> a;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    a[i] = rational(form.coefficients[i]);
  }
  return a[0] * y[0] * y[0] + a[1] * y[1] * y[1] + a[2] * y[2] * y[2] + a[3] * y[0] * y[1] +
    a[4] * y[1] * y[2] + a[5] * y[0] * y[2] + a[6] * y[0] + a[7] * y[1] + a[8] * y[2] + a[9] +
    rational(form.residue);
}

/// a t² + b t + c of a form along a ray.
struct RationalQuadratic
{
  Rational a;
  Rational b;
  Rational c;

  RationalQuadratic(const Ray& ray, const QuadricForm& form)
  {
    const RationalVector o = rational(ray.origin);
    const RationalVector d = rational(ray.direction);
    const RationalVector after = { o[0] + d[0], o[1] + d[1], o[2] + d[2] };
    const Rational here = rationalValue(form, o);
    const Rational ahead = rationalValue(form, after);
    const Rational behind = rationalValue(form, difference(o, d));
    this->c = here;
    this->a = (ahead + behind) / 2 - here;
    this->b = (ahead - behind) / 2;
  }

  [[nodiscard]] Long at(const Long& t) const
  {
    return (asLong(this->a) * t + asLong(this->b)) * t + asLong(this->c);
  }

  [[nodiscard]] std::vector<Long> roots() const
  {
    if (this->a == 0)
    {
      return this->b == 0 ? std::vector<Long>{} : std::vector<Long>{ asLong(-this->c / this->b) };
    }
    const Rational d = this->b * this->b - 4 * this->a * this->c;
    if (d < 0)
    {
      return {};
    }
    const Long middle = asLong(-this->b / (2 * this->a));
    if (d == 0)
    {
      return { middle };
    }
    const Long half = abs(sqrt(asLong(d)) / asLong(2 * this->a));
    return { middle - half, middle + half };
  }
};

struct OracleHit
{
  Long t;
  PrimitiveId primitive;
};

/// x <= 0, for what the tests' numbers can make.
inline bool notAbove(const Long& x, const Long& scale)
{
  return x <= ldexp(scale, -1100);
}

/// The sign of a tree's value at a root.
inline int treeSign(const Ray& ray, const ImplicitTree& tree, const Long& t)
{
  using Operation = ImplicitTree::Operation;
  std::vector<int> stack;
  for (const ImplicitTree::Step& step : tree.steps)
  {
    if (step.operation == Operation::Form)
    {
      const auto& form = tree.forms[static_cast<std::size_t>(step.index)];
      const Long value = RationalQuadratic(ray, form).at(t);
      stack.push_back(notAbove(abs(value), 1) ? 0 : (value > 0 ? 1 : -1));
      continue;
    }
    const int last = stack.back();
    if (step.operation == Operation::Negation || step.operation == Operation::Magnitude)
    {
      stack.back() = step.operation == Operation::Negation ? -last : abs(last);
      continue;
    }
    stack.pop_back();
    stack.back() = step.operation == Operation::Minimum ? std::min(stack.back(), last)
                                                        : std::max(stack.back(), last);
  }
  return stack.back();
}

inline bool isInside(const Ray& ray, const Quadric& q, const Long& t)
{
  const auto coordinate = [&](const Vec3& from, int k)
  { return asLong(rational(ray.origin[k]) - rational(from[k])) + t * Long(ray.direction[k]); };
  const Long one = 1;
  bool in = true;
  for (int k = 0; k < 3; ++k)
  {
    in = in && notAbove(-coordinate(q.clip.lower, k), one) &&
      notAbove(coordinate(q.clip.upper, k), one);
  }
  for (const QuadricCut& cut : q.cuts)
  {
    Long distance = 0;
    for (int k = 0; k < 3; ++k)
    {
      distance += Long(cut.normal[k]) * coordinate(cut.point, k);
    }
    in = in && notAbove(distance, one);
  }
  in = in && notAbove(RationalQuadratic(ray, q.bound).at(t), one);
  return in && (!q.tree || treeSign(ray, *q.tree, t) == 0);
}

/// Every hit of a ray, by (t, primitive).
inline std::vector<OracleHit> oracleHits(const Surface& surface, const Ray& ray)
{
  std::vector<OracleHit> hits;
  for (const PrimitiveId id : surface.hittable())
  {
    std::vector<Long> roots;
    if (surface.isTriangle(id))
    {
      const RationalCrossing x(ray, surface.vertices(id));
      if (x.inside)
      {
        roots.push_back(asLong(x.t));
      }
    }
    else
    {
      for (const Long& t : RationalQuadratic(ray, surface.quadric(id).form).roots())
      {
        if (isInside(ray, surface.quadric(id), t))
        {
          roots.push_back(t);
        }
      }
    }
    for (const Long& t : roots)
    {
      if ((std::isinf(ray.tMin) || notAbove(Long(ray.tMin) - t, 1)) &&
        (std::isinf(ray.tMax) || notAbove(t - Long(ray.tMax), 1)))
      {
        hits.push_back({ t, id });
      }
    }
  }
  std::sort(hits.begin(), hits.end(),
    [](const OracleHit& a, const OracleHit& b)
    {
      const bool tie = notAbove(abs(a.t - b.t), 1 + abs(a.t));
      return tie ? a.primitive < b.primitive : a.t < b.t;
    });
  return hits;
}

} // namespace lumitree::testing

#endif
