// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_LeafKernels_h
#define Lumitree_Accel_Kernel_LeafKernels_h

#include "Accel/Kernel/RayState.h"

namespace lumitree
{

/// Tests the primitives of a leaf; those that the filter keeps go to state.settle. blocks points to
/// a TriangleBlocks<T> of the scalar type the kernel was chosen for.
using LeafKernel = void (*)(RayState& state, const void* blocks, const Span& span);

/// The kernel for a scalar type, for the best instruction set at hand. It stands behind a pointer,
/// so that structures do not multiply with it. It keeps all that floating point cannot rule out.
[[nodiscard]] LeafKernel leafKernel(ArrayView::Scalar scalar);

} // namespace lumitree

#endif
