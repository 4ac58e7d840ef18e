// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_KdTreeView_h
#define Lumitree_Accel_Structures_KdTreeView_h

#include "Accel/Hierarchy.h"
#include "Accel/Kernel/LeafBlocks.h"
#include "Accel/Structures/KdTreeNodes.h"

namespace lumitree
{

/// The tree as a flat list of nodes with their cells and planes. A triangle is listed in every leaf
/// that holds it.
[[nodiscard]] HierarchyView viewKdTree(const KdTreeNodes& tree, const LeafBlocks& blocks);

} // namespace lumitree

#endif
