// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_EdgeFilter_h
#define Lumitree_Accel_Kernel_EdgeFilter_h

#include "Accel/Kernel/TriangleBlock.h"

#include <algorithm>

namespace lumitree
{

/// What the filter needs of a ray, computed once.
struct FilterRay
{
  explicit FilterRay(const Ray& ray)
    : origin(ray.origin)
    , direction(ray.direction)
    , oneNorm(
        std::fabs(ray.direction[0]) + std::fabs(ray.direction[1]) + std::fabs(ray.direction[2]))
    , boundFloor(0x1p-1020 * (1.0 + oneNorm))
  {
  }

  /// With A, B, C the vertices less the origin, the edge function of the edge PQ is
  /// d · ((Q - P) x P'), P' = P - origin. Its rounding error: both differences 1 u, each product of the cross
  /// product 3 u, their difference 4 u, times d 5 u, summing three terms 7 u at most, all relative to the sum of the
  /// magnitudes of the twelve products, which is at most 2 |d|_1 E M (E: largest component of an edge, M: of A, B, C).
  /// So |error| <= 14 u (1 + 8 u) |d|_1 E M. The bound itself is rounded four times, hence 16 u, u = 2^-53. What products
  /// lose by underflow is below boundFloor. 2 E M and 2 |d|_1 E M bound every intermediate value: where one could overflow,
  /// so does the bound, and then nothing is certain.
  static constexpr double edgeBound = 16 * 0x1p-53;

  Vec3 origin;
  Vec3 direction;
  double oneNorm;
  double boundFloor;
};

/// The edge functions of one triangle, the weights of its vertices, and the bound of their error: the point
/// of the ray in the triangle's plane is (u v0 + v v1 + w v2) / (u + v + w).
struct EdgeValues
{
  double u = 0.0;
  double v = 0.0;
  double w = 0.0;
  double error = 0.0;
};

/// The edge functions of four triangles.
struct EdgeBlock
{
  double u[blockWidth];
  double v[blockWidth];
  double w[blockWidth];
  double error[blockWidth];
};

/// d · (e x p)
inline double edgeFunction(double dx, double dy, double dz, double ex, double ey, double ez,
  double px, double py, double pz)
{
  return (dx * (ey * pz - ez * py) + dy * (ez * px - ex * pz)) + dz * (ex * py - ey * px);
}

/// The arithmetic of one lane; every width of it gives the same bits.
template <class T>
inline void edgeFunctions(const FilterRay& ray, const TriangleBlock<T>& block, EdgeBlock& out)
{
  const double dx = ray.direction[0];
  const double dy = ray.direction[1];
  const double dz = ray.direction[2];
  for (int i = 0; i < blockWidth; ++i)
  {
    const double x0 = block.v[0][i], y0 = block.v[1][i], z0 = block.v[2][i];
    const double x1 = block.v[3][i], y1 = block.v[4][i], z1 = block.v[5][i];
    const double x2 = block.v[6][i], y2 = block.v[7][i], z2 = block.v[8][i];
    const double ax = x0 - ray.origin[0], ay = y0 - ray.origin[1], az = z0 - ray.origin[2];
    const double bx = x1 - ray.origin[0], by = y1 - ray.origin[1], bz = z1 - ray.origin[2];
    const double cx = x2 - ray.origin[0], cy = y2 - ray.origin[1], cz = z2 - ray.origin[2];
    out.u[i] = edgeFunction(dx, dy, dz, x2 - x1, y2 - y1, z2 - z1, bx, by, bz);
    out.v[i] = edgeFunction(dx, dy, dz, x0 - x2, y0 - y2, z0 - z2, cx, cy, cz);
    out.w[i] = edgeFunction(dx, dy, dz, x1 - x0, y1 - y0, z1 - z0, ax, ay, az);
    const double m = std::max(std::max(std::max(std::fabs(ax), std::fabs(ay)),
                                std::max(std::fabs(az), std::fabs(bx))),
      std::max(std::max(std::max(std::fabs(by), std::fabs(bz)), std::fabs(cx)),
        std::max(std::fabs(cy), std::fabs(cz))));
    out.error[i] = 2.0 * block.edge * m * ray.oneNorm * (FilterRay::edgeBound / 2) + ray.boundFloor;
  }
}

/// Certainly no hit: one edge function is certainly negative and another certainly positive.
inline bool surelyMissed(const EdgeValues& e)
{
  const double low = std::min(e.u, std::min(e.v, e.w));
  const double high = std::max(e.u, std::max(e.v, e.w));
  return low < -e.error && high > e.error;
}

/// Certainly a hit of the triangle's interior by the ray's line.
inline bool surelyHit(const EdgeValues& e)
{
  const double low = std::min(e.u, std::min(e.v, e.w));
  const double high = std::max(e.u, std::max(e.v, e.w));
  return low > e.error || high < -e.error;
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
