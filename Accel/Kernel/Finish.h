// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_Finish_h
#define Lumitree_Accel_Kernel_Finish_h

#include "Accel/Choices.h"
#include "Accel/Kernel/RayState.h"
#include "Accel/Query.h"

namespace lumitree
{

/// Puts what All or Ties collected in the precision's order, duplicates dropped. Of Ties, only what
/// is at the least t stays.
void arrange(RayState& state, QueryKind query, Precision precision);

/// The hit that a candidate is: a pure function of ray and primitive, the same bits from every
/// structure.
[[nodiscard]] Hit finish(RayState& state, const Candidate& candidate, const QueryOptions& options);

/// Appends the hits that All or Ties found, in order. Where t is not the exact one's rounding, it
/// may descend between two that nearly coincide: then the greater is reported again, which is as
/// near to the exact t, since that does not descend. Exact ties report the first one's t.
void finish(RayState& state, QueryKind query, const QueryOptions& options, std::vector<Hit>& hits);

} // namespace lumitree

#endif
