// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/SolidAngle.h"

#include "Radiometry/Constants.h"

namespace lumitree
{

double solidAngle(const Vec3& from, const Vec3& a, const Vec3& b, const Vec3& c)
{
  // Unit vectors: the formula's products of three lengths could over- or underflow.
  const auto unit = [&](const Vec3& p)
  {
    const Vec3 way = p - from;
    return (1.0 / std::hypot(way[0], way[1], way[2])) * way;
  };
  const Vec3 u = unit(a);
  const Vec3 v = unit(b);
  const Vec3 w = unit(c);
  return 2.0 * std::atan2(dot(u, cross(v, w)), 1.0 + dot(u, v) + dot(v, w) + dot(w, u));
}

double diskSolidAngle(double radius, double height)
{
  const double slant = std::hypot(radius, height);
  return 2.0 * pi * (radius / slant) * (radius / (slant + height));
}

} // namespace lumitree
