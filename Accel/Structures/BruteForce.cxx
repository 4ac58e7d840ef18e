// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/BruteForce.h"

#include "Accel/Kernel/TreeAccelerator.h"

namespace lumitree
{
namespace
{

/// One leaf with everything in it.
class BruteForce
{
public:
  BruteForce(const Surface& surface, const BuildOptions&, LeafBlocks& blocks, BuildProgress&)
    : surface_(surface)
  {
    const auto& all = surface.hittable();
    std::visit([&](auto& store) { store.append(surface, all.data(), all.size()); }, blocks);
  }

  BruteForce(const Surface& surface, const BuildOptions& options, LeafBlocks& blocks,
    BuildProgress& progress, SaveReader&)
    : BruteForce(surface, options, blocks, progress)
  {
  }

  /// There is nothing to tell.
  void save(const Surface&, const BuildOptions&, const LeafBlocks&, SaveWriter&) const {}

  [[nodiscard]] const void* walked() const { return this; }
  static StructureWalks walks() { return baselineWalks<BruteForce>(); }

  template <class Visitor>
  void walk(const RayBox& ray, Visitor& visitor) const
  {
    visitor.node(0);
    visitor.leaf({ 0, static_cast<std::uint32_t>(this->surface_.hittable().size()), ray.tMin() });
  }

  [[nodiscard]] HierarchyView view(const LeafBlocks&) const
  {
    HierarchyView view;
    view.references = this->surface_.hittable();
    HierarchyNode root;
    root.box = this->surface_.bounds();
    root.leaf = true;
    root.referenceCount = static_cast<std::uint32_t>(view.references.size());
    view.nodes.push_back(root);
    completeHierarchy(view);
    return view;
  }

  [[nodiscard]] std::size_t memory() const { return 0; }

private:
  const Surface& surface_;
};

} // namespace

std::shared_ptr<const Accelerator> buildBruteForce(
  std::shared_ptr<const Surface> surface, const BuildOptions& options, JobControl* control)
{
  return std::make_shared<TreeAccelerator<BruteForce>>(std::move(surface), options, control);
}

std::shared_ptr<const Accelerator> loadBruteForce(std::shared_ptr<const Surface> surface,
  const BuildOptions& options, SaveReader& reader, JobControl* control)
{
  return TreeAccelerator<BruteForce>::load(std::move(surface), options, reader, control);
}

} // namespace lumitree
