// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_Finish_h
#define Lumitree_Accel_Kernel_Finish_h

#include "Accel/Choices.h"
#include "Accel/Kernel/RayState.h"

namespace lumitree
{

/// Orders what All or Count collected, by the precision's order, duplicates dropped.
void arrange(RayState& state, Precision precision);

/// The hit that a candidate is: a pure function of ray and primitive, the same bits from every
/// structure.
[[nodiscard]] Hit finish(const RayState& state, const Candidate& candidate, Precision precision);

} // namespace lumitree

#endif
