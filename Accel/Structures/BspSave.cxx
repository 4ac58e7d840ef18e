// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/BspSave.h"

#include "Accel/Structures/BspDivide.h"
#include "Accel/Structures/CellSave.h"

namespace lumitree
{
namespace
{

/// A node in a byte: its axis, that its plane is across none, or that it is a leaf; and where what
/// lies in a plane across an axis goes.
constexpr std::uint8_t kindBits = 7;
constexpr std::uint8_t generalKind = 3;
constexpr std::uint8_t leafKind = 4;
constexpr std::uint8_t aboveBit = 8;

struct Task
{
  BspPart part;
  std::uint32_t node;
  int depth;
};

std::uint8_t kindOf(const BspNode& node, bool inPlaneAbove)
{
  if (node.leaf)
  {
    return leafKind;
  }
  return node.axis < 0 ? generalKind
                       : static_cast<std::uint8_t>(node.axis | (inPlaneAbove ? aboveBit : 0));
}

/// Largest component ±1, so that PlaneDistance's margin is what it says.
bool isNormal(const Vec3& normal)
{
  double largest = 0.0;
  for (const double n : normal)
  {
    if (!(std::fabs(n) <= 1.0))
    {
      return false;
    }
    largest = std::max(largest, std::fabs(n));
  }
  return largest == 1.0;
}

SavedDivisions readDivisions(SaveReader& reader)
{
  auto kinds = reader.getAll<std::uint8_t>(reader.get<std::uint64_t>());
  auto numbers = reader.getAll<double>(reader.get<std::uint64_t>());
  return { std::move(kinds), std::move(numbers) };
}

/// The plane of the next node; false for a leaf.
bool nextPlane(SavedDivisions& divisions, BspPlane& plane)
{
  const std::uint8_t kind = divisions.kind();
  require(kind <= leafKind || (kind >= aboveBit && kind < aboveBit + generalKind),
    "a node is of no kind");
  if (kind == leafKind)
  {
    return false;
  }
  plane = BspPlane{};
  if (kind == generalKind)
  {
    for (double& n : plane.normal)
    {
      n = divisions.number();
    }
    require(isNormal(plane.normal), "a plane has no such normal");
  }
  else
  {
    plane.axis = kind & kindBits;
    plane.inPlaneBelow = (kind & aboveBit) == 0;
    plane.normal[static_cast<std::size_t>(plane.axis)] = 1.0;
  }
  plane.offset = divisions.number();
  require(std::fabs(plane.offset) <= 8.0 * coordinateLimit, "a plane is not finite");
  return true;
}

} // namespace

void saveBspTree(
  const Surface& surface, const BspNodes& tree, const LeafBlocks& blocks, SaveWriter& writer)
{
  const PlanesAbove planes = planesAbove(
    surface, tree, blocks, [](const BspNode& node) { return node.leaf; },
    [](const BspNode& node) { return std::make_pair(static_cast<int>(node.axis), node.offset); });
  std::vector<std::uint8_t> kinds;
  std::vector<double> numbers;
  std::vector<std::uint32_t> waiting = { 0 };
  while (!waiting.empty())
  {
    const std::uint32_t i = waiting.back();
    waiting.pop_back();
    const BspNode& node = tree.nodes[i];
    kinds.push_back(kindOf(node, planes.inPlaneAbove(i)));
    if (node.leaf)
    {
      continue;
    }
    if (node.axis < 0)
    {
      numbers.insert(numbers.end(), node.normal.begin(), node.normal.end());
    }
    numbers.push_back(node.offset);
    waiting.push_back(node.first + 1);
    waiting.push_back(node.first);
  }
  writer.put(std::uint64_t{ kinds.size() });
  writer.putAll(kinds);
  writer.put(std::uint64_t{ numbers.size() });
  writer.putAll(numbers);
}

BspNodes loadBspTree(
  const Surface& surface, LeafBlocks& blocks, BuildProgress& progress, SaveReader& reader)
{
  SavedDivisions divisions = readDivisions(reader);
  BspNodes tree;
  tree.cell = surface.bounds();
  tree.nodes.emplace_back();
  const WideBvhFrame frame = bspFrameOf(tree.cell);
  std::vector<Task> tasks;
  tasks.push_back({ { tree.cell, tree.cell.empty() ? Polyhedron{} : framedRoot(frame, tree.cell),
                      rootReferences(surface) },
    0, 0 });
  std::size_t left = mostReferences(surface);
  progress.stage(0.99, divisions.nodes());
  while (!tasks.empty())
  {
    const Task task = std::move(tasks.back());
    tasks.pop_back();
    progress.advance(1);
    BspPlane plane;
    if (!nextPlane(divisions, plane))
    {
      loadLeaf(surface, task.part.references, blocks, left, tree.nodes[task.node]);
      continue;
    }
    require(task.depth < cellDepthLimit, "it is deeper than 64");
    auto polyhedra = cutPolyhedron(
      task.part.polyhedron, plane.normal, framedOffset(frame, plane.normal, plane.offset));
    require(polyhedra.has_value(), "a plane does not cut its cell");
    auto [below, above] = divideReferences(surface, frame, task.part, plane, std::move(*polyhedra));
    const auto first = static_cast<std::uint32_t>(tree.nodes.size());
    require(first + 2 <= divisions.nodes(), "its nodes are no tree");
    BspNode& node = tree.nodes[task.node];
    node.leaf = false;
    node.normal = plane.normal;
    node.offset = plane.offset;
    node.axis = plane.axis;
    node.first = first;
    tree.nodes.resize(first + 2);
    tasks.push_back({ std::move(above), first + 1, task.depth + 1 });
    tasks.push_back({ std::move(below), first, task.depth + 1 });
  }
  require(divisions.atEnd(), "its nodes are no tree");
  return tree;
}

} // namespace lumitree
