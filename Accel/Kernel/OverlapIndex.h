// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_OverlapIndex_h
#define Lumitree_Accel_Kernel_OverlapIndex_h

#include "Accel/ConvexRegion.h"
#include "Accel/Hierarchy.h"
#include "Accel/Surface.h"

#include <cstdint>
#include <vector>

namespace lumitree
{

/// The nodes of a structure, each with the box of all that the primitives below it reach. A node's
/// own box will not do: cells hold triangles that reach beyond them, and one that lies around a
/// corner of the region, each of its cells outside another half-space, would be lost in some
/// structures only.
///
/// A primitive is left out when, for one half-space, the computed n · x is above a limit at each of
/// its vertices. A node is passed over when it is above the limit at the corner of its box where it
/// is least. Both are computed in the same order of operations, and rounding is monotone: what a
/// node's corner says holds for every vertex below, bit for bit. So the answer is a function of
/// region and surface alone, whatever the structure.
///
/// The limit is the offset and what rounding may account for. With S = Σ |n_k| M_k, M the largest
/// coordinates of the surface, n · x is off by 3.1 u S at most (a product, two sums; u = 2^-53),
/// and the limit's own sum by u (|offset| + 8 u S). The margin is 8 u S + 2 u |offset|. Normals are
/// scaled by a power of two to magnitude 1 … 2, so that nothing overflows; what that, and products,
/// lose by underflow is below 2^-1070 (1 + Σ M_k).
class OverlapIndex
{
public:
  OverlapIndex(const Surface& surface, const HierarchyView& view);

  /// The primitives not left out, ascending, each once. Throws std::invalid_argument for NaN and
  /// for normals that are not finite.
  /// limit: of Accelerator::overlap.
  void overlap(
    const ConvexRegion& region, std::vector<PrimitiveId>& primitives, std::size_t limit) const;

private:
  struct Plane;
  class Builder;

  /// In depth-first order. Nodes without primitives are left out.
  struct Node
  {
    double box[6];                    ///< lower x, y, z, upper x, y, z
    std::uint32_t next = 0;           ///< the first node behind all those below this one
    std::uint32_t firstReference = 0; ///< of the primitives below: side by side in references
    std::uint32_t referenceCount = 0;
    std::uint16_t depth = 0;
    bool leaf = false;
  };

  [[nodiscard]] std::vector<Plane> prepare(const ConvexRegion& region) const;
  [[nodiscard]] bool leftOut(
    PrimitiveId primitive, const std::vector<Plane>& planes, std::uint64_t open) const;
  void collect(const std::vector<Plane>& planes, std::vector<PrimitiveId>& primitives,
    std::size_t limit) const;

  const Surface& surface_;
  std::vector<Node> nodes_;
  std::vector<PrimitiveId> references_;
  std::size_t depth_ = 0;
};

} // namespace lumitree

#endif
