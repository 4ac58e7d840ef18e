// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_DirectionalSource_h
#define Lumitree_Radiometry_DirectionalSource_h

#include "Radiometry/Source.h"

namespace lumitree
{

/// Parallel light from infinitely far (the sun, at first sight): E = E₀ max(0, cosθ), the same
/// everywhere.
class LUMITREE_RADIOMETRY_EXPORT DirectionalSource : public Source
{
public:
  /// normalIrradiance: on a plane that faces the light, W/m² or lx, finite, ≥ 0. direction: in
  /// which the light travels, finite, any length but 0. Throws std::invalid_argument otherwise.
  DirectionalSource(double normalIrradiance, const Vec3& direction);

  /// Unit vector against the light: where it comes from.
  [[nodiscard]] const Vec3& towards() const { return this->towards_; }

  [[nodiscard]] std::optional<double> flux() const override { return std::nullopt; }
  [[nodiscard]] std::optional<double> intensity(const Vec3&) const override { return std::nullopt; }
  [[nodiscard]] double irradiance(const Vec3& position, const Vec3& normal) const override;
  [[nodiscard]] double scalarIrradiance(const Vec3& position) const override;
  [[nodiscard]] Sightline sightline(const Vec3& position) const override;
  [[nodiscard]] Vec3 lightVector(const Vec3& position) const override;

private:
  double normalIrradiance_;
  Vec3 towards_;
};

} // namespace lumitree

#endif
