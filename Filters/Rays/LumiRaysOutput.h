// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Rays_LumiRaysOutput_h
#define Lumitree_Filters_Rays_LumiRaysOutput_h

#include "LumiRayInput.h"
#include "LumitreeFiltersRaysModule.h"

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"

namespace lumitree::filters
{

/// Makes `output`, of the same class as `input`, a dataset with one point per ray or, of lines, one
/// cell per segment: the input itself where it is that already; else its segments as line cells,
/// each with the cell data of its polyline. Returns the attributes that hold a tuple per ray.
LUMITREEFILTERSRAYS_EXPORT vtkDataSetAttributes* makeRaysOutput(
  vtkDataSet* input, const RayInput& rays, vtkDataSet* output);

} // namespace lumitree::filters

#endif
