// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BspBuilder_h
#define Lumitree_Accel_Structures_BspBuilder_h

#include "Accel/BuildOptions.h"
#include "Accel/BuildProgress.h"
#include "Accel/Kernel/LeafBlocks.h"
#include "Accel/Structures/BspNodes.h"
#include "Accel/Surface.h"

namespace lumitree
{

/// No tree holds more references than this many times the triangles.
inline constexpr std::size_t bspReferencesPerTriangle = 8;

/// Costs of a step down, in tests of a block of four triangles: any plane takes more than one
/// across an axis.
///@{
inline constexpr double bspAxisStepCost = 0.75;
inline constexpr double bspPlaneStepCost = 1.0;
///@}

/// Builds a BSP-tree by the surface-area heuristic over the cells' true areas (Ize, Wald & Parker
/// 2008, "Ray tracing with the BSP tree"): among the best plane across an axis, as a KD-tree would
/// choose it, and planes just beside triangles of the cell, at most 16 of them, and none where
/// there are more than 4096 triangles. Divides until that does not pay, a node lies min(maxDepth, 8
/// + 1.3 log2 n) deep, or its share of the references allowed is used up. Deterministic.
///
/// A triangle is held on one side alone only if it is certain to lie there: its vertices by more
/// than PlaneDistance's margin, or the part of it that is in the cell.
[[nodiscard]] BspNodes buildBspNodes(
  const Surface& surface, const BuildOptions& options, LeafBlocks& blocks, BuildProgress& progress);

} // namespace lumitree

#endif
