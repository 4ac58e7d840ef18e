// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiIllumination_h
#define LumiIllumination_h

#include "LumiCache.h"
#include "LumiLights.h"
#include "LumiReceivers.h"

#include <cstdint>
#include <memory>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace lumitree::filters
{

/// What came of one dataset.
struct IlluminationReport
{
  std::uint64_t receivers = 0; ///< ghosts not counted
  std::uint64_t undefined = 0; ///< of them: without a value
  bool completed = true;       ///< false when the job was stopped
};

/// The light that falls on datasets.
struct Illumination
{
  Lights lights;
  std::shared_ptr<const Tree> tree; ///< what casts shadows; null: nothing does
  ReceiverLocation location = ReceiverLocation::Cells;
  Precision precision = Precision::Fast;
  bool perLight = false;
  int threads = 0;

  /// Adds the arrays of Docs/data-model.md to a dataset. rank: of this process. shadowsItself: the
  /// occluders are the dataset, or the composite that it is a leaf of. Throws what the accelerator
  /// throws.
  [[nodiscard]] IlluminationReport addTo(vtkDataSet* data, std::int64_t compositeIndex, int rank,
    bool shadowsItself, JobControl* control) const;
};

} // namespace lumitree::filters
#endif
