// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/KdTreeDivide.h"

#include "Accel/Structures/BodyBoxOverlap.h"
#include "Accel/Structures/KdTreeClip.h"

namespace lumitree
{

KdSide sideOf(const KdReference& reference, const KdSplit& split)
{
  const double lower = reference.bounds.lower[split.axis];
  const double upper = reference.bounds.upper[split.axis];
  const bool inPlane = lower == split.position && upper == split.position;
  if (inPlane ? split.inPlaneBelow : upper <= split.position)
  {
    return KdSide::Below;
  }
  return inPlane || lower >= split.position ? KdSide::Above : KdSide::Both;
}

Box partOf(const Surface& surface, const KdReference& reference, const Box& cell)
{
  if (surface.isTriangle(reference.id))
  {
    return commonBox(clippedBounds(surface.vertices(reference.id), cell), reference.bounds);
  }
  const Box bounds = commonBox(cell, reference.bounds);
  return !bounds.empty() && mayMeet(surface, reference.id, bounds) ? bounds : Box{};
}

KdSides divideReferences(const Surface& surface, const Box& cell,
  const std::vector<KdReference>& references, const KdSplit& split)
{
  const KdCells cells(cell, static_cast<std::size_t>(split.axis), split.position);
  KdSides sides;
  const auto addPart = [&](
                         const KdReference& whole, const Box& part, std::vector<KdReference>& side)
  {
    const Box bounds = partOf(surface, whole, part);
    if (!bounds.empty())
    {
      side.push_back({ bounds, whole.id });
    }
  };
  for (const KdReference& r : references)
  {
    const KdSide side = sideOf(r, split);
    if (side == KdSide::Both)
    {
      addPart(r, cells.below, sides.below);
      addPart(r, cells.above, sides.above);
      continue;
    }
    (side == KdSide::Below ? sides.below : sides.above).push_back(r);
  }
  return sides;
}

} // namespace lumitree
