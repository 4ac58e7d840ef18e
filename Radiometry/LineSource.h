// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_LineSource_h
#define Lumitree_Radiometry_LineSource_h

#include "Radiometry/Source.h"

namespace lumitree
{

/// A straight line that shines along its length, in closed form. In a plane through it every
/// direction alike; towards its ends by its distribution.
class LUMITREE_RADIOMETRY_EXPORT LineSource : public Source
{
public:
  enum class Distribution
  {
    Lambertian, ///< a thin tube: I′ sinγ at the angle γ from the line; Φ = π² I′ l
    Isotropic   ///< I′ in all directions; Φ = 4π I′ l
  };

  /// intensityPerMetre: I′, the intensity across of each metre, W/(sr m) or cd/m, finite, ≥ 0. The
  /// ends differ. metresPerUnit: finite, > 0. Throws std::invalid_argument otherwise, and for ends
  /// that are not finite (or beyond coordinateLimit).
  LineSource(double intensityPerMetre, const Vec3& begin, const Vec3& end,
    Distribution distribution = Distribution::Lambertian, double metresPerUnit = 1.0);

  [[nodiscard]] const Vec3& begin() const { return this->begin_; }
  [[nodiscard]] const Vec3& end() const { return this->end_; }
  [[nodiscard]] Distribution distribution() const { return this->distribution_; }

  /// I′ of each unit of the coordinates.
  [[nodiscard]] double intensityPerUnit() const
  {
    return this->intensityPerMetre_ / this->metresPerUnit_;
  }

  [[nodiscard]] std::optional<double> flux() const override;

  /// In the far field, where the line is a point.
  [[nodiscard]] std::optional<double> intensity(const Vec3& direction) const override;

  /// NaN on the line itself.
  [[nodiscard]] double irradiance(const Vec3& position, const Vec3& normal) const override;
  [[nodiscard]] double scalarIrradiance(const Vec3& position) const override;
  [[nodiscard]] Sightline sightline(const Vec3& position) const override;
  [[nodiscard]] Vec3 lightVector(const Vec3& position) const override;
  [[nodiscard]] bool extended() const override { return true; }
  [[nodiscard]] std::optional<Box> bounds() const override;

  /// Even along the line.
  [[nodiscard]] SourceSample sample(const Vec3& position, double u, double v) const override;

private:
  /// The light vector of a part of it, for I′ = 1 and lengths in units.
  [[nodiscard]] Vec3 vectorOf(const Vec3& toBegin, const Vec3& toEnd) const;

  double intensityPerMetre_;
  Vec3 begin_;
  Vec3 end_;
  Vec3 axis_;
  double length_;
  Distribution distribution_;
  double metresPerUnit_;
};

} // namespace lumitree

#endif
