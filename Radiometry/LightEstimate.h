// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_LightEstimate_h
#define Lumitree_Radiometry_LightEstimate_h

#include "Accel/Accelerator.h"
#include "Radiometry/Export.h"
#include "Radiometry/Receivers.h"
#include "Radiometry/Source.h"

#include <cstdint>
#include <vector>

namespace lumitree
{

/// How the value of a receiver came about; of several sources the greatest. The values are part of
/// the data model.
enum class EstimateMethod : unsigned char
{
  None = 0,       ///< nothing shines on it, or it is not valid
  ClosedForm = 1, ///< nothing is in the way, as a shaft query shows
  Sightline = 2,  ///< one ray to each point or parallel light
  Clipping = 3,   ///< exact: what hides was cut out of the light
  Horizon = 4,    ///< exact: the skyline cut out of the sky
  Bounds = 5,     ///< what cutting left undecided is below the tolerance
  Sampling = 6    ///< rays
};
inline constexpr int estimateMethodCount = 7;

/// What a receiver has of the light that comes its way. The values are part of the data model.
enum class ShadowState : unsigned char
{
  Lit = 0,      ///< all of it
  Penumbra = 1, ///< a part of it
  Umbra = 2,    ///< nothing of it
  Averted = 3   ///< no light comes its way
};

/// How light is estimated.
struct EstimateOptions
{
  /// What casts shadows; null: nothing does.
  const Accelerator* occluders = nullptr;
  Precision precision = Precision::Exact; ///< of rays; all else is exact
  int threads = 0;                       ///< 0: as many as oneTBB gives
  JobControl* control = nullptr;

  /// Sampling ends where half the interval is below the larger of both. ≥ 0. Relative to the value,
  /// in deep shadow to a twentieth of what it would be with nothing in the way.
  ///@{
  double relativeTolerance = 0.01;
  double absoluteTolerance = 0.0; ///< W/m² or lx
  ///@}

  /// Rays to one source from one receiver at most, 64 … 2^24. Where they do not do, the interval is
  /// wider than the tolerance, and the receiver is counted.
  std::uint32_t maximumRays = 16384;

  /// Occluders in a shaft that are cut out of the light at a relative tolerance of 1 %; more: rays.
  /// At other tolerances it changes as the cost of rays does: a fifth of it at 5 %, ten times as
  /// many at 0.1 % and below. (The default is where both cost the same, Docs/radiometry.md.)
  /// 0: always rays.
  std::uint32_t mostClipped = 160;

  /// Whether the skyline is looked for.
  bool horizon = true;

  std::uint64_t seed = 0;        ///< of the random numbers
  Vec3 axis = { 0.0, 0.0, 1.0 }; ///< of cylindrical irradiance; unit
};

/// Where the numbers go: each null, or one number (vector: three) per receiver.
///
/// Light in free space (scalar, vector, cylindrical, hemispherical) comes from all around: the
/// primitives that a receiver skips do not hide it, and it is not moved off its surface.
struct EstimateOutputs
{
  double* irradiance = nullptr;    ///< on the side of the normal
  double* back = nullptr;          ///< on the other side
  double* scalar = nullptr;        ///< ∫ L dω: fluence rate
  double* vector = nullptr;        ///< ∫ L ω dω, towards the light (Gershun)
  double* cylindrical = nullptr;   ///< ∫ L sinθ dω / π, θ from the axis
  double* hemispherical = nullptr; ///< ∫ L (1 + cosθ) / 4 dω, θ from the normal

  /// Of the main quantity: irradiance where receivers have normals, else scalar.
  ///@{
  double* lower = nullptr; ///< bounds where geometry gave them, an interval where rays were cast
  double* upper = nullptr;
  double* unoccluded = nullptr; ///< with nothing in the way
  EstimateMethod* method = nullptr;
  ShadowState* shadow = nullptr;
  ///@}

  std::uint32_t* rays = nullptr; ///< cast for all quantities

  std::vector<double*> perSource; ///< empty, or the main quantity of each source, or null
};

struct EstimateReport
{
  std::uint64_t invalidReceivers = 0; ///< position or normal not finite: NaN everywhere
  std::uint64_t missedTolerance = 0;  ///< receivers for which maximumRays did not do
  std::uint64_t rays = 0;
  bool completed = true; ///< false when stopped: the outputs are then incomplete
};

/// Light that falls on receivers directly from sources, each by the cheapest method that its
/// surroundings need.
///
/// Points and parallel light: one ray. Polygons, spheres, disks, suns and skies: the closed form
/// where a shaft query finds nothing between; where it finds few occluders, these are cut out of
/// the light and Lambert's sum taken of what is left (Clipping, Horizon), exact to about 1e-12;
/// where many, hierarchical bounds, and rays where these leave more undecided than the tolerance.
/// Rays go by the Owen-scrambled Sobol sequence, which doubles until the interval is below the
/// tolerance; where all around agree, its points take over what was found there and no ray is cast.
/// The interval comes from how often neighbours of the sequence differ, widened by what the rays
/// could have missed; measured with the stopping rule on, it covers the true value at more than 90
/// % of penumbra receivers (Testing/Radiometry/TestLightEstimate.cxx).
///
/// The numbers do not depend on the number of threads. Throws UnsupportedQuery when the occluders
/// do not support the precision, std::invalid_argument for options out of range and outputs that do
/// not fit the sources.
LUMITREE_RADIOMETRY_EXPORT EstimateReport estimateLight(const Receivers& receivers,
  const std::vector<const Source*>& sources, const EstimateOutputs& outputs,
  const EstimateOptions& options = {});

} // namespace lumitree

#endif
