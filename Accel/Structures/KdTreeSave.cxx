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

/// A node on the way through a tree.
struct Step
{
  std::uint32_t node;
  std::size_t depth;
  bool above; ///< of its parent's plane
  std::uint32_t parent;
};

PlanesAbove planesAbove(const Surface& surface, const KdTreeNodes& tree, const LeafBlocks& blocks)
{
  PlanesAbove planes(tree.nodes.size());
  std::vector<Step> waiting = { { 0, 0, false, 0 } };
  while (!waiting.empty())
  {
    const Step step = waiting.back();
    waiting.pop_back();
    if (step.depth > 0)
    {
      const KdNode& parent = tree.nodes[step.parent];
      planes.go(step.depth - 1,
        { step.parent, static_cast<int>(parent.axis), parent.position, step.above });
    }
    const KdNode& node = tree.nodes[step.node];
    if (!node.isLeaf())
    {
      waiting.push_back({ node.first + 1, step.depth + 1, true, step.node });
      waiting.push_back({ node.first, step.depth + 1, false, step.node });
      continue;
    }
    for (std::uint32_t i = 0; i < node.count; ++i)
    {
      planes.found(step.depth, surface.box(primitiveAt(blocks, node.first, i)));
    }
  }
  return planes;
}

/// Reads the planes again, in the order in which they were written.
class Planes
{
public:
  explicit Planes(SaveReader& reader)
    : kinds_(reader.getAll<std::uint8_t>(reader.get<std::uint64_t>()))
    , positions_(reader.getAll<double>(this->kinds_.size() / 2))
  {
  }

  [[nodiscard]] std::size_t nodes() const { return this->kinds_.size(); }

  /// That of the next node; its axis is -1 for a leaf.
  KdSplit next()
  {
    require(this->kind_ < this->kinds_.size(), "its nodes are no tree");
    const std::uint8_t kind = this->kinds_[this->kind_++];
    require(kind <= (axisBits | aboveBit), "a node is split along no axis");
    KdSplit split;
    if ((kind & axisBits) != leafKind)
    {
      require(this->position_ < this->positions_.size(), "its nodes are no tree");
      split.axis = kind & axisBits;
      split.position = this->positions_[this->position_++];
      split.inPlaneBelow = (kind & aboveBit) == 0;
    }
    return split;
  }

  [[nodiscard]] bool atEnd() const
  {
    return this->kind_ == this->kinds_.size() && this->position_ == this->positions_.size();
  }

private:
  std::vector<std::uint8_t> kinds_;
  std::vector<double> positions_;
  std::size_t kind_ = 0;
  std::size_t position_ = 0;
};

} // namespace

void saveKdTree(
  const Surface& surface, const KdTreeNodes& tree, const LeafBlocks& blocks, SaveWriter& writer)
{
  const PlanesAbove planes = planesAbove(surface, tree, blocks);
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
  Planes planes(reader);
  KdTreeNodes tree;
  tree.cell = surface.bounds();
  tree.nodes.reserve(planes.nodes());
  tree.nodes.emplace_back();
  std::vector<Task> tasks;
  tasks.push_back({ tree.cell, rootReferences(surface), 0, 0 });
  std::size_t left = mostReferences(surface);
  progress.stage(0.99, planes.nodes());
  while (!tasks.empty())
  {
    const Task task = std::move(tasks.back());
    tasks.pop_back();
    progress.advance(1);
    const KdSplit split = planes.next();
    if (split.axis < 0)
    {
      const std::vector<PrimitiveId> ids = idsOf(task.references);
      require(ids.size() <= left && ids.size() <= KdNode::largestLeaf,
        "it has more references than any builder makes");
      left -= ids.size();
      KdNode& leaf = tree.nodes[task.node];
      leaf.count = static_cast<std::uint32_t>(ids.size());
      std::visit(
        [&](auto& store) { leaf.first = store.append(surface, ids.data(), ids.size()); }, blocks);
      continue;
    }
    const auto axis = static_cast<std::size_t>(split.axis);
    require(task.cell.lower[axis] <= split.position && split.position <= task.cell.upper[axis],
      "a plane lies outside its cell");
    require(task.depth < cellDepthLimit, "it is deeper than 64");
    KdSides sides = divideReferences(surface, task.cell, task.references, split);
    const KdCells cells(task.cell, axis, split.position);
    const auto first = static_cast<std::uint32_t>(tree.nodes.size());
    require(first + 2 <= planes.nodes(), "its nodes are no tree");
    KdNode& node = tree.nodes[task.node];
    node.axis = static_cast<std::uint32_t>(axis) & 3u;
    node.position = split.position;
    node.first = first;
    tree.nodes.resize(first + 2);
    tasks.push_back({ cells.above, std::move(sides.above), first + 1, task.depth + 1 });
    tasks.push_back({ cells.below, std::move(sides.below), first, task.depth + 1 });
  }
  require(planes.atEnd(), "its nodes are no tree");
  return tree;
}

} // namespace lumitree
