// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/BvhBuilder.h"

#include <vector>

namespace lumitree
{
namespace
{

/// A range of references that will become the node `node`.
struct Task
{
  std::size_t begin;
  std::size_t end;
  std::uint32_t node;
  int depth;
};

std::vector<BuildReference> makeReferences(const Surface& surface, BuildProgress& progress)
{
  const auto& ids = surface.hittable();
  std::vector<BuildReference> references(ids.size());
  progress.stage(0.05, ids.size());
  progress.forEach(ids.size(), 16384,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Box box = surface.box(ids[i]);
        references[i] = { box, box.centre(), ids[i] };
      }
    });
  return references;
}

} // namespace

BvhNodes buildBvhNodes(
  const Surface& surface, const BvhSplitter& split, int maxDepth, BuildProgress& progress)
{
  std::vector<BuildReference> references = makeReferences(surface, progress);
  progress.stage(0.7, references.size());
  BvhNodes bvh;
  bvh.nodes.reserve(references.size());
  bvh.nodes.emplace_back();
  std::vector<Task> tasks = { { 0, references.size(), 0, 0 } };
  while (!tasks.empty())
  {
    const Task task = tasks.back();
    tasks.pop_back();
    progress.advance(0);
    BuildReference* const begin = references.data() + task.begin;
    BuildReference* const end = references.data() + task.end;

    BvhNode node;
    for (const BuildReference* r = begin; r != end; ++r)
    {
      node.box.extend(r->box);
    }
    const BvhSplit division = task.depth < maxDepth ? split(node.box, begin, end) : BvhSplit{};
    node.leaf = division.middle == nullptr;
    if (node.leaf)
    {
      // Primitives in ascending order: the leaf does not depend on how its node came about.
      std::sort(
        begin, end, [](const BuildReference& a, const BuildReference& b) { return a.id < b.id; });
      node.first = static_cast<std::uint32_t>(task.begin);
      node.count = static_cast<std::uint32_t>(task.end - task.begin);
      progress.advance(node.count);
    }
    else
    {
      node.first = static_cast<std::uint32_t>(bvh.nodes.size());
      node.axis = static_cast<std::int8_t>(division.axis);
      bvh.nodes.resize(bvh.nodes.size() + 2);
      const auto middle = static_cast<std::size_t>(division.middle - references.data());
      tasks.push_back({ middle, task.end, node.first + 1, task.depth + 1 });
      tasks.push_back({ task.begin, middle, node.first, task.depth + 1 });
    }
    bvh.nodes[task.node] = node;
  }
  bvh.references.reserve(references.size());
  for (const BuildReference& r : references)
  {
    bvh.references.push_back(r.id);
  }
  return bvh;
}

} // namespace lumitree
