// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/BspDivide.h"

#include "Accel/Structures/BodyBoxOverlap.h"
#include "Accel/Structures/BspNodes.h"
#include "Accel/Structures/KdTreeClip.h"

#include <algorithm>

namespace lumitree
{
namespace
{

/// Corners certainly beyond the plane are cut off. The new ones are off by less than 2^-46 of the
/// triangle's coordinates for each unit of how steeply the plane is met, and stay on their edges.
Box partBeside(const std::array<Vec3, 3>& corners, const BspPlane& plane, double sign)
{
  Box bounds;
  Vec3 room = { 0.0, 0.0, 0.0 };
  std::array<double, 3> distance;
  for (int i = 0; i < 3; ++i)
  {
    const PlaneDistance d(plane.normal, plane.offset, corners[i]);
    // A corner is taken for this much nearer than it is computed, so that nothing of this side is
    // cut off.
    distance[i] = sign * d.value - 2.0 * d.margin;
    for (int k = 0; k < 3; ++k)
    {
      room[k] = std::max(room[k], std::fabs(corners[i][k]) * 0x1p-44 + 0x1p-1040);
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    if (distance[i] <= 0.0)
    {
      bounds.extend(corners[i]);
    }
    if ((distance[i] <= 0.0) != (distance[j] <= 0.0))
    {
      const double s = std::clamp(distance[i] / (distance[i] - distance[j]), 0.0, 1.0);
      const Vec3 p = corners[i] + s * (corners[j] - corners[i]);
      bounds.extend(p - room);
      bounds.extend(p + room);
    }
  }
  return bounds;
}

/// Adds what a triangle has where sign * (normal · x - offset) <= 0, if anything.
void addPart(const Surface& surface, const KdReference& whole, const BspPlane& plane, double sign,
  BspPart& side)
{
  const auto corners = surface.vertices(whole.id);
  const bool body = !surface.isTriangle(whole.id);
  Box bounds = side.cell;
  if (!body)
  {
    bounds = plane.axis >= 0 ? clippedBounds(corners, side.cell) : partBeside(corners, plane, sign);
  }
  bounds = commonBox(commonBox(bounds, whole.bounds), side.cell);
  if (!bounds.empty() && !(body && !mayMeet(surface, whole.id, bounds)))
  {
    side.references.push_back({ bounds, whole.id });
  }
}

} // namespace

BspSide sideOf(const Surface& surface, const KdReference& r, const BspPlane& plane)
{
  if (plane.axis >= 0)
  {
    const auto axis = static_cast<std::size_t>(plane.axis);
    const double lower = r.bounds.lower[axis];
    const double upper = r.bounds.upper[axis];
    if (lower == plane.offset && upper == plane.offset)
    {
      return plane.inPlaneBelow ? BspSide::Below : BspSide::Above;
    }
    return upper <= plane.offset ? BspSide::Below
                                 : (lower >= plane.offset ? BspSide::Above : BspSide::Both);
  }
  // The corners of the part's box that are farthest below and above: mostly they decide.
  Vec3 low;
  Vec3 high;
  for (int k = 0; k < 3; ++k)
  {
    const bool rises = plane.normal[k] > 0.0;
    low[k] = rises ? r.bounds.lower[k] : r.bounds.upper[k];
    high[k] = rises ? r.bounds.upper[k] : r.bounds.lower[k];
  }
  const PlaneDistance lowest(plane.normal, plane.offset, low);
  const PlaneDistance highest(plane.normal, plane.offset, high);
  if (highest.value < -highest.margin)
  {
    return BspSide::Below;
  }
  if (lowest.value > lowest.margin)
  {
    return BspSide::Above;
  }
  // Of a body vertices are NaN, and nothing is certain.
  bool below = true;
  bool above = true;
  for (const Vec3& p : surface.vertices(r.id))
  {
    const PlaneDistance distance(plane.normal, plane.offset, p);
    below = below && distance.value < -distance.margin;
    above = above && distance.value > distance.margin;
    if (!below && !above)
    {
      return BspSide::Both;
    }
  }
  return below ? BspSide::Below : BspSide::Above;
}

std::pair<BspPart, BspPart> divideReferences(const Surface& surface, const WideBvhFrame& frame,
  const BspPart& whole, const BspPlane& plane, std::pair<Polyhedron, Polyhedron>&& polyhedra)
{
  BspPart below{ whole.cell, std::move(polyhedra.first), {} };
  BspPart above{ whole.cell, std::move(polyhedra.second), {} };
  if (plane.axis >= 0)
  {
    const auto axis = static_cast<std::size_t>(plane.axis);
    below.cell.upper[axis] = std::min(below.cell.upper[axis], plane.offset);
    above.cell.lower[axis] = std::max(above.cell.lower[axis], plane.offset);
  }
  // A slanted cell that is cut becomes smaller along the other axes, too.
  below.cell = commonBox(below.cell, boxAround(frame, below.polyhedron));
  above.cell = commonBox(above.cell, boxAround(frame, above.polyhedron));
  for (const KdReference& r : whole.references)
  {
    const BspSide side = sideOf(surface, r, plane);
    if (side == BspSide::Both)
    {
      addPart(surface, r, plane, 1.0, below);
      addPart(surface, r, plane, -1.0, above);
      continue;
    }
    // The cell may have become smaller than what its triangle knows of it.
    BspPart& part = side == BspSide::Below ? below : above;
    const Box bounds = commonBox(r.bounds, part.cell);
    if (!bounds.empty())
    {
      part.references.push_back({ bounds, r.id });
    }
  }
  return { std::move(below), std::move(above) };
}

} // namespace lumitree
