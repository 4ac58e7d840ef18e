// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_SkyDistribution_h
#define Lumitree_Radiometry_SkyDistribution_h

#include "Radiometry/Export.h"

namespace lumitree
{

/// Relative radiance of a sky at the angle Z from the zenith and χ from the sun:
/// φ(Z) f(χ), φ = 1 + a exp(b / cosZ), f = base + c exp(d χ) + e cos²χ.
struct SkyDistribution
{
  double a = 0.0;
  double b = -1.0;
  double c = 0.0;
  double d = -1.0;
  double e = 0.0;
  double base = 1.0;

  [[nodiscard]] LUMITREE_RADIOMETRY_EXPORT double gradation(double cosineOfZ) const;
  [[nodiscard]] LUMITREE_RADIOMETRY_EXPORT double indicatrix(double chi, double cosineOfChi) const;

  /// Whether the sun has no part in it.
  [[nodiscard]] bool isRound() const { return this->c == 0.0 && this->e == 0.0; }
};

/// The general skies of ISO 15469:2004 / CIE S 011/E:2003, type 1 (overcast, steep gradation) to 15
/// (white-blue turbid, broad corona). Type 5 is uniform. Type 1 is not the overcast sky of Moon and
/// Spencer, "type 16" (OvercastSky), whose horizontal irradiance for one zenith radiance differs by
/// 0.25 %. Throws std::invalid_argument for another type.
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT SkyDistribution cieSky(int type);

/// The weather as the all-weather model sees it.
struct SkyCondition
{
  double clearness;  ///< ε, 1 (overcast) …
  double brightness; ///< Δ
};

/// ε and Δ of direct normal and diffuse horizontal irradiance [W/m²], with the sun at that angle
/// [rad], below π/2, from the zenith, and an extraterrestrial normal irradiance [W/m²].
/// Throws std::invalid_argument for irradiances that are negative or not finite, and for a diffuse
/// one of 0.
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT SkyCondition skyCondition(double directNormal,
  double diffuseHorizontal, double sunZenith, double extraterrestrial = 1367.0);

/// The all-weather sky (Perez, Seals & Michalsky, Solar Energy 50, 1993, and its erratum, ibid.
/// 51). Within the range of its measurements: ε is kept to 1 … 12.01 and Δ to 0.01 … 0.6, and to at
/// least 0.2 for 1.065 < ε < 2.8.
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT SkyDistribution perezSky(
  const SkyCondition& condition, double sunZenith);

} // namespace lumitree

#endif
