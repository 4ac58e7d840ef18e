// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_LambertPolygon_h
#define Lumitree_Radiometry_LambertPolygon_h

#include "Accel/Vec3.h"
#include "Radiometry/Export.h"

#include <cstddef>
#include <vector>

/// Light of a plane polygon of radiance 1, all of it visible, from corners relative to the receiver
/// (so that coordinates far from the origin cancel once). Three corners or more, convex or not, in
/// either sense; lengths in any unit, from 1e-75 to 1e75. No function returns NaN or a negative
/// number for finite corners: seen from its own plane a polygon gives 0, and corners that coincide
/// with each other or with the receiver add nothing.
///
/// Lambert's formula D = ½ Σ θ Γ over the edges (θ the angle that an edge subtends, Γ the unit
/// normal of its plane with the receiver), in double with atan2 (J. H. Lambert, Photometria, 1760;
/// D. R. Baum, H. E. Rushmeier, J. M. Winget, SIGGRAPH 1989). Polygons that look smaller than about
/// 1/200 lose digits to it: their integral is taken by a rule of degree five, which there is exact
/// to 1e-13.
namespace lumitree
{

/// Light vector D = ∫ ω dω (Gershun); it points to the polygon. Its component along a normal is the
/// irradiance on that side where all of the polygon is above the horizon.
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT Vec3 polygonLightVector(
  const Vec3* corners, std::size_t count);

/// The same with the sign of the winding, for those who know it: it points to the polygon where
/// corners a, b, c have a · (b × c) > 0. Cheaper, as the side is not looked for.
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT Vec3 windingLightVector(
  const Vec3* corners, std::size_t count);

/// Irradiance ∫ max(0, n·ω) dω on the side of a unit normal: the polygon is cut by the horizon.
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT double polygonIrradiance(
  const Vec3* corners, std::size_t count, const Vec3& normal);

/// Solid angle ∫ dω [sr], 0 … 2π; the scalar irradiance.
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT double polygonSolidAngle(
  const Vec3* corners, std::size_t count);

/// The part of a polygon where n·x >= 0. Of one that is not convex the parts may hang together by
/// edges of no width, which add nothing to any integral.
LUMITREE_RADIOMETRY_EXPORT void clipPolygon(
  const Vec3* corners, std::size_t count, const Vec3& normal, std::vector<Vec3>& result);

} // namespace lumitree

#endif
