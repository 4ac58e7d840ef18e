// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/GridBuilder.h"

#include "Accel/Structures/TriangleBoxOverlap.h"

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

struct Reference
{
  std::uint32_t cell;
  PrimitiveId primitive;
};

/// All references of one surface in a lattice, in the order of primitives.
class Insertion
{
public:
  Insertion(const GridLattice& lattice, std::size_t limit)
    : lattice_(lattice)
    , limit_(limit)
  {
  }

  /// False as soon as there are more than the limit.
  bool insertAll(const Surface& surface)
  {
    for (const PrimitiveId id : surface.hittable())
    {
      const TriangleBoxOverlap overlap(surface.vertices(id));
      if (!this->insert(overlap, id, this->lattice_.slabsOf(overlap.bounds())))
      {
        return false;
      }
    }
    return true;
  }

  [[nodiscard]] const std::vector<Reference>& references() const { return this->references_; }

private:
  /// Halves blocks of cells until one cell is left: a large triangle is not tested against every cell of its box.
  bool insert(const TriangleBoxOverlap& overlap, PrimitiveId id, const SlabRange& range)
  {
    int axis = 0;
    for (int k = 1; k < 3; ++k)
    {
      axis = range.last[k] - range.first[k] > range.last[axis] - range.first[axis] ? k : axis;
    }
    if (!overlap.mayMeet(this->lattice_.box(range)))
    {
      return true;
    }
    if (range.first[axis] == range.last[axis])
    {
      const std::size_t cell = this->lattice_.cell(range.first[0], range.first[1], range.first[2]);
      this->references_.push_back({ static_cast<std::uint32_t>(cell), id });
      return this->references_.size() <= this->limit_;
    }
    const int middle = range.first[axis] + (range.last[axis] - range.first[axis]) / 2;
    SlabRange left = range;
    SlabRange right = range;
    left.last[axis] = middle;
    right.first[axis] = middle + 1;
    return this->insert(overlap, id, left) && this->insert(overlap, id, right);
  }

  const GridLattice& lattice_;
  std::size_t limit_;
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

GridCells buildAsAsked(const Surface& surface, const std::array<int, 3>& resolution)
{
  const double cells = static_cast<double>(resolution[0]) * resolution[1] * resolution[2];
  if (cells > static_cast<double>(greatestCells))
  {
    throw std::invalid_argument(
      "a grid of " + text(resolution) + " cells has more than " + std::to_string(greatestCells));
  }
  const GridLattice lattice(surface.bounds(), resolution);
  Insertion insertion(lattice, greatestReferences);
  if (!insertion.insertAll(surface))
  {
    throw std::length_error("in a grid of " + text(resolution) + " cells the surface needs more than " +
      std::to_string(greatestReferences) + " references");
  }
  return arrange(lattice, insertion.references());
}

GridCells buildAutomatically(const Surface& surface, double density)
{
  const std::size_t primitives = surface.hittable().size();
  const std::size_t limit = std::min(fewReferences + referencesPerPrimitive * primitives,
    std::max(greatestReferences, primitives));
  double cells = std::min(std::max(density * static_cast<double>(primitives), 1.0), greatestAutomaticCells);
  while (true)
  {
    const GridLattice lattice(surface.bounds(), GridLattice::resolutionFor(surface.bounds(), cells));
    Insertion insertion(lattice, limit);
    // One cell holds each primitive once, so this ends.
    if (insertion.insertAll(surface))
    {
      return arrange(lattice, insertion.references());
    }
    cells = std::max(0.5 * cells, 1.0);
  }
}

} // namespace

GridCells buildGridCells(const Surface& surface, const BuildOptions& options)
{
  return options.gridResolution[0] > 0 ? buildAsAsked(surface, options.gridResolution)
                                       : buildAutomatically(surface, options.gridDensity);
}

} // namespace lumitree
