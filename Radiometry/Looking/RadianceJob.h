// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Looking_RadianceJob_h
#define Lumitree_Radiometry_Looking_RadianceJob_h

#include "Radiometry/DirectRadiance.h"
#include "Radiometry/ShadowRays.h"

#include <atomic>
#include <optional>
#include <vector>

namespace lumitree
{

/// What is in the way; null: nothing is.
[[nodiscard]] const Accelerator* occludersOf(const RadianceOptions& options);

/// The radiance of the rays of one call.
class RadianceJob
{
public:
  /// stored: the coarser of what rays and occluders were stored as.
  RadianceJob(const RayBatch& rays, const std::vector<const Source*>& sources,
    ArrayView::Scalar stored, const RadianceOptions& options);

  RadianceReport run(double* radiance, JobControl* control);

private:
  /// The nearest hits, and the sources before them.
  void look(std::size_t begin, std::size_t end, double* radiance);

  /// What sources send along a ray up to its hit. crossings: memory to use again.
  [[nodiscard]] double emitted(
    const Ray& ray, const Hit& hit, std::vector<SourceCrossing>& crossings) const;

  /// Adds what the surface that was hit makes of the light that falls on it.
  void reflect(double* radiance, JobControl* control, RadianceReport& report) const;

  [[nodiscard]] double reflectance(const Hit& hit) const
  {
    return this->options_.reflectances ? this->options_.reflectances[hit.primitive]
                                       : this->options_.reflectance;
  }

  const RayBatch& rays_;
  const std::vector<const Source*>& sources_;
  const RadianceOptions& options_;
  const Accelerator* occluders_; ///< null: nothing is in the way
  ArrayView::Scalar stored_;
  std::optional<ShadowRays> shadowRays_; ///< where there are occluders
  std::vector<Hit> hits_;                ///< empty where nothing reflects
  std::atomic<std::uint64_t> invalid_{ 0 };
};

} // namespace lumitree

#endif
