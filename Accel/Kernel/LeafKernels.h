// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_LeafKernels_h
#define Lumitree_Accel_Kernel_LeafKernels_h

#include "Accel/Choices.h"
#include "Accel/Kernel/RayState.h"

namespace lumitree
{

/// Tests the primitives of a leaf: filter, precision, query. Returns through state.tStop. blocks points to a
/// TriangleBlocks<T> of the scalar type the kernel was chosen for.
using LeafKernel = void (*)(RayState& state, const void* blocks, const Span& span);

/// The kernel for a scalar type, precision and query, for the best instruction set at hand. Kernels stand behind a pointer
/// so that structures do not multiply with precisions and queries.
[[nodiscard]] LeafKernel leafKernel(ArrayView::Scalar scalar, Precision precision, QueryKind query);

} // namespace lumitree

#endif
