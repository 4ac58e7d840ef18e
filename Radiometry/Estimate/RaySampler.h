// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_RaySampler_h
#define Lumitree_Radiometry_Estimate_RaySampler_h

#include "Accel/Accelerator.h"
#include "Radiometry/Estimate/Amounts.h"
#include "Radiometry/ShadowRays.h"
#include "Radiometry/Source.h"

#include <functional>
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
class RaySampler
{
public:
  using Direction = std::function<SourceSample(double u, double v)>;

  /// full: the light with nothing in the way, of which `direction` gives samples; what is seen of
  /// it is full × Σ f V / Σ f (a ratio estimate, exact where all is lit). known: light that is
  /// certain beside it; the relative tolerance counts it in.
  RaySample run(const View& view, const Amounts& full, double known, const Direction& direction,
    const RaySamplerOptions& options);

private:
  static constexpr std::uint32_t randomisations = 8;

  void gather(const View& view, const Direction& direction, std::uint32_t begin, std::uint32_t end,
    const RaySamplerOptions& options);

  /// Sums over the samples of one randomisation.
  struct Sums
  {
    double all = 0.0;    ///< Σ f
    double hidden = 0.0; ///< Σ f (1 − V)
  };

  std::vector<Sums> sums_;
  Amounts hidden_;   ///< Σ f (1 − V) of all randomisations
  double all_ = 0.0; ///< Σ f of the main amount
  std::uint32_t rays_ = 0;
  std::vector<Amounts> lights_; ///< of the rays of the batch
  std::vector<std::uint32_t> owners_;
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
