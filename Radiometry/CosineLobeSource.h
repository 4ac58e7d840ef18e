// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_CosineLobeSource_h
#define Lumitree_Radiometry_CosineLobeSource_h

#include "Radiometry/PointLikeSource.h"

namespace lumitree
{

/// A point whose intensity falls off as a power of the cosine: I = I₀ cosⁿγ up to 90° from its
/// axis, nothing behind; Φ = 2π I₀ / (n + 1) (Phong 1975). n = 1 is a small Lambertian surface, n =
/// 0 half of an isotropic point.
class LUMITREE_RADIOMETRY_EXPORT CosineLobeSource : public PointLikeSource
{
public:
  /// axialIntensity: I₀, W/sr or cd, finite, ≥ 0. exponent: n, finite, ≥ 0. axis: finite, any
  /// length but 0. Throws std::invalid_argument otherwise, and as PointLikeSource does.
  CosineLobeSource(double axialIntensity, double exponent, const Vec3& position, const Vec3& axis,
    double metresPerUnit = 1.0);

  /// I₀ of a lobe of that flux.
  [[nodiscard]] static double axialIntensityOf(double flux, double exponent);

  /// The part of the flux within an angle [rad], 0 … π/2, of the axis.
  [[nodiscard]] double fluxWithin(double angle) const;

  [[nodiscard]] std::optional<double> flux() const override;

protected:
  [[nodiscard]] double intensityAlong(const Vec3& direction) const override;

private:
  double axialIntensity_;
  double exponent_;
  Vec3 axis_;
};

} // namespace lumitree

#endif
