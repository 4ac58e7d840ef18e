// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_TriangleBoxOverlap_h
#define Lumitree_Accel_Structures_TriangleBoxOverlap_h

#include "Accel/Box.h"

#include <array>

namespace lumitree
{

/// Whether a closed triangle and closed boxes have a point in common, by separating axes
/// (Akenine-Möller 2001, "Fast 3D triangle-box overlap testing", J. Graphics Tools 6(1)): three box
/// normals, nine cross products of edges, the triangle's normal. Prepared once per triangle, then
/// asked about many boxes.
///
/// It never loses a box that the triangle touches: the box normals are compared without rounding,
/// and the other axes only separate by more than a bound of the rounding errors. A box that the
/// triangle misses by less than about 2^-48 of the distances involved may be taken for met.
class TriangleBoxOverlap
{
public:
  /// Corners must be finite and within coordinateLimit.
  explicit TriangleBoxOverlap(const std::array<Vec3, 3>& corners);

  /// The triangle's own bounds.
  [[nodiscard]] const Box& bounds() const { return this->bounds_; }

  [[nodiscard]] bool mayMeet(const Box& box) const;

private:
  std::array<Vec3, 3> corners_;
  std::array<Vec3, 3>
    edges_; ///< scaled by one power of two, so that the largest component is near 1
  Vec3 normal_;
  Vec3
    normalReach_; ///< sums of the magnitudes that each component of the normal is a difference of
  Box bounds_;
};

} // namespace lumitree

#endif
