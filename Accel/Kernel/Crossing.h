// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_Crossing_h
#define Lumitree_Accel_Kernel_Crossing_h

#include "Accel/Kernel/EdgeFilter.h"

#include <array>

namespace lumitree
{

/// Where a ray crosses a triangle, with a certified interval of t.
struct Crossing
{
  double t = 0.0;
  double tLow = 0.0; ///< tLow <= exact t <= tHigh, given that the triangle is hit
  double tHigh = 0.0;
  double u = 0.0;   ///< weight of vertex 1
  double v = 0.0;   ///< weight of vertex 2
  EdgeValues edges; ///< and a bound of their error: the triangle's own, or its block's
};

/// The largest of the components' magnitudes.
inline double magnitude(const Vec3& a)
{
  return std::max(std::max(std::fabs(a[0]), std::fabs(a[1])), std::fabs(a[2]));
}

/// The axis of the largest component's magnitude, the first of equals.
inline int dominantAxis(const Vec3& a)
{
  const int axis = std::fabs(a[0]) >= std::fabs(a[1]) ? 0 : 1;
  return std::fabs(a[axis]) >= std::fabs(a[2]) ? axis : 2;
}

/// Three vertices' coordinates along a ray's axis: all of a triangle that t depends on beside its
/// edge functions.
using Along = std::array<double, 3>;

inline Along along(const FilterRay& ray, const std::array<Vec3, 3>& vertices)
{
  return { vertices[0][ray.axis], vertices[1][ray.axis], vertices[2][ray.axis] };
}

/// The edge functions of one triangle, by the arithmetic of the block filter: the same bits.
inline EdgeValues edgeValues(const FilterRay& ray, const std::array<Vec3, 3>& vertices)
{
  const Vec3 a = vertices[0] - ray.origin;
  const Vec3 b = vertices[1] - ray.origin;
  const Vec3 bc = vertices[2] - vertices[1];
  const Vec3 ca = vertices[0] - vertices[2];
  const Vec3 ab = vertices[1] - vertices[0];
  const Vec3& d = ray.direction;
  EdgeValues e;
  e.u = edgeFunction(d[0], d[1], d[2], bc[0], bc[1], bc[2], b[0], b[1], b[2]);
  e.v = edgeFunction(d[0], d[1], d[2], ca[0], ca[1], ca[2], a[0], a[1], a[2]);
  e.w = edgeFunction(d[0], d[1], d[2], ab[0], ab[1], ab[2], a[0], a[1], a[2]);
  const double edge = std::max(std::max(magnitude(bc), magnitude(ca)), magnitude(ab));
  const double m = std::max(magnitude(a), magnitude(b));
  e.error = 2.0 * edge * m * ray.oneNorm * (FilterRay::edgeBound / 2) + ray.boundFloor;
  return e;
}

/// t and (u, v) of a ray known, or taken, to hit the triangle: a pure function of the two, so that
/// every path through every structure gives the same bits; only the interval of t also depends on
/// how tight the bound in e is. e: the triangle's edge functions.
///
/// t is the mean of the vertices' t along the direction's dominant axis, weighted by the edge
/// functions. It therefore always lies within the triangle's own range of t, however grazing the
/// ray is. With weights w_i, each wrong by e at most, and S their sum, the mean is wrong by at most
/// 3 e R / (S - 3 e), R the range of the vertices' values; what differences, shares and sums round
/// is below 10 u max|a|, u = 2^-53, and the pad for it 16 u max|a|.
[[gnu::always_inline]] inline Crossing crossing(
  const FilterRay& ray, const Along& vertices, const EdgeValues& e)
{
  const int k = ray.axis;
  const std::array<double, 3> a = { vertices[0] - ray.origin[k], vertices[1] - ray.origin[k],
    vertices[2] - ray.origin[k] };

  // Weights of the majority's sign; what rounding put on the other side is 0 within its error.
  const double sign = e.u + e.v + e.w >= 0.0 ? 1.0 : -1.0;
  const std::array<double, 3> weights = { std::max(sign * e.u, 0.0), std::max(sign * e.v, 0.0),
    std::max(sign * e.w, 0.0) };
  const double sum = weights[0] + weights[1] + weights[2];

  const double low = std::min(std::min(a[0], a[1]), a[2]);
  const double high = std::max(std::max(a[0], a[1]), a[2]);
  const double rounding = 0x1p-49 * std::max(std::fabs(low), std::fabs(high)) + 0x1p-1020;
  double mean = 0.5 * low + 0.5 * high;
  double spread = high - low;
  Crossing x;
  x.edges = e;
  // Sums outside this range have no reciprocal, and weights within their error.
  if (sum >= 0x1p-1020 && sum <= std::numeric_limits<double>::max())
  {
    const double share = 1.0 / sum;
    x.u = weights[1] * share;
    x.v = weights[2] * share;
    mean = (weights[0] * share) * a[0] + (x.u * a[1] + x.v * a[2]);
    mean = std::min(std::max(mean, low), high);
    // A weight's error relative to the sum; 1 / (1 - 3 e) < 1 + 4 e below 1 / 12.
    const double relative = e.error * share;
    if (relative < 1.0 / 12)
    {
      spread = std::min(spread, 3.0 * relative * (1.0 + 4.0 * relative) * spread);
    }
  }
  else
  {
    x.u = 1.0 / 3.0;
    x.v = 1.0 / 3.0;
  }
  const double pad = spread + rounding;
  const double first = ray.parameter(std::max(mean - pad, low - rounding));
  const double second = ray.parameter(std::min(mean + pad, high + rounding));
  x.t = mean / ray.direction[k];
  // Where t overflows, the greatest number bounds it on the inner side.
  x.tLow = std::min({ first, second, std::numeric_limits<double>::max() });
  x.tHigh = std::max({ first, second, std::numeric_limits<double>::lowest() });
  x.tLow -= std::fabs(x.tLow) * 0x1p-51 + 0x1p-1020;
  x.tHigh += std::fabs(x.tHigh) * 0x1p-51 + 0x1p-1020;
  return x;
}

/// Whether the crossing, if there is one, is certainly between the ray's limits, or beyond one.
///@{
inline bool surelyBetween(const FilterRay& ray, const Crossing& x)
{
  return x.tLow >= ray.tMin && x.tHigh <= ray.tMax;
}
inline bool surelyBeyond(const FilterRay& ray, const Crossing& x)
{
  return x.tHigh < ray.tMin || x.tLow > ray.tMax;
}
///@}

/// Whether the whole triangle certainly lies between the ray's limits along its dominant axis: by
/// the bounds of `crossing`, where no weight narrows them.
inline bool surelyBetweenLimits(const FilterRay& ray, const Along& vertices)
{
  const double origin = ray.origin[ray.axis];
  const std::array<double, 3> a = { vertices[0] - origin, vertices[1] - origin,
    vertices[2] - origin };
  const double low = std::min(std::min(a[0], a[1]), a[2]);
  const double high = std::max(std::max(a[0], a[1]), a[2]);
  const double rounding = 0x1p-49 * std::max(std::fabs(low), std::fabs(high)) + 0x1p-1020;
  const double first = ray.parameter(low - rounding);
  const double second = ray.parameter(high + rounding);
  const double tLow = std::min(first, second);
  const double tHigh = std::max(first, second);
  return tLow - (std::fabs(tLow) * 0x1p-51 + 0x1p-1020) >= ray.tMin &&
    tHigh + (std::fabs(tHigh) * 0x1p-51 + 0x1p-1020) <= ray.tMax &&
    tHigh <= std::numeric_limits<double>::max();
}

/// Where the ray crosses the triangle, with the triangle's own bound.
inline Crossing crossing(const FilterRay& ray, const std::array<Vec3, 3>& vertices)
{
  return crossing(ray, along(ray, vertices), edgeValues(ray, vertices));
}

} // namespace lumitree

#endif
