// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/OctreeSave.h"

#include "Accel/Structures/CellSave.h"
#include "Accel/Structures/OctreeCells.h"
#include "Accel/Structures/PrimitiveBoxOverlap.h"

#include <array>

namespace lumitree
{
namespace
{

struct Open
{
  std::uint32_t node;
  Box octant;
  std::vector<PrimitiveId> primitives;
};

class Loader
{
public:
  Loader(const Surface& surface, BuildProgress& progress, SaveReader& reader)
    : surface_(surface)
    , progress_(progress)
    , cells_(surface.bounds())
    , divided_(reader.getAll<std::uint8_t>(reader.get<std::uint64_t>()))
    , most_(mostReferences(surface))
    , held_(surface.hittable().size())
  {
  }

  OctreeNodes load()
  {
    require(!this->divided_.empty(), "it has no nodes");
    this->progress_.stage(0.9, this->divided_.size());
    this->tree_.nodes.emplace_back();
    this->tree_.nodes[0].box = this->surface_.bounds();
    std::vector<Open> level;
    level.push_back({ 0, this->cells_.root(), this->surface_.hittable() });
    std::size_t done = 0;
    for (int depth = 0; !level.empty(); ++depth)
    {
      std::vector<Open> next;
      for (Open& open : level)
      {
        this->progress_.advance(1);
        require(done < this->divided_.size(), "its nodes are not those of its surface");
        require(this->divided_[done] <= 1, "a node is neither divided nor a leaf");
        if (this->divided_[done++] == 0)
        {
          this->close(open);
          continue;
        }
        require(depth < octreeDepthLimit, "it is deeper than 21");
        this->divide(open, next);
      }
      level = std::move(next);
    }
    require(done == this->divided_.size(), "its nodes are not those of its surface");
    return std::move(this->tree_);
  }

private:
  void divide(const Open& open, std::vector<Open>& next)
  {
    const Vec3 centre = open.octant.centre();
    this->held_ -= open.primitives.size();
    OctreeNode parent = this->tree_.nodes[open.node];
    parent.leaf = false;
    parent.first = static_cast<std::uint32_t>(this->tree_.nodes.size());
    std::array<Box, 8> octants;
    std::array<Box, 8> boxes;
    for (int i = 0; i < 8; ++i)
    {
      octants[i] = OctreeCells::octantOf(open.octant, centre, i);
      boxes[i] = this->cells_.boxOf(octants[i]);
    }
    std::array<std::vector<PrimitiveId>, 8> held;
    for (const PrimitiveId id : open.primitives)
    {
      const PrimitiveBoxOverlap overlap(this->surface_, id);
      for (int i = 0; i < 8; ++i)
      {
        if (overlap.mayMeet(boxes[i]))
        {
          held[i].push_back(id);
          ++this->held_;
        }
      }
      require(this->held_ <= this->most_, "it has more references than any builder makes");
    }
    for (int i = 0; i < 8; ++i)
    {
      if (!held[i].empty())
      {
        OctreeNode child;
        child.box = boxes[i];
        child.parent = open.node;
        next.push_back(
          { static_cast<std::uint32_t>(this->tree_.nodes.size()), octants[i], std::move(held[i]) });
        this->tree_.nodes.push_back(child);
        ++parent.count;
      }
    }
    require(parent.count > 0, "its nodes are not those of its surface");
    this->tree_.nodes[open.node] = parent;
  }

  void close(const Open& open)
  {
    OctreeNode& node = this->tree_.nodes[open.node];
    node.first = static_cast<std::uint32_t>(this->tree_.references.size());
    node.count = static_cast<std::uint32_t>(open.primitives.size());
    this->tree_.references.insert(
      this->tree_.references.end(), open.primitives.begin(), open.primitives.end());
  }

  const Surface& surface_;
  BuildProgress& progress_;
  OctreeCells cells_;
  std::vector<std::uint8_t> divided_;
  std::size_t most_;
  std::size_t held_; ///< over all nodes without children
  OctreeNodes tree_;
};

} // namespace

void saveOctree(const OctreeNodes& tree, SaveWriter& writer)
{
  // Level by level, whatever the builder's order is.
  std::vector<std::uint8_t> divided;
  std::vector<std::uint32_t> nodes = { 0 };
  nodes.reserve(tree.nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const OctreeNode& node = tree.nodes[nodes[i]];
    divided.push_back(node.leaf ? 0 : 1);
    for (std::uint32_t child = 0; !node.leaf && child < node.count; ++child)
    {
      nodes.push_back(node.first + child);
    }
  }
  writer.put(std::uint64_t{ divided.size() });
  writer.putAll(divided);
}

OctreeNodes loadOctree(const Surface& surface, BuildProgress& progress, SaveReader& reader)
{
  return Loader(surface, progress, reader).load();
}

} // namespace lumitree
