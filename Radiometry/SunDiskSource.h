// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_SunDiskSource_h
#define Lumitree_Radiometry_SunDiskSource_h

#include "Radiometry/Source.h"

namespace lumitree
{

/// The mean angular diameter of the sun: 0.533°.
inline constexpr double sunDiameterInDegrees = 0.533;

/// A round disk infinitely far away that shines evenly: the sun with its penumbras, without the
/// darkening of its limb. E₀ on a plane that faces it; L = E₀ / (π sin²α), α its angular radius.
class LUMITREE_RADIOMETRY_EXPORT SunDiskSource : public Source
{
public:
  /// normalIrradiance: W/m² or lx, finite, ≥ 0. direction: in which the light travels, finite, any
  /// length but 0. angularDiameter: rad, above 0 and up to π. Throws std::invalid_argument
  /// otherwise.
  SunDiskSource(double normalIrradiance, const Vec3& direction, double angularDiameter);

  /// Unit vector to the middle of the disk.
  [[nodiscard]] const Vec3& towards() const { return this->towards_; }
  [[nodiscard]] double angularRadius() const { return this->angularRadius_; }
  [[nodiscard]] double diskRadiance() const { return this->radiance_; }

  [[nodiscard]] std::optional<double> flux() const override { return std::nullopt; }
  [[nodiscard]] std::optional<double> intensity(const Vec3&) const override { return std::nullopt; }
  [[nodiscard]] double irradiance(const Vec3& position, const Vec3& normal) const override;
  [[nodiscard]] double scalarIrradiance(const Vec3& position) const override;
  [[nodiscard]] Sightline sightline(const Vec3& position) const override;
  [[nodiscard]] Vec3 lightVector(const Vec3& position) const override;
  [[nodiscard]] bool extended() const override { return true; }
  [[nodiscard]] SourceSample sample(const Vec3& position, double u, double v) const override;
  [[nodiscard]] std::optional<double> radiance(
    const Vec3& position, const Vec3& direction) const override;

private:
  double normalIrradiance_;
  Vec3 towards_;
  double angularRadius_;
  double radiance_;
};

} // namespace lumitree

#endif
