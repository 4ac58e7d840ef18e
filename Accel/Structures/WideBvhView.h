// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_WideBvhView_h
#define Lumitree_Accel_Structures_WideBvhView_h

#include "Accel/BuildOptions.h"
#include "Accel/Hierarchy.h"
#include "Accel/Kernel/LeafBlocks.h"
#include "Accel/Structures/WideBvhNodes.h"
#include "Accel/Surface.h"

namespace lumitree
{

/// Whether there is a child in that lane.
[[nodiscard]] inline bool isUsed(const WideBvhNode& node, int lane)
{
  return node.planes[0][lane] <= node.planes[3][lane];
}

/// A child's box, out of the frame.
[[nodiscard]] Box boxOf(const WideBvhFrame& frame, const WideBvhNode& node, int lane);

/// The tree as a flat list of nodes, with the boxes that its walk uses (outward in float, so a
/// little larger than tight).
[[nodiscard]] HierarchyView viewWideBvh(const WideBvhNodes& tree, const LeafBlocks& blocks);

/// What describe says of the view, without making it.
[[nodiscard]] BuildStatistics statisticsOf(const WideBvhNodes& tree, const Surface& surface);

} // namespace lumitree

#endif
