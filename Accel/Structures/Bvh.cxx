// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/Bvh.h"

#include "Accel/Kernel/RayBox.h"
#include "Accel/Kernel/TreeAccelerator.h"
#include "Accel/Structures/BvhBuilder.h"
#include "Accel/Structures/BvhLeaves.h"
#include "Accel/Structures/BvhSave.h"

namespace lumitree
{
namespace
{

class Bvh
{
public:
  Bvh(const Surface& surface, const BuildOptions& options, LeafBlocks& blocks,
    BuildProgress& progress)
    : Bvh(surface, build(surface, options, progress), blocks, progress)
  {
  }

  Bvh(const Surface& surface, const BuildOptions& options, LeafBlocks& blocks,
    BuildProgress& progress, SaveReader& reader)
    : Bvh(surface, loadBvh(surface, hasParts(options), reader, progress), blocks, progress)
  {
  }

  Bvh(const Surface& surface, const BuildOptions&, LeafBlocks& blocks, BuildProgress& progress,
    const Bvh& before, const LeafBlocks&)
    : Bvh(surface, refitBvh(surface, before.bvh_, progress), blocks, progress)
  {
  }

  static bool canMove(const BuildOptions& options) { return !hasParts(options); }

  [[nodiscard]] bool holds(const Surface& moved, const LeafBlocks&) const
  {
    return holdAll(moved, this->bvh_.references);
  }

  void save(
    const Surface&, const BuildOptions& options, const LeafBlocks&, SaveWriter& writer) const
  {
    saveBvh(this->bvh_, hasParts(options), writer);
  }

private:
  static bool hasParts(const BuildOptions& options)
  {
    return options.bvhBuild == BvhBuild::SpatialSplits;
  }

  static BvhNodes build(
    const Surface& surface, const BuildOptions& options, BuildProgress& progress)
  {
    if (surface.hittable().empty())
    {
      BvhNodes empty;
      empty.nodes.resize(1);
      return empty;
    }
    return exactBvhNodes(surface, buildBvhTree(surface, options, progress), progress);
  }

  Bvh(const Surface& surface, BvhNodes&& bvh, LeafBlocks& blocks, BuildProgress& progress)
    : bvh_(std::move(bvh))
  {
    this->firstBlock_.resize(this->bvh_.nodes.size());
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < this->bvh_.nodes.size(); ++i)
    {
      const BvhNode& node = this->bvh_.nodes[i];
      this->firstBlock_[i] = count;
      count += node.leaf ? (node.count + blockWidth - 1) / blockWidth : 0;
    }
    progress.stage(0.99, this->bvh_.nodes.size());
    std::visit(
      [&](auto& store)
      {
        store.resize(count);
        progress.forEach(this->bvh_.nodes.size(), 2048,
          [&](std::size_t begin, std::size_t end)
          {
            for (std::size_t i = begin; i < end; ++i)
            {
              const BvhNode& node = this->bvh_.nodes[i];
              if (node.leaf)
              {
                store.put(this->firstBlock_[i], surface, this->bvh_.references.data() + node.first,
                  node.count);
              }
            }
          });
      },
      blocks);
  }

public:
  [[nodiscard]] const void* walked() const { return this; }
  static StructureWalks walks() { return baselineWalks<Bvh>(); }

  /// Nearer child first; a child is entered only if its box is met before the best hit so far.
  template <class Visitor>
  void walk(const RayBox& ray, Visitor& visitor) const
  {
    struct Entry
    {
      std::uint32_t node;
      double tEnter;
    };
    // At most one sibling waits per level, and no node lies deeper than 64.
    Entry stack[65];
    int height = 0;
    Entry current = { 0, 0.0 };
    double tStop = visitor.tStop();
    if (!ray.meets(this->bvh_.nodes[0].box, tStop, current.tEnter))
    {
      return;
    }
    while (true)
    {
      visitor.node(current.node);
      const BvhNode& node = this->bvh_.nodes[current.node];
      if (!node.leaf)
      {
        double tEnter[2];
        const unsigned met = ray.meetPair(
          this->bvh_.nodes[node.first].box, this->bvh_.nodes[node.first + 1].box, tStop, tEnter);
        if (met == 3)
        {
          const std::uint32_t nearer =
            tEnter[1] < tEnter[0] || (tEnter[1] == tEnter[0] && ray.negative(node.axis)) ? 1 : 0;
          stack[height++] = { node.first + 1 - nearer, tEnter[1 - nearer] };
          current = { node.first + nearer, tEnter[nearer] };
          continue;
        }
        if (met != 0)
        {
          current = { node.first + (met >> 1), tEnter[met >> 1] };
          continue;
        }
      }
      else
      {
        tStop = visitor.leaf({ this->firstBlock_[current.node], node.count, current.tEnter });
      }
      do
      {
        if (height == 0)
        {
          return;
        }
        current = stack[--height];
      } while (current.tEnter > tStop);
    }
  }

  [[nodiscard]] HierarchyView view(const LeafBlocks&) const
  {
    HierarchyView view;
    view.references = this->bvh_.references;
    view.nodes.resize(this->bvh_.nodes.size());
    for (std::size_t i = 0; i < view.nodes.size(); ++i)
    {
      const BvhNode& node = this->bvh_.nodes[i];
      HierarchyNode& shown = view.nodes[i];
      shown.box = node.box;
      shown.leaf = node.leaf;
      shown.firstReference = node.leaf ? node.first : 0;
      shown.referenceCount = node.count;
      if (!node.leaf)
      {
        for (std::uint32_t child = node.first; child < node.first + 2; ++child)
        {
          view.nodes[child].parent = static_cast<std::int64_t>(i);
          view.nodes[child].depth = shown.depth + 1;
        }
      }
    }
    completeHierarchy(view);
    return view;
  }

  [[nodiscard]] BuildStatistics statistics(const Surface& surface) const
  {
    BuildStatistics s;
    s.nodes = this->bvh_.nodes.size();
    s.references = this->bvh_.references.size();
    s.duplication = duplicationOf(s.references, surface);
    std::vector<int> depths(s.nodes, 0);
    const double whole = this->bvh_.nodes.front().box.area();
    for (std::size_t i = 0; i < s.nodes; ++i)
    {
      const BvhNode& node = this->bvh_.nodes[i];
      s.leaves += node.leaf ? 1 : 0;
      s.depth = std::max(s.depth, depths[i]);
      s.sahCost +=
        whole > 0.0 ? node.box.area() / whole * (node.leaf ? leafCost(node.count) : 1.0) : 0.0;
      if (!node.leaf)
      {
        depths[node.first] = depths[node.first + 1] = depths[i] + 1;
      }
    }
    return s;
  }

  [[nodiscard]] std::size_t memory() const
  {
    return this->bvh_.nodes.capacity() * sizeof(BvhNode) +
      this->bvh_.references.capacity() * sizeof(PrimitiveId) +
      this->firstBlock_.capacity() * sizeof(std::uint32_t);
  }

private:
  BvhNodes bvh_;
  std::vector<std::uint32_t> firstBlock_; ///< per node, for leaves
};

} // namespace

std::shared_ptr<const Accelerator> buildBvh(
  std::shared_ptr<const Surface> surface, const BuildOptions& options, JobControl* control)
{
  return std::make_shared<TreeAccelerator<Bvh>>(std::move(surface), options, control);
}

std::shared_ptr<const Accelerator> loadBvh(std::shared_ptr<const Surface> surface,
  const BuildOptions& options, SaveReader& reader, JobControl* control)
{
  return TreeAccelerator<Bvh>::load(std::move(surface), options, reader, control);
}

} // namespace lumitree
