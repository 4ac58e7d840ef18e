// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Rays_LumiSurfaceCost_h
#define Lumitree_Filters_Rays_LumiSurfaceCost_h

#include "LumiSurfaceInput.h"

#include "Accel/Accelerator.h"

#include "vtkDataObject.h"
#include "vtkMultiProcessController.h"

#include <vector>

namespace lumitree::filters
{

/// Makes the sums over all ranks, on every rank. Collective.
void sumOverRanks(std::vector<PrimitiveCounters>& counters, vtkMultiProcessController* controller);

/// Copies a surface, whatever dataset or composite it is, shallowly to an output of the same class.
void copySurface(vtkDataObject* input, vtkDataObject* output);

/// Adds the cell arrays RayTests, RayHits and LeafReferences (Docs/data-model.md) to a copy of the
/// surface; of cells that gave no triangles they are 0. process: the rank whose cells it has.
void addSurfaceCost(const SurfaceInput& surface, const Accelerator& accelerator,
  const std::vector<PrimitiveCounters>& counters, int process, vtkDataObject* output);

} // namespace lumitree::filters

#endif
