// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Integration_ConeSample_h
#define Lumitree_Radiometry_Integration_ConeSample_h

#include "Radiometry/Constants.h"
#include "Radiometry/Frame.h"

#include <algorithm>

namespace lumitree
{

/// 2π (1 − cosα) from sin(α/2): narrow cones keep their digits.
inline double coneSolidAngle(double sineOfHalf)
{
  return 4.0 * pi * sineOfHalf * sineOfHalf;
}

/// A direction within a cone around a unit vector, even over its solid angle. (u, v) of the unit
/// square: distance from the axis, and azimuth.
inline Vec3 sampleCone(const Vec3& axis, double sineOfHalf, double u, double v)
{
  const double versine = 2.0 * sineOfHalf * sineOfHalf * u;
  const double sine = std::sqrt(std::max(0.0, versine * (2.0 - versine)));
  const double azimuth = 2.0 * pi * v;
  return Frame::around(axis).toWorld(
    { sine * std::cos(azimuth), sine * std::sin(azimuth), 1.0 - versine });
}

} // namespace lumitree

#endif
