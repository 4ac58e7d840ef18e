// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/KdTree.h"

#include "Accel/Kernel/TreeAccelerator.h"
#include "Accel/Structures/KdTreeBuilder.h"
#include "Accel/Structures/KdTreeSave.h"
#include "Accel/Structures/KdTreeView.h"
#include "Accel/Structures/KdTreeWalk.h"
#include "Accel/Structures/Mailbox.h"

namespace lumitree
{
namespace
{

class KdTree
{
public:
  KdTree(const Surface& surface, const BuildOptions& options, LeafBlocks& blocks,
    BuildProgress& progress)
    : tree_(buildKdTreeNodes(surface, options, blocks, progress))
  {
    this->remember(options, blocks);
  }

  KdTree(const Surface& surface, const BuildOptions& options, LeafBlocks& blocks,
    BuildProgress& progress, SaveReader& reader)
    : tree_(loadKdTree(surface, blocks, progress, reader))
  {
    this->remember(options, blocks);
  }

  void save(
    const Surface& surface, const BuildOptions&, const LeafBlocks& blocks, SaveWriter& writer) const
  {
    saveKdTree(surface, this->tree_, blocks, writer);
  }

  [[nodiscard]] const void* walked() const { return this; }
  static StructureWalks walks() { return baselineWalks<KdTree>(); }

  template <class Visitor>
  void walk(const RayBox& ray, Visitor& visitor) const
  {
    walkWithMailbox(
      this->mailbox_, visitor, [&](auto& each) { walkKdTree(this->tree_, ray, each); });
  }

  [[nodiscard]] HierarchyView view(const LeafBlocks& blocks) const
  {
    return viewKdTree(this->tree_, blocks);
  }

  [[nodiscard]] std::size_t memory() const
  {
    return this->tree_.nodes.capacity() * sizeof(KdNode) + this->mailbox_.memory();
  }

private:
  void remember(const BuildOptions& options, const LeafBlocks& blocks)
  {
    for (const KdNode& node : this->tree_.nodes)
    {
      if (options.mailboxing && node.isLeaf())
      {
        this->mailbox_.add(blocks, node.first, node.count);
      }
    }
  }

  KdTreeNodes tree_;
  Mailbox mailbox_;
};

} // namespace

std::shared_ptr<const Accelerator> buildKdTree(
  std::shared_ptr<const Surface> surface, const BuildOptions& options, JobControl* control)
{
  return std::make_shared<TreeAccelerator<KdTree>>(std::move(surface), options, control);
}

std::shared_ptr<const Accelerator> loadKdTree(std::shared_ptr<const Surface> surface,
  const BuildOptions& options, SaveReader& reader, JobControl* control)
{
  return TreeAccelerator<KdTree>::load(std::move(surface), options, reader, control);
}

} // namespace lumitree
