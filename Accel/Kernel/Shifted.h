// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_Shifted_h
#define Lumitree_Accel_Kernel_Shifted_h

#include "Accel/Box.h"
#include "Accel/Kernel/Bounded.h"
#include "Accel/Ray.h"

namespace lumitree
{

/// A t at which the line passes near the middle of a box; infinite or NaN where it is out of range.
/// Scaled, so that it neither overflows nor underflows on its way.
inline double nearMiddle(const Ray& ray, const Box& box)
{
  const double scale = std::max(
    { std::fabs(ray.direction[0]), std::fabs(ray.direction[1]), std::fabs(ray.direction[2]) });
  const Vec3 d = { ray.direction[0] / scale, ray.direction[1] / scale, ray.direction[2] / scale };
  return dot(box.centre() - ray.origin, d) / dot(d, d) / scale;
}

/// o + t d - centre to about twice the precision of doubles.
inline Bounded shifted(double origin, double centre, double t, double direction)
{
  double difference;
  double differenceRest;
  Bounded::twoSum(origin, -centre, difference, differenceRest);
  const double product = t * direction;
  const double productRest = std::fma(t, direction, -product);
  double sum;
  double sumRest;
  Bounded::twoSum(difference, product, sum, sumRest);
  const double rest = sumRest + (differenceRest + productRest);
  const double v = sum + rest;
  const double lost =
    4.0 * (std::fabs(sumRest) + std::fabs(differenceRest) + std::fabs(productRest)) + std::fabs(v);
  return { v, Bounded::grown(Bounded::roundoff * lost) };
}

} // namespace lumitree

#endif
