// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_LuminousEfficacy_h
#define Lumitree_Radiometry_LuminousEfficacy_h

#include "Radiometry/Export.h"

#include <vector>

/// What links the two systems of quantities. Light of a spectrum S has
/// Φv = K Φe, K = 683 lm/W × ∫ S V dλ / ∫ S dλ: 683 lm/W at 555 nm (the SI's definition of the
/// candela has 683 lm/W at 540 THz, which is there to 0.002 %), less for any other spectrum.
namespace lumitree
{

/// Km, lm/W
inline constexpr double maximumLuminousEfficacy = 683.0;

/// V(λ) of photopic vision, CIE 1924 (as tabulated in CIE 018 and ISO/CIE 23539, every 5 nm from
/// 360 to 780 nm), linear in between; 0 elsewhere. nanometres: of the wavelength in air.
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT double luminousEfficiency(double nanometres);

/// One value of a spectrum: radiant flux (or any radiant quantity) per wavelength, in any unit.
struct SpectralValue
{
  double nanometres;
  double value;
};

/// K [lm/W] of a spectrum that is linear between its values. Those outside of 360 … 780 nm count as
/// radiation, not as light. Throws std::invalid_argument for fewer than 2 values, wavelengths that
/// do not grow, values that are negative or not finite, and a spectrum that is 0 everywhere.
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT double luminousEfficacy(
  const std::vector<SpectralValue>& spectrum);

} // namespace lumitree

#endif
