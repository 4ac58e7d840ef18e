// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_GridLattice_h
#define Lumitree_Accel_Structures_GridLattice_h

#include "Accel/Box.h"

#include <array>
#include <cstddef>
#include <vector>

namespace lumitree
{

/// Cells along a side of the blocks by which a grid skips what is empty; blocks begin at slab 0.
inline constexpr int gridBlock = 8;

/// Slabs first … last of each axis.
struct SlabRange
{
  std::array<int, 3> first = { 0, 0, 0 };
  std::array<int, 3> last = { 0, 0, 0 };
};

/// The planes that cut a box into cells. Cells are what lies between stored planes, so that builder
/// and walk speak of the same numbers.
class GridLattice
{
public:
  /// Cells of a grid of about that many cells, all nearly cubes. An axis along which the box is
  /// thinner than such a cell is not divided; no axis more than 2^20 times.
  [[nodiscard]] static std::array<int, 3> resolutionFor(const Box& bounds, double cells);

  GridLattice() = default;
  GridLattice(const Box& bounds, const std::array<int, 3>& resolution);

  [[nodiscard]] int count(int axis) const { return this->resolution_[axis]; }
  [[nodiscard]] std::size_t cellCount() const;
  [[nodiscard]] const std::vector<double>& planes(int axis) const { return this->planes_[axis]; }

  [[nodiscard]] std::size_t cell(int x, int y, int z) const
  {
    return (static_cast<std::size_t>(z) * this->resolution_[1] + y) * this->resolution_[0] + x;
  }

  /// A slab near coordinate x: only rounding away from the one that holds it, if any does.
  [[nodiscard]] int slabNear(int axis, double x) const;

  /// What a block of cells holds: the cells, and a margin of 2^-36 of the grid's size around them,
  /// inside the bounds. The margin is for Fast and Watertight, which may take for hit what a ray
  /// misses by rounding.
  [[nodiscard]] Box box(const SlabRange& range) const;

  /// The slabs whose margin included meets a box inside the bounds.
  [[nodiscard]] SlabRange slabsOf(const Box& box) const;

private:
  [[nodiscard]] double low(int axis, int slab) const
  {
    return this->planes_[axis][slab] - this->margin_;
  }
  [[nodiscard]] double high(int axis, int slab) const
  {
    return this->planes_[axis][slab + 1] + this->margin_;
  }

  Box bounds_;
  std::array<int, 3> resolution_ = { 1, 1, 1 };
  std::array<std::vector<double>, 3>
    planes_; ///< resolution + 1 each, ascending, the first and last on the bounds
  Vec3 slabsPerUnit_ = { 0, 0, 0 };
  double margin_ = 0.0;
};

} // namespace lumitree

#endif
