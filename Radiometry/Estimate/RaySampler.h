// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_RaySampler_h
#define Lumitree_Radiometry_Estimate_RaySampler_h

#include "Accel/Accelerator.h"
#include "Radiometry/Estimate/Estimate.h"
#include "Radiometry/Estimate/LightSamples.h"
#include "Radiometry/Estimate/VisibleShare.h"
#include "Radiometry/ShadowRays.h"
#include "Radiometry/Source.h"

#include <memory>
#include <vector>

namespace lumitree
{

struct RaySamplerOptions
{
  const Accelerator* occluders = nullptr;
  const ShadowRays* shadowRays = nullptr;
  Precision precision = Precision::Fast;
  double relativeTolerance = 0.01;
  std::uint32_t maximumRays = 16384;
};

/// Light of which rays are to say what is visible.
struct SampledLight
{
  View view;
  Amounts full;                                ///< with nothing in the way; main > 0
  double known = 0.0;                          ///< certain light beside it, which the relative
                                               ///< tolerance counts in
  double tolerance = 0.0;                      ///< absolute, beside the relative one
  std::shared_ptr<const LightSamples> samples; ///< of that light
  Estimate* to = nullptr;                      ///< what is found is added there
};

/// Estimates which share of lights is visible: full × Σ f V / Σ f (a ratio estimate, exact where
/// all is lit).
///
/// The rays to each are one Owen-scrambled Sobol sequence, which doubles until the interval is
/// below the tolerance (VisibleShare.h). Lights are queued, and those that are not done have their
/// next rays cast together: the structure is called some thousand rays at a time. What is found of
/// one does not depend on the others.
class RaySampler
{
public:
  void add(SampledLight light);
  [[nodiscard]] std::size_t size() const { return this->lights_.size(); }

  /// Casts the rays of all that were added, and forgets these.
  void run(const RaySamplerOptions& options);

private:
  struct Progress
  {
    SampledLight light;
    VisibleShare share;
    Amounts hidden; ///< Σ f (1 − V), where more than the main amount is asked for
    std::uint32_t rays = 0;
  };

  /// The next rays of lights first … last - 1 of those that are open.
  void cast(std::size_t first, std::size_t last, const RaySamplerOptions& options);
  void draw(std::size_t first, std::size_t last);

  /// A sample of light number `at` of the batch, if there is a ray to be cast.
  void addRay(std::size_t at, std::size_t sample, const RaySamplerOptions& options);

  /// Adds the light's answer to its estimate once it has one.
  static bool finish(Progress& progress, const RaySamplerOptions& options);

  std::vector<Progress> lights_;
  std::vector<Progress*> open_;

  struct RayOwner
  {
    std::uint32_t at; ///< number of the light in the batch
    std::uint32_t sample;
    double light; ///< main amount, over that of the whole light
  };

  // The batch: samples of some lights, one light after the other; and rays.
  std::vector<std::array<double, 2>> points_;
  std::vector<SourceSample> samples_;
  std::vector<std::uint32_t> slots_;     ///< of VisibleShare, per sample
  std::vector<std::size_t> firstSample_; ///< of each light, and the end
  std::size_t size_ = 0;                 ///< how many of what follows are rays of the batch
  Progress* const* batch_ = nullptr;
  std::vector<RayOwner> owners_;
  std::vector<double> origins_;
  std::vector<double> directions_;
  std::vector<double> tMins_;
  std::vector<double> tMaxs_;
  std::vector<std::uint8_t> hit_;
  std::vector<std::uint32_t> sets_;
  std::vector<std::uint64_t> skipOffsets_;
  std::vector<PrimitiveId> skipPrimitives_;
};

/// What a sample gives a view.
[[nodiscard]] Amounts amountsOf(const View& view, const SourceSample& sample);

} // namespace lumitree

#endif
