// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_RayBox_h
#define Lumitree_Accel_Kernel_RayBox_h

#include "Accel/Box.h"
#include "Accel/Ray.h"

#include <cstddef>
#include <cstring>

namespace lumitree
{

/// All that a structure may know of a ray: enough to meet boxes, nothing of triangles.
///
/// The slab test never misses a box that the ray meets in exact arithmetic. Each plane is at
/// t = (plane - origin) * (1 / direction): three roundings, a relative error below 3.1 u with u =
/// 2^-53 while nothing underflows. The pad is 2^-40, far above that, so that the double arithmetic
/// of leaf tests, too, lands inside a box they found; what underflow can lose is below the absolute
/// pad. A direction component of 0 gives ±infinity, or NaN on the plane itself, which the
/// comparisons ignore; a component whose reciprocal overflows gives NaN everywhere and so does not
/// constrain (Ize 2013; Williams et al. 2005). Planes are chosen by the sign of the direction, and
/// every comparison is <=: a flat box is met.
class RayBox
{
public:
  /// How far a t of one plane, computed as above, is trusted.
  ///@{
  static constexpr double relativePad = 0x1p-40;
  static constexpr double absolutePad = 0x1p-1000;
  ///@}

  explicit RayBox(const Ray& ray)
    : origin_(ray.origin)
    , tMin_(ray.tMin)
    , tMax_(ray.tMax)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double d = ray.direction[k];
      this->reciprocal_[k] = 1.0 / d;
      if (d != 0.0 && std::isinf(this->reciprocal_[k]))
      {
        this->reciprocal_[k] = std::numeric_limits<double>::quiet_NaN();
      }
      this->negative_[k] = std::signbit(d);
      this->near_[k] = offsetOf(this->negative_[k], k);
      this->far_[k] = offsetOf(!this->negative_[k], k);
    }
  }

  [[nodiscard]] const Vec3& origin() const { return this->origin_; }
  [[nodiscard]] double tMin() const { return this->tMin_; }
  [[nodiscard]] double tMax() const { return this->tMax_; }
  [[nodiscard]] bool negative(int axis) const { return this->negative_[axis]; }
  /// 1 / direction; ±infinity for ±0, NaN where it would overflow.
  [[nodiscard]] double reciprocal(int axis) const { return this->reciprocal_[axis]; }

  /// Whether the closed segment, cut at tStop, may meet the closed box. tEnter becomes a lower
  /// bound of the t at which it does.
  [[nodiscard]] bool meets(const Box& box, double tStop, double& tEnter) const
  {
    double tExit = 0.0;
    return this->meets(box, tStop, tEnter, tExit);
  }

  /// The same; tExit becomes an upper bound.
  [[nodiscard]] bool meets(const Box& box, double tStop, double& tEnter, double& tExit) const
  {
    double enter = -std::numeric_limits<double>::infinity();
    double exit = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k)
    {
      const double tNear = (plane(box, this->near_[k]) - this->origin_[k]) * this->reciprocal_[k];
      const double tFar = (plane(box, this->far_[k]) - this->origin_[k]) * this->reciprocal_[k];
      enter = tNear > enter ? tNear : enter;
      exit = tFar < exit ? tFar : exit;
    }
    if (!(enter < std::numeric_limits<double>::infinity() &&
          exit > -std::numeric_limits<double>::infinity()))
    {
      if (this->passesBeside(box))
      {
        return false;
      }
      enter = std::min(enter, std::numeric_limits<double>::max());
      exit = std::max(exit, std::numeric_limits<double>::lowest());
    }
    // No infinity is less itself here: enter is below +infinity, exit above -infinity.
    enter -= padOf(enter);
    tExit = exit + padOf(exit);
    tEnter = enter > this->tMin_ ? enter : this->tMin_;
    return tEnter <= tExit && tEnter <= tStop;
  }

  /// What meets says of two boxes, in one: bit 0 for the first, bit 1 for the second.
  [[nodiscard]] unsigned meetPair(const Box& a, const Box& b, double tStop, double tEnter[2]) const
  {
    using Double2 = double __attribute__((vector_size(16)));
    using Long2 = std::int64_t __attribute__((vector_size(16)));
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Double2 enter = { -infinity, -infinity };
    Double2 exit = { infinity, infinity };
    for (int k = 0; k < 3; ++k)
    {
      const Double2 nearPlane = { plane(a, this->near_[k]), plane(b, this->near_[k]) };
      const Double2 farPlane = { plane(a, this->far_[k]), plane(b, this->far_[k]) };
      const Double2 tNear = (nearPlane - this->origin_[k]) * this->reciprocal_[k];
      const Double2 tFar = (farPlane - this->origin_[k]) * this->reciprocal_[k];
      enter = tNear > enter ? tNear : enter;
      exit = tFar < exit ? tFar : exit;
    }
    const Long2 sound = (enter < infinity) & (exit > -infinity);
    if (!(sound[0] & sound[1])) // rare: one box after the other
    {
      const bool meetsA = this->meets(a, tStop, tEnter[0]);
      const bool meetsB = this->meets(b, tStop, tEnter[1]);
      return (meetsA ? 1u : 0u) | (meetsB ? 2u : 0u);
    }
    const auto magnitude = [](Double2 t)
    { return reinterpret_cast<Double2>(reinterpret_cast<Long2>(t) & (~std::uint64_t{ 0 } >> 1)); };
    enter -= magnitude(enter) * relativePad + absolutePad;
    exit += magnitude(exit) * relativePad + absolutePad;
    enter = enter > this->tMin_ ? enter : Double2{ this->tMin_, this->tMin_ };
    tEnter[0] = enter[0];
    tEnter[1] = enter[1];
    const Long2 met = (enter <= exit) & (enter <= tStop);
    return (met[0] ? 1u : 0u) | (met[1] ? 2u : 0u);
  }

  /// Bounds of the t at which the line crosses the plane of points that have this position on the
  /// axis: ±infinity where the line runs beside the plane; NaN where it runs in the plane, and
  /// where the axis does not constrain.
  void crosses(int axis, double position, double& tLow, double& tHigh) const
  {
    const double t = (position - this->origin_[axis]) * this->reciprocal_[axis];
    if (std::fabs(t) <= std::numeric_limits<double>::max())
    {
      tLow = t - padOf(t);
      tHigh = t + padOf(t);
      return;
    }
    tLow = tHigh = t;
    if (std::isinf(t) && !std::isinf(this->reciprocal_[axis])) // it overflowed
    {
      const double most = std::copysign(std::numeric_limits<double>::max(), t);
      tLow = most - padOf(most);
      tHigh = most + padOf(most);
    }
  }

