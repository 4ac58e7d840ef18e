// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_EdgeFilter_h
#define Lumitree_Accel_Kernel_EdgeFilter_h

#include "Accel/Kernel/TriangleBlock.h"

#include <algorithm>

namespace lumitree
{

/// A ray, and what the filter needs to know of it.
struct FilterRay : Ray
{
  FilterRay() = default;
  explicit FilterRay(const Ray& ray)
    : Ray(ray)
  {
    this->prepare();
  }

  /// To be called when the ray has changed.
  void prepare()
  {
    const double x = std::fabs(this->direction[0]);
    const double y = std::fabs(this->direction[1]);
    const double z = std::fabs(this->direction[2]);
    this->axis = x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2);
    this->perAxis = 1.0 / this->direction[this->axis];
    this->oneNorm = x + y + z;
    this->boundFloor = 0x1p-1020 * (1.0 + this->oneNorm);
  }

  /// The t at which the ray has gone so far along its axis.
  [[nodiscard]] double parameter(double along) const
  {
    // A subnormal direction has no reciprocal.
    return std::isfinite(this->perAxis) ? along * this->perAxis
                                        : along / this->direction[this->axis];
  }

  /// With A, B, C the vertices less the origin, the edge function of the edge PQ is
  /// d · ((Q - P) x P'), P' = P - origin; Q' in place of P' is the same, and A and B
  /// are enough for all three. Its rounding error: both differences 1 u, each product of
  /// the cross product 3 u, their difference 4 u, times d 5 u, summing three terms 7 u at most, all
  /// relative to the sum of the magnitudes of the six products, which is at most 2 |d|_1 E M (E:
  /// largest component of an edge, M: of A and B). So |error| <= 14 u (1 + 8 u) |d|_1 E M. The
  /// bound itself is rounded four times, hence 16 u, u = 2^-53. What products lose by underflow is
  /// below boundFloor. 2 E M and 2 |d|_1 E M bound every intermediate value: where one could
  /// overflow, so does the bound, and then nothing is certain.
  static constexpr double edgeBound = 16 * 0x1p-53;

  int axis = 2;         ///< of the direction's largest component, the first of equals
  double perAxis = 1.0; ///< 1 / direction[axis]; infinite where that overflows
  double oneNorm = 1.0; ///< of the direction
  double boundFloor = 0.0;
};

/// The edge functions of one triangle, the weights of its vertices, and the bound of their error:
/// the point of the ray in the triangle's plane is (u v0 + v v1 + w v2) / (u + v + w).
struct EdgeValues
{
  double u = 0.0;
  double v = 0.0;
  double w = 0.0;
  double error = 0.0;
};

/// d · (e x p)
inline double edgeFunction(
  double dx, double dy, double dz, double ex, double ey, double ez, double px, double py, double pz)
{
  return (dx * (ey * pz - ez * py) + dy * (ez * px - ex * pz)) + dz * (ex * py - ey * px);
}

/// Certainly no hit: one edge function is certainly negative and another certainly positive.
inline bool surelyMissed(const EdgeValues& e)
{
  const bool negative = e.u < -e.error || e.v < -e.error || e.w < -e.error;
  const bool positive = e.u > e.error || e.v > e.error || e.w > e.error;
  return negative && positive;
}

/// Certainly a hit of the triangle's interior by the ray's line.
inline bool surelyHit(const EdgeValues& e)
{
  const bool negative = e.u < -e.error && e.v < -e.error && e.w < -e.error;
  const bool positive = e.u > e.error && e.v > e.error && e.w > e.error;
  return negative || positive;
}

/// What plain floating point says: all edge functions of one sign, their sum not 0.
inline bool apparentlyHit(const EdgeValues& e)
{
  const bool positive = e.u >= 0.0 && e.v >= 0.0 && e.w >= 0.0;
  const bool negative = e.u <= 0.0 && e.v <= 0.0 && e.w <= 0.0;
  return (positive || negative) && e.u + e.v + e.w != 0.0;
}

} // namespace lumitree

#endif
