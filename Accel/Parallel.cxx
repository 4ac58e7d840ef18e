// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Parallel.h"

#include "Accel/FloatEnvironment.h"
#include "Accel/ThreadSanitizer.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <thread>

namespace lumitree
{
namespace
{
char spawned;
char finished;

/// For ThreadSanitizer, also where an exception leaves: the end of a task, and that of all.
///@{
struct TaskEnd
{
  ~TaskEnd() { happensBefore(finished); }
};
struct LoopEnd
{
  ~LoopEnd() { happensAfter(finished); }
};
///@}
} // namespace

bool parallelFor(std::size_t n, std::size_t chunk, int threads, JobControl* control,
  const std::function<void(std::size_t, std::size_t)>& body)
{
  const std::size_t step = std::max<std::size_t>(chunk, 1);
  const std::size_t chunks = (n + step - 1) / step;
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<std::size_t> done{ 0 };
  const auto stopped = [&] { return control && control->stop.load(std::memory_order_relaxed); };

  const auto runChunk = [&](std::size_t i)
  {
    if (stopped())
    {
      return;
    }
    {
      const FloatEnvironment environment;
      body(i * step, std::min(n, (i + 1) * step));
    }
    const std::size_t count = done.fetch_add(1, std::memory_order_relaxed) + 1;
    if (control && control->onProgress && std::this_thread::get_id() == caller &&
      !control->onProgress(static_cast<double>(count) / static_cast<double>(chunks)))
    {
      control->stop.store(true, std::memory_order_relaxed);
    }
  };

  if (threads == 1 || chunks <= 1)
  {
    for (std::size_t i = 0; i < chunks; ++i)
    {
      runChunk(i);
    }
  }
  else
  {
    // oneTBB warns on the standard error of a program that asks for more than it may have.
    tbb::task_arena arena(threads > 0 ? concurrency(threads) : tbb::task_arena::automatic);
    happensBefore(spawned);
    const LoopEnd loopEnd;
    arena.execute(
      [&]
      {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, chunks, 1),
          [&](const tbb::blocked_range<std::size_t>& range)
          {
            happensAfter(spawned);
            const TaskEnd taskEnd;
            for (std::size_t i = range.begin(); i != range.end(); ++i)
            {
              runChunk(i);
            }
          });
      });
  }
  return done.load() == chunks;
}

int concurrency(int threads)
{
  const auto allowed = static_cast<int>(
    tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  return threads > 0 ? std::min(threads, allowed) : allowed;
}

} // namespace lumitree
