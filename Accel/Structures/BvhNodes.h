// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BvhNodes_h
#define Lumitree_Accel_Structures_BvhNodes_h

#include "Accel/Box.h"
#include "Accel/BuildProgress.h"
#include "Accel/Structures/BvhTree.h"
#include "Accel/Surface.h"

#include <cstdint>
#include <vector>

namespace lumitree
{

/// A node of a binary hierarchy. Interior: count is 0, first is the left child, the right one
/// follows it. Leaf: count references from first on. Boxes are those of the stored coordinates,
/// exactly (a float is a double).
struct BvhNode
{
  Box box;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  std::int8_t axis = -1; ///< split axis of an interior node
  bool leaf = true;
};

/// Node 0 is the root; children come after their parent, side by side.
struct BvhNodes
{
  std::vector<BvhNode> nodes;
  std::vector<PrimitiveId> references; ///< in the order of the leaves
};

/// The nodes of a tree as built, with their boxes in double: those of the primitives' coordinates,
/// or, where these are clipped, the tree's own, outward.
[[nodiscard]] BvhNodes exactBvhNodes(
  const Surface& surface, BvhTree&& tree, BuildProgress& progress);

/// Makes the boxes of inner nodes those of what lies below.
void boundFromBelow(BvhNodes& bvh);

/// Makes the boxes those of the surface's coordinates, from the leaves up.
void refitBoxes(const Surface& surface, BvhNodes& bvh, BuildProgress& progress);

} // namespace lumitree

#endif
