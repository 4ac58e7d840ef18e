// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_PhotometricWeb_h
#define Lumitree_Radiometry_PhotometricWeb_h

#include "Radiometry/Export.h"

#include <optional>
#include <string>
#include <vector>

namespace lumitree
{

/// Luminous intensities of a luminaire over directions, as photometric files have them.
///
/// Type C: γ from 0° (the axis, straight down as a luminaire hangs) to 180°, C around it. Type B: H
/// from −90° to 90° to the right and V from −90° to 90° up, of a floodlight that is looked along:
/// direction = sinH right + cosH (cosV ahead + sinV up).
///
/// Between the angles intensities are bilinear in the two angles, in degrees; outside of the γ, H
/// and V that are there they are 0. Symmetries of files are unfolded: horizontals of type C are a
/// single 0 (the same all around) or go from 0 to 360 with both.
struct LUMITREE_RADIOMETRY_EXPORT PhotometricWeb
{
  enum class Type
  {
    C,
    B
  };

  Type type = Type::C;
  std::vector<double> verticals;   ///< γ or V, degrees, growing
  std::vector<double> horizontals; ///< C or H, degrees, growing
  std::vector<double> intensities; ///< cd, ≥ 0: [horizontal × number of verticals + vertical]

  std::string name;   ///< of the luminaire; may be empty
  std::string format; ///< "IES LM-63-2002", "EULUMDAT", … or empty

  /// What the file says that the luminaire emits (its lamps times their efficiency, where the file
  /// has one): lm. Nothing where it only has intensities (absolute photometry). It differs from
  /// flux() by what the file's rounding and the interpolation make of it.
  std::optional<double> statedFlux;

  double width = 0.0;  ///< of the luminous opening along C 90, metres; ≤ 0: round or a point
  double length = 0.0; ///< along C 0, metres
  double height = 0.0; ///< metres
  double watts = 0.0;  ///< electric; 0: not stated

  /// Factors on all intensities by the tilt of the lamp, in degrees; empty: none.
  std::vector<double> tiltAngles;
  std::vector<double> tiltFactors;

  /// Intensity [cd] for a horizontal (any turn) and a vertical angle, degrees.
  [[nodiscard]] double intensity(double horizontal, double vertical) const;

  /// Flux [lm] of the interpolant, exactly: Σ 2π (cₖ (cosγₖ − cosγₖ₊₁) + m (sinγₖ₊₁ − sinγₖ −
  /// Δγ cosγₖ₊₁)) of a type C that is the same all around, and its like.
  [[nodiscard]] double flux() const;

  /// Factor for a tilt of the lamp, linear between the table's angles, the outermost beyond; 1
  /// without a table.
  [[nodiscard]] double tiltFactor(double degrees) const;

  /// Throws std::invalid_argument where this is no web: sizes that do not fit, angles that do not
  /// grow or are out of range, intensities that are negative or not finite.
  void check() const;
};

} // namespace lumitree

#endif
