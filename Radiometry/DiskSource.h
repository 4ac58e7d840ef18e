// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_DiskSource_h
#define Lumitree_Radiometry_DiskSource_h

#include "Radiometry/Frame.h"
#include "Radiometry/Source.h"

namespace lumitree
{

/// A flat disk that shines by Lambert's law: Φ = π² R² L for each side that shines. Irradiance in
/// closed form for any receiver: all of it above the horizon by the view factors of parallel and of
/// perpendicular elements (Howell's catalogue, B-12 and B-13), cut by the horizon by the integral
/// along what is left of its outline. Into its own plane it does not shine.
class LUMITREE_RADIOMETRY_EXPORT DiskSource : public Source
{
public:
  /// radiance: W/(m² sr) or cd/m², finite, ≥ 0. normal: of the side that shines, finite, any length
  /// but 0. radius: in units of the coordinates, finite, > 0. metresPerUnit: finite, > 0. Throws
  /// std::invalid_argument otherwise, and for a centre that is not finite (or beyond
  /// coordinateLimit).
  DiskSource(double radiance, const Vec3& centre, const Vec3& normal, double radius,
    bool twoSided = false, double metresPerUnit = 1.0);

  [[nodiscard]] const Vec3& centre() const { return this->centre_; }
  [[nodiscard]] const Vec3& normal() const { return this->frame_.z; }
  [[nodiscard]] double radius() const { return this->radius_; }
  [[nodiscard]] bool twoSided() const { return this->twoSided_; }

  [[nodiscard]] std::optional<double> flux() const override;
  [[nodiscard]] std::optional<double> intensity(const Vec3& direction) const override;
  [[nodiscard]] double irradiance(const Vec3& position, const Vec3& normal) const override;

  /// L Ω, Ω by complete elliptic integrals (Paxton, Rev. Sci. Instrum. 30, 1959), far away by
  /// cubature.
  [[nodiscard]] double scalarIrradiance(const Vec3& position) const override;
  [[nodiscard]] Sightline sightline(const Vec3& position) const override;
  [[nodiscard]] Vec3 lightVector(const Vec3& position) const override;
  [[nodiscard]] bool extended() const override { return true; }
  [[nodiscard]] std::optional<Box> bounds() const override;

  /// By area, concentric.
  [[nodiscard]] SourceSample sample(const Vec3& position, double u, double v) const override;
  [[nodiscard]] std::optional<double> radiance(
    const Vec3& position, const Vec3& direction) const override;
  void crossings(
    const Vec3& position, const Vec3& direction, std::vector<SourceCrossing>& to) const override;

private:
  /// Height above the side that the position sees, > 0; 0 where it sees none.
  [[nodiscard]] double heightOver(const Vec3& position) const;
  [[nodiscard]] double cutIrradiance(const Vec3& towardsCentre, const Vec3& normal) const;

  double radiance_;
  Vec3 centre_;
  Frame frame_;
  double radius_;
  bool twoSided_;
  double metresPerUnit_;
};

} // namespace lumitree

#endif
