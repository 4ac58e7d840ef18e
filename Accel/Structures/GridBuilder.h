// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_GridBuilder_h
#define Lumitree_Accel_Structures_GridBuilder_h

#include "Accel/BuildOptions.h"
#include "Accel/BuildProgress.h"
#include "Accel/Structures/GridLattice.h"
#include "Accel/Surface.h"

namespace lumitree
{

/// Which cells hold which primitives.
struct GridCells
{
  struct Leaf
  {
    std::uint32_t first = 0; ///< of its primitives in references
    std::uint32_t count = 0;
  };

  /// In place of a leaf: neither the cell nor any other of its block of gridBlock³ holds anything,
  /// so that a walk may go on behind the block.
  static constexpr std::uint32_t emptyBlock = ~std::uint32_t{ 0 };

  GridLattice lattice;
  /// Per cell: 1 + the cell's leaf; 0 for an empty cell, or emptyBlock.
  std::vector<std::uint32_t> leafOf;
  std::vector<Leaf> leaves;            ///< occupied cells, in the order of cells
  std::vector<PrimitiveId> references; ///< ascending within a leaf
};

/// Puts each primitive into every cell that its surface meets.
///
/// Automatic resolution: gridDensity cells per primitive, at most 2^25 cells; lowered for as long
/// as primitives would be held more than 16 times on average (65536 references are always allowed).
/// A resolution that is asked for is kept, or refused: std::invalid_argument beyond 2^27 cells,
/// std::length_error beyond 2^26 references.
[[nodiscard]] GridCells buildGridCells(
  const Surface& surface, const BuildOptions& options, BuildProgress& progress);

} // namespace lumitree

#endif
