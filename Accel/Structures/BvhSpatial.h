// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BvhSpatial_h
#define Lumitree_Accel_Structures_BvhSpatial_h

#include "Accel/Structures/BvhBinned.h"
#include "Accel/Structures/WideBvhNodes.h"
#include "Accel/Surface.h"

namespace lumitree
{

/// Spatial splits (Stich, Friedrich & Dietrich 2009, "Spatial splits in bounding volume
/// hierarchies"): where the two sides of the best object split overlap much, planes through the
/// node are tried as well; triangles across the plane go to both sides, each with the box of its
/// part, unless one side alone is cheaper.
///
/// A reference answers for every point of its triangle inside its box. Parts are clipped in double
/// in the frame, where coordinates are at most 1, and padded by 2^-44, above the 2^-50 that
/// clipping rounds: each point is in a part. A node may only have as many references as its segment
/// has room for; children share what is left by their numbers.
class SpatialStrategy
{
public:
  SpatialStrategy(const Surface& surface, const WideBvhFrame& frame, BuildReferences& references,
    const BvhSegment& root, int leafSize, BuildProgress& progress);

  bool split(BvhSegment& segment, bool halve, BvhSegment& left, BvhSegment& right, int& axis);
  void ids(BvhSegment& segment, PrimitiveId* out) const;

private:
  struct Plane;

  /// What a reference has between two planes across an axis; empty where that is nothing. Of a
  /// body, what its box has.
  [[nodiscard]] BuildBox partOf(const BuildReference& r, int axis, float low, float high) const;
  [[nodiscard]] Plane bestPlane(const BvhSegment& segment) const;

  /// False where the plane gains nothing or takes too much room; nothing is changed then.
  bool divide(const BvhSegment& segment, const Plane& plane, BvhSegment& left, BvhSegment& right);

  /// Moves the right side away from the left one, so that both have room.
  void share(const BvhSegment& segment, BvhSegment& left, BvhSegment& right);

  const Surface& surface_;
  WideBvhFrame frame_;
  BuildReferences& references_;
  BinnedStrategy binned_;
  std::size_t leafSize_;
  float leastOverlap_;
};

} // namespace lumitree

#endif
