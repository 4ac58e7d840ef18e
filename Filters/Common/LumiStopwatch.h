// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiStopwatch_h
#define LumiStopwatch_h

#include <chrono>

namespace lumitree::filters
{

/// Tells how long each of several steps took.
class Stopwatch
{
public:
  /// Seconds since it was made or last asked.
  double lap()
  {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> past = now - this->last_;
    this->last_ = now;
    return past.count();
  }

private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

} // namespace lumitree::filters
#endif
