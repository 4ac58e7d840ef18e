// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiJob_h
#define LumiJob_h

#include "LumitreeFiltersCommonModule.h"
#include "vtkLumiABI.h"

#include "Accel/Query.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
VTK_ABI_NAMESPACE_END

namespace lumitree::filters
{

/// Ties a job of the cores to the progress and abort of an algorithm. Make it on the thread that
/// runs RequestData and hand control() to the core: progress and abort are touched on that thread
/// only, workers read a flag.
class LUMITREEFILTERSCOMMON_EXPORT Job
{
public:
  /// The job is the part from … to (0…1) of the algorithm's work. A null algorithm reports nothing
  /// and is never aborted.
  explicit Job(vtkAlgorithm* algorithm, double from = 0.0, double to = 1.0);
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  [[nodiscard]] JobControl* control() { return &this->control_; }

  /// For loops of the caller's own: tells the fraction done (0…1) and returns false to stop.
  bool report(double fraction);

  /// Whether the user asked to stop, now or earlier.
  [[nodiscard]] bool aborted();

private:
  vtkAlgorithm* algorithm_;
  double from_;
  double to_;
  double reported_ = -1.0;
  JobControl control_;
};

/// Threads for the cores: the filter's NumberOfThreads if positive, else the environment variable
/// VTK_SMP_MAX_THREADS if positive, else 0, with which the cores use every processor of the
/// process's affinity mask.
[[nodiscard]] LUMITREEFILTERSCOMMON_EXPORT int threadsFor(int numberOfThreads);

} // namespace lumitree::filters
#endif
