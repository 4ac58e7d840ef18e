// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_DirectIrradiance_h
#define Lumitree_Radiometry_DirectIrradiance_h

#include "Accel/Accelerator.h"
#include "Radiometry/Export.h"
#include "Radiometry/Receivers.h"
#include "Radiometry/Source.h"

#include <cstdint>
#include <vector>

namespace lumitree
{

/// How direct irradiance is computed.
struct DirectOptions
{
  /// What casts shadows; null: nothing does.
  const Accelerator* occluders = nullptr;
  Precision precision = Precision::Exact;
  int threads = 0; ///< 0: as many as oneTBB gives
  JobControl* control = nullptr;
};

/// What came of it.
struct DirectReport
{
  std::uint64_t invalidReceivers = 0; ///< position or normal not finite: NaN
  std::uint64_t shadowRays = 0;
  bool completed = true; ///< false when stopped: the outputs are then incomplete
};

/// Irradiance at receivers directly from sources (scalar irradiance where the receivers have no
/// normals): the sources' closed forms times their visibility, 0 or 1. Rays are cast only to
/// sources that would give something. Memory beside the outputs does not grow with receivers or
/// sources.
///
/// total: one number per receiver, the sum over the sources in their order.
/// perSource: empty, or one output per source, each null or one number per receiver.
/// The numbers do not depend on the number of threads. Throws UnsupportedQuery when the occluders
/// do not support the precision, std::invalid_argument where one of the sources is extended and
/// there are occluders.
LUMITREE_RADIOMETRY_EXPORT DirectReport directIrradiance(const Receivers& receivers,
  const std::vector<const Source*>& sources, double* total,
  const std::vector<double*>& perSource = {}, const DirectOptions& options = {});

} // namespace lumitree

#endif
