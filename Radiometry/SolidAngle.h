// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_SolidAngle_h
#define Lumitree_Radiometry_SolidAngle_h

#include "Accel/Vec3.h"
#include "Radiometry/Export.h"

namespace lumitree
{

/// Solid angle [sr] of the triangle (a, b, c) seen from a point, -2π … 2π: positive when its normal
/// by winding points away from there. The triangles of a closed surface with outward normals add up
/// to 4π around a point within, and to 0 around one without. Seen from its own plane: 0 beside it,
/// ±2π within it; NaN at a vertex. (Van Oosterom & Strackee, IEEE Trans. Biomed. Eng. 30, 1983,
/// eq. 8.)
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT double solidAngle(
  const Vec3& from, const Vec3& a, const Vec3& b, const Vec3& c);

/// Solid angle [sr] of a disk of that radius (≥ 0), seen from its axis at that height (> 0):
/// 2π (1 - h / √(h² + R²)), without its cancellation for small disks.
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT double diskSolidAngle(double radius, double height);

} // namespace lumitree

#endif
