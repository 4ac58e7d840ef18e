// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/GridBuilder.h"

#include "Accel/Structures/PrimitiveBoxOverlap.h"

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
constexpr std::size_t sampleSize = 1024;
constexpr std::size_t primitivesPerReport = 64;

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
    return this->insertEach(surface, 1) == surface.hittable().size();
  }

  /// How many references the surface needs, from a sample of its primitives.
  double estimate(const Surface& surface)
  {
    const std::size_t all = surface.hittable().size();
    const std::size_t done = this->insertEach(surface, all / sampleSize + 1);
    return static_cast<double>(this->references_.size()) * static_cast<double>(all) /
      static_cast<double>(std::max<std::size_t>(done, 1));
  }

  [[nodiscard]] const std::vector<Reference>& references() const { return this->references_; }

private:
  /// Inserts every stride-th primitive until there are more references than the limit; how many
  /// were inserted.
  std::size_t insertEach(const Surface& surface, std::size_t stride)
  {
    std::size_t done = 0;
    const std::vector<PrimitiveId>& all = surface.hittable();
    for (std::size_t i = 0; i < all.size() && this->references_.size() <= this->limit_; i += stride)
    {
      const PrimitiveBoxOverlap overlap(surface, all[i]);
      this->insert(overlap, all[i], this->lattice_.slabsOf(overlap.bounds()));
      ++done;
      if (done % primitivesPerReport == 0)
      {
        this->progress_.advance(primitivesPerReport);
      }
    }
    // The last one may have been cut short: too few rather than a wrong grid.
    return this->references_.size() <= this->limit_ ? done : std::min(done, all.size() - 1);
  }

  /// Halves blocks of cells until one cell is left: a large triangle is not tested against every
  /// cell of its box.
  void insert(const PrimitiveBoxOverlap& overlap, PrimitiveId id, const SlabRange& range)
  {
    int axis = 0;
    for (int k = 1; k < 3; ++k)
    {
      axis = range.last[k] - range.first[k] > range.last[axis] - range.first[axis] ? k : axis;
    }
    if (this->references_.size() > this->limit_ || !overlap.mayMeet(this->lattice_.box(range)))
    {
      return;
    }
    if (range.first[axis] == range.last[axis])
    {
      const std::size_t cell = this->lattice_.cell(range.first[0], range.first[1], range.first[2]);
      this->references_.push_back({ static_cast<std::uint32_t>(cell), id });
      return;
    }
    const int middle = range.first[axis] + (range.last[axis] - range.first[axis]) / 2;
    SlabRange left = range;
    SlabRange right = range;
    left.last[axis] = middle;
    right.first[axis] = middle + 1;
    this->insert(overlap, id, left);
    this->insert(overlap, id, right);
  }

  const GridLattice& lattice_;
  std::size_t limit_;
  BuildProgress& progress_;
  std::vector<Reference> references_;
};

/// Sorts references by cell; those of one cell keep their order.
GridCells arrange(GridLattice lattice, const std::vector<Reference>& references)
{
  GridCells grid;
  grid.leafOf.assign(lattice.cellCount(), 0);
  grid.lattice = std::move(lattice);
  for (const Reference& r : references)
  {
    ++grid.leafOf[r.cell];
  }
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
  grid.references.resize(references.size());
  for (const Reference& r : references)
  {
    GridCells::Leaf& leaf = grid.leaves[grid.leafOf[r.cell] - 1];
    grid.references[leaf.first + leaf.count++] = r.primitive;
  }
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
  const GridLattice lattice(surface.bounds(), resolution);
  progress.stage(0.5, surface.hittable().size());
  Insertion insertion(lattice, greatestReferences, progress);
  if (!insertion.insertAll(surface))
  {
    throw std::length_error("in a grid of " + text(resolution) +
      " cells the surface needs more than " + std::to_string(greatestReferences) + " references");
  }
  return arrange(lattice, insertion.references());
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
    const GridLattice lattice(
      surface.bounds(), GridLattice::resolutionFor(surface.bounds(), cells));
    // The number of references grows no faster than that of cells, so this factor does not
    // overshoot.
    const double excess =
      Insertion(lattice, limit, progress).estimate(surface) / static_cast<double>(limit);
    if (excess <= 1.0)
    {
      // It nearly always fits the first time.
      toDo *= 0.25;
      progress.stage(0.6 * (1.0 - toDo), primitives);
      Insertion insertion(lattice, limit, progress);
      if (insertion.insertAll(surface))
      {
        return arrange(lattice, insertion.references());
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
