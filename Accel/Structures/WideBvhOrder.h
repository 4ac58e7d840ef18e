// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_WideBvhOrder_h
#define Lumitree_Accel_Structures_WideBvhOrder_h

#include "Accel/Structures/WideBvhCollapse.h"
#include "Accel/Structures/WideBvhNodes.h"

namespace lumitree
{

/// Fills in WideBvhNode::order of a node from the binary splits that it was made of.
void orderLanes(const BvhTree& binary, const std::vector<CollapsedNode>& kept,
  const CollapsedNode& node, WideBvhNode& wide);

} // namespace lumitree

#endif
