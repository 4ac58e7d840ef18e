// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_Accel_RationalOracle_h
#define Lumitree_Testing_Accel_RationalOracle_h

#include "Accel/Ray.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

/// The definition of a hit in rational numbers, written down once more and without haste: it shares
/// no code with Accel/Exact.
namespace lumitree::testing
{

using Rational = boost::multiprecision::cpp_rational;
using RationalVector = std::array<Rational, 3>;

inline Rational rational(double x)
{
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
  exponent -= 53;
  boost::multiprecision::cpp_int power = 1;
  power <<= std::abs(exponent);
  return exponent >= 0 ? Rational(mantissa * power) : Rational(mantissa, power);
}

inline RationalVector rational(const Vec3& a)
{
  return { rational(a[0]), rational(a[1]), rational(a[2]) };
}

inline RationalVector difference(const RationalVector& a, const RationalVector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline Rational determinant(
  const RationalVector& a, const RationalVector& b, const RationalVector& c)
{
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
    a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Where the line of a ray crosses the plane of a triangle.
struct RationalCrossing
{
  std::array<Rational, 3> weights; ///< of the vertices, times the determinant of (direction, edges)
  Rational t;
  bool parallel = false;
  bool inside = false; ///< in the closed triangle, and not parallel

  RationalCrossing(const Ray& ray, const std::array<Vec3, 3>& triangle)
    : RationalCrossing(ray, triangle, RationalVector{})
  {
  }

  /// The same with the origin moved.
  RationalCrossing(const Ray& ray, const std::array<Vec3, 3>& triangle, const RationalVector& move)
  {
    const RationalVector d = rational(ray.direction);
    RationalVector o = rational(ray.origin);
    for (int k = 0; k < 3; ++k)
    {
      o[k] += move[k];
    }
    const RationalVector a = difference(rational(triangle[0]), o);
    const RationalVector b = difference(rational(triangle[1]), o);
    const RationalVector c = difference(rational(triangle[2]), o);
    this->weights = { determinant(d, c, b), determinant(d, a, c), determinant(d, b, a) };
    const Rational sum = this->weights[0] + this->weights[1] + this->weights[2];
    this->parallel = sum == 0;
    if (!this->parallel)
    {
      // a + x (b - a) + y (c - a) = t d, by Cramer's rule.
      const RationalVector ab = difference(b, a);
      const RationalVector ac = difference(c, a);
      this->t = determinant(a, ab, ac) / determinant(d, ab, ac);
      this->inside = true;
      for (const Rational& w : this->weights)
      {
        this->inside = this->inside && w * sum >= 0;
      }
    }
  }
};

/// Whether the closed segment of the ray meets the closed triangle, not being parallel to its
/// plane.
inline bool rationallyHits(const Ray& ray, const RationalCrossing& x)
{
  return x.inside && (std::isinf(ray.tMin) || x.t >= rational(ray.tMin)) &&
    (std::isinf(ray.tMax) || x.t <= rational(ray.tMax));
}

/// |x - exact| in units of the last place of x.
inline double errorInUlps(double x, const Rational& exact)
{
  const double ulp = std::nextafter(std::fabs(x), HUGE_VAL) - std::fabs(x);
  return static_cast<double>(abs(rational(x) - exact) / rational(ulp));
}

} // namespace lumitree::testing

#endif
