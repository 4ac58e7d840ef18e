// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/BspView.h"

#include "Accel/Structures/BspBuilder.h"
#include "Accel/Structures/BspFrame.h"
#include "Accel/Structures/ConvexPolyhedron.h"
#include "Accel/Structures/KdTreeClip.h"

namespace lumitree
{
HierarchyView viewBspTree(const BspNodes& tree, const LeafBlocks& blocks)
{
  HierarchyView view;
  view.axisStepCost = bspAxisStepCost;
  view.stepCost = bspPlaneStepCost;
  view.nodes.resize(tree.nodes.size());
  view.polyhedra.resize(tree.nodes.size());
  const WideBvhFrame frame = bspFrameOf(tree.cell);
  std::vector<Polyhedron> framed(tree.nodes.size());
  if (!tree.cell.empty())
  {
    framed[0] = framedRoot(frame, tree.cell);
  }
  for (std::size_t i = 0; i < tree.nodes.size(); ++i)
  {
    const BspNode& node = tree.nodes[i];
    HierarchyNode& shown = view.nodes[i];
    Polyhedron& polyhedron = framed[i];
    shown.leaf = node.leaf;
    if (node.leaf)
    {
      shown.firstReference = static_cast<std::uint32_t>(view.references.size());
      shown.referenceCount = node.count;
      for (std::uint32_t r = 0; r < node.count; ++r)
      {
        view.references.push_back(primitiveAt(blocks, node.first, r));
      }
    }
    else
    {
      shown.splitAxis = node.axis;
      shown.splitPosition = node.axis >= 0 ? node.offset : 0.0;
      // The builder made the same cut.
      auto parts =
        cutPolyhedron(polyhedron, node.normal, framedOffset(frame, node.normal, node.offset));
      framed[node.first] = std::move(parts->first);
      framed[node.first + 1] = std::move(parts->second);
      for (std::size_t child = node.first; child < node.first + 2; ++child)
      {
        view.nodes[child].parent = static_cast<std::int64_t>(i);
        view.nodes[child].depth = shown.depth + 1;
      }
    }
    if (!tree.cell.empty())
    {
      shown.box = i == 0 ? tree.cell : commonBox(boxAround(frame, polyhedron), tree.cell);
    }
    unframe(frame, polyhedron);
    view.polyhedra[i] = std::move(polyhedron);
  }
  completeHierarchy(view);
  return view;
}

} // namespace lumitree
