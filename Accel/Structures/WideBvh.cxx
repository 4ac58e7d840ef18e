// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/WideBvh.h"

#include "Accel/Kernel/TreeAccelerator.h"
#include "Accel/Structures/BvhBuilder.h"
#include "Accel/Structures/WideBvhBundle.h"
#include "Accel/Structures/WideBvhFill.h"
#include "Accel/Structures/WideBvhTopology.h"
#include "Accel/Structures/WideBvhView.h"
#include "Accel/Structures/WideBvhWalk.h"

namespace lumitree
{
namespace
{

class WideBvh
{
public:
  WideBvh(const Surface& surface, const BuildOptions& options, LeafBlocks& blocks,
    BuildProgress& progress)
  {
    if (!surface.hittable().empty())
    {
      BvhTree binary = buildBvhTree(surface, options, progress);
      this->tree_ = fillWideBvh(surface, std::move(binary), options.leafSize, blocks, progress);
    }
  }

  WideBvh(const Surface& surface, const BuildOptions& options, LeafBlocks& blocks,
    BuildProgress& progress, SaveReader& reader)
    : tree_(assembleWideBvh(
        surface, loadTopology(surface, hasParts(options), reader), blocks, progress))
  {
  }

  WideBvh(const Surface& surface, const BuildOptions&, LeafBlocks& blocks, BuildProgress& progress,
    const WideBvh& before, const LeafBlocks& ofBefore)
    : tree_(assembleWideBvh(surface, topologyOf(before.tree_, ofBefore, false), blocks, progress))
  {
  }

  static bool canMove(const BuildOptions& options) { return !hasParts(options); }

  [[nodiscard]] bool holds(const Surface& moved, const LeafBlocks& blocks) const
  {
    return holdAll(moved, topologyOf(this->tree_, blocks, false).leaves.references);
  }

  void save(
    const Surface&, const BuildOptions& options, const LeafBlocks& blocks, SaveWriter& writer) const
  {
    saveTopology(topologyOf(this->tree_, blocks, hasParts(options)), writer);
  }

  static StructureWalks walks()
  {
    StructureWalks walks;
    walks.kernel = wideBvhKernel;
    walks.bundle = wideBvhBundleKernel;
    walks.counting = [](const void* tree, RayState& state, CountingVisitor& visitor)
    { wideBvhCountingWalk()(*static_cast<const WideBvhNodes*>(tree), state, visitor); };
    return walks;
  }

  [[nodiscard]] const void* walked() const { return &this->tree_; }

  [[nodiscard]] HierarchyView view(const LeafBlocks& blocks) const
  {
    return viewWideBvh(this->tree_, blocks);
  }

  [[nodiscard]] BuildStatistics statistics(const Surface& surface) const
  {
    return statisticsOf(this->tree_, surface);
  }

  [[nodiscard]] std::size_t memory() const
  {
    return this->tree_.nodes.capacity() * sizeof(WideBvhNode) +
      this->tree_.firstId.capacity() * sizeof(std::uint32_t);
  }

private:
  static bool hasParts(const BuildOptions& options)
  {
    return options.bvhBuild == BvhBuild::SpatialSplits;
  }

  WideBvhNodes tree_;
};

} // namespace

std::shared_ptr<const Accelerator> buildWideBvh(
  std::shared_ptr<const Surface> surface, const BuildOptions& options, JobControl* control)
{
  return std::make_shared<TreeAccelerator<WideBvh>>(std::move(surface), options, control);
}

std::shared_ptr<const Accelerator> loadWideBvh(std::shared_ptr<const Surface> surface,
  const BuildOptions& options, SaveReader& reader, JobControl* control)
{
  return TreeAccelerator<WideBvh>::load(std::move(surface), options, reader, control);
}

} // namespace lumitree
