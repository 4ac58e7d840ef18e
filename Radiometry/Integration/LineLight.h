// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Integration_LineLight_h
#define Lumitree_Radiometry_Integration_LineLight_h

#include "Accel/Vec3.h"

namespace lumitree
{

/// A straight line as a receiver in the origin sees it, without its distance from the whole line:
/// so nothing is lost where the receiver is on the prolongation of it.
class LineLight
{
public:
  LineLight(const Vec3& toBegin, const Vec3& toEnd)
  {
    const Vec3 way = toEnd - toBegin;
    const double first = std::hypot(toBegin[0], toBegin[1], toBegin[2]);
    const double second = std::hypot(toEnd[0], toEnd[1], toEnd[2]);
    const Vec3 a = (1.0 / first) * toBegin;
    const Vec3 b = (1.0 / second) * toEnd;
    const Vec3 sum = a + b;
    const double size = length(sum);
    this->touches_ = !(first > 0.0 && second > 0.0 && size > 0.0);
    this->scale_ = std::hypot(way[0], way[1], way[2]) / first / second;
    this->cosineOfHalf_ = 0.5 * size;
    this->middle_ = (1.0 / size) * sum;
    this->angle_ = std::atan2(length(cross(a, b)), dot(a, b));
  }

  /// The receiver is on the line: nothing else is defined.
  [[nodiscard]] bool touches() const { return this->touches_; }

  [[nodiscard]] double scale() const { return this->scale_; }               ///< l / (r₁ r₂)
  [[nodiscard]] const Vec3& middle() const { return this->middle_; }        ///< of the angle, unit
  [[nodiscard]] double cosineOfHalf() const { return this->cosineOfHalf_; } ///< cos(angle / 2)
  [[nodiscard]] double angle() const { return this->angle_; }               ///< seen, 0 … π

  /// ∫ ω / r² dl
  [[nodiscard]] Vec3 isotropicVector() const
  {
    return (this->scale_ / this->cosineOfHalf_) * this->middle_;
  }

private:
  bool touches_;
  double scale_;
  double cosineOfHalf_;
  double angle_;
  Vec3 middle_;
};

} // namespace lumitree

#endif
