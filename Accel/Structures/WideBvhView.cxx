// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/WideBvhView.h"

namespace lumitree
{
namespace
{

template <class T>
void appendReferences(const TriangleBlocks<T>& blocks, std::uint32_t first, std::uint32_t count,
  std::vector<PrimitiveId>& references)
{
  for (std::uint32_t i = 0; i < count; ++i)
  {
    references.push_back(blocks[first + i / blockWidth].id[i % blockWidth]);
  }
}

} // namespace

Box boxOf(const WideBvhFrame& frame, const WideBvhNode& node, int lane)
{
  Box box;
  for (int k = 0; k < 3; ++k)
  {
    box.lower[k] = frame.centre[k] + static_cast<double>(node.planes[k][lane]) / frame.scale;
    box.upper[k] = frame.centre[k] + static_cast<double>(node.planes[k + 3][lane]) / frame.scale;
  }
  return box;
}

HierarchyView viewWideBvh(const WideBvhNodes& tree, const LeafBlocks& blocks)
{
  HierarchyView view;
  view.nodes.resize(1);
  view.nodes[0].leaf = tree.nodes.empty();
  // The children of node n stand side by side from firstId[n] on, nodes in ascending order: as they
  // are met here.
  std::vector<std::size_t> idOf(tree.nodes.size(), 0);
  for (std::size_t n = 0; n < tree.nodes.size(); ++n)
  {
    const WideBvhNode& node = tree.nodes[n];
    for (int lane = 0; lane < wideArity && isUsed(node, lane); ++lane)
    {
      HierarchyNode child;
      child.box = boxOf(tree.frame, node, lane);
      child.parent = static_cast<std::int64_t>(idOf[n]);
      child.depth = view.nodes[idOf[n]].depth + 1;
      const WideChild kind(node.child[lane]);
      child.leaf = kind.isLeaf();
      if (child.leaf)
      {
        child.firstReference = static_cast<std::uint32_t>(view.references.size());
        child.referenceCount = tree.countOf(kind);
        std::visit([&](const auto& store)
          { appendReferences(store, kind.firstBlock(), child.referenceCount, view.references); },
          blocks);
      }
      else
      {
        idOf[kind.nodeIndex()] = view.nodes.size();
      }
      if (n == 0)
      {
        view.nodes[0].box.extend(child.box);
      }
      view.nodes.push_back(child);
    }
  }
  completeHierarchy(view);
  return view;
}

BuildStatistics statisticsOf(const WideBvhNodes& tree, const Surface& surface)
{
  BuildStatistics s;
  s.nodes = 1;
  s.leaves = tree.nodes.empty() ? 1 : 0;
  std::vector<int> depths(tree.nodes.size(), 0);
  Box root;
  double area = 0.0;
  for (std::size_t n = 0; n < tree.nodes.size(); ++n)
  {
    const WideBvhNode& node = tree.nodes[n];
    for (int lane = 0; lane < wideArity && isUsed(node, lane); ++lane)
    {
      const Box box = boxOf(tree.frame, node, lane);
      const WideChild child(node.child[lane]);
      const bool leaf = child.isLeaf();
      const std::uint32_t count = leaf ? tree.countOf(child) : 0;
      const int depth = depths[n] + 1;
      ++s.nodes;
      s.leaves += leaf ? 1 : 0;
      s.depth = std::max(s.depth, depth);
      s.references += count;
      area += box.area() * (leaf ? leafCost(count) : 1.0);
      if (!leaf)
      {
        depths[child.nodeIndex()] = depth;
      }
      if (n == 0)
      {
        root.extend(box);
      }
    }
  }
  s.sahCost = root.area() > 0.0 ? (root.area() + area) / root.area() : 0.0;
  s.duplication = duplicationOf(s.references, surface);
  return s;
}

} // namespace lumitree
