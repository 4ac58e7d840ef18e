// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_SkySource_h
#define Lumitree_Radiometry_SkySource_h

#include "Radiometry/Source.h"

namespace lumitree
{

/// Light from infinitely far, from all directions above the horizon, and from below it of a ground
/// that shines evenly: the same at every position.
class LUMITREE_RADIOMETRY_EXPORT SkySource : public Source
{
public:
  /// Unit vector to the zenith.
  [[nodiscard]] const Vec3& up() const { return this->up_; }
  [[nodiscard]] double groundRadiance() const { return this->groundRadiance_; }

  /// Radiance that comes from a direction of unit length.
  [[nodiscard]] double radianceFrom(const Vec3& direction) const;

  /// The same to about 1e-7 of the sky's brightest part, sooner: for samples.
  [[nodiscard]] virtual double radianceOfSample(const Vec3& direction) const
  {
    return this->radianceFrom(direction);
  }

  [[nodiscard]] std::optional<double> flux() const final { return std::nullopt; }
  [[nodiscard]] std::optional<double> intensity(const Vec3&) const final { return std::nullopt; }
  [[nodiscard]] double irradiance(const Vec3& position, const Vec3& normal) const final;
  [[nodiscard]] double scalarIrradiance(const Vec3& position) const final;
  [[nodiscard]] Vec3 lightVector(const Vec3& position) const final;

  /// To the zenith.
  [[nodiscard]] Sightline sightline(const Vec3& position) const final;
  [[nodiscard]] bool extended() const final { return true; }

  /// Even over the hemisphere; over the sphere where the ground shines.
  [[nodiscard]] SourceSample sample(const Vec3& position, double u, double v) const final;
  [[nodiscard]] std::optional<double> radiance(
    const Vec3& position, const Vec3& direction) const final;

protected:
  /// up: finite, any length but 0. groundRadiance: W/(m² sr) or cd/m², finite, ≥ 0. Throws
  /// std::invalid_argument otherwise.
  SkySource(const Vec3& up, double groundRadiance);

  /// Of the sky alone. Directions and normals are unit vectors; directions are above the horizon.
  [[nodiscard]] virtual double skyRadiance(const Vec3& direction) const = 0;
  [[nodiscard]] virtual double skyIrradiance(const Vec3& normal) const = 0;
  [[nodiscard]] virtual double skyScalarIrradiance() const = 0;
  [[nodiscard]] virtual Vec3 skyVector() const = 0;

private:
  Vec3 up_;
  double groundRadiance_;
};

/// Everywhere the same radiance: E = πL (1 + cosβ) / 2 on a plane of that tilt.
class LUMITREE_RADIOMETRY_EXPORT UniformSky : public SkySource
{
public:
  /// radiance: W/(m² sr) or cd/m², finite, ≥ 0. Throws std::invalid_argument as SkySource does.
  explicit UniformSky(
    double radiance, const Vec3& up = { 0.0, 0.0, 1.0 }, double groundRadiance = 0.0);

protected:
  [[nodiscard]] double skyRadiance(const Vec3& direction) const override;
  [[nodiscard]] double skyIrradiance(const Vec3& normal) const override;
  [[nodiscard]] double skyScalarIrradiance() const override;
  [[nodiscard]] Vec3 skyVector() const override;

private:
  double radiance_;
};

} // namespace lumitree

#endif
