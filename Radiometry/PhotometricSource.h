// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_PhotometricSource_h
#define Lumitree_Radiometry_PhotometricSource_h

#include "Radiometry/Frame.h"
#include "Radiometry/PhotometricWeb.h"
#include "Radiometry/PointLikeSource.h"

#include <memory>

namespace lumitree
{

/// A luminaire by its photometric web, as a point: valid from about five times its size on.
class LUMITREE_RADIOMETRY_EXPORT PhotometricSource : public PointLikeSource
{
public:
  /// web: what PhotometricWeb::check accepts. axis: where γ = 0, or H = V = 0, points to.
  /// reference: the direction of C 0, or of H > 0, taken at right angles to the axis; C 90, or V >
  /// 0, is a quarter of a turn counterclockwise from it, seen from behind the luminaire. scale: on
  /// all intensities, finite, ≥ 0. Throws std::invalid_argument otherwise, where axis and reference
  /// are parallel, and as PointLikeSource does.
  PhotometricSource(std::shared_ptr<const PhotometricWeb> web, const Vec3& position,
    const Vec3& axis, const Vec3& reference, double scale = 1.0, double metresPerUnit = 1.0);

  [[nodiscard]] const PhotometricWeb& web() const { return *this->web_; }
  [[nodiscard]] double scale() const { return this->scale_; }

  /// Of the interpolant, scaled.
  [[nodiscard]] std::optional<double> flux() const override { return this->flux_; }

protected:
  [[nodiscard]] double intensityAlong(const Vec3& direction) const override;

private:
  std::shared_ptr<const PhotometricWeb> web_;
  Frame frame_; ///< x: C 0, y: C 90, z: backwards
  double scale_;
  double flux_;
};

} // namespace lumitree

#endif
