// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_OriginOrder_h
#define Lumitree_Accel_Kernel_OriginOrder_h

#include "Accel/Box.h"
#include "Accel/Kernel/RadixOrder.h"
#include "Accel/Ray.h"

#include <cstdint>
#include <vector>

namespace lumitree
{

/// An order in which rays that come in none go through a structure larger than the caches: by the
/// octant of their directions, then along a Morton curve by their origins. One ray then finds in
/// the caches what those before it looked at.
class OriginOrder
{
public:
  /// Chunks to be ordered are as large as this where there are rays enough, and never smaller than
  /// leastChunk, of which too few rays share a cell.
  ///@{
  static constexpr std::size_t mostChunk = 65536;
  static constexpr std::size_t leastChunk = 16384;
  ///@}

  /// Whether the order is worth its time, for a structure of so many bytes: it does not fit the
  /// caches, and rays that follow each other have little in common.
  [[nodiscard]] static bool pays(const RayBatch& rays, const Box& bounds, std::size_t memory);

  /// Rays [begin, end) of the batch; bounds: the surface's.
  void make(const RayBatch& rays, const Box& bounds, std::size_t begin, std::size_t end);

  [[nodiscard]] const std::vector<std::size_t>& rays() const { return this->rays_; }

private:
  RadixOrder order_;
  std::vector<std::uint32_t> keys_;
  std::vector<std::size_t> rays_;
};

} // namespace lumitree

#endif
