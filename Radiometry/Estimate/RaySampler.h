// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_RaySampler_h
#define Lumitree_Radiometry_Estimate_RaySampler_h

#include "Accel/Accelerator.h"
#include "Radiometry/Estimate/Amounts.h"
#include "Radiometry/Estimate/LightSamples.h"
#include "Radiometry/ShadowRays.h"
#include "Radiometry/Source.h"

#include <vector>

namespace lumitree
{

struct RaySamplerOptions
{
  const Accelerator* occluders = nullptr;
  const ShadowRays* shadowRays = nullptr;
  Precision precision = Precision::Fast;
  double relativeTolerance = 0.01;
  double absoluteTolerance = 0.0;
  std::uint32_t maximumRays = 16384;
};

/// What rays say about light of which the unoccluded amount is known.
struct RaySample
{
  Amounts value;
  double halfWidth = 0.0; ///< of value.main
  std::uint32_t rays = 0;
  bool missed = false; ///< the tolerance
};

/// Estimates which share of some light is visible.
///
/// The rays are one Owen-scrambled Sobol sequence, the interval is of the means of eight blocks of
/// it: each block is a net, as even as the whole, and what one leaves out others have, so that the
/// mean of all is better than eight independent ones would be.
class RaySampler
{
public:
  /// full: the light with nothing in the way, of which there are samples; what is seen of it is
  /// full × Σ f V / Σ f (a ratio estimate, exact where all is lit). known: light that is certain
  /// beside it; the relative tolerance counts it in.
  RaySample run(const View& view, const Amounts& full, double known, const LightSamples& samples,
    const RaySamplerOptions& options);

private:
  static constexpr std::uint32_t blockCount = 8;

  /// Sums over the samples of one block.
  struct Sums
  {
    double all = 0.0;    ///< Σ f
    double hidden = 0.0; ///< Σ f (1 − V)
  };

  /// Casts the rays begin … end of the sequence, which begin with that block.
  void cast(const View& view, const LightSamples& samples, std::uint32_t begin, std::uint32_t end,
    std::uint32_t firstBlock, const RaySamplerOptions& options);
  void draw(const View& view, const LightSamples& samples, std::uint32_t begin, std::uint32_t end,
    std::uint32_t firstBlock, const RaySamplerOptions& options);

  std::array<Sums, blockCount> blocks_;
  Amounts hidden_;   ///< Σ f (1 − V) of all
  double all_ = 0.0; ///< Σ f of the main amount
  std::uint32_t rays_ = 0;
  std::size_t batch_ = 0; ///< how many of what follows are rays of the batch
  std::vector<std::array<double, 2>> points_;
  std::vector<SourceSample> samples_;
  std::vector<double> lights_;         ///< main amounts of the rays of the batch
  std::vector<std::uint32_t> sources_; ///< which sample each ray is
  std::vector<std::uint32_t> owners_;  ///< which block
  std::vector<double> origins_;
  std::vector<double> directions_;
  std::vector<double> tMins_;
  std::vector<double> tMaxs_;
  std::vector<std::uint32_t> sets_;
  std::vector<std::uint8_t> hit_;
};

/// What a sample gives a view.
[[nodiscard]] Amounts amountsOf(const View& view, const SourceSample& sample);

} // namespace lumitree

#endif
