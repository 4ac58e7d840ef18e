// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_PolygonSource_h
#define Lumitree_Radiometry_PolygonSource_h

#include "Radiometry/Source.h"

#include <array>
#include <cstddef>
#include <memory>

namespace lumitree
{

/// Flat polygons that shine by Lambert's law: L is the same in all directions, M = πL, Φ = ΣMA.
/// Irradiance by Lambert's formula (LambertPolygon.h), cut off at the receiver's horizon.
///
/// A polygon does not shine into its own plane: there, and behind it if it is one-sided, it gives
/// 0.
class LUMITREE_RADIOMETRY_EXPORT PolygonSource : public Source
{
public:
  /// polygons: their normals are computed here from their corners. Those without area give nothing.
  /// metresPerUnit: finite, > 0. Throws std::invalid_argument otherwise, for fewer than 3 corners,
  /// for coordinates that are not finite (or beyond coordinateLimit), and for a radiance that is
  /// negative or not finite.
  explicit PolygonSource(std::vector<EmittingPolygon> polygons, double metresPerUnit = 1.0);

  [[nodiscard]] std::optional<double> flux() const override { return this->flux_; }

  /// In the far field, where the source is a point: Σ L A cosθ of the polygons that face that way.
  [[nodiscard]] std::optional<double> intensity(const Vec3& direction) const override;
  [[nodiscard]] double irradiance(const Vec3& position, const Vec3& normal) const override;
  [[nodiscard]] double scalarIrradiance(const Vec3& position) const override;
  [[nodiscard]] Sightline sightline(const Vec3& position) const override;
  [[nodiscard]] Vec3 lightVector(const Vec3& position) const override;
  [[nodiscard]] bool extended() const override { return true; }

  /// Of few polygons: a triangle by what it contributes, in it by solid angle (Arvo 1995). Of many:
  /// by area and radiance.
  [[nodiscard]] SourceSample sample(const Vec3& position, double u, double v) const override;
  [[nodiscard]] const std::vector<EmittingPolygon>* polygons() const override
  {
    return &this->polygons_;
  }
  [[nodiscard]] std::optional<Box> bounds() const override { return this->bounds_; }
  [[nodiscard]] std::optional<double> radiance(
    const Vec3& position, const Vec3& direction) const override;

  /// Of many polygons by a structure over their triangles, made at the first call.
  void crossings(
    const Vec3& position, const Vec3& direction, std::vector<SourceCrossing>& to) const override;

private:
  /// A part of a polygon, for samples.
  struct Triangle
  {
    std::size_t polygon;
    std::array<Vec3, 3> corners;
    double area;
  };

  struct Finder;

  static void crossing(const EmittingPolygon& polygon, const Vec3& position, const Vec3& direction,
    std::vector<SourceCrossing>& to);

  /// 1: the position sees the front, −1: the back of a two-sided polygon, 0: nothing.
  static double side(const EmittingPolygon& polygon, const Vec3& position);
  [[nodiscard]] double shownSolidAngle(const Triangle& triangle, const Vec3& position) const;
  [[nodiscard]] SourceSample sampleIn(const Triangle& triangle, double chance, double solidAngle,
    const Vec3& position, double u, double v) const;

  std::vector<EmittingPolygon> polygons_;
  std::vector<Triangle> triangles_;
  std::vector<double> powerSums_; ///< of the triangles, running
  Box bounds_;
  Vec3 middle_;
  double metresPerUnit_;
  std::shared_ptr<Finder> finder_;
  double flux_ = 0.0;
};

} // namespace lumitree

#endif
