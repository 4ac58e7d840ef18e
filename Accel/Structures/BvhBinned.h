// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BvhBinned_h
#define Lumitree_Accel_Structures_BvhBinned_h

#include "Accel/BuildProgress.h"
#include "Accel/Structures/BvhSegment.h"

namespace lumitree
{

/// A plane between bins, and what it costs: Σ half area × blocks of four.
struct BinnedPlane
{
  int axis = -1;
  int bin = 0; ///< bins below this one go left
  float cost = std::numeric_limits<float>::infinity();
  float base = 0.0f; ///< the bin of a centre is (centre - base) * scale, truncated
  float scale = 0.0f;
  BuildBox left;
  BuildBox right;

  [[nodiscard]] bool isLeft(const BuildReference& r) const
  {
    return static_cast<int>((r.centre(this->axis) - this->base) * this->scale) < this->bin;
  }
};

/// The surface-area heuristic over bins of the centres on all three axes at once (Wald 2007, "On
/// fast construction of SAH-based bounding volume hierarchies"): up to 32 bins, fewer where there
/// are few references.
class BinnedStrategy
{
public:
  /// Stretches at least this long are binned and divided by all threads together. Bins and sides
  /// are sets, so the tree is the same.
  static constexpr std::size_t sharedFrom = 65536;

  BinnedStrategy(BuildReferences& references, int leafSize, BuildProgress& progress);

  bool split(BvhSegment& segment, bool halve, BvhSegment& left, BvhSegment& right, int& axis);
  void ids(BvhSegment& segment, PrimitiveId* out) const;

  /// The cheapest plane; axis -1 where no plane parts the centres.
  [[nodiscard]] BinnedPlane best(const BvhSegment& segment) const;

  /// Divides by the plane.
  void divide(
    const BvhSegment& segment, const BinnedPlane& plane, BvhSegment& left, BvhSegment& right);

private:
  [[nodiscard]] bool isShared(const BvhSegment& segment) const
  {
    return this->together_ && segment.count() >= sharedFrom;
  }

  void divideShared(
    const BvhSegment& segment, const BinnedPlane& plane, BvhSegment& left, BvhSegment& right);

  BuildReferences& references_;
  BuildReferences spare_; ///< what divideShared copies to
  std::size_t leafSize_;
  BuildProgress& progress_;
  bool together_; ///< there are several threads
};

} // namespace lumitree

#endif
