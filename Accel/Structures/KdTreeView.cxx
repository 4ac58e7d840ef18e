// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/KdTreeView.h"

#include "Accel/Structures/KdTreeSplitters.h"

namespace lumitree
{
HierarchyView viewKdTree(const KdTreeNodes& tree, const LeafBlocks& blocks)
{
  HierarchyView view;
  view.axisStepCost = kdStepCost;
  view.nodes.resize(tree.nodes.size());
  view.nodes[0].box = tree.cell;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i)
  {
    const KdNode& node = tree.nodes[i];
    HierarchyNode& shown = view.nodes[i];
    shown.leaf = node.isLeaf();
    if (shown.leaf)
    {
      shown.firstReference = static_cast<std::uint32_t>(view.references.size());
      shown.referenceCount = node.count;
      for (std::uint32_t r = 0; r < node.count; ++r)
      {
        view.references.push_back(primitiveAt(blocks, node.first, r));
      }
      continue;
    }
    shown.splitAxis = static_cast<std::int32_t>(node.axis);
    shown.splitPosition = node.position;
    const KdCells cells(shown.box, node.axis, node.position);
    view.nodes[node.first].box = cells.below;
    view.nodes[node.first + 1].box = cells.above;
    for (std::size_t child = node.first; child < node.first + 2; ++child)
    {
      view.nodes[child].parent = static_cast<std::int64_t>(i);
      view.nodes[child].depth = shown.depth + 1;
    }
  }
  completeHierarchy(view);
  return view;
}

} // namespace lumitree
