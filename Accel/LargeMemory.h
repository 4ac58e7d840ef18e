// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_LargeMemory_h
#define Lumitree_Accel_LargeMemory_h

#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace lumitree
{

/// The size of a large page, and what memory that is to lie in them is aligned to.
inline constexpr std::size_t largePage = std::size_t{ 1 } << 21;

/// Asks the system to put memory, aligned to a large page, in large pages as far as it fills them.
/// Only advice: without large pages all is as it was.
inline void adviseLargePages(void* memory, std::size_t bytes)
{
#ifdef __linux__
  (void)madvise(memory, bytes / largePage * largePage, MADV_HUGEPAGE);
#else
  (void)memory;
  (void)bytes;
#endif
}

/// An allocator for what rays read in no order, nodes and leaves: where there is much of it, it
/// lies in large pages, so that finding a page does not cost more than reading it. Blocks are
/// aligned to cache lines at least.
template <class T>
struct LargeMemory
{
  using value_type = T;

  static constexpr std::size_t line = 64;

  LargeMemory() = default;
  template <class U>
  LargeMemory(const LargeMemory<U>&)
  {
  }

  [[nodiscard]] T* allocate(std::size_t n)
  {
    if (n > std::numeric_limits<std::size_t>::max() / 2 / sizeof(T))
    {
      throw std::bad_array_new_length();
    }
    const std::size_t size = n * sizeof(T);
    void* const memory = ::operator new(size, alignment(n));
    if (size >= largePage)
    {
      adviseLargePages(memory, size);
    }
    return static_cast<T*>(memory);
  }

  void deallocate(T* memory, std::size_t n) { ::operator delete(memory, alignment(n)); }

  template <class U>
  bool operator==(const LargeMemory<U>&) const
  {
    return true;
  }
  template <class U>
  bool operator!=(const LargeMemory<U>&) const
  {
    return false;
  }

private:
  static std::align_val_t alignment(std::size_t n)
  {
    return std::align_val_t{ n * sizeof(T) >= largePage ? largePage : line };
  }
};

} // namespace lumitree

#endif
