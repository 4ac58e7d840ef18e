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
    std::size_t done = 0;
    for (const PrimitiveId id : surface.hittable())
    {
      const PrimitiveBoxOverlap overlap(surface, id);
      this->insert(overlap, id, this->lattice_.slabsOf(overlap.bounds()));
      if (this->references_.size() > this->limit_)
      {
        return false;
      }
      if (++done % primitivesPerReport == 0)
      {
        this->progress_.advance(primitivesPerReport);
      }
    }
    return true;
  }

  [[nodiscard]] const std::vector<Reference>& references() const { return this->references_; }

private:
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
    if (!surface.isQuadric(id))
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
