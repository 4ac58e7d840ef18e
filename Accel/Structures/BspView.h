// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BspView_h
#define Lumitree_Accel_Structures_BspView_h

#include "Accel/Hierarchy.h"
#include "Accel/Kernel/LeafBlocks.h"
#include "Accel/Structures/BspNodes.h"

namespace lumitree
{

/// The tree as a flat list of nodes, each with its polyhedron. Boxes have a margin of 2^-40 of the
/// coordinates around the polyhedron, inside the root's.
[[nodiscard]] HierarchyView viewBspTree(const BspNodes& tree, const LeafBlocks& blocks);

} // namespace lumitree

#endif
