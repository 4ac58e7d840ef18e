// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Query_h
#define Lumitree_Accel_Query_h

#include "Accel/Choices.h"

#include <atomic>
#include <cstdint>
#include <functional>

namespace lumitree
{

/// What the canonical single-ray walk of one ray cost, whatever batching does.
struct RayCounters
{
  std::uint32_t nodes =
    0; ///< nodes entered, leaves included; of a grid: the grid itself and its occupied cells
  std::uint32_t cells = 0;  ///< cells stepped through, empty ones included; 0 for all but a grid
  std::uint32_t leaves = 0; ///< leaves (or occupied cells) whose primitives were tested
  std::uint32_t primitives = 0; ///< primitives tested, a repeated test counted again
};

/// What the canonical walks of a batch of rays did to one primitive.
struct PrimitiveCounters
{
  std::uint64_t tested = 0; ///< tests, a repeated test of one ray counted again
  std::uint64_t hit = 0;    ///< hits among the answers: of Closest and Any at most one a ray
};

/// How a long job talks to the thread that started it. Only that thread calls onProgress; workers
/// read the flag.
struct JobControl
{
  /// Told the fraction done, 0…1; returns false to stop the job. May be empty.
  std::function<bool(double)> onProgress;
  std::atomic<bool> stop{ false };
};

/// How a batch is to be answered.
struct QueryOptions
{
  Precision precision = Precision::Exact; ///< of references see Accelerator::bestPrecision
  int threads = 0; ///< 0: as many as oneTBB gives
  /// Exact: t is the double nearest to the exact t, of two equally near the even one, and not only
  /// within one float ulp of it. With another precision the query is refused (UnsupportedQuery).
  bool roundedT = false;
  JobControl* control = nullptr;
  RayCounters* perRay = nullptr;    ///< one per ray, overwritten; null: not counted
  std::uint64_t* perNode = nullptr; ///< visits, one per node of hierarchy(), added to; or null
  PrimitiveCounters* perPrimitive = nullptr; ///< one per primitive, added to; or null
};

/// What is to be known of a batch beside its answers.
struct QueryReport
{
  std::uint64_t invalidRays = 0; ///< rays that are not valid (see isValid): they hit nothing
  /// Questions that the floating-point filter could not decide: whether a candidate is hit, in
  /// which order two are, on which side of a limit. Watertight takes such candidates for hits,
  /// Exact asks exact arithmetic.
  std::uint64_t exactTests = 0;
  std::uint64_t exactParameters = 0; ///< reported t that exact arithmetic rounded
  bool completed = true;             ///< false when stopped: answers of rays not reached are misses
};

} // namespace lumitree

#endif
