// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_Settle_h
#define Lumitree_Accel_Kernel_Settle_h

#include "Accel/Choices.h"
#include "Accel/Kernel/RayState.h"

namespace lumitree
{

/// What becomes of a candidate under a precision and a query. Compiled once and called for the one
/// or two primitives a ray that the filter keeps, so that the SIMD kernels know neither. Bodies:
/// whether the surface has any; without them the function does not ask.
[[nodiscard]] SettleFunction settleFunction(Precision precision, QueryKind query, bool bodies);

} // namespace lumitree

#endif
