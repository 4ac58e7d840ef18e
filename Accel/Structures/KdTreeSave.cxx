// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/KdTreeSave.h"

#include "Accel/Structures/CellSave.h"
#include "Accel/Structures/KdTreeDivide.h"

namespace lumitree
{
namespace
{

/// A node in a byte: its axis (or that it is a leaf), and where what lies in its plane goes.
constexpr std::uint8_t axisBits = 3;
constexpr std::uint8_t leafKind = 3;
constexpr std::uint8_t aboveBit = 4;

struct Task
{
  Box cell;
  std::vector<KdReference> references;
  std::uint32_t node;
  int depth;
};

SavedDivisions readDivisions(SaveReader& reader)
{
  auto kinds = reader.getAll<std::uint8_t>(reader.get<std::uint64_t>());
  auto positions = reader.getAll<double>(kinds.size() / 2);
  return { std::move(kinds), std::move(positions) };
}

/// The plane of the next node; its axis is -1 for a leaf.
KdSplit nextSplit(SavedDivisions& divisions)
{
  const std::uint8_t kind = divisions.kind();
  require(kind <= (axisBits | aboveBit), "a node is split along no axis");
  KdSplit split;
  if ((kind & axisBits) != leafKind)
  {
    split.axis = kind & axisBits;
    split.position = divisions.number();
    split.inPlaneBelow = (kind & aboveBit) == 0;
  }
  return split;
}

} // namespace

void saveKdTree(
  const Surface& surface, const KdTreeNodes& tree, const LeafBlocks& blocks, SaveWriter& writer)
{
  const PlanesAbove planes = planesAbove(
    surface, tree, blocks, [](const KdNode& node) { return node.isLeaf(); },
    [](const KdNode& node)
    { return std::make_pair(static_cast<int>(node.axis), static_cast<double>(node.position)); });
  std::vector<std::uint8_t> kinds;
  std::vector<double> positions;
  std::vector<std::uint32_t> waiting = { 0 };
  while (!waiting.empty())
  {
    const std::uint32_t i = waiting.back();
    waiting.pop_back();
    const KdNode& node = tree.nodes[i];
    kinds.push_back(node.isLeaf()
        ? leafKind
        : static_cast<std::uint8_t>(node.axis | (planes.inPlaneAbove(i) ? aboveBit : 0u)));
    if (!node.isLeaf())
    {
      positions.push_back(node.position);
      waiting.push_back(node.first + 1);
      waiting.push_back(node.first);
    }
  }
  writer.put(std::uint64_t{ kinds.size() });
  writer.putAll(kinds);
  writer.putAll(positions);
}

KdTreeNodes loadKdTree(
  const Surface& surface, LeafBlocks& blocks, BuildProgress& progress, SaveReader& reader)
{
  SavedDivisions divisions = readDivisions(reader);
  KdTreeNodes tree;
  tree.cell = surface.bounds();
  tree.nodes.reserve(divisions.nodes());
  tree.nodes.emplace_back();
  std::vector<Task> tasks;
  tasks.push_back({ tree.cell, rootReferences(surface), 0, 0 });
  std::size_t left = mostReferences(surface);
  progress.stage(0.99, divisions.nodes());
  while (!tasks.empty())
  {
    const Task task = std::move(tasks.back());
    tasks.pop_back();
    progress.advance(1);
    const KdSplit split = nextSplit(divisions);
    if (split.axis < 0)
    {
      require(task.references.size() <= KdNode::largestLeaf,
        "it has more references than any builder makes");
      loadLeaf(surface, task.references, blocks, left, tree.nodes[task.node]);
      continue;
    }
    const auto axis = static_cast<std::size_t>(split.axis);
    require(task.cell.lower[axis] <= split.position && split.position <= task.cell.upper[axis],
      "a plane lies outside its cell");
    require(task.depth < cellDepthLimit, "it is deeper than 64");
    KdSides sides = divideReferences(surface, task.cell, task.references, split);
    const KdCells cells(task.cell, axis, split.position);
    const auto first = static_cast<std::uint32_t>(tree.nodes.size());
    require(first + 2 <= divisions.nodes(), "its nodes are no tree");
    KdNode& node = tree.nodes[task.node];
    node.axis = static_cast<std::uint32_t>(axis) & 3u;
    node.position = split.position;
    node.first = first;
    tree.nodes.resize(first + 2);
    tasks.push_back({ cells.above, std::move(sides.above), first + 1, task.depth + 1 });
    tasks.push_back({ cells.below, std::move(sides.below), first, task.depth + 1 });
  }
  require(divisions.atEnd(), "its nodes are no tree");
  return tree;
}

} // namespace lumitree
