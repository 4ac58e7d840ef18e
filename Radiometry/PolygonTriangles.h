// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_PolygonTriangles_h
#define Lumitree_Radiometry_PolygonTriangles_h

#include "Accel/Vec3.h"
#include "Radiometry/Export.h"

#include <array>
#include <cstddef>
#include <vector>

namespace lumitree
{

/// Area times unit normal of at least 3 corners, in units of the coordinates squared; projected
/// along itself where the polygon is not flat (Newell).
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT Vec3 polygonAreaVector(const std::vector<Vec3>& corners);

/// Triangles (indices of corners) that a flat polygon without crossings consists of, with its
/// winding: a fan where it is convex, ears cut one by one where it is not.
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT std::vector<std::array<std::size_t, 3>> triangulatePolygon(
  const std::vector<Vec3>& corners);

} // namespace lumitree

#endif
