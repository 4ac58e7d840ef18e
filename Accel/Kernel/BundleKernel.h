// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_BundleKernel_h
#define Lumitree_Accel_Kernel_BundleKernel_h

#include "Accel/Kernel/RayBundle.h"

namespace lumitree
{

/// Takes a bundle through a whole structure. Returns false, and has then found nothing, where its
/// rays are better taken one by one: where the structure cannot take them together, or where they
/// meet so many leaves between them that it does not pay.
using BundleKernel = bool (*)(const void* structure, const void* blocks, RayBundle& bundle);

/// Chooses the kernel for a scalar type.
using BundleKernelChooser = BundleKernel (*)(ArrayView::Scalar);

} // namespace lumitree

#endif
