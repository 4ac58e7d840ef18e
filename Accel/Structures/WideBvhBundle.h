// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_WideBvhBundle_h
#define Lumitree_Accel_Structures_WideBvhBundle_h

#include "Accel/Kernel/BundleKernel.h"

namespace lumitree
{

/// Walks a bundle of rays together; structure is a WideBvhNodes.
[[nodiscard]] BundleKernel wideBvhBundleKernel(ArrayView::Scalar scalar);

} // namespace lumitree

#endif
