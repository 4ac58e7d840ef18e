// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_SightlineBatch_h
#define Lumitree_Radiometry_Estimate_SightlineBatch_h

#include "Radiometry/Estimate/SourceEstimator.h"

#include <cstdint>
#include <vector>

namespace lumitree
{

/// The light of one source that is not extended, for some receivers at once: one ray each.
class SightlineBatch
{
public:
  void clear();

  /// Sets the estimate to the source's light with nothing in the way, and queues the ray that
  /// decides about it. The estimate must live until cast.
  void add(const Source& source, const View& view, const EstimateScene& scene, Estimate& estimate);

  /// Takes the light from those whose ray is hit. skips: whether receivers have primitives that do
  /// not hide.
  void cast(const EstimateScene& scene, bool skips);

private:
  std::vector<Estimate*> owners_; ///< of the rays
  std::vector<double> origins_;
  std::vector<double> directions_;
  std::vector<double> tMins_;
  std::vector<double> tMaxs_;
  std::vector<std::uint64_t> skipOffsets_;
  std::vector<PrimitiveId> skipPrimitives_;
  std::vector<std::uint8_t> hit_;
};

} // namespace lumitree

#endif
