// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BvhFrame_h
#define Lumitree_Accel_Structures_BvhFrame_h

#include "Accel/Box.h"
#include "Accel/Structures/WideBvhNodes.h"

#include <algorithm>
#include <cmath>

namespace lumitree
{

/// The frame in which what lies in the bounds has coordinates of magnitude 1 at most.
[[nodiscard]] inline WideBvhFrame frameOf(const Box& bounds)
{
  WideBvhFrame frame;
  frame.centre = bounds.centre();
  const Vec3 size = bounds.size();
  int exponent = 0;
  std::frexp(std::max({ size[0], size[1], size[2] }), &exponent);
  frame.scale = std::ldexp(1.0, std::clamp(1 - exponent, -1000, 1000));
  return frame;
}

/// A coordinate in the frame, rounded outward: the subtraction rounds to 2^-53 of the result, the
/// conversion to 2^-24. Monotonic, so that the bounds of a box in the frame are its box's.
///@{
[[nodiscard]] inline float roundedDown(double x, double centre, double scale)
{
  const double v = (x - centre) * scale;
  return static_cast<float>(v - (std::fabs(v) * 0x1p-23 + 0x1p-120));
}

[[nodiscard]] inline float roundedUp(double x, double centre, double scale)
{
  const double v = (x - centre) * scale;
  return static_cast<float>(v + (std::fabs(v) * 0x1p-23 + 0x1p-120));
}
///@}

/// The coordinate of a position in the frame, moved out by more than the sum rounds: 2^-53 of the
/// largest of its terms.
///@{
[[nodiscard]] inline double unframedDown(float v, double centre, double scale)
{
  const double x = static_cast<double>(v) / scale;
  return centre + x - (std::fabs(centre) + std::fabs(x)) * 0x1p-51;
}

[[nodiscard]] inline double unframedUp(float v, double centre, double scale)
{
  const double x = static_cast<double>(v) / scale;
  return centre + x + (std::fabs(centre) + std::fabs(x)) * 0x1p-51;
}
///@}

} // namespace lumitree

#endif
