// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiRayOutput_h
#define LumiRayOutput_h

#include "Accel/Vec3.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkPolyData.h"

#include <cstdint>
#include <functional>

namespace lumitree::filters
{

/// The share [first, first + count) of a piece.
struct Share
{
  vtkIdType first = 0;
  vtkIdType count = 0;
};

/// What the piece that the pipeline asks for has of `total` things: pieces are contiguous, in
/// order, and together they are the whole.
Share shareOf(vtkInformation* output, vtkIdType total);

/// Whether the pipeline asks for piece 0, which is where a light is.
bool isFirstPiece(vtkInformation* output);

struct RayLine
{
  Vec3 origin;
  Vec3 direction;
};

/// Gives an empty output `count` rays as Docs/data-model.md wants them: points, a vertex cell each,
/// and the point array RayDirection, all float when `precision` is vtkAlgorithm::SINGLE_PRECISION,
/// else double. `ray` is called with 0 ... count - 1 from several threads. Progress and abort are
/// those of `algorithm`; when it was aborted the output is left empty, and the result is false.
bool writeRays(vtkAlgorithm* algorithm, vtkPolyData* output, vtkIdType count, int precision,
  const std::function<RayLine(vtkIdType)>& ray);

}

#endif
