// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_KdTreeWalk_h
#define Lumitree_Accel_Structures_KdTreeWalk_h

#include "Accel/Kernel/RayBox.h"
#include "Accel/Kernel/Span.h"
#include "Accel/Structures/KdTreeNodes.h"

namespace lumitree
{

/// Takes a ray through a KD-tree, the nearer child first.
///
/// Each cell is met over an interval of t that holds all t of the segment inside the closed cell: a
/// plane's padded bounds cut the near child's end and the far child's beginning. Where the plane
/// does not constrain (NaN: a ray in the plane) both children keep the whole interval. So each leaf
/// that the exact segment meets is visited, with a certified beginning. A cell that begins at the
/// nearest hit so far is still visited; where a hit lies is nobody's business here.
template <class Visitor>
void walkKdTree(const KdTreeNodes& tree, const RayBox& ray, Visitor& visitor)
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
    const KdNode& node = tree.nodes[current.node];
    if (!node.isLeaf())
    {
      double tLow;
      double tHigh;
      ray.crosses(node.axis, node.position, tLow, tHigh);
      const std::uint32_t nearAbove = ray.negative(node.axis) ? 1 : 0;
      const Entry nearChild = { node.first + nearAbove, current.tEnter,
        tHigh < current.tExit ? tHigh : current.tExit };
      const Entry farChild = { node.first + 1 - nearAbove,
        tLow > current.tEnter ? tLow : current.tEnter, current.tExit };
      // tLow <= tHigh, so a ray that does not meet the near child meets the far one.
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
