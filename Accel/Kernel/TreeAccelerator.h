// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_TreeAccelerator_h
#define Lumitree_Accel_Kernel_TreeAccelerator_h

#include "Accel/Kernel/BatchRunner.h"

#include <chrono>
#include <memory>
#include <variant>

namespace lumitree
{

/// Blocks of the surface's own scalar type.
using LeafBlocks = std::variant<TriangleBlocks<float>, TriangleBlocks<double>>;

[[nodiscard]] inline LeafBlocks makeLeafBlocks(const Surface& surface)
{
  if (surface.scalar() == ArrayView::Scalar::Float)
  {
    return TriangleBlocks<float>{};
  }
  return TriangleBlocks<double>{};
}

/// An accelerator from a structure that only builds, walks and shows itself:
///
///     Tree(const Surface&, const BuildOptions&, LeafBlocks&);
///     template <class Visitor> void walk(const RayBox&, Visitor&) const;
///     HierarchyView view() const;
///     std::size_t memory() const;
template <class Tree>
class TreeAccelerator final : public Accelerator
{
public:
  TreeAccelerator(std::shared_ptr<const Surface> surface, const BuildOptions& options)
    : Accelerator(std::move(surface), options)
    , blocks_(makeLeafBlocks(this->surface()))
  {
    const auto start = std::chrono::steady_clock::now();
    this->tree_ = std::make_unique<const Tree>(this->surface(), options, this->blocks_);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;

    this->statistics_ = describe(this->hierarchy(), this->surface());
    this->statistics_.buildSeconds = elapsed.count();
    this->statistics_.memory = this->tree_->memory() +
      std::visit([](const auto& blocks) { return blocks.memory(); }, this->blocks_);
  }

  [[nodiscard]] bool supports(Precision) const override { return true; }

  QueryReport closest(
    const RayBatch& rays, Hit* hits, const QueryOptions& options) const override
  {
    return this->runner().closest(rays, hits, options);
  }

  QueryReport any(
    const RayBatch& rays, std::uint8_t* hit, const QueryOptions& options) const override
  {
    return this->runner().any(rays, hit, options);
  }

  QueryReport all(const RayBatch& rays, AllHits& hits, const QueryOptions& options) const override
  {
    return this->runner().all(rays, hits, options);
  }

  QueryReport count(
    const RayBatch& rays, std::uint32_t* counts, const QueryOptions& options) const override
  {
    return this->runner().count(rays, counts, options);
  }

  [[nodiscard]] HierarchyView hierarchy() const override { return this->tree_->view(); }

private:
  [[nodiscard]] BatchRunner runner() const
  {
    return BatchRunner(this->surface(), this->tree_.get(), walkFunctions<Tree>(),
      std::visit([](const auto& blocks) -> const void* { return &blocks; }, this->blocks_),
      this->statistics_.nodes);
  }

  LeafBlocks blocks_;
  std::unique_ptr<const Tree> tree_;
};

} // namespace lumitree

#endif
