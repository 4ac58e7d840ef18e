// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_RayKernel_h
#define Lumitree_Accel_Kernel_RayKernel_h

#include "Accel/Kernel/RayState.h"

namespace lumitree
{

/// Takes one ray, started in state, through a whole structure.
using RayKernel = void (*)(const void* structure, const void* blocks, RayState& state);

/// Chooses the kernel for a scalar type; certain is as in leafKernel.
using RayKernelChooser = RayKernel (*)(ArrayView::Scalar, bool certain);

} // namespace lumitree

#endif
