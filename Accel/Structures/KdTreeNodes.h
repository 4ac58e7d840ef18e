// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_KdTreeNodes_h
#define Lumitree_Accel_Structures_KdTreeNodes_h

#include "Accel/Box.h"

#include <cstdint>
#include <vector>

namespace lumitree
{

/// A node of a KD-tree; its cell follows from the planes above it. Interior: first is the child
/// below the plane, the one above it follows. Leaf: count triangles from block first on.
struct KdNode
{
  static constexpr std::uint32_t leafMark = 3;
  static constexpr std::size_t largestLeaf = (std::size_t{ 1 } << 30) - 1;

  double position = 0.0; ///< of the plane; cells are closed, so its points belong to both children
  std::uint32_t first = 0;
  std::uint32_t axis : 2; ///< 0, 1, 2, or leafMark
  std::uint32_t count : 30;

  KdNode()
    : axis(leafMark)
    , count(0)
  {
  }

  [[nodiscard]] bool isLeaf() const { return this->axis == leafMark; }
};

/// Node 0 is the root; children come after their parent, side by side.
struct KdTreeNodes
{
  Box cell; ///< of the root
  std::vector<KdNode> nodes;
};

/// The two parts of a cell.
struct KdCells
{
  Box below;
  Box above;

  KdCells(const Box& cell, std::size_t axis, double position)
    : below(cell)
    , above(cell)
  {
    this->below.upper[axis] = position;
    this->above.lower[axis] = position;
  }
};

} // namespace lumitree

#endif
