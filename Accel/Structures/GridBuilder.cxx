// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/GridBuilder.h"

#include "Accel/Structures/PrimitiveBoxOverlap.h"

#include <algorithm>
#include <atomic>
#include <stdexcept>

namespace lumitree
{
namespace
{

constexpr double greatestAutomaticCells = 0x1p25;
constexpr std::size_t greatestCells = std::size_t{ 1 } << 27;
constexpr std::size_t greatestReferences = std::size_t{ 1 } << 26;
constexpr std::size_t fewReferences = 65536;
constexpr std::size_t referencesPerPrimitive = 16;
/// Primitives that a thread inserts at a time.
constexpr std::size_t chunk = 256;

struct Reference
{
  std::uint32_t cell;
  PrimitiveId primitive;
};

/// All references of one surface in a lattice, in the order of primitives.
class Insertion
{
public:
  Insertion(const GridLattice& lattice, std::size_t limit, BuildProgress& progress)
    : lattice_(lattice)
    , limit_(limit)
    , progress_(progress)
  {
  }

  /// False as soon as there are more than the limit.
  bool insertAll(const Surface& surface)
  {
    const std::vector<PrimitiveId>& ids = surface.hittable();
    this->chunks_.assign((ids.size() + chunk - 1) / chunk, {});
    this->progress_.forEach(ids.size(), chunk,
      [&](std::size_t begin, std::size_t end)
      {
        std::vector<Reference>& references = this->chunks_[begin / chunk];
        std::size_t counted = 0;
        for (std::size_t i = begin; i < end && !this->full(0); ++i)
        {
          const PrimitiveBoxOverlap overlap(surface, ids[i]);
          this->insert(overlap, ids[i], this->lattice_.slabsOf(overlap.bounds()), references);
          this->held_.fetch_add(references.size() - counted, std::memory_order_relaxed);
          counted = references.size();
        }
      });
    return !this->full(0);
  }

  /// Calls use(reference) for each in order.
  template <class Use>
  void forEach(const Use& use) const
  {
    for (const std::vector<Reference>& references : this->chunks_)
    {
      std::for_each(references.begin(), references.end(), use);
    }
  }

  [[nodiscard]] std::size_t size() const { return this->held_.load(std::memory_order_relaxed); }

private:
  /// Halves blocks of cells until one cell is left: a large triangle is not tested against every
  /// cell of its box.
  void insert(const PrimitiveBoxOverlap& overlap, PrimitiveId id, const SlabRange& range,
    std::vector<Reference>& references) const
  {
    int axis = 0;
    for (int k = 1; k < 3; ++k)
    {
      axis = range.last[k] - range.first[k] > range.last[axis] - range.first[axis] ? k : axis;
    }
    if (this->full(references.size()) || !overlap.mayMeet(this->lattice_.box(range)))
    {
      return;
    }
    if (range.first[axis] == range.last[axis])
    {
      const std::size_t cell = this->lattice_.cell(range.first[0], range.first[1], range.first[2]);
      references.push_back({ static_cast<std::uint32_t>(cell), id });
      return;
    }
    const int middle = range.first[axis] + (range.last[axis] - range.first[axis]) / 2;
    SlabRange left = range;
    SlabRange right = range;
    left.last[axis] = middle;
    right.first[axis] = middle + 1;
    this->insert(overlap, id, left, references);
    this->insert(overlap, id, right, references);
  }

  /// Whether there are more references than allowed, or so many in one chunk.
  [[nodiscard]] bool full(std::size_t references) const
  {
    return std::max(references, this->size()) > this->limit_;
  }

