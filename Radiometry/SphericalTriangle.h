// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_SphericalTriangle_h
#define Lumitree_Radiometry_SphericalTriangle_h

#include "Accel/Vec3.h"
#include "Radiometry/Export.h"

#include <array>

namespace lumitree
{

/// A direction of unit length to a point (u, v) of the unit square, of even density over the solid
/// angle of a triangle as seen from a position outside its plane. (Arvo, "Stratified sampling of
/// spherical triangles", SIGGRAPH 1995.) For solid angles between 3e-4 and 6.22 sr; outside of them
/// rounding distorts it.
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT Vec3 sampleSphericalTriangle(
  const Vec3& position, const std::array<Vec3, 3>& corners, double u, double v);

} // namespace lumitree

#endif
