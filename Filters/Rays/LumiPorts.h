// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Rays_LumiPorts_h
#define Lumitree_Filters_Rays_LumiPorts_h

#include "LumitreeFiltersRaysModule.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"

namespace lumitree::filters
{

/// Lets an input port take any dataset and any composite as a whole. Were composites not named, VTK
/// would run the filter block by block, and blocks would not see each other.
LUMITREEFILTERSRAYS_EXPORT void acceptAnyDataSet(vtkInformation* port);

/// Puts a new object of the very class of `model` into an output, unless one is there. Returns 0
/// without a model.
LUMITREEFILTERSRAYS_EXPORT int makeOutputLike(vtkDataObject* model, vtkInformation* output);

/// Tells what is known of an output's grid before it is made: that of the rays when it holds them
/// (sameGrid), else nothing. VTK would give it that of the surface. Time steps come from the rays
/// when the surface has none.
void describeOutput(vtkInformation* rays, vtkInformation* output, bool sameGrid);

/// Asks an input for a piece of everything, without ghosts.
LUMITREEFILTERSRAYS_EXPORT void requestPiece(vtkInformation* input, int piece, int pieces);

/// Asks a surface port for this rank's piece of everything, whatever piece of the outputs is asked
/// for.
LUMITREEFILTERSRAYS_EXPORT void requestSurface(
  vtkInformation* surface, vtkMultiProcessController* controller);

/// Asks a ray port for what is asked of an output: an extent where `output` holds the rays
/// themselves (sameGrid) and has one, else the piece.
void requestRays(vtkInformation* rays, vtkInformation* output, bool sameGrid);

} // namespace lumitree::filters

#endif
