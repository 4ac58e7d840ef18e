// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_KdTreeSplitters_h
#define Lumitree_Accel_Structures_KdTreeSplitters_h

#include "Accel/Structures/KdTreeEvents.h"

namespace lumitree
{

/// Cost of a step down, in tests of a block of four triangles. Of 0.25 … 6, rays were fastest with
/// 2 … 3 (torus, city, stadium): a step waits for memory and for branches, a block hardly.
inline constexpr double kdStepCost = 2.0;

/// A plane that divides a cell.
struct KdSplit
{
  int axis = -1; ///< -1: do not divide
  double position = 0.0;
  bool inPlaneBelow = true; ///< what lies in the plane goes below it, else above
};

/// A plane and what the cell is expected to cost with it, in tests of a block of four triangles.
struct KdOffer
{
  KdSplit split;
  double cost = 0.0;
};

/// The textbook's split: the cell's longest axis, in the middle, until leafSize or fewer are left.
[[nodiscard]] KdSplit spatialMedianSplit(const Box& cell, std::size_t references, int leafSize);

/// What a leaf of so many references costs: no split.
[[nodiscard]] KdOffer kdLeafOffer(std::size_t references);

/// The surface-area heuristic over all planes across an axis at which the bounds of a reference
/// begin or end (Wald and Havran, "On building fast kd-trees for ray tracing, and on doing that in
/// O(N log N)", 2006, sections 3 and 4.2), with their rule for triangles in the plane and their
/// bonus for cutting off empty space: the cheapest, or what was offered before where nothing costs
/// less. The events are those of the references on that axis, sorted.
[[nodiscard]] KdOffer cheapestAcross(int axis, const Box& cell, std::size_t references,
  const std::vector<KdEvent>& events, const KdOffer& before);

/// The same on all three axes, sorting first. Keeps its memory from node to node.
class KdPlaneSearch
{
public:
  [[nodiscard]] KdSplit best(const Box& cell, const std::vector<KdReference>& references);

private:
  std::vector<KdEvent> events_;
};

} // namespace lumitree

#endif
