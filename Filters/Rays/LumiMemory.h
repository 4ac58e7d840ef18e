// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Rays_LumiMemory_h
#define Lumitree_Filters_Rays_LumiMemory_h

#include "Accel/LargeMemory.h"

#include <cstddef>
#include <cstdlib>
#include <new>

namespace lumitree::filters
{

/// Memory for std::free. Much of it lies in large pages where the system has them: the first touch
/// of a million rays' arrays costs less.
inline void* allocate(std::size_t bytes)
{
  void* memory = nullptr;
#if defined(__linux__)
  if (bytes >= largePage)
  {
    if (posix_memalign(&memory, largePage, bytes) != 0)
    {
      throw std::bad_alloc();
    }
    adviseLargePages(memory, bytes);
    return memory;
  }
#endif
  memory = std::malloc(bytes > 0 ? bytes : 1);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}

} // namespace lumitree::filters

#endif