private:
  static double padOf(double t) { return std::fabs(t) * relativePad + absolutePad; }

  /// Where a plane is in the memory of a box.
  static constexpr std::size_t offsetOf(bool upper, int axis)
  {
    return (upper ? offsetof(Box, upper) : offsetof(Box, lower)) +
      static_cast<std::size_t>(axis) * sizeof(double);
  }
  static double plane(const Box& box, std::size_t offset)
  {
    double position;
    std::memcpy(&position, reinterpret_cast<const char*>(&box) + offset, sizeof(position));
    return position;
  }

  /// Whether the ray is parallel to a slab and outside it. Else what is infinite is so because it
  /// overflowed.
  [[nodiscard]] [[gnu::noinline, gnu::cold]] bool passesBeside(const Box& box) const
  {
    bool beside = false;
    for (int k = 0; k < 3; ++k)
    {
      beside = beside ||
        (std::isinf(this->reciprocal_[k]) &&
          !(box.lower[k] <= this->origin_[k] && this->origin_[k] <= box.upper[k]));
    }
    return beside;
  }

  Vec3 origin_;
  Vec3 reciprocal_;
  double tMin_;
  double tMax_;
  bool negative_[3];
  /// Of the planes that the ray meets first and last on each axis, whatever their place.
  ///@{
  std::size_t near_[3];
  std::size_t far_[3];
  ///@}
};

} // namespace lumitree

#endif
