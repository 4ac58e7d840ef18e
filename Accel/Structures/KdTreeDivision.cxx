// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/KdTreeDivision.h"

namespace lumitree
{

bool KdDivision::divide(
  const Surface& surface, const KdPart& whole, const KdSplit& split, KdPart& below, KdPart& above)
{
  const KdCells cells(whole.cell, static_cast<std::size_t>(split.axis), split.position);
  below.cell = cells.below;
  above.cell = cells.above;
  below.depth = above.depth = whole.depth + 1;
  below.references.clear();
  above.references.clear();
  this->sides_.reset(whole.references.size());
  for (auto& side : this->fresh_)
  {
    for (std::vector<KdEvent>& events : side)
    {
      events.clear();
    }
  }
  std::size_t i = 0;
  // Order is kept, so references ascend by id in every node.
  for (const KdReference& r : whole.references)
  {
    const KdSide side = sideOf(r, split);
    if (side == KdSide::Both)
    {
      this->sides_.set(i, KdSideMap::neither, 0);
      this->addPart(surface, r, KdSide::Below, below);
      this->addPart(surface, r, KdSide::Above, above);
    }
    else
    {
      KdPart& part = side == KdSide::Below ? below : above;
      this->sides_.set(i, static_cast<std::uint32_t>(side), part.references.size());
      part.references.push_back(r);
    }
    ++i;
  }
  const std::size_t held = below.references.size() + above.references.size();
  if (held > whole.allowance)
  {
    return false;
  }
  // Each side is allowed what it holds and its share of the rest.
  const std::size_t spare = whole.allowance - held;
  const std::size_t spareBelow = held > 0
    ? static_cast<std::size_t>(static_cast<double>(spare) *
        static_cast<double>(below.references.size()) / static_cast<double>(held))
    : 0;
  below.allowance = below.references.size() + std::min(spareBelow, spare);
  above.allowance = whole.allowance - below.allowance;
  return true;
}

void KdDivision::takeEvents(const KdPart& whole, int axis, KdPart& below, KdPart& above)
{
  const auto k = static_cast<std::size_t>(axis);
  for (const std::uint32_t side : { 0u, 1u })
  {
    KdPart& part = side == 0 ? below : above;
    if (part.references.size() < 2) // it will not be divided
    {
      part.events[k].clear();
      continue;
    }
    lumitree::takeEvents(
      whole.events[k], this->sides_, side, this->fresh_[side][k], part.events[k]);
  }
}

void KdDivision::addPart(
  const Surface& surface, const KdReference& whole, KdSide side, KdPart& part)
{
  const Box bounds = partOf(surface, whole, part.cell);
  if (bounds.empty())
  {
    return;
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    appendEvents(bounds, static_cast<int>(axis), static_cast<std::uint32_t>(part.references.size()),
      this->fresh_[static_cast<std::size_t>(side)][axis]);
  }
  part.references.push_back({ bounds, whole.id });
}

} // namespace lumitree
