// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_SpotSource_h
#define Lumitree_Radiometry_SpotSource_h

#include "Radiometry/PointLikeSource.h"

namespace lumitree
{

/// A point that shines evenly into a cone, and fades to nothing between two angles from its axis:
/// I = I₀ s((cosγ − cosγₑ) / (cosγₛ − cosγₑ)), s(x) = x² (3 − 2x) between 0 and 1;
/// Φ = 2π I₀ ((1 − cosγₛ) + (cosγₛ − cosγₑ) / 2). (As pbrt-v4, section 12.2.1.)
class LUMITREE_RADIOMETRY_EXPORT SpotSource : public PointLikeSource
{
public:
  /// axialIntensity: I₀, W/sr or cd, finite, ≥ 0. coneAngle: γₛ, up to which it shines fully, and
  /// cutoffAngle: γₑ, from which on it does not, in rad, 0 ≤ γₛ ≤ γₑ ≤ π, γₑ > 0. axis: finite, any
  /// length but 0. Throws std::invalid_argument otherwise, and as PointLikeSource does.
  SpotSource(double axialIntensity, double coneAngle, double cutoffAngle, const Vec3& position,
    const Vec3& axis, double metresPerUnit = 1.0);

  /// I₀ of a spot of that flux and those angles, which are as above.
  [[nodiscard]] static double axialIntensityOf(double flux, double coneAngle, double cutoffAngle);

  [[nodiscard]] std::optional<double> flux() const override;

protected:
  [[nodiscard]] double intensityAlong(const Vec3& direction) const override;

private:
  double axialIntensity_;
  double coneAngle_;
  double cutoffAngle_;
  Vec3 axis_;
};

} // namespace lumitree

#endif
