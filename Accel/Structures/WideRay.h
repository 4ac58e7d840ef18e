// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_WideRay_h
#define Lumitree_Accel_Structures_WideRay_h

#include "Accel/Ray.h"
#include "Accel/Structures/WideBvhNodes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace lumitree
{

/// A ray in the frame of a wide BVH, in float. Its origin is an interval that holds the exact one;
/// its parameter is s = t perT, with perT a power of two such that the direction's largest
/// component is in [1, 2): s is a distance in the tree's frame.
struct WideRay
{
  WideRay(const WideBvhFrame& frame, const Ray& ray)
  {
    const double largest = std::max(
      { std::fabs(ray.direction[0]), std::fabs(ray.direction[1]), std::fabs(ray.direction[2]) });
    const double unit = 1.0 / powerBelow(largest);
    this->perT = frame.scale / unit;
    this->bounded = std::isnormal(this->perT);
    bool distant = false;
    for (int k = 0; k < 3; ++k)
    {
      // The subtraction rounds to 2^-53 of the result, the conversion to 2^-24; 2^-22 covers both
      // and itself.
      const double o = (ray.origin[k] - frame.centre[k]) * frame.scale;
      distant = distant || !(std::fabs(o) <= 0x1p64);
      const double pad = std::fabs(o) * 0x1p-22 + 0x1p-120;
      const auto low = static_cast<float>(o - pad);
      const auto high = static_cast<float>(o + pad);
      this->negative[k] = std::signbit(ray.direction[k]);
      // A near plane's t is bounded from below, a far plane's from above.
      this->originNear[k] = this->negative[k] ? low : high;
      this->originFar[k] = this->negative[k] ? high : low;
      this->reciprocal[k] = static_cast<float>(1.0 / (ray.direction[k] * unit));
      // As in RayBox: a component whose reciprocal overflows does not constrain. 0 itself does.
      if (ray.direction[k] != 0.0 && std::isinf(this->reciprocal[k]))
      {
        this->reciprocal[k] = std::numeric_limits<float>::quiet_NaN();
      }
    }
    if (distant)
    {
      this->meetEverything();
    }
    this->sMin = this->below(ray.tMin);
    this->forward = this->sMin >= 0.0f;
  }

  /// s of a t, rounded down or up; no bound where the range of doubles is not enough to know it.
  ///@{
  [[nodiscard]] float below(double t) const
  {
    const double s = t * this->perT;
    return this->bounded ? static_cast<float>(s - std::min(std::fabs(s), 0x1p200) * 0x1p-22)
                         : -std::numeric_limits<float>::infinity();
  }
  [[nodiscard]] float above(double t) const
  {
    const double s = t * this->perT;
    return this->bounded
      ? static_cast<float>(s + (std::min(std::fabs(s), 0x1p200) * 0x1p-22 + 0x1p-120))
      : std::numeric_limits<float>::infinity();
  }
  ///@}

  float originNear[3];
  float originFar[3];
  float reciprocal[3];
  bool negative[3];
  float sMin;
  double perT;  ///< s / t, a power of two
  bool bounded; ///< perT is in the range of doubles, s in that of floats
  bool forward; ///< s is never negative

private:
  /// Floats might overflow on the way to a hit that starts more than 2^64 away; nearer, its s is
  /// below 2^117. Slabs are met from -2^100 to 2^100, and those of lanes without a child, at
  /// infinity, still nowhere.
  void meetEverything()
  {
    std::fill_n(this->originNear, 3, 0x1p100f);
    std::fill_n(this->originFar, 3, -0x1p100f);
    std::fill_n(this->reciprocal, 3, 1.0f);
    std::fill_n(this->negative, 3, false);
    this->bounded = false;
  }

  /// The power of two in (x / 2, x]; of a subnormal number the least normal one.
  static double powerBelow(double x)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof(bits));
    bits = std::max(bits & 0x7ff0000000000000u, std::uint64_t{ 0x0010000000000000u });
    std::memcpy(&x, &bits, sizeof(bits));
    return x;
  }
};

} // namespace lumitree

#endif
