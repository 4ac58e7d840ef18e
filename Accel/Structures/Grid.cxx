// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/Grid.h"

#include "Accel/Kernel/TreeAccelerator.h"
#include "Accel/Structures/GridBuilder.h"
#include "Accel/Structures/GridSweep.h"
#include "Accel/Structures/Mailbox.h"

namespace lumitree
{
namespace
{

class Grid
{
public:
  Grid(const Surface& surface, const BuildOptions& options, LeafBlocks& blocks,
    BuildProgress& progress)
    : cells_(buildGridCells(surface, options, progress))
  {
    std::visit([&](auto& store) { this->fill(surface, store, progress); }, blocks);
    for (std::size_t i = 0; options.mailboxing && i < this->cells_.leaves.size(); ++i)
    {
      this->mailbox_.add(blocks, this->firstBlock_[i], this->cells_.leaves[i].count);
    }
  }

  /// What is in which cell follows from the surface: cells are filled again.
  Grid(const Surface& surface, const BuildOptions& options, LeafBlocks& blocks,
    BuildProgress& progress, SaveReader& reader)
    : Grid(surface, withResolution(surface, options, reader), blocks, progress)
  {
    require(this->cells_.leaves.size() == reader.get<std::uint64_t>() &&
        this->cells_.references.size() == reader.get<std::uint64_t>(),
      "its cells are not those of its surface");
  }

  void save(
    const Surface& surface, const BuildOptions&, const LeafBlocks&, SaveWriter& writer) const
  {
    const GridLattice& lattice = this->cells_.lattice;
    require(isSaved(surface, { lattice.count(0), lattice.count(1), lattice.count(2) }),
      "a grid of more than 1000 cells a primitive, and 65536, is not saved: it is built again");
    for (int k = 0; k < 3; ++k)
    {
      writer.put(static_cast<std::int32_t>(this->cells_.lattice.count(k)));
    }
    writer.put(std::uint64_t{ this->cells_.leaves.size() });
    writer.put(std::uint64_t{ this->cells_.references.size() });
  }

  [[nodiscard]] const void* walked() const { return this; }
  static StructureWalks walks() { return baselineWalks<Grid>(); }

  template <class Visitor>
  void walk(const RayBox& ray, Visitor& visitor) const
  {
    walkWithMailbox(this->mailbox_, visitor, [&](auto& each) { this->walkCells(ray, each); });
  }

private:
  template <class Visitor>
  void walkCells(const RayBox& ray, Visitor& visitor) const
  {
    GridSweep sweep(this->cells_.lattice, ray);
    if (!sweep.start(visitor.tStop()))
    {
      return;
    }
    visitor.node(0);
    std::uint32_t leaf = 0;
    do
    {
      sweep.forEachCell(
        [&](std::ptrdiff_t cell)
        {
          visitor.cell();
          leaf = this->cells_.leafOf[static_cast<std::size_t>(cell)];
          if (leaf > 0 && leaf != GridCells::emptyBlock)
          {
            visitor.node(leaf);
            visitor.leaf(
              { this->firstBlock_[leaf - 1], this->cells_.leaves[leaf - 1].count, sweep.tEnter() });
          }
        });
    } while (sweep.advance(visitor.tStop(), leaf == GridCells::emptyBlock));
  }

public:
  /// The grid, then its occupied cells.
  [[nodiscard]] HierarchyView view(const LeafBlocks&) const
  {
    const GridLattice& lattice = this->cells_.lattice;
    HierarchyView view;
    view.references = this->cells_.references;
    view.nodes.resize(this->cells_.leaves.size() + 1);
    SlabRange all;
    for (int k = 0; k < 3; ++k)
    {
      all.last[k] = lattice.count(k) - 1;
      view.gridResolution[k] = lattice.count(k);
    }
    view.nodes[0].box = lattice.box(all);
    view.nodes[0].leaf = this->cells_.leaves.empty();
    for (int z = 0; z <= all.last[2]; ++z)
    {
      for (int y = 0; y <= all.last[1]; ++y)
      {
        for (int x = 0; x <= all.last[0]; ++x)
        {
          const std::uint32_t leaf = this->cells_.leafOf[lattice.cell(x, y, z)];
          if (leaf > 0 && leaf != GridCells::emptyBlock)
          {
            HierarchyNode& node = view.nodes[leaf];
            node.box = lattice.box({ { x, y, z }, { x, y, z } });
            node.parent = 0;
            node.depth = 1;
            node.leaf = true;
            node.firstReference = this->cells_.leaves[leaf - 1].first;
            node.referenceCount = this->cells_.leaves[leaf - 1].count;
          }
        }
      }
    }
    completeHierarchy(view);
    return view;
  }

