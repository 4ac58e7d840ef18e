// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Exact_Predicates_h
#define Lumitree_Accel_Exact_Predicates_h

#include "Accel/Export.h"
#include "Accel/Ray.h"

#include <array>

/// Questions about a ray and triangles, answered as rational arithmetic on the stored numbers
/// answers them. Every coordinate is finite. Called only where floating point cannot decide: a
/// tenth of a microsecond each, two where magnitudes are very uneven (Stages.h).
namespace lumitree::exact
{

/// Whether the line of the ray meets the closed triangle, not being parallel to its plane. False
/// for a triangle of zero area.
[[nodiscard]] LUMITREE_ACCEL_EXPORT bool lineMeetsTriangle(
  const Ray& ray, const std::array<Vec3, 3>& triangle);

/// The same of the line moved by (e, e^2, e^3), for every small enough e > 0. Two triangles that
/// share an edge, by the coordinates of its ends, answer for it with opposite signs: of a closed
/// surface around a point of the line, one triangle says yes where the line passes through.
[[nodiscard]] LUMITREE_ACCEL_EXPORT bool movedLineMeetsTriangle(
  const Ray& ray, const std::array<Vec3, 3>& triangle);

/// Sign of (t - limit), t where the line crosses the triangle's plane, which it does. The limit may
/// be infinite.
[[nodiscard]] LUMITREE_ACCEL_EXPORT int compareCrossing(
  const Ray& ray, const std::array<Vec3, 3>& triangle, double limit);

/// The same of the line moved by (e, e^2, e^3): never 0.
[[nodiscard]] LUMITREE_ACCEL_EXPORT int compareMovedCrossing(
  const Ray& ray, const std::array<Vec3, 3>& triangle, double limit);

/// Sign of (t of a - t of b), where the line crosses both planes.
[[nodiscard]] LUMITREE_ACCEL_EXPORT int compareCrossings(
  const Ray& ray, const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b);

/// t where the line crosses the triangle's plane, which it does: the double nearest to it, of two
/// equally near the even one; infinite beyond their range.
[[nodiscard]] LUMITREE_ACCEL_EXPORT double crossingParameter(
  const Ray& ray, const std::array<Vec3, 3>& triangle);

/// Whether the three points lie on one line (or coincide).
[[nodiscard]] LUMITREE_ACCEL_EXPORT bool isZeroArea(const std::array<Vec3, 3>& triangle);

} // namespace lumitree::exact

#endif
