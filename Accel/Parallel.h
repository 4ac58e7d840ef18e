// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Parallel_h
#define Lumitree_Accel_Parallel_h

#include "Accel/Export.h"
#include "Accel/Query.h"

#include <cstddef>
#include <functional>

namespace lumitree
{

/// Calls body(begin, end) for chunks that cover 0…n - 1, on up to `threads` threads (0: as many as
/// oneTBB gives), the calling thread among them. Chunks do not depend on the number of threads.
/// Each chunk runs in the default floating-point environment (round to nearest, subnormals kept),
/// whatever the caller's is. Progress is reported on the calling thread only. An exception in a
/// chunk stops the rest and is thrown here. Returns false when the job was stopped before its end.
LUMITREE_ACCEL_EXPORT bool parallelFor(std::size_t n, std::size_t chunk, int threads,
  JobControl* control, const std::function<void(std::size_t, std::size_t)>& body);

/// How many threads parallelFor uses when it is asked for so many.
[[nodiscard]] LUMITREE_ACCEL_EXPORT int concurrency(int threads);

} // namespace lumitree

#endif
