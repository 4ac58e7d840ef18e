// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BvhTree_h
#define Lumitree_Accel_Structures_BvhTree_h

#include "Accel/Hit.h"
#include "Accel/Structures/WideBvhNodes.h"

#include <cstdint>
#include <vector>

namespace lumitree
{

/// A node of a binary hierarchy as builders make it, with its box in the tree's frame.
struct BvhTreeNode
{
  float lower[3];
  std::uint32_t first; ///< interior: the left child, the right one follows; leaf: of its references
  float upper[3];
  std::uint32_t content; ///< leaf: number of references; interior: interiorMark + split axis

  static constexpr std::uint32_t interiorMark = 0x80000000u;

  [[nodiscard]] bool isLeaf() const { return this->content < interiorMark; }
  [[nodiscard]] std::uint32_t count() const { return this->isLeaf() ? this->content : 0; }
  [[nodiscard]] int axis() const
  {
    return this->isLeaf() ? -1 : static_cast<int>(this->content - interiorMark);
  }
  [[nodiscard]] float halfArea() const
  {
    const float x = this->upper[0] - this->lower[0];
    const float y = this->upper[1] - this->lower[1];
    const float z = this->upper[2] - this->lower[2];
    return x * y + y * z + z * x;
  }
};

/// Node 0 is the root; children come after their parent, side by side. The references below a node
/// are one stretch, ascending and without repetition within a leaf.
struct BvhTree
{
  WideBvhFrame frame;
  std::vector<BvhTreeNode> nodes;
  std::vector<PrimitiveId> references;
  bool clipped = false; ///< boxes may hold parts of primitives only (spatial splits)
};

} // namespace lumitree

#endif
