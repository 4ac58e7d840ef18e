// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Rays_LumiSurfaceData_h
#define Lumitree_Filters_Rays_LumiSurfaceData_h

#include "LumiSurfaceInput.h"

#include "vtkPolyData.h"

namespace lumitree::filters
{

/// Gives hits the surface's own arrays: numeric point arrays interpolated in the triangle that was
/// hit, cell arrays copied. Taken are the arrays that every leaf with primitives has, with the same
/// type and components, whose name the hits do not have yet; of two that share a name, the point
/// array. Ghost marks are left out, and of point arrays global and pedigree ids, which cannot be
/// interpolated.
///
/// primitives: one per hit. The hits' UV are their weights. A vertex that is no point of the
/// dataset (of a subdivided curved face) leaves its weight to the others.
void addSurfaceData(
  const SurfaceInput& surface, const PrimitiveId* primitives, int threads, vtkPolyData* hits);

} // namespace lumitree::filters

#endif
