// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/SphericalTriangle.h"

#include "Radiometry/Constants.h"

#include <algorithm>

namespace lumitree
{

namespace
{

Vec3 unit(const Vec3& v)
{
  const double size = length(v);
  return size > 0.0 ? (1.0 / size) * v : v;
}

/// Angle between the planes of two great circles with those normals.
double angleBetween(const Vec3& a, const Vec3& b)
{
  return std::atan2(length(cross(a, b)), dot(a, b));
}

/// The part of a at right angles to the unit vector b, of unit length.
Vec3 across(const Vec3& a, const Vec3& b)
{
  return unit(a - dot(a, b) * b);
}

} // namespace

Vec3 sampleSphericalTriangle(
  const Vec3& position, const std::array<Vec3, 3>& corners, double u, double v)
{
  const Vec3 a = unit(corners[0] - position);
  const Vec3 b = unit(corners[1] - position);
  const Vec3 c = unit(corners[2] - position);
  const Vec3 ab = unit(cross(a, b));
  const Vec3 bc = unit(cross(b, c));
  const Vec3 ca = unit(cross(c, a));
  const double alpha = angleBetween(ab, -1.0 * ca);
  const double beta = angleBetween(bc, -1.0 * ab);
  const double gamma = angleBetween(ca, -1.0 * bc);

  // The sub-triangle (a, b, c') of the area u × whole; then a point between b and c'.
  const double area = u * (alpha + beta + gamma - pi);
  const double s = std::sin(area - alpha);
  const double t = std::cos(area - alpha);
  const double p = t - std::cos(alpha);
  const double q = s + std::sin(alpha) * dot(a, b);
  const double above = (q * t - p * s) * std::cos(alpha) - q;
  const double below = (q * s + p * t) * std::sin(alpha);
  const double x = below == 0.0 ? 1.0 : std::clamp(above / below, -1.0, 1.0);
  const Vec3 edge = x * a + std::sqrt((1.0 - x) * (1.0 + x)) * across(c, a);
  const double z = 1.0 - v * (1.0 - dot(edge, b));
  return z * b + std::sqrt(std::max(0.0, (1.0 - z) * (1.0 + z))) * across(edge, b);
}

} // namespace lumitree
