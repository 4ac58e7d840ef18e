// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_WideBvhWalk_h
#define Lumitree_Accel_Structures_WideBvhWalk_h

#include "Accel/Kernel/RayKernel.h"
#include "Accel/Kernel/Visitors.h"
#include "Accel/Structures/WideBvhNodes.h"

namespace lumitree
{

/// Walks one ray with node test and leaf test in one function; structure is a WideBvhNodes.
[[nodiscard]] RayKernel wideBvhKernel(ArrayView::Scalar scalar);

/// The same walk, node by node to a visitor that counts.
using WideBvhCountingWalk = void (*)(const WideBvhNodes&, RayState&, CountingVisitor&);
[[nodiscard]] WideBvhCountingWalk wideBvhCountingWalk();

} // namespace lumitree

#endif