  const GridLattice& lattice_;
  std::size_t limit_;
  BuildProgress& progress_;
  std::vector<std::vector<Reference>> chunks_;
  std::atomic<std::size_t> held_{ 0 };
};

/// References that a surface needs at the very least, but for rounding: seen along an axis, a
/// triangle covers as many columns of cells as its shadow is larger than one of them, and it is in
/// a cell of each. Quick: nothing is inserted.
double leastReferences(const Surface& surface, const std::array<int, 3>& resolution)
{
  const Vec3 size = surface.bounds().size();
  Vec3 perUnit;
  for (int k = 0; k < 3; ++k)
  {
    perUnit[k] = size[k] > 0.0 ? resolution[k] / size[k] : 0.0;
    // A subnormal size has no reciprocal: nothing is known then.
    perUnit[k] = std::isfinite(perUnit[k]) ? perUnit[k] : 0.0;
  }
  double sum = 0.0;
  for (const PrimitiveId id : surface.hittable())
  {
    double most = 1.0;
    if (surface.isTriangle(id))
    {
      const auto v = surface.vertices(id);
      Vec3 a = v[1] - v[0];
      Vec3 b = v[2] - v[0];
      for (int k = 0; k < 3; ++k)
      {
        a[k] *= perUnit[k];
        b[k] *= perUnit[k];
      }
      for (const double shadow : cross(a, b))
      {
        most = std::max(most, 0.5 * std::fabs(shadow));
      }
    }
    sum += most;
  }
  return sum;
}

/// Marks the cells of blocks that hold nothing.
void markEmptyBlocks(GridCells& grid)
{
  const GridLattice& lattice = grid.lattice;
  const auto forEachCell = [&](const SlabRange& block, const auto& use)
  {
    for (int z = block.first[2]; z <= block.last[2]; ++z)
    {
      for (int y = block.first[1]; y <= block.last[1]; ++y)
      {
        const std::size_t row = lattice.cell(block.first[0], y, z);
        use(grid.leafOf.begin() + static_cast<std::ptrdiff_t>(row),
          grid.leafOf.begin() +
            static_cast<std::ptrdiff_t>(row + block.last[0] - block.first[0] + 1));
      }
    }
  };
  SlabRange block;
  const auto place = [&](int axis, int slab)
  {
    block.first[axis] = slab;
    block.last[axis] = std::min(slab + gridBlock, lattice.count(axis)) - 1;
  };
  for (int z = 0; z < lattice.count(2); z += gridBlock)
  {
    place(2, z);
    for (int y = 0; y < lattice.count(1); y += gridBlock)
    {
      place(1, y);
      for (int x = 0; x < lattice.count(0); x += gridBlock)
      {
        place(0, x);
        bool empty = true;
        forEachCell(block,
          [&](auto begin, auto end) {
            empty = empty && std::all_of(begin, end, [](std::uint32_t leaf) { return leaf == 0; });
          });
        if (empty)
        {
          forEachCell(
            block, [](auto begin, auto end) { std::fill(begin, end, GridCells::emptyBlock); });
        }
      }
    }
  }
}

/// Sorts references by cell; those of one cell keep their order.
GridCells arrange(GridLattice lattice, const Insertion& insertion)
{
  GridCells grid;
  grid.leafOf.assign(lattice.cellCount(), 0);
  grid.lattice = std::move(lattice);
  insertion.forEach([&](const Reference& r) { ++grid.leafOf[r.cell]; });
  std::uint32_t first = 0;
  for (std::uint32_t& entry : grid.leafOf)
  {
    if (entry > 0)
    {
      grid.leaves.push_back({ first, 0 });
      first += entry;
      entry = static_cast<std::uint32_t>(grid.leaves.size());
    }
  }
  grid.references.resize(insertion.size());
  insertion.forEach(
    [&](const Reference& r)
    {
      GridCells::Leaf& leaf = grid.leaves[grid.leafOf[r.cell] - 1];
      grid.references[leaf.first + leaf.count++] = r.primitive;
    });
  markEmptyBlocks(grid);
  return grid;
}

std::string text(const std::array<int, 3>& resolution)
{
  return std::to_string(resolution[0]) + " × " + std::to_string(resolution[1]) + " × " +
    std::to_string(resolution[2]);
}

GridCells buildAsAsked(
  const Surface& surface, const std::array<int, 3>& resolution, BuildProgress& progress)
{
  const double cells = static_cast<double>(resolution[0]) * resolution[1] * resolution[2];
  if (cells > static_cast<double>(greatestCells))
  {
    throw std::invalid_argument(
      "a grid of " + text(resolution) + " cells has more than " + std::to_string(greatestCells));
  }
  const auto refuse = [&]
  {
    throw std::length_error("in a grid of " + text(resolution) +
      " cells the surface needs more than " + std::to_string(greatestReferences) + " references");
  };
  if (leastReferences(surface, resolution) > 1.001 * static_cast<double>(greatestReferences))
  {
    refuse();
  }
  const GridLattice lattice(surface.bounds(), resolution);
  progress.stage(0.5, surface.hittable().size());
  Insertion insertion(lattice, greatestReferences, progress);
  if (!insertion.insertAll(surface))
  {
    refuse();
  }
  return arrange(lattice, insertion);
}

GridCells buildAutomatically(const Surface& surface, double density, BuildProgress& progress)
{
  const std::size_t primitives = surface.hittable().size();
  const std::size_t limit = std::min(
    fewReferences + referencesPerPrimitive * primitives, std::max(greatestReferences, primitives));
  double cells =
    std::min(std::max(density * static_cast<double>(primitives), 1.0), greatestAutomaticCells);
  double toDo = 1.0;
  while (true)
  {
    const std::array<int, 3> resolution = GridLattice::resolutionFor(surface.bounds(), cells);
    const GridLattice lattice(surface.bounds(), resolution);
    // The number of references grows no faster than that of cells, so this factor does not
    // overshoot.
    const double excess = leastReferences(surface, resolution) / static_cast<double>(limit);
    if (excess <= 1.0)
    {
      // It nearly always fits the first time.
      toDo *= 0.25;
      progress.stage(0.6 * (1.0 - toDo), primitives);
      Insertion insertion(lattice, limit, progress);
      if (insertion.insertAll(surface))
      {
        return arrange(lattice, insertion);
      }
    }
    // One cell holds each primitive once, so this ends.
    cells = std::max((excess > 1.0 ? std::min(0.9, 1.0 / excess) : 0.5) * cells, 1.0);
  }
}

} // namespace

GridCells buildGridCells(
  const Surface& surface, const BuildOptions& options, BuildProgress& progress)
{
  return options.gridResolution[0] > 0 ? buildAsAsked(surface, options.gridResolution, progress)
                                       : buildAutomatically(surface, options.gridDensity, progress);
}

} // namespace lumitree
