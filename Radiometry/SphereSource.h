// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_SphereSource_h
#define Lumitree_Radiometry_SphereSource_h

#include "Radiometry/Source.h"

namespace lumitree
{

/// A sphere that shines outward by Lambert's law: Φ = 4π² R² L, I = π R² L, and E = π L (R/d)² cosθ
/// where all of it is above the receiver's horizon. Inside it is dark.
class LUMITREE_RADIOMETRY_EXPORT SphereSource : public Source
{
public:
  /// radiance: W/(m² sr) or cd/m², finite, ≥ 0. radius: in units of the coordinates, finite, > 0.
  /// metresPerUnit: finite, > 0. Throws std::invalid_argument otherwise, and for a centre that is
  /// not finite (or beyond coordinateLimit).
  SphereSource(double radiance, const Vec3& centre, double radius, double metresPerUnit = 1.0);

  [[nodiscard]] const Vec3& centre() const { return this->centre_; }
  [[nodiscard]] double radius() const { return this->radius_; }

  [[nodiscard]] std::optional<double> flux() const override;
  [[nodiscard]] std::optional<double> intensity(const Vec3& direction) const override;
  [[nodiscard]] double irradiance(const Vec3& position, const Vec3& normal) const override;
  [[nodiscard]] double scalarIrradiance(const Vec3& position) const override;
  [[nodiscard]] Sightline sightline(const Vec3& position) const override;
  [[nodiscard]] Vec3 lightVector(const Vec3& position) const override;
  [[nodiscard]] bool extended() const override { return true; }
  [[nodiscard]] std::optional<Box> bounds() const override;

  /// By solid angle.
  [[nodiscard]] SourceSample sample(const Vec3& position, double u, double v) const override;
  [[nodiscard]] std::optional<double> radiance(
    const Vec3& position, const Vec3& direction) const override;
  void crossings(
    const Vec3& position, const Vec3& direction, std::vector<SourceCrossing>& to) const override;

private:
  double radiance_;
  Vec3 centre_;
  double radius_;
  double metresPerUnit_;
};

} // namespace lumitree

#endif
