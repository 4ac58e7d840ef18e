// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BvhSweep_h
#define Lumitree_Accel_Structures_BvhSweep_h

#include "Accel/BuildProgress.h"
#include "Accel/Structures/BvhSegment.h"

#include <array>

namespace lumitree
{

/// The surface-area heuristic over every way to divide the references by their centres, on all
/// three axes (Goldsmith & Salmon 1987; swept as in Wald 2007, section 3.1). They are sorted once
/// per axis, by (centre, id), and kept in order while they are divided: O(n log n).
class SweepStrategy
{
public:
  SweepStrategy(const BuildReferences& references, int leafSize, BuildProgress& progress);

  bool split(BvhSegment& segment, bool halve, BvhSegment& left, BvhSegment& right, int& axis);
  void ids(BvhSegment& segment, PrimitiveId* out) const;

private:
  struct Division
  {
    int axis = -1;
    std::size_t left = 0; ///< so many go left
    float cost = std::numeric_limits<float>::infinity();
  };

  [[nodiscard]] Division best(const BvhSegment& segment);
  void divide(
    const BvhSegment& segment, const Division& division, BvhSegment& left, BvhSegment& right);

  const BuildReferences& references_;
  std::size_t leafSize_;
  std::array<RawArray<std::uint32_t>, 3> order_; ///< indices of references
  RawArray<std::uint32_t> spare_;
  RawArray<float> rightCost_;
  RawArray<bool> isLeft_; ///< per reference
};

} // namespace lumitree

#endif
