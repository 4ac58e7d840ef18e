// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_PointLikeSource_h
#define Lumitree_Radiometry_PointLikeSource_h

#include "Radiometry/Source.h"

namespace lumitree
{

/// A source so small that it is a point: E = I(ω) cosθ / r², E₀ = I(ω) / r². At the point itself
/// nothing is defined (NaN).
class LUMITREE_RADIOMETRY_EXPORT PointLikeSource : public Source
{
public:
  [[nodiscard]] const Vec3& position() const { return this->position_; }

  [[nodiscard]] std::optional<double> intensity(const Vec3& direction) const final;
  [[nodiscard]] double irradiance(const Vec3& position, const Vec3& normal) const final;
  [[nodiscard]] double scalarIrradiance(const Vec3& position) const final;
  [[nodiscard]] Sightline sightline(const Vec3& position) const final;
  [[nodiscard]] Vec3 lightVector(const Vec3& position) const final;

protected:
  /// metresPerUnit: finite, > 0. Throws std::invalid_argument otherwise, and for a position that is
  /// not finite (or beyond coordinateLimit).
  PointLikeSource(const Vec3& position, double metresPerUnit);

  /// Intensity in a direction of unit length away from the source: W/sr or cd, ≥ 0.
  [[nodiscard]] virtual double intensityAlong(const Vec3& direction) const = 0;

private:
  Vec3 position_;
  double metresPerUnit_;
};

} // namespace lumitree

#endif
