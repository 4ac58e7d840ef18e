// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiTriangulate_h
#define LumiTriangulate_h

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolygon.h"

#include "Accel/Surface.h"

#include <vector>

namespace lumitree::filters
{

/// Cuts polygons and strips into triangles that keep the cell's winding. One per thread.
class Triangulator
{
public:
  explicit Triangulator(const PointArray& points)
    : points_(points)
  {
  }

  /// A polygon of n ≥ 3 points: n − 2 triangles. Quads are cut along a diagonal that stays inside,
  /// the shorter of two (as vtkQuad does); larger polygons by vtkPolygon's ear cutting. A polygon
  /// that cannot be cut (it crosses itself, or is not planar at all) becomes a fan, which covers
  /// it, so that nothing leaks.
  ///
  /// A cell with a coordinate that is not finite is never hit as a whole: it becomes one triangle
  /// that has this point.
  void polygon(vtkIdType n, const vtkIdType* ids, std::vector<Triangle>& triangles);

  /// A strip of n ≥ 3 points: n − 2 triangles, every other one reversed; the same for points not
  /// finite.
  void strip(vtkIdType n, const vtkIdType* ids, std::vector<Triangle>& triangles) const;

private:
  [[nodiscard]] bool notFinite(
    vtkIdType n, const vtkIdType* ids, std::vector<Triangle>& triangles) const;
  void quad(const vtkIdType* ids, std::vector<Triangle>& triangles) const;
  [[nodiscard]] bool cutEars(vtkIdType n, const vtkIdType* ids);

  const PointArray& points_;
  vtkNew<vtkPolygon> polygon_;
  vtkNew<vtkIdList> ears_;
};

} // namespace lumitree::filters
#endif
