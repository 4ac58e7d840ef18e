// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/Octree.h"

#include "Accel/Kernel/RayBox.h"
#include "Accel/Kernel/TreeAccelerator.h"
#include "Accel/Structures/Mailbox.h"
#include "Accel/Structures/OctreeSave.h"

namespace lumitree
{
namespace
{

class Octree
{
public:
  Octree(const Surface& surface, const BuildOptions& options, LeafBlocks& blocks,
    BuildProgress& progress)
    : Octree(surface, options, buildOctreeNodes(surface, options, progress), blocks, progress)
  {
  }

  Octree(const Surface& surface, const BuildOptions& options, LeafBlocks& blocks,
    BuildProgress& progress, SaveReader& reader)
    : Octree(surface, options, loadOctree(surface, progress, reader), blocks, progress)
  {
  }

  void save(const Surface&, const BuildOptions&, const LeafBlocks&, SaveWriter& writer) const
  {
    saveOctree(this->octree_, writer);
  }

private:
  Octree(const Surface& surface, const BuildOptions& options, OctreeNodes&& octree,
    LeafBlocks& blocks, BuildProgress& progress)
    : octree_(std::move(octree))
    , firstBlock_(octree_.nodes.size())
  {
    const std::vector<OctreeNode>& nodes = this->octree_.nodes;
    std::size_t count = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      this->firstBlock_[i] = static_cast<std::uint32_t>(count);
      count += nodes[i].leaf ? (nodes[i].count + blockWidth - 1) / blockWidth : 0;
    }
    progress.stage(0.99, nodes.size());
    std::visit(
      [&](auto& store)
      {
        store.resize(count);
        progress.forEach(nodes.size(), nodesPerChunk,
          [&](std::size_t begin, std::size_t end)
          {
            for (std::size_t i = begin; i < end; ++i)
            {
              if (nodes[i].leaf)
              {
                store.put(this->firstBlock_[i], surface,
                  this->octree_.references.data() + nodes[i].first, nodes[i].count);
              }
            }
          });
      },
      blocks);
    for (std::size_t i = 0; options.mailboxing && i < nodes.size(); ++i)
    {
      if (nodes[i].leaf)
      {
        this->mailbox_.add(blocks, this->firstBlock_[i], nodes[i].count);
      }
    }
  }

public:
  [[nodiscard]] const void* walked() const { return this; }
  static StructureWalks walks() { return baselineWalks<Octree>(); }

  template <class Visitor>
  void walk(const RayBox& ray, Visitor& visitor) const
  {
    walkWithMailbox(this->mailbox_, visitor, [&](auto& each) { this->walkOctants(ray, each); });
  }

private:
  /// Nearest octant first; an octant is entered only if its box is met before the best hit so far.
  template <class Visitor>
  void walkOctants(const RayBox& ray, Visitor& visitor) const
  {
    struct Entry
    {
      std::uint32_t node;
      double tEnter;
    };
    // At most seven siblings wait per level, and the eight children of the last.
    Entry stack[7 * octreeDepthLimit + 8];
    int height = 0;
    const std::vector<OctreeNode>& nodes = this->octree_.nodes;
    double tStop = visitor.tStop();
    Entry root = { 0, 0.0 };
    if (ray.meets(nodes[0].box, tStop, root.tEnter))
    {
      stack[height++] = root;
    }
    while (height > 0)
    {
      const Entry current = stack[--height];
      if (current.tEnter > tStop)
      {
        continue;
      }
      visitor.node(current.node);
      const OctreeNode& node = nodes[current.node];
      if (node.leaf)
      {
        tStop = visitor.leaf({ this->firstBlock_[current.node], node.count, current.tEnter });
        continue;
      }
      const int bottom = height;
      for (std::uint32_t child = node.first; child < node.first + node.count; ++child)
      {
        Entry entry = { child, 0.0 };
        if (ray.meets(nodes[child].box, tStop, entry.tEnter))
        {
          int place = height++;
          for (; place > bottom && stack[place - 1].tEnter < entry.tEnter; --place)
          {
            stack[place] = stack[place - 1];
          }
          stack[place] = entry;
        }
      }
    }
  }

public:
  [[nodiscard]] HierarchyView view(const LeafBlocks&) const
  {
    HierarchyView view;
    view.references = this->octree_.references;
    view.nodes.resize(this->octree_.nodes.size());
    for (std::size_t i = 0; i < view.nodes.size(); ++i)
    {
      const OctreeNode& node = this->octree_.nodes[i];
      HierarchyNode& shown = view.nodes[i];
      shown.box = node.box;
      shown.leaf = node.leaf;
      shown.firstReference = node.leaf ? node.first : 0;
      shown.referenceCount = node.leaf ? node.count : 0;
      if (i > 0)
      {
        shown.parent = node.parent;
        shown.depth = view.nodes[node.parent].depth + 1;
      }
    }
    completeHierarchy(view);
    return view;
  }

  [[nodiscard]] std::size_t memory() const
  {
    return this->octree_.nodes.capacity() * sizeof(OctreeNode) +
      this->octree_.references.capacity() * sizeof(PrimitiveId) +
      this->firstBlock_.capacity() * sizeof(std::uint32_t) + this->mailbox_.memory();
  }

private:
  static constexpr std::size_t nodesPerChunk = 256;

  OctreeNodes octree_;
  std::vector<std::uint32_t> firstBlock_; ///< per node, for leaves
  Mailbox mailbox_;
};

} // namespace

std::shared_ptr<const Accelerator> buildOctree(
  std::shared_ptr<const Surface> surface, const BuildOptions& options, JobControl* control)
{
  return std::make_shared<TreeAccelerator<Octree>>(std::move(surface), options, control);
}

std::shared_ptr<const Accelerator> loadOctree(std::shared_ptr<const Surface> surface,
  const BuildOptions& options, SaveReader& reader, JobControl* control)
{
  return TreeAccelerator<Octree>::load(std::move(surface), options, reader, control);
}

} // namespace lumitree
