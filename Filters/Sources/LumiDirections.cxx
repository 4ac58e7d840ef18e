// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiDirections.h"

#include <algorithm>
#include <cmath>

namespace
{

using namespace lumitree;

Vec3 fromHeight(double z, double radius, double turns)
{
  const std::array<double, 2> circle = lumitree::filters::unitCircle(turns);
  return { radius * circle[0], radius * circle[1], z };
}

Vec3 aroundNormal(const Vec3& n, const Vec3& local)
{
  const std::array<Vec3, 2> t = lumitree::filters::tangents(n);
  return local[0] * t[0] + local[1] * t[1] + local[2] * n;
}

}

namespace lumitree::filters
{

std::array<double, 2> unitCircle(double turns)
{
  // The nearest quarter turn is taken off without rounding; |x| <= pi / 4 is left.
  const double quarters = 4.0 * (turns - std::floor(turns));
  const double nearest = std::floor(quarters + 0.5);
  const double x = (quarters - nearest) * 1.5707963267948966;
  const double y = x * x;

  // Taylor's series: the first term left out is below 1e-16 for |x| <= pi / 4.
  static constexpr std::array<double, 8> sine = { 1.0, -1.0 / 6, 1.0 / 120, -1.0 / 5040,
    1.0 / 362880, -1.0 / 39916800, 1.0 / 6227020800.0, -1.0 / 1307674368000.0 };
  static constexpr std::array<double, 9> cosine = { 1.0, -1.0 / 2, 1.0 / 24, -1.0 / 720,
    1.0 / 40320, -1.0 / 3628800, 1.0 / 479001600, -1.0 / 87178291200.0, 1.0 / 20922789888000.0 };
  double s = 0.0;
  std::for_each(sine.rbegin(), sine.rend(), [&](double term) { s = s * y + term; });
  s *= x;
  double c = 0.0;
  std::for_each(cosine.rbegin(), cosine.rend(), [&](double term) { c = c * y + term; });

  switch (static_cast<int>(nearest))
  {
    case 1:
      return { -s, c };
    case 2:
      return { -c, -s };
    case 3:
      return { s, -c };
    default:
      return { c, s };
  }
}

Vec3 sphereDirection(double u, double v)
{
  return fromHeight(1.0 - 2.0 * u, 2.0 * std::sqrt(u * (1.0 - u)), v);
}

Vec3 spiralDirection(std::uint64_t i, std::uint64_t count)
{
  // The golden ratio's fraction times 2^64: whole numbers keep the fraction of a turn for any i.
  const std::uint64_t turn = i * 0x9e3779b97f4a7c15ull;
  const double u = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
  return sphereDirection(u, static_cast<double>(turn >> 11) * 0x1p-53);
}

std::array<Vec3, 2> tangents(const Vec3& n)
{
  const double sign = std::copysign(1.0, n[2]);
  const double a = -1.0 / (sign + n[2]);
  const double b = n[0] * n[1] * a;
  return { Vec3{ 1.0 + sign * n[0] * n[0] * a, sign * b, -sign * n[0] },
    Vec3{ b, sign + n[1] * n[1] * a, -n[1] } };
}

Vec3 cosineDirection(const Vec3& n, double u, double v)
{
  return aroundNormal(n, fromHeight(std::sqrt(1.0 - u), std::sqrt(u), v));
}

Vec3 uniformDirection(const Vec3& n, double u, double v)
{
  return aroundNormal(n, fromHeight(u, std::sqrt((1.0 - u) * (1.0 + u)), v));
}

Vec3 unit(const Vec3& v)
{
  // Scaled first: squares of very large or very small components would overflow or vanish.
  const double largest = std::max({ std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2]) });
  if (!isFinite(v) || largest < 1e-300)
  {
    return { 0.0, 0.0, 0.0 };
  }
  const Vec3 scaled = { v[0] / largest, v[1] / largest, v[2] / largest };
  return (1.0 / length(scaled)) * scaled;
}

}
