// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_PolygonEstimator_h
#define Lumitree_Radiometry_Estimate_PolygonEstimator_h

#include "Radiometry/Estimate/SourceEstimator.h"

namespace lumitree
{

/// Light of a few flat polygons: each by itself, in the shaft from the eye to it.
class PolygonEstimator : public SourceEstimatorBase
{
public:
  PolygonEstimator(const Source& source, const EstimateScene& scene);

  [[nodiscard]] Estimate estimate(
    const View& view, double tolerance, EstimateWorkspace& workspace) const override;

private:
  struct Polygon
  {
    std::vector<std::vector<Vec3>> parts; ///< convex, with the winding of the whole
    std::vector<Vec3> hull;               ///< convex, the same winding
    Vec3 normal;
    double radiance = 0.0;
    bool twoSided = false;
    double clearance = 0.0; ///< what is nearer to the polygon than that is the polygon
  };

  [[nodiscard]] Estimate estimate(
    const Polygon& polygon, const View& view, double tolerance, EstimateWorkspace& workspace) const;

  /// The polygon in pieces as a position sees it, cut by the horizon of a sided view.
  static void look(
    const Polygon& polygon, const Vec3& position, const View& view, std::vector<ConePiece>& pieces);

  /// Finds what is in the shaft and makes it cones; false where that is too much to be cut out.
  bool findCones(const Polygon& polygon, double side, double height, std::size_t mostClipped,
    const View& view, EstimateWorkspace& workspace) const;

  std::vector<Polygon> polygons_;
};

} // namespace lumitree

#endif
