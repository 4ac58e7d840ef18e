// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Rays_LumiMemory_h
#define Lumitree_Filters_Rays_LumiMemory_h

#include <cstddef>
#include <cstdlib>
#include <new>
#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace lumitree::filters
{

/// Memory for std::free. Much of it lies in large pages where the system has them: with small ones
/// the first touch of a million rays' arrays took a quarter as long as the tracing.
inline void* allocate(std::size_t bytes)
{
#if defined(__linux__)
  constexpr std::size_t page = std::size_t{ 1 } << 21;
  if (bytes >= page)
  {
    void* memory = nullptr;
    if (posix_memalign(&memory, page, bytes) == 0)
    {
      (void)madvise(memory, bytes, MADV_HUGEPAGE); // a hint: small pages do as well
      return memory;
    }
    throw std::bad_alloc();
  }
#endif
  void* memory = std::malloc(bytes > 0 ? bytes : 1);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}

} // namespace lumitree::filters

#endif
