// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiJob.h"

#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>

namespace lumitree::filters
{
namespace
{

/// Observers redraw progress bars; a thousandth is finer than any of them.
constexpr double progressStep = 0.001;

bool askedToStop(vtkAlgorithm* algorithm)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20230101)
  // Also hears of an abort further down the pipeline.
  return algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}

} // namespace

Job::Job(vtkAlgorithm* algorithm, double from, double to)
  : algorithm_(algorithm)
  , from_(from)
  , to_(to)
{
  this->control_.onProgress = [this](double fraction) { return this->report(fraction); };
}

bool Job::report(double fraction)
{
  if (this->algorithm_)
  {
    const double progress =
      this->from_ + (this->to_ - this->from_) * std::clamp(fraction, 0.0, 1.0);
    if (progress >= this->reported_ + progressStep || fraction >= 1.0)
    {
      this->reported_ = progress;
      this->algorithm_->UpdateProgress(progress);
    }
  }
  return !this->aborted();
}

bool Job::aborted()
{
  if (this->algorithm_ && !this->control_.stop.load() && askedToStop(this->algorithm_))
  {
    this->control_.stop.store(true);
  }
  return this->control_.stop.load();
}

int threadsFor(int numberOfThreads)
{
  if (numberOfThreads > 0)
  {
    return numberOfThreads;
  }
  int threads = 0;
  if (const char* value = std::getenv("VTK_SMP_MAX_THREADS"))
  {
    std::from_chars(value, value + std::strlen(value), threads);
  }
  return std::max(threads, 0);
}

} // namespace lumitree::filters
