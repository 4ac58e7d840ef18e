// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/DirectionGrid.h"

#include "Radiometry/Checks.h"
#include "Radiometry/Constants.h"

#include <cmath>
#include <stdexcept>

namespace lumitree
{

DirectionGrid makeDirectionGrid(const Vec3& axis, const Vec3& reference, int rings, int sectors)
{
  if (rings < 1 || sectors < 1)
  {
    throw std::invalid_argument("A grid of directions needs rings and sectors.");
  }
  const Vec3 z = checks::unit(axis, "The axis");
  const Vec3 given = checks::unit(reference, "The reference");
  const Vec3 across = given - dot(given, z) * z;
  if (!(length(across) > 1e-9))
  {
    throw std::invalid_argument("The axis and the reference are parallel.");
  }
  const Vec3 x = checks::unit(across, "The reference");
  const Vec3 y = cross(z, x);
  DirectionGrid grid;
  for (int ring = 0; ring < rings; ++ring)
  {
    const double theta = pi * (ring + 0.5) / rings;
    // cosθ₁ − cosθ₂, without cancellation.
    const double band = 2.0 * std::sin(theta) * std::sin(0.5 * pi / rings);
    for (int sector = 0; sector < sectors; ++sector)
    {
      const double phi = 2.0 * pi * (sector + 0.5) / sectors;
      grid.directions.push_back(
        std::cos(theta) * z + std::sin(theta) * (std::cos(phi) * x + std::sin(phi) * y));
      grid.solidAngles.push_back(2.0 * pi / sectors * band);
    }
  }
  return grid;
}

} // namespace lumitree
