// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/WideBvhTopology.h"

#include "Accel/Structures/WideBvhView.h"

namespace lumitree
{
namespace
{

constexpr int depthLimit = 64;

/// Whether it names each of the eight lanes once.
bool isOrder(std::uint32_t order)
{
  unsigned lanes = 0;
  for (int i = 0; i < wideArity; ++i, order >>= 4)
  {
    lanes |= 1u << (order & 15u);
  }
  return lanes == 0xff;
}

} // namespace

WideBvhTopology topologyOf(const WideBvhNodes& tree, const LeafBlocks& blocks, bool parts)
{
  WideBvhTopology topology;
  topology.nodes.reserve(tree.nodes.size());
  std::visit(
    [&](const auto& store)
    {
      for (const WideBvhNode& node : tree.nodes)
      {
        WideBvhTopology::Node kept;
        for (int lane = 0; lane < wideArity && isUsed(node, lane); ++lane)
        {
          ++kept.children;
          const WideChild child(node.child[lane]);
          if (!child.isLeaf())
          {
            continue;
          }
          kept.leafLanes = static_cast<std::uint8_t>(kept.leafLanes | 1u << lane);
          const std::uint32_t count = tree.countOf(child);
          topology.leaves.sizes.push_back(count);
          for (std::uint32_t i = 0; i < count; ++i)
          {
            topology.leaves.references.push_back(
              store[child.firstBlock() + i / blockWidth].id[i % blockWidth]);
          }
          if (parts)
          {
            topology.leaves.boxes.push_back(boxOf(tree.frame, node, lane));
          }
        }
        std::copy_n(node.order, 8, kept.order.begin());
        topology.nodes.push_back(kept);
      }
    },
    blocks);
  return topology;
}

void saveTopology(const WideBvhTopology& topology, SaveWriter& writer)
{
  writer.put(std::uint64_t{ topology.nodes.size() });
  for (const WideBvhTopology::Node& node : topology.nodes)
  {
    writer.put(node.children);
    writer.put(node.leafLanes);
    for (const std::uint32_t order : node.order)
    {
      writer.put(order);
    }
  }
  saveLeaves(topology.leaves, writer);
}

WideBvhTopology loadTopology(const Surface& surface, bool parts, SaveReader& reader)
{
  constexpr std::size_t nodeSize = 2 + 8 * sizeof(std::uint32_t);
  const auto count = reader.get<std::uint64_t>();
  require(count <= reader.left() / nodeSize, "it ends too early");
  WideBvhTopology topology;
  topology.nodes.resize(static_cast<std::size_t>(count));
  std::vector<std::uint8_t> depths(topology.nodes.size(), 0);
  std::size_t met = 1;
  std::size_t leaves = 0;
  for (std::size_t n = 0; n < topology.nodes.size(); ++n)
  {
    WideBvhTopology::Node& node = topology.nodes[n];
    node.children = reader.get<std::uint8_t>();
    node.leafLanes = reader.get<std::uint8_t>();
    require(node.children >= 1 && node.children <= wideArity, "a node has no such children");
    require(node.leafLanes >> node.children == 0, "a leaf is in a lane without a child");
    for (std::uint32_t& order : node.order)
    {
      order = reader.get<std::uint32_t>();
      require(isOrder(order), "an order of lanes leaves one out");
    }
    // Children come after their parents, so that there is no circle and everything hangs together.
    require(n < met, "its nodes are no tree");
    for (unsigned lane = 0; lane < node.children; ++lane)
    {
      if ((node.leafLanes >> lane & 1u) != 0)
      {
        ++leaves;
        continue;
      }
      require(met < topology.nodes.size(), "its nodes are no tree");
      depths[met] = static_cast<std::uint8_t>(depths[n] + 1);
      require(depths[met++] < depthLimit, "it is deeper than 64");
    }
  }
  require(topology.nodes.empty() || met == topology.nodes.size(), "its nodes are no tree");
  topology.leaves = loadLeaves(surface, leaves, parts, reader);
  return topology;
}

} // namespace lumitree
