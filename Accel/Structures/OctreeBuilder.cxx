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
///@{
constexpr std::size_t growthHalves = 3;
constexpr std::size_t growthHalvesOfRoot = 4;
///@}

/// Primitives that a thread looks at, at a time.
constexpr std::size_t chunk = 4096;

/// What each octant holds.
using Octants = std::array<std::vector<PrimitiveId>, 8>;

/// A node of the level at work.
struct Open
{
  std::uint32_t node;
  Box octant;
  std::vector<PrimitiveId> primitives;
  std::array<Box, 8> boxes; ///< of the octants, where it may be split
  std::size_t firstPart = 0;
  std::size_t parts = 0; ///< 0 where it becomes a leaf
};

/// Primitives begin … end - 1 of a node.
struct Part
{
  std::size_t open;
  std::size_t begin;
  std::size_t end;
  std::size_t total = 0;
  Octants held;
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
    std::vector<Open> level(1);
    level[0].node = 0;
    level[0].octant = this->cells_.root();
    level[0].primitives = this->surface_.hittable();
    double toDo = 1.0;
    for (int depth = 0; !level.empty(); ++depth)
    {
      // How many levels there will be is not known: each is a third of what is left.
      toDo *= 2.0 / 3.0;
      std::vector<Part> parts = this->partsOf(level, depth);
      std::size_t work = 0;
      for (const Part& part : parts)
      {
        work += part.end - part.begin;
      }
      this->progress_.stage(0.9 * (1.0 - toDo), work);
      this->progress_.forEach(
        parts.size(), partsPerChunk,
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t i = begin; i < end; ++i)
          {
            this->sortOut(level[parts[i].open], parts[i]);
          }
        },
        [&](std::size_t begin, std::size_t end)
        {
          std::size_t done = 0;
          for (std::size_t i = begin; i < end; ++i)
          {
            done += parts[i].end - parts[i].begin;
          }
          return done;
        });
      std::vector<Open> next;
      for (Open& open : level)
      {
        if (open.parts == 0 || !this->split(open, parts.data() + open.firstPart, next))
        {
          this->close(open);
        }
      }
      level = std::move(next);
    }
    return std::move(this->tree_);
  }

private:
  static constexpr std::size_t partsPerChunk = 16;

  /// Of the nodes that may be split, and what their octants are.
  std::vector<Part> partsOf(std::vector<Open>& level, int depth) const
  {
    std::vector<Part> parts;
    for (std::size_t i = 0; i < level.size(); ++i)
    {
      Open& open = level[i];
      const std::size_t count = open.primitives.size();
      if (depth == this->depthLimit_ || count <= this->leafSize_)
      {
        continue;
      }
      const Vec3 centre = open.octant.centre();
      for (int k = 0; k < 8; ++k)
      {
        open.boxes[k] = this->cells_.boxOf(OctreeCells::octantOf(open.octant, centre, k));
      }
      open.firstPart = parts.size();
      for (std::size_t begin = 0; begin < count; begin += chunk)
      {
        parts.push_back({ i, begin, std::min(begin + chunk, count), 0, {} });
      }
      open.parts = parts.size() - open.firstPart;
    }
    return parts;
  }

  /// How many references the children of a node may have together, whatever the rest of the tree.
  static std::size_t allowedBelow(const Open& open)
  {
    return (open.node == 0 ? growthHalvesOfRoot : growthHalves) * open.primitives.size() / 2;
  }

  void sortOut(const Open& open, Part& part) const
  {
    for (std::size_t p = part.begin; p < part.end && part.total <= allowedBelow(open); ++p)
    {
      const PrimitiveBoxOverlap overlap(this->surface_, open.primitives[p]);
      for (std::size_t i = 0; i < 8; ++i)
      {
        if (overlap.mayMeet(open.boxes[i]))
        {
          part.held[i].push_back(open.primitives[p]);
          ++part.total;
        }
      }
    }
  }

  /// Appends the node's children to the tree and to the next level; false where the node must
  /// become a leaf.
  bool split(const Open& open, Part* parts, std::vector<Open>& next)
  {
    const std::size_t count = open.primitives.size();
    const std::size_t allowed = std::min(
      allowedBelow(open), this->limit_ > this->held_ ? this->limit_ - this->held_ + count : count);
    std::size_t total = 0;
    for (std::size_t p = 0; p < open.parts; ++p)
    {
      total += parts[p].total;
    }
    // Of nothing the node holds only what its margin of safety took for met.
    if (total == 0 || total > allowed)
    {
      return false;
    }
    this->held_ = this->held_ + total - count;
    Octants held = std::move(parts[0].held);
    for (std::size_t p = 1; p < open.parts; ++p)
    {
      for (std::size_t i = 0; i < 8; ++i)
      {
        held[i].insert(held[i].end(), parts[p].held[i].begin(), parts[p].held[i].end());
        parts[p].held[i] = {};
      }
    }
    OctreeNode& parent = this->tree_.nodes[open.node];
    parent.leaf = false;
    parent.first = static_cast<std::uint32_t>(this->tree_.nodes.size());
    for (std::size_t i = 0; i < 8; ++i)
    {
      parent.count += held[i].empty() ? 0 : 1;
    }
    const Vec3 centre = open.octant.centre();
    for (std::size_t i = 0; i < 8; ++i)
    {
      if (!held[i].empty())
      {
        OctreeNode child;
        child.box = open.boxes[i];
        child.parent = open.node;
        next.emplace_back();
        next.back().node = static_cast<std::uint32_t>(this->tree_.nodes.size());
        next.back().octant = OctreeCells::octantOf(open.octant, centre, static_cast<int>(i));
        next.back().primitives = std::move(held[i]);
        this->tree_.nodes.push_back(child);
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
