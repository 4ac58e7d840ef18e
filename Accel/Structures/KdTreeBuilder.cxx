// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/KdTreeBuilder.h"

#include "Accel/Structures/KdTreeDivide.h"

#include <stdexcept>

namespace lumitree
{
namespace
{

/// A cell and what reaches into it, to become the node `node`.
struct Task
{
  Box cell;
  std::vector<KdReference> references;
  std::size_t allowance; ///< references that the leaves below may hold together
  std::uint32_t node;
  int depth;
};

class Builder
{
public:
  Builder(const Surface& surface, LeafBlocks& blocks, BuildProgress& progress)
    : surface_(surface)
    , blocks_(blocks)
    , progress_(progress)
  {
  }

  KdTreeNodes build(const KdSplitter& split, int maxDepth)
  {
    this->tree_.nodes.emplace_back();
    std::vector<Task> tasks;
    tasks.push_back(this->rootTask());
    // Leaves share the references allowed, all of which are given to one in the end.
    this->progress_.stage(0.99, tasks.back().allowance);
    const int depthLimit = this->depthLimit(maxDepth);
    while (!tasks.empty())
    {
      Task task = std::move(tasks.back());
      tasks.pop_back();
      this->progress_.advance(0);
      const KdSplit division =
        task.depth < depthLimit ? split(task.cell, task.references) : KdSplit{};
      const KdSides sides = division.axis >= 0
        ? divideReferences(this->surface_, task.cell, task.references, division)
        : KdSides{};
      const std::size_t held = sides.below.size() + sides.above.size();
      if (division.axis < 0 || held > task.allowance)
      {
        this->makeLeaf(task);
        this->progress_.advance(task.allowance);
        continue;
      }
      this->makeInterior(task, division, sides, tasks);
    }
    return std::move(this->tree_);
  }

private:
  Task rootTask()
  {
    this->tree_.cell = this->surface_.bounds();
    Task root{ this->tree_.cell, {}, 0, 0, 0 };
    root.references.reserve(this->surface_.hittable().size());
    for (const PrimitiveId id : this->surface_.hittable())
    {
      root.references.push_back({ this->surface_.box(id), id });
    }
    root.allowance = kdReferencesPerTriangle * root.references.size();
    return root;
  }

  [[nodiscard]] int depthLimit(int maxDepth) const
  {
    const auto count =
      static_cast<double>(std::max<std::size_t>(1, this->surface_.hittable().size()));
    return std::min(maxDepth, static_cast<int>(8.0 + 1.3 * std::log2(count)));
  }

  void makeLeaf(const Task& task)
  {
    if (task.references.size() > KdNode::largestLeaf)
    {
      throw std::length_error("too many triangles in one cell of a KD-tree");
    }
    std::vector<PrimitiveId> ids;
    for (const KdReference& r : task.references)
    {
      ids.push_back(r.id);
    }
    KdNode& leaf = this->tree_.nodes[task.node];
    leaf.count = static_cast<std::uint32_t>(ids.size());
    std::visit([&](auto& store)
      { leaf.first = store.append(this->surface_, ids.data(), ids.size()); },
      this->blocks_);
  }

  void makeInterior(const Task& task, const KdSplit& split, KdSides sides, std::vector<Task>& tasks)
  {
    const auto axis = static_cast<std::uint32_t>(split.axis);
    const auto first = static_cast<std::uint32_t>(this->tree_.nodes.size());
    KdNode& node = this->tree_.nodes[task.node];
    node.axis = axis & 3u;
    node.position = split.position;
    node.first = first;
    this->tree_.nodes.resize(first + 2);

    // Each side is allowed what it holds and its share of the rest.
    const std::size_t held = sides.below.size() + sides.above.size();
    const std::size_t spare = task.allowance - held;
    const std::size_t spareBelow = held > 0
      ? static_cast<std::size_t>(static_cast<double>(spare) *
          static_cast<double>(sides.below.size()) / static_cast<double>(held))
      : 0;
    const std::size_t allowedBelow = sides.below.size() + std::min(spareBelow, spare);
    const std::size_t allowedAbove = task.allowance - allowedBelow;
    const KdCells cells(task.cell, axis, split.position);
    tasks.push_back(
      { cells.above, std::move(sides.above), allowedAbove, first + 1, task.depth + 1 });
    tasks.push_back({ cells.below, std::move(sides.below), allowedBelow, first, task.depth + 1 });
  }

  const Surface& surface_;
  LeafBlocks& blocks_;
  BuildProgress& progress_;
  KdTreeNodes tree_;
};

} // namespace

KdTreeNodes buildKdTreeNodes(const Surface& surface, const KdSplitter& split, int maxDepth,
  LeafBlocks& blocks, BuildProgress& progress)
{
  return Builder(surface, blocks, progress).build(split, maxDepth);
}

} // namespace lumitree
