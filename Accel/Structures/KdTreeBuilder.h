// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_KdTreeBuilder_h
#define Lumitree_Accel_Structures_KdTreeBuilder_h

#include "Accel/BuildOptions.h"
#include "Accel/BuildProgress.h"
#include "Accel/Kernel/LeafBlocks.h"
#include "Accel/Structures/KdTreeNodes.h"
#include "Accel/Surface.h"

namespace lumitree
{

/// No tree holds more references than this many times the triangles.
inline constexpr std::size_t kdReferencesPerTriangle = 8;

/// Divides from the root on until kdBuild's rule stops (KdTreeSplitters.h), a node lies
/// min(maxDepth, 8 + 1.3 log2 n) deep, or its share of the references allowed is used up.
/// Deterministic. O(n log n): bounds are sorted once; who divides a cell keeps their order. The
/// nodes at the top are divided level by level, the subtrees below them side by side; which these
/// are depends on the number of triangles alone, so the tree is the same for any number of threads.
///
/// Every point of a triangle lies in a closed leaf that holds the triangle. A triangle that touches
/// a plane from one side only is held on that side only, one in the plane on the side that the
/// splitter says: rays that come as near to the plane as rounding can tell visit both sides.
[[nodiscard]] KdTreeNodes buildKdTreeNodes(
  const Surface& surface, const BuildOptions& options, LeafBlocks& blocks, BuildProgress& progress);

} // namespace lumitree

#endif
