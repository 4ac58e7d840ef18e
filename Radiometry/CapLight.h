// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_CapLight_h
#define Lumitree_Radiometry_CapLight_h

#include "Radiometry/Export.h"

namespace lumitree
{

/// Irradiance by a round cap of the sky of radiance 1 and the angular radius α, 0 … π/2, in the
/// middle of which a receiver's normal sees at that cosine: π sin²α cosθ, less what is below the
/// receiver's horizon. A sphere of radius R at distance d is such a cap, sinα = R / d, and so is
/// the sun. (Naito & Marui's view factor of a sphere, Howell's catalogue B-44, arranged so that
/// small caps keep their digits.) Never negative.
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT double capIrradiance(double sineOfRadius, double cosine);

} // namespace lumitree

#endif
