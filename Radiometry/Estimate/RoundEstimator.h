// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_RoundEstimator_h
#define Lumitree_Radiometry_Estimate_RoundEstimator_h

#include "Radiometry/Estimate/SeenDisk.h"
#include "Radiometry/Estimate/SourceEstimator.h"

#include <optional>

namespace lumitree
{

class DiskSource;
class SphereSource;
class SunDiskSource;

/// Light of a sphere, a disk or the sun's disk: as of a polygon, but that what is cut out by
/// triangles is cut out of a circle (SeenDisk.h). Rays remain where too many triangles are in the
/// shaft, where one reaches into the sphere, where quadrics hide, for cylindrical irradiance, and
/// from places that all but touch the light.
class RoundEstimator : public SourceEstimatorBase
{
public:
  RoundEstimator(const Source& source, const EstimateScene& scene);

  /// Whether the source is one of these.
  [[nodiscard]] static bool suits(const Source& source);

  [[nodiscard]] Estimate estimate(
    const View& view, double tolerance, EstimateWorkspace& workspace) const override;

private:
  /// The light as the eye sees it, and the front of its shaft but for the hull; nothing where that
  /// has no digits.
  [[nodiscard]] std::optional<SeenDisk> look(const View& view, LightFront& front) const;

  const DiskSource* disk_;
  const SphereSource* sphere_;
  const SunDiskSource* sun_;
};

} // namespace lumitree

#endif
