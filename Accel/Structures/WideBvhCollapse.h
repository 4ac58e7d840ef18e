// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_WideBvhCollapse_h
#define Lumitree_Accel_Structures_WideBvhCollapse_h

#include "Accel/Structures/BvhTree.h"

#include <cstdint>
#include <vector>

namespace lumitree
{

/// A node of the collapsed tree: a node of the binary tree that is kept, as a leaf of all
/// primitives below it or with up to eight children, which stand side by side. Parents come before
/// their children; node 0 is the root, never a leaf.
struct CollapsedNode
{
  std::uint32_t binary = 0;
  bool leaf = true;
  std::uint32_t firstChild = 0;
  std::uint32_t childCount = 0;
};

/// Collapses a binary hierarchy to one of eight children a node at the least surface-area cost that
/// its boxes allow (Ylitie, Karras & Laine 2017, section 3.1, by dynamic programming): a node costs
/// its area, a leaf of at most leafSize primitives its area times its blocks of four. Of siblings
/// those that cost a ray least come last: where any hit will do, they are the ones to look at first
/// (as in Ogaki & Derouet-Jourdan 2016, "An N-ary BVH child node sorting technique for occlusion
/// test").
[[nodiscard]] std::vector<CollapsedNode> collapse(const BvhTree& bvh, int leafSize);

} // namespace lumitree

#endif
