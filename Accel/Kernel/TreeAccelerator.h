// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_TreeAccelerator_h
#define Lumitree_Accel_Kernel_TreeAccelerator_h

#include "Accel/BuildProgress.h"
#include "Accel/Kernel/BatchRunner.h"
#include "Accel/Kernel/LeafBlocks.h"
#include "Accel/Save/SaveStream.h"

#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <type_traits>

namespace lumitree
{

/// Whether a structure has statistics of its own.
///@{
template <class Tree, class = void>
struct CountsItself : std::false_type
{
};
template <class Tree>
struct CountsItself<Tree,
  std::void_t<decltype(std::declval<const Tree&>().statistics(std::declval<const Surface&>()))>>
  : std::true_type
{
};
///@}

/// Whether a structure can be fitted to points that moved.
///@{
template <class Tree, class = void>
struct CanBeRefitted : std::false_type
{
};
template <class Tree>
struct CanBeRefitted<Tree,
  std::void_t<decltype(std::declval<const Tree&>().holds(
    std::declval<const Surface&>(), std::declval<const LeafBlocks&>()))>> : std::true_type
{
};
///@}

/// An accelerator from a structure that only builds, walks and shows itself:
///
///     Tree(const Surface&, const BuildOptions&, LeafBlocks&, BuildProgress&);
///     static StructureWalks walks();
///     const void* walked() const; // what the walks take as their structure
///     HierarchyView view(const LeafBlocks&) const;
///     std::size_t memory() const;
///
/// that can be saved
///
///     void save(const Surface&, const BuildOptions&, const LeafBlocks&, SaveWriter&) const;
///     Tree(const Surface&, const BuildOptions&, LeafBlocks&, BuildProgress&, SaveReader&);
///
/// where points may move
///
///     static bool canMove(const BuildOptions&); // whether the next can be
///     bool holds(const Surface& moved, const LeafBlocks&) const; // and holds all that can be hit
///     Tree(const Surface&, const BuildOptions&, LeafBlocks&, BuildProgress&, const Tree& before,
///       const LeafBlocks& ofBefore);
///
/// and where the view takes long to make
///
///     BuildStatistics statistics(const Surface&) const; // what describe says of the view
template <class Tree>
class TreeAccelerator final : public Accelerator
{
public:
  using MakeTree = std::function<std::unique_ptr<const Tree>(
    const Surface&, const BuildOptions&, LeafBlocks&, BuildProgress&)>;

  /// Builds the tree.
  TreeAccelerator(
    std::shared_ptr<const Surface> surface, const BuildOptions& options, JobControl* control)
    : TreeAccelerator(std::move(surface), options, control, Origin::Built,
        [](const Surface& s, const BuildOptions& o, LeafBlocks& blocks, BuildProgress& progress)
        { return std::make_unique<const Tree>(s, o, blocks, progress); })
  {
    this->statistics_.sahCostBuilt = this->statistics_.sahCost;
  }

  /// What saveTo wrote.
  [[nodiscard]] static std::shared_ptr<const Accelerator> load(
    std::shared_ptr<const Surface> surface, const BuildOptions& options, SaveReader& reader,
    JobControl* control)
  {
    const auto sahCostBuilt = reader.get<double>();
    require(std::isfinite(sahCostBuilt) && sahCostBuilt >= 0.0, "its cost is no cost");
    auto loaded =
      std::make_shared<TreeAccelerator>(std::move(surface), options, control, Origin::Loaded,
        [&](const Surface& s, const BuildOptions& o, LeafBlocks& blocks, BuildProgress& progress)
        { return std::make_unique<const Tree>(s, o, blocks, progress, reader); });
    require(reader.left() == 0, "it holds more than its structure has");
    loaded->statistics_.sahCostBuilt = sahCostBuilt;
    return loaded;
  }

  TreeAccelerator(std::shared_ptr<const Surface> surface, const BuildOptions& options,
    JobControl* control, Origin origin, const MakeTree& make)
    : Accelerator(std::move(surface), options)
    , blocks_(makeLeafBlocks(this->surface()))
  {
    const auto start = std::chrono::steady_clock::now();
    BuildProgress progress(control, options.threads);
    progress.stage(0.0, 1);
    this->tree_ = make(this->surface(), options, this->blocks_, progress);
    progress.stage(1.0, 0);
    progress.advance(1);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;

    if constexpr (CountsItself<Tree>::value)
    {
      this->statistics_ = this->tree_->statistics(this->surface());
    }
    else
    {
      this->statistics_ = describe(this->hierarchy(), this->surface());
    }
    this->statistics_.origin = origin;
    this->statistics_.buildSeconds = elapsed.count();
    this->statistics_.memory = this->tree_->memory() +
      std::visit([](const auto& blocks) { return blocks.memory(); }, this->blocks_);
  }

  [[nodiscard]] bool supports(Precision) const override { return true; }

  QueryReport closest(const RayBatch& rays, Hit* hits, const QueryOptions& options) const override
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

  QueryReport ties(const RayBatch& rays, AllHits& hits, const QueryOptions& options) const override
  {
    return this->runner().ties(rays, hits, options);
  }

  QueryReport crossings(
    const RayBatch& rays, std::uint32_t* counts, const QueryOptions& options) const override
  {
    return this->runner().crossings(rays, counts, options);
  }

  [[nodiscard]] HierarchyView hierarchy() const override
  {
    return this->tree_->view(this->blocks_);
  }

protected:
  [[nodiscard]] std::shared_ptr<const Accelerator> refitted(
    std::shared_ptr<const Surface> surface, int threads, JobControl* control) const override
  {
    if constexpr (CanBeRefitted<Tree>::value)
    {
      // A tree holds all that could be hit when it was made.
      const bool holdsAll = this->surface().hittable().size() == this->surface().size();
      if (Tree::canMove(this->options()) &&
        (holdsAll || this->tree_->holds(*surface, this->blocks_)))
      {
        BuildOptions options = this->options();
        options.threads = threads;
        auto fitted = std::make_shared<TreeAccelerator>(std::move(surface), options, control,
          Origin::Refitted,
          [&](const Surface& s, const BuildOptions& o, LeafBlocks& blocks, BuildProgress& progress)
          {
            return std::make_unique<const Tree>(
              s, o, blocks, progress, *this->tree_, this->blocks_);
          });
        fitted->statistics_.sahCostBuilt = this->statistics().sahCostBuilt;
        fitted->statistics_.choice = this->statistics().choice;
        return fitted;
      }
    }
    return nullptr;
  }

  bool saveTo(SaveWriter& writer) const override
  {
    writer.put(this->statistics().sahCostBuilt);
    this->tree_->save(this->surface(), this->options(), this->blocks_, writer);
    return true;
  }

private:
  [[nodiscard]] BatchRunner runner() const
  {
    return BatchRunner(this->surface(), this->tree_->walked(), Tree::walks(),
      std::visit([](const auto& blocks) -> const void* { return &blocks; }, this->blocks_),
      this->statistics_.nodes, this->statistics_.memory);
  }

  LeafBlocks blocks_;
  std::unique_ptr<const Tree> tree_;
};

} // namespace lumitree

#endif
