// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiRayOutput.h"

#include "LumiJob.h"

#include "Accel/Parallel.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <numeric>

namespace
{

constexpr std::size_t raysPerChunk = 16384;

vtkSmartPointer<vtkCellArray> vertexCells(vtkIdType count)
{
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(count + 1);
  std::iota(offsets->GetPointer(0), offsets->GetPointer(0) + count + 1, vtkIdType(0));
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(count);
  std::iota(connectivity->GetPointer(0), connectivity->GetPointer(0) + count, vtkIdType(0));
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, connectivity);
  return cells;
}

template <class Array>
bool writeTyped(vtkAlgorithm* algorithm, vtkPolyData* output, vtkIdType count,
  const std::function<lumitree::filters::RayLine(vtkIdType)>& ray)
{
  using Real = typename Array::ValueType;
  vtkNew<Array> origins;
  origins->SetNumberOfComponents(3);
  origins->SetNumberOfTuples(count);
  vtkNew<Array> directions;
  directions->SetName("RayDirection");
  directions->SetNumberOfComponents(3);
  directions->SetNumberOfTuples(count);

  Real* const origin = origins->GetPointer(0);
  Real* const direction = directions->GetPointer(0);
  lumitree::filters::Job job(algorithm);
  const bool completed = lumitree::parallelFor(static_cast<std::size_t>(count), raysPerChunk,
    lumitree::filters::threadsFor(0), job.control(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const lumitree::filters::RayLine line = ray(static_cast<vtkIdType>(i));
        for (std::size_t k = 0; k < 3; ++k)
        {
          origin[3 * i + k] = static_cast<Real>(line.origin[k]);
          direction[3 * i + k] = static_cast<Real>(line.direction[k]);
        }
      }
    });
  if (!completed)
  {
    return false;
  }

  vtkNew<vtkPoints> points;
  points->SetData(origins);
  output->SetPoints(points);
  output->SetVerts(vertexCells(count));
  output->GetPointData()->SetVectors(directions);
  return true;
}

}

namespace lumitree::filters
{

Share shareOf(vtkInformation* output, vtkIdType total)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const vtkIdType pieces = output->Has(Pipeline::UPDATE_NUMBER_OF_PIECES())
    ? std::max(1, output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()))
    : 1;
  const vtkIdType piece = output->Has(Pipeline::UPDATE_PIECE_NUMBER())
    ? std::max(0, output->Get(Pipeline::UPDATE_PIECE_NUMBER()))
    : 0;
  // The first total % pieces pieces have one more; no product that could overflow.
  const vtkIdType each = total / pieces;
  const vtkIdType more = total % pieces;
  return { piece * each + std::min(piece, more), each + (piece < more ? 1 : 0) };
}

bool isFirstPiece(vtkInformation* output)
{
  return shareOf(output, 1).count == 1;
}

bool writeRays(vtkAlgorithm* algorithm, vtkPolyData* output, vtkIdType count, int precision,
  const std::function<RayLine(vtkIdType)>& ray)
{
  return precision == vtkAlgorithm::SINGLE_PRECISION
    ? writeTyped<vtkFloatArray>(algorithm, output, count, ray)
    : writeTyped<vtkDoubleArray>(algorithm, output, count, ray);
}

}
