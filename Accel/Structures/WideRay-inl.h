// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Included once per instruction set (Highway's scheme), so without an ordinary guard.
#if defined(LUMITREE_WIDE_RAY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LUMITREE_WIDE_RAY_INL
#undef LUMITREE_WIDE_RAY_INL
#else
#define LUMITREE_WIDE_RAY_INL
#endif

#include "Accel/Kernel/Simd-inl.h"

#include "Accel/Ray.h"
#include "Accel/Structures/WideBvhNodes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace lumitree
{
namespace HWY_NAMESPACE
{

/// A ray in the frame of a wide BVH, in float. Its origin is an interval that holds the exact one;
/// its parameter is s = t perT, with perT a power of two such that the direction's largest
/// component is in [1, 2): s is a distance in the tree's frame. Where there is a fourth number it
/// means nothing.
struct WideRay
{
  /// Direction, reciprocal, difference and product round to 2^-24 each, 4.1 · 2^-24 in all, and the
  /// padded reciprocal once more.
  static constexpr float slabPad = 0x1p-21f;

  HWY_INLINE void start(const WideBvhFrame& frame, const Ray& ray)
  {
    const double size = powerBelow(std::max(
      { std::fabs(ray.direction[0]), std::fabs(ray.direction[1]), std::fabs(ray.direction[2]) }));
    this->unit = reciprocalOfPower(size);
    this->perT = frame.scale * size;
    this->bounded = std::isnormal(this->perT);

    // The subtraction rounds to 2^-53 of the result, the conversion to 2^-24; 2^-22 covers both
    // and itself.
    static_assert(sizeof(Ray) == 8 * sizeof(double) && sizeof(WideBvhFrame) == 4 * sizeof(double));
    const auto* const numbers = reinterpret_cast<const double*>(&ray);
    const Double4 o =
      (Double4::load(numbers) - Double4::load(reinterpret_cast<const double*>(&frame))) *
      Double4::all(frame.scale);
    if (((Double4::all(0x1p64) < absolute(o)).bits() & 7u) != 0)
    {
      this->meetEverything();
      return;
    }
    const Double4 pad = absolute(o) * Double4::all(0x1p-22) + Double4::all(0x1p-120);
    const Float4 low = toFloat(o - pad);
    const Float4 high = toFloat(o + pad);
    const Float4 along = toFloat(Double4::load(numbers + 3) * Double4::all(this->unit));
    // A near plane's t is bounded from below, a far plane's from above.
    whereNegative(along, low, high).store(this->originNear);
    whereNegative(along, high, low).store(this->originFar);
    const Float4 one = Float4::all(1.0f);
    this->octant = (whereNegative(along, Float4::all(-1.0f), one) < one).bits() & 7u;
    this->sMin = this->below(ray.tMin);
    this->setReciprocals(ray, one / along);
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

  float originNear[4];
  float originFar[4];
  float nearReciprocal[4]; ///< padded downward where forward
  float farReciprocal[4];  ///< padded upward where forward
  unsigned octant;         ///< bit k is set where component k of the direction is negative
  float sMin;
  double unit;  ///< the power of two that takes the direction's largest component into [1, 2)
  double perT;  ///< s / t, a power of two
  bool bounded; ///< perT is in the range of doubles, s in that of floats
  bool forward; ///< s is never negative

private:
  HWY_INLINE void setReciprocals(const Ray& ray, const Float4& reciprocal)
  {
    this->forward = this->sMin >= 0.0f;
    // Where s >= 0 a factor makes it smaller or larger; elsewhere the pad is added later.
    const float pad = this->forward ? slabPad : 0.0f;
    (reciprocal * Float4::all(1.0f - pad)).store(this->nearReciprocal);
    (reciprocal * Float4::all(1.0f + pad)).store(this->farReciprocal);
    // As in RayBox: a component whose reciprocal overflows, or is that of a number that floats hold
    // with fewer digits, does not constrain. 0 itself does.
    if (((Float4::all(0x1p118f) < absolute(reciprocal)).bits() & 7u) != 0)
    {
      for (int k = 0; k < 3; ++k)
      {
        if (ray.direction[k] != 0.0 && std::fabs(this->nearReciprocal[k]) > 0x1p118f)
        {
          this->nearReciprocal[k] = std::numeric_limits<float>::quiet_NaN();
          this->farReciprocal[k] = std::numeric_limits<float>::quiet_NaN();
        }
      }
    }
  }

  /// Floats might overflow on the way to a hit that starts more than 2^64 away; nearer, its s is
  /// below 2^117. Slabs are met from -2^100 to 2^100, and those of lanes without a child, at
  /// infinity, still nowhere.
  void meetEverything()
  {
    std::fill_n(this->originNear, 4, 0x1p100f);
    std::fill_n(this->originFar, 4, -0x1p100f);
    std::fill_n(this->nearReciprocal, 4, 1.0f);
    std::fill_n(this->farReciprocal, 4, 1.0f);
    this->octant = 0;
    this->bounded = false;
    this->sMin = -std::numeric_limits<float>::infinity();
    this->forward = false;
  }

  /// The power of two in (x / 2, x]; of a subnormal number the least normal one.
  static double powerBelow(double x)
  {
    return fromBits(std::max(toBits(x) & exponentBits, std::uint64_t{ 0x0010000000000000u }));
  }

  /// 1 / x of such a power, which is below 2^1000 (coordinateLimit).
  static double reciprocalOfPower(double x) { return fromBits(0x7fe0000000000000u - toBits(x)); }

  static constexpr std::uint64_t exponentBits = 0x7ff0000000000000u;

  static std::uint64_t toBits(double x)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof(bits));
    return bits;
  }

  static double fromBits(std::uint64_t bits)
  {
    double x;
    std::memcpy(&x, &bits, sizeof(x));
    return x;
  }
};

} // namespace HWY_NAMESPACE
} // namespace lumitree
HWY_AFTER_NAMESPACE();

#endif
