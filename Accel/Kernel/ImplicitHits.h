// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_ImplicitHits_h
#define Lumitree_Accel_Kernel_ImplicitHits_h

#include "Accel/Choices.h"
#include "Accel/Kernel/RayState.h"

#include <vector>

namespace lumitree
{

/// Hits of one implicit within the limits of the ray, in the order of t: all, or the first. A pure
/// function of ray, implicit and precision, except that what begins beyond state.tStop is passed
/// over, and what has been asked for along this ray is not given again. Fast leaves out what is not
/// certain and has no change of sign either.
[[nodiscard]] std::vector<Candidate> implicitHits(
  RayState& state, PrimitiveId primitive, Precision precision, bool everyRoot);

/// Where the sign of an implicit that is bounded changes along the ray: so many times that the
/// parity is right, however close together.
[[nodiscard]] std::vector<Candidate> implicitPassages(RayState& state, PrimitiveId primitive);

} // namespace lumitree

#endif
