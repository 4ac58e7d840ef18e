// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiIllumination_h
#define LumiIllumination_h

#include "LumiCache.h"
#include "LumiLights.h"
#include "LumiReceivers.h"

#include <cstdint>
#include <limits>
#include <memory>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace lumitree::filters
{

/// Of the main quantity over receivers that have a value, ghosts left out.
struct IlluminationStatistics
{
  std::uint64_t count = 0;
  double sum = 0.0;
  double minimum = std::numeric_limits<double>::infinity();
  double maximum = -std::numeric_limits<double>::infinity();

  void add(double value);
  void add(const IlluminationStatistics& other);
};

/// What came of one dataset.
struct IlluminationReport
{
  std::uint64_t receivers = 0; ///< ghosts not counted
  std::uint64_t undefined = 0; ///< of them: without a value
  std::uint64_t missed = 0;    ///< of them: with an interval wider than the tolerance
  bool completed = true;       ///< false when the job was stopped
  IlluminationStatistics statistics;
  Quantity quantity = Quantity::Irradiance; ///< that of the statistics
};

/// Which arrays there are beside the main ones.
struct IlluminationArrays
{
  bool perLight = false;
  bool back = false;
  bool scalar = false;
  bool vector = false;
  bool cylindrical = false;
  bool hemispherical = false;
  bool estimates = false; ///< bounds, method, number of rays
  bool masks = false;     ///< shadow, penumbra
};

/// The light that falls on datasets.
struct Illumination
{
  Lights lights;
  std::shared_ptr<const Tree> tree; ///< what casts shadows; null: nothing does
  ReceiverLocation location = ReceiverLocation::Cells;
  Precision precision = Precision::Exact;
  IlluminationArrays arrays;
  double relativeTolerance = 0.01;
  double absoluteTolerance = 0.0;
  std::uint32_t maximumRays = 16384;
  int threads = 0;

  /// Of a horizontal plane under the skies among the lights, with nothing in the way; 0 without.
  [[nodiscard]] double outdoorIrradiance() const;

  /// Adds the arrays of Docs/data-model.md to a dataset. rank: of this process. shadowsItself: the
  /// occluders are the dataset, or the composite that it is a leaf of. Throws what the accelerator
  /// throws.
  [[nodiscard]] IlluminationReport addTo(vtkDataSet* data, std::int64_t compositeIndex, int rank,
    bool shadowsItself, JobControl* control) const;
};

} // namespace lumitree::filters
#endif
