// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Quantities_h
#define Lumitree_Radiometry_Quantities_h

#include "Radiometry/Export.h"

#include <string>
#include <string_view>

/// Quantities of light and their units (CIE S 017, ILV). Each exists twice: radiometric, weighing
/// all radiation by its energy, and photometric, weighing it by the eye. The numbers of both obey
/// the same laws; they must only never be mixed.
namespace lumitree
{

/// The values are part of the schema of lights.
enum class LightSystem : int
{
  Radiometric = 0,
  Photometric = 1
};
inline constexpr int lightSystemCount = 2;

enum class Quantity : int
{
  Energy,           ///< Q: J, lm s
  Flux,             ///< Φ = dQ/dt: W, lm
  Intensity,        ///< I = dΦ/dω: W/sr, cd
  Irradiance,       ///< E = dΦ/dA falling on a surface: W/m², lx
  ScalarIrradiance, ///< E₀ = ∫ L dω over all directions, no cosine (fluence rate): W/m², lx
  NormalIrradiance, ///< E on a plane that faces parallel light: W/m², lx
  Exitance,         ///< M = dΦ/dA leaving a surface: W/m², lm/m²
  Radiance          ///< L = d²Φ/(dA cosθ dω): W/(m² sr), cd/m²
};
inline constexpr int quantityCount = 8;

/// A quantity in one system. The unit is in plain ASCII ("W/m^2").
struct QuantityName
{
  std::string_view name;
  std::string_view unit;
};

[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT QuantityName describe(Quantity, LightSystem);

/// What an array of that quantity is called: "Irradiance [W/m^2]".
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT std::string arrayName(Quantity, LightSystem);

/// "radiometric" or "photometric".
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT std::string_view name(LightSystem);

} // namespace lumitree

#endif
