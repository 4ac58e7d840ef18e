// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_QuadricHits_h
#define Lumitree_Accel_Kernel_QuadricHits_h

#include "Accel/Choices.h"
#include "Accel/Kernel/RayState.h"

namespace lumitree
{

/// Hits of one quadric within the limits of the ray, in the order of t.
struct QuadricHits
{
  int count = 0;
  std::array<Candidate, 2> hits;
};

/// A pure function of ray, quadric and precision, except that quadrics whose box begins beyond
/// state.tStop are passed over. As for triangles: Fast takes floating point at its word, Watertight
/// counts whatever is not certain (what is nearly tangent as one hit), Exact settles it.
[[nodiscard]] QuadricHits quadricHits(RayState& state, PrimitiveId primitive, Precision precision);

/// Where the ray, moved as for Crossings, passes through the quadric.
[[nodiscard]] QuadricHits quadricPassages(RayState& state, PrimitiveId primitive);

/// Sign of (t of a - t of b), exactly; either may be a triangle. Of an implicit t is what was
/// computed, and the ray is noted as one whose order is not certain.
[[nodiscard]] int compareExactly(RayState& state, const Candidate& a, const Candidate& b);

/// The double nearest to t of a quadric's hit.
[[nodiscard]] double nearestParameter(const RayState& state, const Candidate& c);

} // namespace lumitree

#endif
