// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/OctreeBuilder.h"

#include "Accel/Structures/OctreeCells.h"
#include "Accel/Structures/PrimitiveBoxOverlap.h"

#include <array>

namespace lumitree
{
namespace
{

constexpr std::size_t fewReferences = 65536;
constexpr std::size_t referencesPerPrimitive = 16;
/// See OctreeBuilder.h.
constexpr std::size_t growthHalves = 3;

/// A node of the level at work.
struct Open
{
  std::uint32_t node;
  Box octant;
  std::vector<PrimitiveId> primitives;
};

class Builder
{
public:
  Builder(const Surface& surface, const BuildOptions& options, BuildProgress& progress)
    : surface_(surface)
    , progress_(progress)
    , cells_(surface.bounds())
    , leafSize_(static_cast<std::size_t>(options.leafSize))
    , depthLimit_(std::min(options.maxDepth, octreeDepthLimit))
    , limit_(fewReferences + referencesPerPrimitive * surface.hittable().size())
    , held_(surface.hittable().size())
  {
  }

  OctreeNodes build()
  {
    this->tree_.nodes.emplace_back();
    this->tree_.nodes[0].box = this->surface_.bounds();
    std::vector<Open> level;
    level.push_back({ 0, this->cells_.root(), this->surface_.hittable() });
    double toDo = 1.0;
    for (int depth = 0; !level.empty(); ++depth)
    {
      std::vector<Open> next;
      // How many levels there will be is not known: each is a third of what is left.
      toDo *= 2.0 / 3.0;
      this->progress_.stage(0.9 * (1.0 - toDo), level.size());
      for (Open& open : level)
      {
        if (depth == this->depthLimit_ || open.primitives.size() <= this->leafSize_ ||
          !this->split(open, next))
        {
          this->close(open);
        }
        this->progress_.advance(1);
      }
      level = std::move(next);
    }
    return std::move(this->tree_);
  }

private:
  /// Appends the node's children to the tree and to the next level; false where the node must
  /// become a leaf.
  bool split(const Open& open, std::vector<Open>& next)
  {
    const Vec3 centre = open.octant.centre();
    std::array<Box, 8> boxes;
    for (int i = 0; i < 8; ++i)
    {
      boxes[i] = this->cells_.boxOf(OctreeCells::octantOf(open.octant, centre, i));
    }
    const std::size_t count = open.primitives.size();
    const std::size_t allowed = std::min(growthHalves * count / 2,
      this->limit_ > this->held_ ? this->limit_ - this->held_ + count : count);
    std::array<std::vector<PrimitiveId>, 8> held;
    std::size_t total = 0;
    for (const PrimitiveId id : open.primitives)
    {
      const PrimitiveBoxOverlap overlap(this->surface_, id);
      for (int i = 0; i < 8; ++i)
      {
        if (overlap.mayMeet(boxes[i]))
        {
          held[i].push_back(id);
          ++total;
        }
      }
      if (total > allowed)
      {
        return false;
      }
    }
    if (total == 0)
    {
      return false; // the node holds only what its margin of safety took for met
    }
    this->held_ = this->held_ + total - count;
    OctreeNode& parent = this->tree_.nodes[open.node];
    parent.leaf = false;
    parent.first = static_cast<std::uint32_t>(this->tree_.nodes.size());
    for (int i = 0; i < 8; ++i)
    {
      parent.count += held[i].empty() ? 0 : 1;
    }
    for (int i = 0; i < 8; ++i)
    {
      if (!held[i].empty())
      {
        const auto index = static_cast<std::uint32_t>(this->tree_.nodes.size());
        OctreeNode child;
        child.box = boxes[i];
        child.parent = open.node;
        this->tree_.nodes.push_back(child);
        next.push_back(
          { index, OctreeCells::octantOf(open.octant, centre, i), std::move(held[i]) });
      }
    }
    return true;
  }

  void close(Open& open)
  {
    OctreeNode& node = this->tree_.nodes[open.node];
    node.first = static_cast<std::uint32_t>(this->tree_.references.size());
    node.count = static_cast<std::uint32_t>(open.primitives.size());
    this->tree_.references.insert(
      this->tree_.references.end(), open.primitives.begin(), open.primitives.end());
    open.primitives = {};
  }

  const Surface& surface_;
  BuildProgress& progress_;
  OctreeCells cells_;
  std::size_t leafSize_;
  int depthLimit_;
  std::size_t limit_; ///< of references
  std::size_t held_;  ///< references so far, over all nodes without children
  OctreeNodes tree_;
};

} // namespace

OctreeNodes buildOctreeNodes(
  const Surface& surface, const BuildOptions& options, BuildProgress& progress)
{
  return Builder(surface, options, progress).build();
}

} // namespace lumitree
