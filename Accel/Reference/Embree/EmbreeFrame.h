// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Reference_Embree_EmbreeFrame_h
#define Lumitree_Accel_Reference_Embree_EmbreeFrame_h

#include "Accel/Box.h"
#include "Accel/Ray.h"

#include <array>

namespace lumitree
{

/// A segment as Embree takes it: it begins at the origin, and numbers are moderate.
struct EmbreeSegment
{
  std::array<float, 3> origin;
  std::array<float, 3> direction;
  float tFar = 0.0f;

  /// The parameter on the caller's ray of Embree's t.
  [[nodiscard]] double t(float embree) const
  {
    return std::ldexp(this->start + static_cast<double>(embree), this->exponent);
  }

  double start = 0.0;
  int exponent = 0;
};

/// Coordinates in which Embree works: moved, in double, to the centre of the surface's bounds, and
/// scaled by a power of two to about 1. Embree knows floats only, takes no negative t, and loses or
/// refuses numbers beyond 10^±18; on moderate numbers the scaling changes no bit of its answers.
class EmbreeFrame
{
public:
  explicit EmbreeFrame(const Box& bounds);

  [[nodiscard]] std::array<float, 3> point(const Vec3& p) const;

  /// The part of a valid ray within a ball about the surface. False when there is none, or when the
  /// origin is so far away (beyond some 10^12 times the surface's size) that doubles no longer
  /// tell.
  [[nodiscard]] bool cut(const Ray& ray, EmbreeSegment& segment) const;

private:
  [[nodiscard]] Vec3 inside(const Vec3& p) const;

  Vec3 centre_ = { 0.0, 0.0, 0.0 };
  double radius_ = -1.0; ///< of the ball, scaled; negative when there is nothing to hit
  int exponent_ = 0;     ///< one unit is 2^exponent of the caller's
};

} // namespace lumitree

#endif
