// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BvhMorton_h
#define Lumitree_Accel_Structures_BvhMorton_h

#include "Accel/BuildProgress.h"
#include "Accel/Structures/BvhSegment.h"
#include "Accel/Structures/BvhTree.h"

namespace lumitree
{

/// A linear build (Lauterbach et al. 2009, "Fast BVH construction on GPUs"): references sorted
/// along the Morton curve through their centres, 14 bits an axis, and divided where the highest bit
/// changes; in the middle where all bits are the same. The quickest to build.
class MortonStrategy
{
public:
  /// Sorts the references.
  MortonStrategy(const BuildReferences& references, const BvhSegment& root, int leafSize,
    BuildProgress& progress);

  bool split(BvhSegment& segment, bool halve, BvhSegment& left, BvhSegment& right, int& axis);
  void ids(BvhSegment& segment, PrimitiveId* out) const;

private:
  RawArray<std::uint64_t> codes_; ///< ascending
  BuildReferences references_;    ///< in that order
  std::size_t leafSize_;
};

/// Makes boxes of inner nodes those of their children, from the leaves up; leaves have theirs.
void boundFromBelow(BvhTree& tree);

} // namespace lumitree

#endif
