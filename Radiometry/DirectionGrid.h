// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_DirectionGrid_h
#define Lumitree_Radiometry_DirectionGrid_h

#include "Accel/Vec3.h"
#include "Radiometry/Export.h"

#include <vector>

namespace lumitree
{

/// The whole sphere in rings around an axis, each in sectors: direction ring × sectors + sector is
/// in the middle of its cell, θ = π (ring + ½) / rings from the axis and φ = 2π (sector + ½) /
/// sectors from the reference, counterclockwise about the axis. The solid angles of the cells, Δφ
/// (cosθ₁ − cosθ₂), add up to 4π.
struct DirectionGrid
{
  std::vector<Vec3> directions;    ///< unit
  std::vector<double> solidAngles; ///< sr
};

/// axis, reference: any length but 0, not parallel. rings, sectors: > 0. Throws
/// std::invalid_argument otherwise.
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT DirectionGrid makeDirectionGrid(
  const Vec3& axis, const Vec3& reference, int rings, int sectors);

} // namespace lumitree

#endif
