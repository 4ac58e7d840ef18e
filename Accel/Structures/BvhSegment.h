// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BvhSegment_h
#define Lumitree_Accel_Structures_BvhSegment_h

#include "Accel/Structures/BuildBox.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lumitree
{

/// A stretch of references that becomes a node.
///
/// What divides them, a strategy, is a class with
///
///     bool split(BvhSegment& segment, bool halve, BvhSegment& left, BvhSegment& right, int& axis);
///     void ids(BvhSegment& leaf, PrimitiveId* out) const;
///
/// split divides a segment of at least two references into two that hold one at least, by
/// reordering its own stretch, or returns false: it is to be a leaf. halve asks for two halves.
/// ids writes the primitives of a leaf and sets its bounds, where the strategy bounds from below.
/// Threads work on stretches that do not overlap.
struct BvhSegment
{
  std::size_t begin = 0;
  std::size_t end = 0;
  std::size_t limit = 0; ///< there is room for references up to here
  BuildBox bounds;
  BuildBox centres; ///< of twice the centres; not looked at where a leaf is certain
  std::uint32_t node = 0;
  int depth = 0;

  [[nodiscard]] std::size_t count() const { return this->end - this->begin; }
};

/// Up to so many references are a leaf, if leafSize allows.
inline constexpr std::size_t bvhBlock = 4;

/// Leaf tests go by blocks of four primitives.
[[nodiscard]] inline float blocksOf(std::size_t count)
{
  return static_cast<float>((count + bvhBlock - 1) / bvhBlock);
}

/// Halves a segment along an axis by (centre, id).
void halveSegment(BuildReferences& references, int axis, const BvhSegment& segment,
  BvhSegment& left, BvhSegment& right);

} // namespace lumitree

#endif
