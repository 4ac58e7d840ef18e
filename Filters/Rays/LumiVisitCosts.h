// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Rays_LumiVisitCosts_h
#define Lumitree_Filters_Rays_LumiVisitCosts_h

#include "Accel/Accelerator.h"

#include <cstdint>
#include <vector>

namespace lumitree::filters
{

/// What the surface-area heuristic expects of a ray that enters the root, as it was: what rays paid
/// for the nodes they entered (costOf), and in a grid for the cells they stepped through. NaN when
/// no ray has entered it. perNode: visits, one a node of the view.
[[nodiscard]] double observedCost(
  const HierarchyView& view, const std::vector<std::uint64_t>& perNode, std::uint64_t cellsStepped);

/// Leaves that hold nothing; of a grid its empty cells.
[[nodiscard]] std::uint64_t emptyLeaves(const HierarchyView& view);

/// Leaves that hold something and were entered by no ray; 0 when no ray has entered the root.
[[nodiscard]] std::uint64_t unvisitedLeaves(
  const HierarchyView& view, const std::vector<std::uint64_t>& perNode);

/// End-point overlap (EndPointOverlap.h) of a hierarchy of boxes; 0 of a structure whose nodes do
/// not overlap. Takes time.
[[nodiscard]] double overlapOf(const Accelerator& accelerator, const HierarchyView& view);

} // namespace lumitree::filters

#endif
