// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/KdTreeDivide.h"

#include "Accel/Structures/KdTreeClip.h"
#include "Accel/Structures/QuadricBoxOverlap.h"

namespace lumitree
{
namespace
{

void addPart(
  const Surface& surface, const KdReference& whole, const Box& cell, std::vector<KdReference>& side)
{
  const bool quadric = surface.isQuadric(whole.id);
  const Box bounds =
    commonBox(quadric ? cell : clippedBounds(surface.vertices(whole.id), cell), whole.bounds);
  if (!bounds.empty() && !(quadric && !mayMeet(surface.quadric(whole.id), bounds)))
  {
    side.push_back({ bounds, whole.id });
  }
}

} // namespace

KdSides divideReferences(const Surface& surface, const Box& cell,
  const std::vector<KdReference>& references, const KdSplit& split)
{
  const auto axis = static_cast<std::size_t>(split.axis);
  const KdCells cells(cell, axis, split.position);
  KdSides sides;
  for (const KdReference& r : references)
  {
    const double lower = r.bounds.lower[axis];
    const double upper = r.bounds.upper[axis];
    const bool inPlane = lower == split.position && upper == split.position;
    if (inPlane ? split.inPlaneBelow : upper <= split.position)
    {
      sides.below.push_back(r);
    }
    else if (inPlane || lower >= split.position)
    {
      sides.above.push_back(r);
    }
    else
    {
      addPart(surface, r, cells.below, sides.below);
      addPart(surface, r, cells.above, sides.above);
    }
  }
  return sides;
}

} // namespace lumitree
