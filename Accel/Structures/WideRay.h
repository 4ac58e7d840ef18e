// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_WideRay_h
#define Lumitree_Accel_Structures_WideRay_h

#include "Accel/Ray.h"
#include "Accel/Structures/WideBvhNodes.h"

#include <algorithm>
#include <cmath>

namespace lumitree
{

/// A ray in the frame of a wide BVH, in float. Its origin is an interval that holds the exact one; its parameter is
/// s = t 2^shift, so that the direction's largest component is in [1/2, 1) and s is a distance in the tree's frame.
struct WideRay
{
  WideRay(const WideBvhFrame& frame, const Ray& ray)
  {
    const double largest = std::max({ std::fabs(ray.direction[0]), std::fabs(ray.direction[1]),
      std::fabs(ray.direction[2]) });
    int exponent = 0;
    std::frexp(largest, &exponent);
    int frameExponent = 0;
    std::frexp(frame.scale, &frameExponent);
    this->shift = exponent + frameExponent - 1;
    for (int k = 0; k < 3; ++k)
    {
      // The subtraction rounds to 2^-53 of the result, the conversion to 2^-24; 2^-22 covers both and itself.
      const double o = (ray.origin[k] - frame.centre[k]) * frame.scale;
      const double pad = std::fabs(o) * 0x1p-22 + 0x1p-120;
      const auto low = static_cast<float>(o - pad);
      const auto high = static_cast<float>(o + pad);
      this->negative[k] = std::signbit(ray.direction[k]);
      // A near plane's t is bounded from below, a far plane's from above.
      this->originNear[k] = this->negative[k] ? low : high;
      this->originFar[k] = this->negative[k] ? high : low;
      const double d = std::ldexp(ray.direction[k], -exponent);
      this->reciprocal[k] = static_cast<float>(1.0 / d);
      // As in RayBox: a component whose reciprocal overflows does not constrain. 0 itself does.
      if (ray.direction[k] != 0.0 && std::isinf(this->reciprocal[k]))
      {
        this->reciprocal[k] = std::numeric_limits<float>::quiet_NaN();
      }
    }
    this->sMin = this->below(ray.tMin);
  }

  /// s of a t, rounded down or up.
  ///@{
  [[nodiscard]] float below(double t) const
  {
    const double s = std::ldexp(t, this->shift);
    const double padded = s - std::fabs(s) * 0x1p-22;
    return static_cast<float>(std::min(padded, 0x1p127));
  }
  [[nodiscard]] float above(double t) const
  {
    const double s = std::ldexp(t, this->shift);
    const double padded = s + std::fabs(s) * 0x1p-22;
    return static_cast<float>(std::max(padded + 0x1p-120, -0x1p127));
  }
  ///@}

  float originNear[3];
  float originFar[3];
  float reciprocal[3];
  bool negative[3];
  float sMin;
  int shift;
};

} // namespace lumitree

#endif
