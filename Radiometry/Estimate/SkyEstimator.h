// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_SkyEstimator_h
#define Lumitree_Radiometry_Estimate_SkyEstimator_h

#include "Radiometry/Estimate/SourceEstimator.h"
#include "Radiometry/SkySource.h"

namespace lumitree
{

/// Light of a sky. Exact where its radiance is constant + rising × the sine of the elevation (the
/// uniform sky, the overcast sky of Moon and Spencer): by the skyline, or by cutting out what
/// hides. Other skies are exact only where nothing hides them.
class SkyEstimator : public SourceEstimatorBase
{
public:
  SkyEstimator(const SkySource& sky, const EstimateScene& scene);

  [[nodiscard]] Estimate estimate(
    const View& view, double tolerance, EstimateWorkspace& workspace) const override;

private:
  /// Whether the value is exact, in workspace pieces of the sky and of the ground.
  bool cut(
    const View& view, double tolerance, EstimateWorkspace& workspace, Estimate& result) const;

  const SkySource& sky_;
  std::shared_ptr<const RadianceSkySamples> samples_; ///< of level ground
  std::optional<PieceRadiance> radiance_;             ///< of the sky, where it is of that form
  std::optional<Skyline> skyline_;
};

} // namespace lumitree

#endif
