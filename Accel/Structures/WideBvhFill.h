// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_WideBvhFill_h
#define Lumitree_Accel_Structures_WideBvhFill_h

#include "Accel/BuildProgress.h"
#include "Accel/Kernel/LeafBlocks.h"
#include "Accel/Structures/BvhTree.h"
#include "Accel/Structures/WideBvhNodes.h"

namespace lumitree
{

/// A node without children: no ray meets any of its boxes.
[[nodiscard]] WideBvhNode emptyWideNode();

/// Throws std::length_error where a tree has no room for so many blocks.
void requireRoomFor(std::uint32_t blocks);

/// Collapses a binary tree over a surface that is not empty and writes its nodes and the blocks of
/// its leaves. The tree's references are used up.
[[nodiscard]] WideBvhNodes fillWideBvh(const Surface& surface, BvhTree&& binary, int leafSize,
  LeafBlocks& blocks, BuildProgress& progress);

} // namespace lumitree

#endif
