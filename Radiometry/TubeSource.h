// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_TubeSource_h
#define Lumitree_Radiometry_TubeSource_h

#include "Radiometry/Frame.h"
#include "Radiometry/Source.h"

namespace lumitree
{

/// The outside of a round cylinder that shines by Lambert's law, without its ends (a fluorescent
/// tube): Φ = 2π² R l L. Irradiance by the integral along the outline that a receiver sees, two
/// lines and two arcs, cut by its horizon. Inside it is dark.
class LUMITREE_RADIOMETRY_EXPORT TubeSource : public Source
{
public:
  /// radiance: W/(m² sr) or cd/m², finite, ≥ 0. The ends of its axis differ. radius: in units of
  /// the coordinates, finite, > 0. metresPerUnit: finite, > 0. Throws std::invalid_argument
  /// otherwise, and for ends that are not finite (or beyond coordinateLimit).
  TubeSource(
    double radiance, const Vec3& begin, const Vec3& end, double radius, double metresPerUnit = 1.0);

  [[nodiscard]] const Vec3& begin() const { return this->begin_; }
  [[nodiscard]] double length() const { return this->length_; }
  [[nodiscard]] const Vec3& axis() const { return this->frame_.z; } ///< unit, towards its end
  [[nodiscard]] double tubeRadiance() const { return this->radiance_; }
  [[nodiscard]] double radius() const { return this->radius_; }

  [[nodiscard]] std::optional<double> flux() const override;

  /// In the far field: L 2 R l sinγ, γ the angle from its axis.
  [[nodiscard]] std::optional<double> intensity(const Vec3& direction) const override;
  [[nodiscard]] double irradiance(const Vec3& position, const Vec3& normal) const override;

  /// By quadrature around the axis, to about 1e-12.
  [[nodiscard]] double scalarIrradiance(const Vec3& position) const override;
  [[nodiscard]] Sightline sightline(const Vec3& position) const override;
  [[nodiscard]] Vec3 lightVector(const Vec3& position) const override;
  [[nodiscard]] bool extended() const override { return true; }
  [[nodiscard]] std::optional<Box> bounds() const override;

  /// By area, of the part that is turned to the position.
  [[nodiscard]] SourceSample sample(const Vec3& position, double u, double v) const override;
  [[nodiscard]] std::optional<double> radiance(
    const Vec3& position, const Vec3& direction) const override;
  void crossings(
    const Vec3& position, const Vec3& direction, std::vector<SourceCrossing>& to) const override;

private:
  struct Sight;
  [[nodiscard]] double integral(const Sight& sight, const Vec3& normal, bool cut) const;

  double radiance_;
  Vec3 begin_;
  Frame frame_; ///< z along the axis
  double length_;
  double radius_;
  double metresPerUnit_;
};

} // namespace lumitree

#endif
