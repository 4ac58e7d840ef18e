// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_PlaneWalk_h
#define Lumitree_Accel_Structures_PlaneWalk_h

#include "Accel/Kernel/RayBox.h"
#include "Accel/Kernel/Span.h"

namespace lumitree
{

/// Where a ray crosses the plane of a node: which side it is on first, and bounds of t. NaN where
/// the plane does not constrain it.
struct PlaneCrossing
{
  bool nearAbove;
  double low;
  double high;
};

/// Takes a ray through a tree of cells divided by planes, the nearer child first. `isLeaf(node)`
/// tells leaves, whose `first` and `count` are blocks and primitives; of others the child below the
/// plane is `first`, the one above it follows. `cross(node)` gives the PlaneCrossing.
///
/// Each cell is met over an interval of t that holds all t of the segment inside the closed cell: a
/// plane's padded bounds cut the near child's end and the far child's beginning. Where the plane
/// does not constrain, both children keep the whole interval. So each leaf that the exact segment
/// meets is visited, with a certified beginning. A cell that begins at the nearest hit so far is
/// still visited; where a hit lies is nobody's business here.
template <class Tree, class IsLeaf, class Cross, class Visitor>
void walkPlanes(
  const Tree& tree, const RayBox& ray, const IsLeaf& isLeaf, const Cross& cross, Visitor& visitor)
{
  struct Entry
  {
    std::uint32_t node;
    double tEnter;
    double tExit;
  };
  // At most one far child waits per level, and no node lies deeper than 64.
  Entry stack[65];
  int height = 0;
  Entry current = { 0, 0.0, 0.0 };
  double tStop = visitor.tStop();
  if (!ray.meets(tree.cell, tStop, current.tEnter, current.tExit))
  {
    return;
  }
  while (true)
  {
    visitor.node(current.node);
    const auto& node = tree.nodes[current.node];
    if (!isLeaf(node))
    {
      const PlaneCrossing crossing = cross(node);
      const std::uint32_t nearAbove = crossing.nearAbove ? 1 : 0;
      // Comparisons with NaN leave the interval as it is.
      const Entry nearChild = { node.first + nearAbove, current.tEnter,
        crossing.high < current.tExit ? crossing.high : current.tExit };
      const Entry farChild = { node.first + 1 - nearAbove,
        crossing.low > current.tEnter ? crossing.low : current.tEnter, current.tExit };
      // low <= high, so a ray that does not meet the near child meets the far one; or it runs
      // beside the plane, on the near side.
      if (!(nearChild.tEnter <= nearChild.tExit))
      {
        current = farChild;
        continue;
      }
      if (farChild.tEnter <= farChild.tExit && farChild.tEnter <= tStop)
      {
        stack[height++] = farChild;
      }
      current = nearChild;
      continue;
    }
    if (node.count > 0)
    {
      tStop = visitor.leaf({ node.first, node.count, current.tEnter });
    }
    do
    {
      if (height == 0)
      {
        return;
      }
      current = stack[--height];
    } while (current.tEnter > tStop);
  }
}

} // namespace lumitree

#endif
