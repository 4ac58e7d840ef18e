// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_EndPointOverlap_h
#define Lumitree_Accel_EndPointOverlap_h

#include "Accel/Export.h"
#include "Accel/Hierarchy.h"
#include "Accel/Surface.h"

namespace lumitree
{

/// End-point overlap (Aila, Karras and Laine 2013, section 4): what rays that end on the surface
/// are expected to pay for boxes that they only meet because boxes overlap,
///
///     Σ_n c(n) · area(of the surface in n's box that is not below n) / area(the surface),
///
/// c as in BuildStatistics::sahCost and in its unit. 0 where nodes do not overlap, as of grids and
/// KD-trees, but for the outward rounding of their cells. In double arithmetic; triangles only.
/// Takes about as long as building a hierarchy of boxes; of a grid, whose root has all cells for
/// children, much longer.
[[nodiscard]] LUMITREE_ACCEL_EXPORT double endPointOverlap(
  const HierarchyView& view, const Surface& surface);

} // namespace lumitree

#endif
