// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/KdTreeClip.h"

namespace lumitree
{
namespace
{

/// A corner of what is left of the triangle. The true corner is within error of it, axis by axis.
struct Corner
{
  Vec3 at;
  Vec3 error;
};

/// A polygon, convex but for rounding. Where it is convex, each of six cuts adds one corner at
/// most; in the worst of cases a cut adds one for each two there were: 3, 4, 6, 9, 13, 19, 28.
struct Polygon
{
  std::array<Corner, 28> corners;
  int size = 0;

  void add(const Corner& corner) { this->corners[this->size++] = corner; }
};

/// What one cut may round: with u = 2^-53 and all coordinates at most M, a + s (b - a) is off
/// by 6.2 u M for the three roundings of s, by 2 u M each for b - a and the product, and by u M for
/// the sum; below 12 u M < 2^-49 M.
Vec3 roundingOfACut(const std::array<Vec3, 3>& triangle)
{
  Vec3 rounding;
  for (int k = 0; k < 3; ++k)
  {
    const double most =
      std::max({ std::fabs(triangle[0][k]), std::fabs(triangle[1][k]), std::fabs(triangle[2][k]) });
    rounding[k] = most * 0x1p-49 + 0x1p-1060;
  }
  return rounding;
}

Corner cutEdge(
  const Corner& outside, const Corner& inside, int axis, double plane, const Vec3& rounding)
{
  const double s =
    std::clamp((plane - outside.at[axis]) / (inside.at[axis] - outside.at[axis]), 0.0, 1.0);
  Corner cut;
  for (int k = 0; k < 3; ++k)
  {
    const bool constant = outside.at[k] == inside.at[k];
    cut.at[k] = outside.at[k] + s * (inside.at[k] - outside.at[k]);
    cut.error[k] = std::max(outside.error[k], inside.error[k]) + (constant ? 0.0 : rounding[k]);
  }
  cut.at[axis] = plane;
  return cut;
}

/// Keeps what lies at sign * x[axis] >= sign * plane.
void cutPolygon(Polygon& polygon, int axis, double plane, double sign, const Vec3& rounding)
{
  const auto isInside = [&](const Corner& c) { return sign * c.at[axis] >= sign * plane; };
  const auto end = polygon.corners.begin() + polygon.size;
  if (std::all_of(polygon.corners.begin(), end, isInside))
  {
    return;
  }
  Polygon kept;
  for (int i = 0; i < polygon.size; ++i)
  {
    const Corner& a = polygon.corners[i];
    const Corner& b = polygon.corners[i + 1 < polygon.size ? i + 1 : 0];
    if (isInside(a))
    {
      kept.add(a);
    }
    if (isInside(a) != isInside(b))
    {
      kept.add(
        isInside(a) ? cutEdge(b, a, axis, plane, rounding) : cutEdge(a, b, axis, plane, rounding));
    }
  }
  polygon.size = kept.size;
  std::copy_n(kept.corners.begin(), kept.size, polygon.corners.begin());
}

} // namespace

Box clippedBounds(const std::array<Vec3, 3>& triangle, const Box& cell)
{
  const Vec3 rounding = roundingOfACut(triangle);
  Polygon polygon;
  for (const Vec3& vertex : triangle)
  {
    polygon.add({ vertex, { 0.0, 0.0, 0.0 } });
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    // Errors of six cuts add up to 6 roundings: planes are moved out by more, so that no corner is
    // cut off wrongly.
    const double out = 8.0 * rounding[axis];
    cutPolygon(polygon, axis, cell.lower[axis] - out, 1.0, rounding);
    cutPolygon(polygon, axis, cell.upper[axis] + out, -1.0, rounding);
  }
  Box bounds;
  for (int i = 0; i < polygon.size; ++i)
  {
    const Corner& corner = polygon.corners[i];
    bounds.extend(corner.at - corner.error);
    bounds.extend(corner.at + corner.error);
  }
  return commonBox(bounds, cell);
}

Box commonBox(const Box& a, const Box& b)
{
  Box common;
  for (int k = 0; k < 3; ++k)
  {
    common.lower[k] = std::max(a.lower[k], b.lower[k]);
    common.upper[k] = std::min(a.upper[k], b.upper[k]);
  }
  for (int k = 0; k < 3; ++k)
  {
    if (!(common.lower[k] <= common.upper[k]))
    {
      return Box{};
    }
  }
  return common;
}

} // namespace lumitree
