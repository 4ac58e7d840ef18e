// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_DirectRadiance_h
#define Lumitree_Radiometry_DirectRadiance_h

#include "Accel/Accelerator.h"
#include "Radiometry/Export.h"
#include "Radiometry/LightEstimate.h"
#include "Radiometry/Receivers.h"
#include "Radiometry/Source.h"

#include <cstdint>
#include <vector>

namespace lumitree
{

/// How radiance is looked for.
struct RadianceOptions
{
  /// What is in the way (occluders), how rays are cast, and, of reflected light, how the irradiance
  /// of the surface is estimated.
  EstimateOptions estimate;

  /// The surface in the way reflects this share of the light that falls on it directly, alike in
  /// all directions, on both sides: L = reflectance × E / π. 0 … 1.
  double reflectance = 0.0;

  /// One number per primitive of the surface in place of that one, each 0 … 1; or null.
  const double* reflectances = nullptr;
};

struct RadianceReport
{
  std::uint64_t invalidRays = 0;     ///< not valid (isValid), or from an invalid place: NaN
  std::uint64_t missedTolerance = 0; ///< rays whose reflected light needed more than maximumRays
  bool completed = true;             ///< false when stopped: the output is then incomplete
};

/// A limit of a ray from there on is none: infinitely far sources are seen.
inline constexpr double endlessRay = 1e290;

/// The radiance that arrives at the origin of each ray out of its direction: the sum over the
/// sources that the ray meets between tMin and tMax before it hits the surface, and what that
/// surface reflects. Radiance does not change on its way: moving the origin along the ray changes
/// nothing.
///
/// Sources do not hide each other, as in estimateLight: the integral of the radiance × cosθ over
/// the hemisphere is the irradiance. Points, lines and parallel light have no radiance: they are
/// seen only by what they make of the surface. A source that touches the surface is not hidden by
/// it (ShadowRays.h). tMin below 0 counts as 0.
///
/// radiance: one number per ray; NaN where the ray is not valid. The numbers do not depend on the
/// number of threads. Throws UnsupportedQuery when the occluders do not support the precision,
/// std::invalid_argument for options out of range.
LUMITREE_RADIOMETRY_EXPORT RadianceReport directRadiance(const RayBatch& rays,
  const std::vector<const Source*>& sources, double* radiance, const RadianceOptions& options = {});

/// The radiance that arrives at places out of directions (towards where it is looked; any length
/// but 0): radiance[i × directions + d]. Where a place has a normal, what is behind it gives 0 and
/// rays start off its surface, as those of estimateLight; a normal that is not finite is none.
LUMITREE_RADIOMETRY_EXPORT RadianceReport radianceAround(const Receivers& places,
  const std::vector<Vec3>& directions, const std::vector<const Source*>& sources, double* radiance,
  const RadianceOptions& options = {});

} // namespace lumitree

#endif
