// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_EmittingPolygon_h
#define Lumitree_Radiometry_EmittingPolygon_h

#include "Accel/Vec3.h"

#include <vector>

namespace lumitree
{

/// A flat polygon without holes that shines with the same radiance everywhere and in every
/// direction of its side (Lambert).
struct EmittingPolygon
{
  std::vector<Vec3>
    corners; ///< at least 3, in units of the coordinates; convex or not, no crossing
  Vec3 normal = { 0.0, 0.0,
    1.0 };               ///< unit, of the side that shines: that from which corners turn left
  double radiance = 0.0; ///< W/(m² sr) or cd/m², ≥ 0
  bool twoSided = false; ///< true: the other side shines alike
};

} // namespace lumitree

#endif
