// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/WideBvhFill.h"

#include "Accel/Structures/WideBvhCollapse.h"
#include "Accel/Structures/WideBvhOrder.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace lumitree
{
namespace
{

constexpr std::size_t chunk = 1024;

/// A stretch of a tree's references.
struct Range
{
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// The references below each binary node: those of its leaves, which lie side by side.
std::vector<Range> rangesOf(const BvhTree& bvh)
{
  std::vector<Range> ranges(bvh.nodes.size());
  for (std::size_t i = bvh.nodes.size(); i-- > 0;)
  {
    const BvhTreeNode& node = bvh.nodes[i];
    ranges[i] = node.isLeaf()
      ? Range{ node.first, node.count() }
      : Range{ ranges[node.first].first, ranges[node.first].count + ranges[node.first + 1].count };
  }
  return ranges;
}

/// What a kept node has become.
struct Place
{
  Range range;              ///< leaf: its primitives
  std::uint32_t number = 0; ///< leaf: its first block; else its node
};

} // namespace

WideBvhNode emptyWideNode()
{
  WideBvhNode node{};
  for (int k = 0; k < 3; ++k)
  {
    std::fill_n(node.planes[k], wideArity, std::numeric_limits<float>::infinity());
    std::fill_n(node.planes[k + 3], wideArity, -std::numeric_limits<float>::infinity());
  }
  return node;
}

void requireRoomFor(std::uint32_t blocks)
{
  if (blocks > WideChild::maxBlock)
  {
    throw std::length_error(
      "a wide BVH has room for 2^27 blocks of primitives; these need " + std::to_string(blocks));
  }
}

WideBvhNodes fillWideBvh(const Surface& surface, BvhTree&& binary, int leafSize, LeafBlocks& blocks,
  BuildProgress& progress)
{
  const std::vector<CollapsedNode> kept = collapse(binary, leafSize);
  progress.stage(0.8, 2 * kept.size());
  std::vector<Place> places(kept.size());
  {
    const std::vector<Range> ranges = rangesOf(binary);
    progress.forEach(kept.size(), chunk,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          if (kept[i].leaf)
          {
            // Ascending, so that a leaf does not depend on how its node came about, and once each.
            Range range = ranges[kept[i].binary];
            PrimitiveId* const ids = binary.references.data() + range.first;
            std::sort(ids, ids + range.count);
            range.count = static_cast<std::uint32_t>(std::unique(ids, ids + range.count) - ids);
            places[i].range = range;
          }
        }
      });
  }
  std::uint32_t nodeCount = 0;
  std::uint32_t blockCount = 0;
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    places[i].number = kept[i].leaf ? blockCount : nodeCount;
    blockCount += (places[i].range.count + blockWidth - 1) / blockWidth;
    nodeCount += kept[i].leaf ? 0 : 1;
  }

  requireRoomFor(blockCount);
  WideBvhNodes tree;
  tree.frame = binary.frame;
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    if (kept[i].leaf && places[i].range.count > WideChild::maxCount)
    {
      tree.largeLeaves.emplace_back(places[i].number, places[i].range.count);
    }
  }
  tree.nodes.resize(nodeCount);
  tree.firstId.resize(nodeCount);
  std::visit([&](auto& store) { store.resize(blockCount); }, blocks);
  progress.stage(0.99, kept.size());
  progress.forEach(kept.size(), chunk,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const CollapsedNode& node = kept[i];
        const Place& place = places[i];
        if (node.leaf)
        {
          std::visit(
            [&](auto& store)
            {
              store.put(place.number, surface, binary.references.data() + place.range.first,
                place.range.count);
            },
            blocks);
          continue;
        }
        WideBvhNode wide = emptyWideNode();
        for (std::uint32_t lane = 0; lane < node.childCount; ++lane)
        {
          const std::size_t child = node.firstChild + lane;
          const BvhTreeNode& box = binary.nodes[kept[child].binary];
          for (int k = 0; k < 3; ++k)
          {
            wide.planes[k][lane] = box.lower[k];
            wide.planes[k + 3][lane] = box.upper[k];
          }
          wide.child[lane] =
            (kept[child].leaf ? WideChild::leaf(places[child].number, places[child].range.count)
                              : WideChild::node(places[child].number))
              .bits();
        }
        orderLanes(binary, kept, node, wide);
        tree.nodes[place.number] = wide;
        tree.firstId[place.number] = node.firstChild;
      }
    });
  return tree;
}

} // namespace lumitree
