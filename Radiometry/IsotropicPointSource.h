// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_IsotropicPointSource_h
#define Lumitree_Radiometry_IsotropicPointSource_h

#include "Radiometry/PointLikeSource.h"

namespace lumitree
{

/// A point that shines alike in all directions: I = Φ / 4π, E = I cosθ / r², E₀ = I / r².
class LUMITREE_RADIOMETRY_EXPORT IsotropicPointSource : public PointLikeSource
{
public:
  /// flux: W or lm, finite, ≥ 0. metresPerUnit: finite, > 0. Throws std::invalid_argument
  /// otherwise, and for a position that is not finite (or beyond coordinateLimit).
  IsotropicPointSource(double flux, const Vec3& position, double metresPerUnit = 1.0);

  [[nodiscard]] std::optional<double> flux() const override { return this->flux_; }

protected:
  [[nodiscard]] double intensityAlong(const Vec3& direction) const override;

private:
  double flux_;
};

} // namespace lumitree

#endif
