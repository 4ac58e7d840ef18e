// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_RayBox_h
#define Lumitree_Accel_Kernel_RayBox_h

#include "Accel/Box.h"
#include "Accel/Ray.h"

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
      const double nearPlane = this->negative_[k] ? box.upper[k] : box.lower[k];
      const double farPlane = this->negative_[k] ? box.lower[k] : box.upper[k];
      const double tNear = (nearPlane - this->origin_[k]) * this->reciprocal_[k];
      const double tFar = (farPlane - this->origin_[k]) * this->reciprocal_[k];
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
    // By factors, because infinity less infinity would be NaN and the box met.
    enter = lowerBound(enter);
    tExit = upperBound(exit);
    tEnter = enter > this->tMin_ ? enter : this->tMin_;
    return tEnter <= tExit && tEnter <= tStop;
  }

  /// Bounds of the t at which the line crosses the plane of points that have this position on the
  /// axis: ±infinity where the line runs beside the plane; NaN where it runs in the plane, and
  /// where the axis does not constrain.
  void crosses(int axis, double position, double& tLow, double& tHigh) const
  {
    double t = (position - this->origin_[axis]) * this->reciprocal_[axis];
    if (std::isinf(t) && !std::isinf(this->reciprocal_[axis])) // it overflowed
    {
      t = std::copysign(std::numeric_limits<double>::max(), t);
    }
    tLow = lowerBound(t);
    tHigh = upperBound(t);
  }

private:
  static double lowerBound(double t)
  {
    return t * (t > 0.0 ? 1.0 - relativePad : 1.0 + relativePad) - absolutePad;
  }
  static double upperBound(double t)
  {
    return t * (t > 0.0 ? 1.0 + relativePad : 1.0 - relativePad) + absolutePad;
  }

  /// Whether the ray is parallel to a slab and outside it. Else what is infinite is so because it
  /// overflowed.
  [[nodiscard]] bool passesBeside(const Box& box) const
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
};

} // namespace lumitree

#endif
