// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_ThreadSanitizer_h
#define Lumitree_Accel_ThreadSanitizer_h

// The oneTBB of a distribution is not instrumented, so ThreadSanitizer cannot see that a task
// starts after it was spawned and ends before parallel_for returns. These two say so; in other
// builds they are nothing.

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace lumitree
{

/// What was done before this call on one thread is seen after happensAfter of the same place on
/// another.
inline void happensBefore([[maybe_unused]] char& place)
{
#if defined(__SANITIZE_THREAD__)
  __tsan_release(&place);
#endif
}

inline void happensAfter([[maybe_unused]] char& place)
{
#if defined(__SANITIZE_THREAD__)
  __tsan_acquire(&place);
#endif
}

} // namespace lumitree

#endif
