// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_RadixOrder_h
#define Lumitree_Accel_Kernel_RadixOrder_h

#include <cstdint>
#include <vector>

namespace lumitree
{

/// Sorts numbers by keys of a few bits. Keeps its memory from one time to the next.
class RadixOrder
{
public:
  /// 0 … keys.size() - 1 by ascending key, those of equal keys ascending. bits: of the keys, 24 at
  /// most.
  const std::vector<std::uint32_t>& sort(const std::vector<std::uint32_t>& keys, int bits);

private:
  void sortByRadix(const std::vector<std::uint32_t>& keys, int bits);

  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> byLowBits_;
  std::vector<std::uint32_t> lowStarts_;
  std::vector<std::uint32_t> highStarts_;
};

} // namespace lumitree

#endif
