// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_BuildProgress_h
#define Lumitree_Accel_BuildProgress_h

#include "Accel/Export.h"
#include "Accel/Query.h"

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <thread>

namespace lumitree
{

/// How a builder tells how far it has come, hears that it is to stop, and knows how many threads it
/// may use. Made on the thread that asked for the build; only there onProgress is called.
class LUMITREE_ACCEL_EXPORT BuildProgress
{
public:
  explicit BuildProgress(JobControl* control = nullptr, int threads = 0);
  BuildProgress(const BuildProgress&) = delete;
  BuildProgress& operator=(const BuildProgress&) = delete;

  [[nodiscard]] int threads() const { return this->threads_; }

  /// What follows is the part from where the last stage ended to `until` (0…1) of the build, and
  /// is done when `work` has been advanced. Not while workers run.
  void stage(double until, std::size_t work);

  /// So much more of the stage is done. From any thread; throws BuildStopped when the build was
  /// stopped.
  void advance(std::size_t amount);

  /// Throws BuildStopped when the build was stopped. From any thread.
  void check() const;

  using Body = std::function<void(std::size_t begin, std::size_t end)>;
  using Weight = std::function<std::size_t(std::size_t begin, std::size_t end)>;

  /// parallelFor over 0…n - 1, which advances by what it has done: the size of the chunk, or what
  /// weight says.
  void forEach(std::size_t n, std::size_t chunk, const Body& body, const Weight& weight = {});

private:
  void report();

  JobControl* control_;
  int threads_;
  std::thread::id caller_;
  double from_ = 0.0;
  double until_ = 0.0;
  double work_ = 1.0;
  double reported_ = -1.0; ///< this and the next of the calling thread only
  std::chrono::steady_clock::time_point time_;
  std::atomic<std::size_t> done_{ 0 };
};

} // namespace lumitree

#endif