  [[nodiscard]] std::size_t memory() const
  {
    return this->cells_.leafOf.capacity() * sizeof(std::uint32_t) +
      this->cells_.leaves.capacity() * sizeof(GridCells::Leaf) +
      this->cells_.references.capacity() * sizeof(PrimitiveId) +
      this->firstBlock_.capacity() * sizeof(std::uint32_t) + this->mailbox_.memory();
  }

private:
  /// Whether a grid has so few cells that a small file cannot make much work.
  static bool isSaved(const Surface& surface, const std::array<int, 3>& resolution)
  {
    const double cells = static_cast<double>(resolution[0]) * resolution[1] * resolution[2];
    return cells <= 65536.0 + 1000.0 * static_cast<double>(surface.hittable().size());
  }

  static BuildOptions withResolution(
    const Surface& surface, const BuildOptions& options, SaveReader& reader)
  {
    BuildOptions asked = options;
    for (int& cells : asked.gridResolution)
    {
      cells = reader.get<std::int32_t>();
      require(cells >= 1 && cells <= 1 << 20, "a grid has no such resolution");
    }
    require(isSaved(surface, asked.gridResolution), "a grid has too many cells for its surface");
    require(reader.left() == 2 * sizeof(std::uint64_t), "it does not end where a grid does");
    return asked;
  }

  static constexpr std::size_t leavesPerChunk = 256;

  /// Cells that hold one and the same single primitive share its block: a large triangle fills
  /// many.
  template <class Store>
  void fill(const Surface& surface, Store& store, BuildProgress& progress)
  {
    constexpr std::uint32_t none = ~std::uint32_t{ 0 };
    const std::vector<GridCells::Leaf>& leaves = this->cells_.leaves;
    std::vector<std::uint32_t> alone(surface.size(), none);
    this->firstBlock_.resize(leaves.size());
    std::vector<std::uint32_t> filled; // leaves with blocks of their own
    filled.reserve(leaves.size());
    std::size_t blocks = 0;
    for (std::uint32_t i = 0; i < leaves.size(); ++i)
    {
      const std::uint32_t count = leaves[i].count;
      std::uint32_t& shared = alone[this->cells_.references[leaves[i].first]];
      const bool again = count == 1 && shared != none;
      this->firstBlock_[i] = again ? shared : static_cast<std::uint32_t>(blocks);
      if (!again)
      {
        filled.push_back(i);
        blocks += (count + blockWidth - 1) / blockWidth;
      }
      shared = count == 1 ? this->firstBlock_[i] : shared;
    }
    store.resize(blocks);
    progress.stage(0.99, filled.size());
    progress.forEach(filled.size(), leavesPerChunk,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          const GridCells::Leaf& leaf = leaves[filled[i]];
          store.put(this->firstBlock_[filled[i]], surface,
            this->cells_.references.data() + leaf.first, leaf.count);
        }
      });
  }

  GridCells cells_;
  std::vector<std::uint32_t> firstBlock_; ///< per leaf
  Mailbox mailbox_;
};

} // namespace

std::shared_ptr<const Accelerator> buildGrid(
  std::shared_ptr<const Surface> surface, const BuildOptions& options, JobControl* control)
{
  return std::make_shared<TreeAccelerator<Grid>>(std::move(surface), options, control);
}

std::shared_ptr<const Accelerator> loadGrid(std::shared_ptr<const Surface> surface,
  const BuildOptions& options, SaveReader& reader, JobControl* control)
{
  return TreeAccelerator<Grid>::load(std::move(surface), options, reader, control);
}

} // namespace lumitree
