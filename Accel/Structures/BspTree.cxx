// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/BspTree.h"

#include "Accel/Kernel/TreeAccelerator.h"
#include "Accel/Structures/BspBuilder.h"
#include "Accel/Structures/BspSave.h"
#include "Accel/Structures/BspView.h"
#include "Accel/Structures/BspWalk.h"
#include "Accel/Structures/Mailbox.h"

namespace lumitree
{
namespace
{

class BspTree
{
public:
  BspTree(const Surface& surface, const BuildOptions& options, LeafBlocks& blocks,
    BuildProgress& progress)
    : tree_(buildBspNodes(surface, options, blocks, progress))
  {
    this->remember(options, blocks);
  }

  BspTree(const Surface& surface, const BuildOptions& options, LeafBlocks& blocks,
    BuildProgress& progress, SaveReader& reader)
    : tree_(loadBspTree(surface, blocks, progress, reader))
  {
    this->remember(options, blocks);
  }

  void save(
    const Surface& surface, const BuildOptions&, const LeafBlocks& blocks, SaveWriter& writer) const
  {
    saveBspTree(surface, this->tree_, blocks, writer);
  }

  [[nodiscard]] const void* walked() const { return this; }

  static StructureWalks walks()
  {
    StructureWalks walks;
    walks.plain = [](const void* tree, RayState& state, LeafVisitor& visitor)
    { static_cast<const BspTree*>(tree)->walk(state, visitor); };
    walks.counting = [](const void* tree, RayState& state, CountingVisitor& visitor)
    { static_cast<const BspTree*>(tree)->walk(state, visitor); };
    return walks;
  }

  [[nodiscard]] HierarchyView view(const LeafBlocks& blocks) const
  {
    return viewBspTree(this->tree_, blocks);
  }

  [[nodiscard]] std::size_t memory() const
  {
    return this->tree_.nodes.capacity() * sizeof(BspNode) + this->mailbox_.memory();
  }

private:
  template <class Visitor>
  void walk(RayState& state, Visitor& visitor) const
  {
    walkWithMailbox(this->mailbox_, visitor,
      [&](auto& each) { walkBspTree(this->tree_, state.ray, state.box(), each); });
  }

  void remember(const BuildOptions& options, const LeafBlocks& blocks)
  {
    for (const BspNode& node : this->tree_.nodes)
    {
      if (options.mailboxing && node.leaf)
      {
        this->mailbox_.add(blocks, node.first, node.count);
      }
    }
  }

  BspNodes tree_;
  Mailbox mailbox_;
};

} // namespace

std::shared_ptr<const Accelerator> buildBspTree(
  std::shared_ptr<const Surface> surface, const BuildOptions& options, JobControl* control)
{
  return std::make_shared<TreeAccelerator<BspTree>>(std::move(surface), options, control);
}

std::shared_ptr<const Accelerator> loadBspTree(std::shared_ptr<const Surface> surface,
  const BuildOptions& options, SaveReader& reader, JobControl* control)
{
  return TreeAccelerator<BspTree>::load(std::move(surface), options, reader, control);
}

} // namespace lumitree
