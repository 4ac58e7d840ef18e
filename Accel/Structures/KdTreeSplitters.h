// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_KdTreeSplitters_h
#define Lumitree_Accel_Structures_KdTreeSplitters_h

#include "Accel/Hit.h"
#include "Accel/Structures/KdTreeNodes.h"

#include <functional>
#include <vector>

namespace lumitree
{

/// A triangle in a cell while a KD-tree is built.
struct KdReference
{
  Box bounds; ///< of its part inside the cell, rounded outward
  PrimitiveId id = noPrimitive;
};

/// A plane that divides a cell.
struct KdSplit
{
  int axis = -1; ///< -1: do not divide
  double position = 0.0;
  bool inPlaneBelow = true; ///< what lies in the plane goes below it, else above
};

using KdSplitter =
  std::function<KdSplit(const Box& cell, const std::vector<KdReference>& references)>;

/// The textbook's split: the cell's longest axis, in the middle, until leafSize or fewer are left.
[[nodiscard]] KdSplitter spatialMedianSplitter(int leafSize);

/// The surface-area heuristic over all planes at which the bounds of a reference begin or end (Wald
/// and Havran, "On building fast kd-trees for ray tracing, and on doing that in O(N log N)", 2006,
/// sections 3 and 4.2), with their rule for triangles in the plane and their bonus for cutting off
/// empty space. Sorting per node makes the whole build O(n log² n).
[[nodiscard]] KdSplitter kdSahSplitter();

} // namespace lumitree

#endif
