// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/BvhSave.h"

#include "Accel/Structures/BvhLeaves.h"

namespace lumitree
{
namespace
{

constexpr std::uint8_t leafMark = 3;
constexpr int depthLimit = 64;

/// The leaves, in the order of nodes; with their boxes if these matter.
BvhLeaves leavesOf(const BvhNodes& bvh, bool parts)
{
  BvhLeaves leaves;
  leaves.references.reserve(bvh.references.size());
  for (const BvhNode& node : bvh.nodes)
  {
    if (node.leaf)
    {
      const auto first = bvh.references.begin() + node.first;
      leaves.sizes.push_back(node.count);
      leaves.references.insert(leaves.references.end(), first, first + node.count);
      if (parts)
      {
        leaves.boxes.push_back(node.box);
      }
    }
  }
  return leaves;
}

/// Puts leaves into their nodes and boxes around all.
void assemble(BvhNodes& bvh, BvhLeaves&& leaves)
{
  std::size_t leaf = 0;
  std::uint32_t first = 0;
  for (BvhNode& node : bvh.nodes)
  {
    node.box = Box{};
    if (node.leaf)
    {
      node.first = first;
      node.count = leaves.sizes[leaf];
      node.box = leaves.boxes[leaf++];
      first += node.count;
    }
  }
  bvh.references = std::move(leaves.references);
  boundFromBelow(bvh);
}

} // namespace

void saveBvh(const BvhNodes& bvh, bool parts, SaveWriter& writer)
{
  writer.put(std::uint64_t{ bvh.nodes.size() });
  std::vector<std::uint32_t> children;
  for (const BvhNode& node : bvh.nodes)
  {
    writer.put(node.leaf ? leafMark : static_cast<std::uint8_t>(node.axis));
    if (!node.leaf)
    {
      children.push_back(node.first);
    }
  }
  writer.putAll(children);
  saveLeaves(leavesOf(bvh, parts), writer);
}

BvhNodes loadBvh(const Surface& surface, bool parts, SaveReader& reader, BuildProgress& progress)
{
  const std::vector<std::uint8_t> kinds = reader.getAll<std::uint8_t>(reader.get<std::uint64_t>());
  require(kinds.size() % 2 == 1 && kinds.size() < noPrimitive, "it has no such number of nodes");
  const std::vector<std::uint32_t> children = reader.getAll<std::uint32_t>(kinds.size() / 2);
  BvhNodes bvh;
  bvh.nodes.resize(kinds.size());
  std::vector<std::uint8_t> depths(kinds.size(), 0);
  std::vector<bool> taken(kinds.size(), false);
  std::size_t interior = 0;
  for (std::size_t i = 0; i < kinds.size(); ++i)
  {
    require(kinds[i] <= leafMark, "a node is split along no axis");
    if (kinds[i] == leafMark)
    {
      continue;
    }
    require(interior < children.size(), "it has more inner nodes than children for them");
    const std::size_t first = children[interior++];
    require(first > i && first < kinds.size() - 1 && !taken[first] && !taken[first + 1],
      "its nodes are no tree");
    require(depths[i] < depthLimit, "it is deeper than 64");
    taken[first] = taken[first + 1] = true;
    depths[first] = depths[first + 1] = static_cast<std::uint8_t>(depths[i] + 1);
    bvh.nodes[i].leaf = false;
    bvh.nodes[i].axis = static_cast<std::int8_t>(kinds[i]);
    bvh.nodes[i].first = static_cast<std::uint32_t>(first);
  }
  // As many pairs of children as inner nodes, none twice: each node but the root has one parent.
  require(interior == children.size(), "its nodes are no tree");
  BvhLeaves leaves = loadLeaves(surface, kinds.size() - interior, parts, reader);
  fitBoxes(surface, leaves, progress);
  assemble(bvh, std::move(leaves));
  return bvh;
}

BvhNodes refitBvh(const Surface& surface, const BvhNodes& before, BuildProgress& progress)
{
  BvhLeaves leaves = leavesOf(before, false);
  keepHittable(surface, leaves);
  fitBoxes(surface, leaves, progress);
  BvhNodes bvh;
  bvh.nodes = before.nodes;
  assemble(bvh, std::move(leaves));
  return bvh;
}

} // namespace lumitree
