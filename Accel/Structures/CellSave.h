// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_CellSave_h
#define Lumitree_Accel_Structures_CellSave_h

#include "Accel/Kernel/LeafBlocks.h"
#include "Accel/Save/SaveStream.h"
#include "Accel/Structures/KdTreeSplitters.h"
#include "Accel/Surface.h"

#include <utility>

namespace lumitree
{

/// What the trees of cells share when they are saved. Of these only the divisions are saved, the
/// root first and what is below a plane before what is above it; the surface is divided again by
/// them when they are loaded.

inline constexpr int cellDepthLimit = 64;

/// How many references a loaded tree may have: more than any builder makes.
[[nodiscard]] inline std::size_t mostReferences(const Surface& surface)
{
  return 65536 + 16 * surface.hittable().size();
}

/// What reaches into the root.
[[nodiscard]] inline std::vector<KdReference> rootReferences(const Surface& surface)
{
  std::vector<KdReference> references;
  references.reserve(surface.hittable().size());
  for (const PrimitiveId id : surface.hittable())
  {
    references.push_back({ surface.box(id), id });
  }
  return references;
}

[[nodiscard]] inline std::vector<PrimitiveId> idsOf(const std::vector<KdReference>& references)
{
  std::vector<PrimitiveId> ids;
  ids.reserve(references.size());
  for (const KdReference& r : references)
  {
    ids.push_back(r.id);
  }
  return ids;
}

/// The planes above a leaf that lie across an axis, while a tree is gone through; to find out on
/// which side of its plane a node has what lies in the plane, which the tree itself does not say.
class PlanesAbove
{
public:
  struct Plane
  {
    std::size_t node = 0;
    int axis = -1; ///< -1: not across an axis
    double position = 0.0;
    bool above = false; ///< the side gone to
  };

  explicit PlanesAbove(std::size_t nodes)
    : inPlaneAbove_(nodes, false)
  {
  }

  /// The way goes on from a node of that depth, which forgets deeper ones.
  void go(std::size_t depth, const Plane& plane)
  {
    this->planes_.resize(depth);
    this->planes_.push_back(plane);
  }

  /// At a leaf of that depth: it has this primitive.
  void found(std::size_t depth, const Box& box)
  {
    for (std::size_t i = 0; i < depth; ++i)
    {
      const Plane& p = this->planes_[i];
      if (p.axis >= 0 && p.above && box.lower[p.axis] == p.position &&
        box.upper[p.axis] == p.position)
      {
        this->inPlaneAbove_[p.node] = true;
      }
    }
  }

  [[nodiscard]] bool inPlaneAbove(std::size_t node) const { return this->inPlaneAbove_[node]; }

private:
  std::vector<Plane> planes_;
  std::vector<bool> inPlaneAbove_;
};

/// The planes of a tree whose nodes' children stand side by side. isLeaf(node); planeOf(node) gives
/// the axis and the position of a plane, or the axis -1.
template <class Tree, class IsLeaf, class PlaneOf>
[[nodiscard]] PlanesAbove planesAbove(const Surface& surface, const Tree& tree,
  const LeafBlocks& blocks, const IsLeaf& isLeaf, const PlaneOf& planeOf)
{
  struct Step
  {
    std::uint32_t node;
    std::size_t depth;
    bool above; ///< of its parent's plane
    std::uint32_t parent;
  };
  PlanesAbove planes(tree.nodes.size());
  std::vector<Step> waiting = { { 0, 0, false, 0 } };
  while (!waiting.empty())
  {
    const Step step = waiting.back();
    waiting.pop_back();
    if (step.depth > 0)
    {
      const auto [axis, position] = planeOf(tree.nodes[step.parent]);
      planes.go(step.depth - 1, { step.parent, axis, position, step.above });
    }
    const auto& node = tree.nodes[step.node];
    if (!isLeaf(node))
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

/// The divisions again, in the order in which they were written: a byte for each node, and numbers
/// for each plane.
class SavedDivisions
{
public:
  SavedDivisions(std::vector<std::uint8_t> kinds, std::vector<double> numbers)
    : kinds_(std::move(kinds))
    , numbers_(std::move(numbers))
  {
  }

  [[nodiscard]] std::size_t nodes() const { return this->kinds_.size(); }

  std::uint8_t kind()
  {
    require(this->kind_ < this->kinds_.size(), "its nodes are no tree");
    return this->kinds_[this->kind_++];
  }

  double number()
  {
    require(this->number_ < this->numbers_.size(), "its nodes are no tree");
    return this->numbers_[this->number_++];
  }

  [[nodiscard]] bool atEnd() const
  {
    return this->kind_ == this->kinds_.size() && this->number_ == this->numbers_.size();
  }

private:
  std::vector<std::uint8_t> kinds_;
  std::vector<double> numbers_;
  std::size_t kind_ = 0;
  std::size_t number_ = 0;
};

/// Fills a leaf's blocks; left: how many references there may still be.
template <class Node>
void loadLeaf(const Surface& surface, const std::vector<KdReference>& references,
  LeafBlocks& blocks, std::size_t& left, Node& leaf)
{
  const std::vector<PrimitiveId> ids = idsOf(references);
  require(ids.size() <= left, "it has more references than any builder makes");
  left -= ids.size();
  leaf.count = static_cast<std::uint32_t>(ids.size());
  std::visit(
    [&](auto& store) { leaf.first = store.append(surface, ids.data(), ids.size()); }, blocks);
}

} // namespace lumitree

#endif
