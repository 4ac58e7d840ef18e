// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Looking_PolygonsAlongRay_h
#define Lumitree_Radiometry_Looking_PolygonsAlongRay_h

#include "Accel/Accelerator.h"
#include "Radiometry/EmittingPolygon.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace lumitree
{

/// Finds among many polygons those that a ray may meet: a structure over their triangles is asked
/// what is in a thin shaft around the ray, as wide as rounding, and what polygons lack of being
/// flat, ask for. Built on the calling thread.
class PolygonsAlongRay
{
public:
  /// A part of a polygon.
  struct Triangle
  {
    std::size_t polygon;
    std::array<Vec3, 3> corners;
  };

  PolygonsAlongRay(
    const std::vector<EmittingPolygon>& polygons, const std::vector<Triangle>& triangles);

  /// All that the half-line meets, and perhaps others; ascending, each once.
  void find(const Vec3& position, const Vec3& direction, std::vector<std::size_t>& polygons) const;

private:
  std::vector<std::size_t> polygonOf_; ///< per triangle
  std::shared_ptr<const Accelerator> accelerator_;
  double unevenness_ = 0.0; ///< of corners from the planes of their polygons, at most
};

} // namespace lumitree

#endif
