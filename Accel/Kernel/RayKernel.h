// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_RayKernel_h
#define Lumitree_Accel_Kernel_RayKernel_h

#include "Accel/Kernel/RayState.h"

namespace lumitree
{

/// Where a kernel gets its rays and puts their answers.
struct RayFeed
{
  void* owner = nullptr;
  /// Starts another ray in a state that is free; false when there are no more.
  bool (*next)(void* owner, RayState& state) = nullptr;
  /// The ray in the state has been through the structure.
  void (*done)(void* owner, RayState& state) = nullptr;
};

/// How many rays a kernel interleaves at most: enough for one's memory and arithmetic to wait on
/// those of the others, few enough for their stacks to stay in the innermost cache.
inline constexpr int mostTravellers = 3;

/// Takes rays through a whole structure, as many at a time as there are states (mostTravellers at
/// most): while one waits for memory and for its own arithmetic, the others go on. What a ray finds
/// does not depend on that; with one state the rays are done in the order in which they came.
using RayKernel = void (*)(
  const void* structure, const void* blocks, RayState* states, int count, const RayFeed& feed);

/// Chooses the kernel for a scalar type.
using RayKernelChooser = RayKernel (*)(ArrayView::Scalar);

} // namespace lumitree

#endif
