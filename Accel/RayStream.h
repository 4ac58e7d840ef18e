// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_RayStream_h
#define Lumitree_Accel_RayStream_h

#include "Accel/Accelerator.h"
#include "Accel/Export.h"

#include <cstddef>
#include <functional>

namespace lumitree
{

/// Rays that are made, traced and taken away a block at a time: more than memory could hold.
struct RayStream
{
  std::size_t size = 0;          ///< rays in all
  std::size_t block = 1u << 18u; ///< rays in memory at a time; at least 1
  /// Gives rays first … first + count - 1 of the stream; the batch must hold count rays and live
  /// until the next call. Called on the calling thread, in order.
  std::function<RayBatch(std::size_t first, std::size_t count)> rays;
};

/// The same as closest and any of the whole stream in one batch. take gets the answers of rays
/// first … first + count - 1, on the calling thread, in order; they are gone when it returns.
/// perRay of the options, if any, holds one element per ray of the stream. A job that is stopped
/// ends with the block at hand, whose answers are still given, misses where they were not reached.
/// Throws what the queries throw, and std::invalid_argument for a block of 0 and for a batch of
/// another size.
///@{
LUMITREE_ACCEL_EXPORT QueryReport streamClosest(const Accelerator& accelerator,
  const RayStream& stream,
  const std::function<void(std::size_t first, std::size_t count, const Hit* hits)>& take,
  const QueryOptions& options = {});
LUMITREE_ACCEL_EXPORT QueryReport streamAny(const Accelerator& accelerator, const RayStream& stream,
  const std::function<void(std::size_t first, std::size_t count, const std::uint8_t* hit)>& take,
  const QueryOptions& options = {});
///@}

} // namespace lumitree

#endif
