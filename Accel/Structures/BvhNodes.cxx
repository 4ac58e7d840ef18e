// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/BvhNodes.h"

#include "Accel/Structures/BvhFrame.h"

namespace lumitree
{
namespace
{

constexpr std::size_t chunk = 4096;

Box boxOf(const WideBvhFrame& frame, const BvhTreeNode& node)
{
  Box box;
  for (int k = 0; k < 3; ++k)
  {
    box.lower[k] = unframedDown(node.lower[k], frame.centre[k], frame.scale);
    box.upper[k] = unframedUp(node.upper[k], frame.centre[k], frame.scale);
  }
  return box;
}

} // namespace

BvhNodes exactBvhNodes(const Surface& surface, BvhTree&& tree, BuildProgress& progress)
{
  BvhNodes bvh;
  bvh.references = std::move(tree.references);
  bvh.nodes.resize(tree.nodes.size());
  for (std::size_t i = 0; i < tree.nodes.size(); ++i)
  {
    BvhNode& node = bvh.nodes[i];
    node.leaf = tree.nodes[i].isLeaf();
    node.first = tree.nodes[i].first;
    node.count = tree.nodes[i].count();
    node.axis = static_cast<std::int8_t>(tree.nodes[i].axis());
    if (tree.clipped)
    {
      node.box = boxOf(tree.frame, tree.nodes[i]);
    }
  }
  if (!tree.clipped)
  {
    progress.stage(0.8, bvh.nodes.size());
    refitBoxes(surface, bvh, progress);
  }
  return bvh;
}

void refitBoxes(const Surface& surface, BvhNodes& bvh, BuildProgress& progress)
{
  progress.forEach(bvh.nodes.size(), chunk,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        BvhNode& node = bvh.nodes[i];
        node.box = Box{};
        for (std::uint32_t r = 0; r < node.count; ++r)
        {
          node.box.extend(surface.box(bvh.references[node.first + r]));
        }
      }
    });
  boundFromBelow(bvh);
}

void boundFromBelow(BvhNodes& bvh)
{
  // Children come after their parents.
  for (std::size_t i = bvh.nodes.size(); i-- > 0;)
  {
    BvhNode& node = bvh.nodes[i];
    if (!node.leaf)
    {
      node.box.extend(bvh.nodes[node.first].box);
      node.box.extend(bvh.nodes[node.first + 1].box);
    }
  }
}

} // namespace lumitree
