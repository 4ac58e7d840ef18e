// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/BuildProgress.h"

#include "Accel/Accelerator.h"
#include "Accel/Parallel.h"

#include <algorithm>

namespace lumitree
{
namespace
{

/// Observers redraw progress bars and hear of the user's wish to stop: they are told when so much
/// more is done, or so much time has passed.
///@{
constexpr double step = 1.0 / 512;
constexpr std::chrono::milliseconds interval(50);
///@}

} // namespace

BuildProgress::BuildProgress(JobControl* control, int threads)
  : control_(control)
  , threads_(threads)
  , caller_(std::this_thread::get_id())
{
}

void BuildProgress::stage(double until, std::size_t work)
{
  this->from_ = this->until_;
  this->until_ = std::max(until, this->from_);
  this->work_ = std::max(static_cast<double>(work), 1.0);
  this->done_.store(0, std::memory_order_relaxed);
  this->report();
  this->check();
}

void BuildProgress::advance(std::size_t amount)
{
  this->done_.fetch_add(amount, std::memory_order_relaxed);
  if (this->control_ && std::this_thread::get_id() == this->caller_)
  {
    this->report();
  }
  this->check();
}

void BuildProgress::check() const
{
  if (this->control_ && this->control_->stop.load(std::memory_order_relaxed))
  {
    throw BuildStopped("the build was stopped");
  }
}

void BuildProgress::forEach(
  std::size_t n, std::size_t chunk, const Body& body, const Weight& weight)
{
  parallelFor(n, chunk, this->threads_, nullptr,
    [&](std::size_t begin, std::size_t end)
    {
      this->check();
      body(begin, end);
      this->advance(weight ? weight(begin, end) : end - begin);
    });
}

void BuildProgress::report()
{
  if (!this->control_ || !this->control_->onProgress)
  {
    return;
  }
  const double share =
    std::min(1.0, static_cast<double>(this->done_.load(std::memory_order_relaxed)) / this->work_);
  const double fraction = this->from_ + share * (this->until_ - this->from_);
  const auto now = std::chrono::steady_clock::now();
  if (fraction >= this->reported_ + step || (fraction >= 1.0 && this->reported_ < 1.0) ||
    now >= this->time_ + interval)
  {
    this->reported_ = fraction;
    this->time_ = now;
    if (!this->control_->onProgress(fraction))
    {
      this->control_->stop.store(true, std::memory_order_relaxed);
    }
  }
}

} // namespace lumitree
