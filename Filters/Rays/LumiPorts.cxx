// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiPorts.h"

#include "vtkAlgorithm.h"
#include "vtkExtentTranslator.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <string>

namespace lumitree::filters
{

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

} // namespace

void requestPiece(vtkInformation* input, int piece, int pieces)
{
  input->Set(Pipeline::UPDATE_PIECE_NUMBER(), piece);
  input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), pieces);
  input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  if (input->Has(Pipeline::WHOLE_EXTENT()))
  {
    int whole[6];
    int extent[6];
    input->Get(Pipeline::WHOLE_EXTENT(), whole);
    vtkNew<vtkExtentTranslator> translator;
    translator->PieceToExtentThreadSafe(
      piece, pieces, 0, whole, extent, translator->GetSplitMode(), 0);
    input->Set(Pipeline::UPDATE_EXTENT(), extent, 6);
  }
}

void acceptAnyDataSet(vtkInformation* port)
{
  port->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
}

int makeOutputLike(vtkDataObject* model, vtkInformation* output)
{
  if (!model)
  {
    return 0;
  }
  const vtkDataObject* present = output->Get(vtkDataObject::DATA_OBJECT());
  if (!present || std::string(present->GetClassName()) != model->GetClassName())
  {
    output->Set(
      vtkDataObject::DATA_OBJECT(), vtkSmartPointer<vtkDataObject>::Take(model->NewInstance()));
  }
  return 1;
}

void describeOutput(vtkInformation* rays, vtkInformation* output, bool sameGrid)
{
  const vtkNew<vtkInformation> nothing;
  vtkInformation* grid = sameGrid ? rays : nothing.Get();
  output->CopyEntry(grid, Pipeline::WHOLE_EXTENT());
  output->CopyEntry(grid, vtkDataObject::ORIGIN());
  output->CopyEntry(grid, vtkDataObject::SPACING());
  output->CopyEntry(grid, vtkDataObject::DIRECTION());
  if (rays && !output->Has(Pipeline::TIME_RANGE()))
  {
    output->CopyEntry(rays, Pipeline::TIME_STEPS());
    output->CopyEntry(rays, Pipeline::TIME_RANGE());
  }
}

void requestSurface(vtkInformation* surface, vtkMultiProcessController* controller)
{
  requestPiece(surface, controller ? controller->GetLocalProcessId() : 0,
    controller ? controller->GetNumberOfProcesses() : 1);
}

void requestRays(vtkInformation* rays, vtkInformation* output, bool sameGrid)
{
  if (sameGrid && rays->Has(Pipeline::WHOLE_EXTENT()) && output->Has(Pipeline::UPDATE_EXTENT()))
  {
    rays->CopyEntry(output, Pipeline::UPDATE_EXTENT());
    rays->CopyEntry(output, Pipeline::UPDATE_PIECE_NUMBER());
    rays->CopyEntry(output, Pipeline::UPDATE_NUMBER_OF_PIECES());
    rays->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
  else
  {
    requestPiece(rays,
      output->Has(Pipeline::UPDATE_PIECE_NUMBER()) ? output->Get(Pipeline::UPDATE_PIECE_NUMBER())
                                                   : 0,
      output->Has(Pipeline::UPDATE_NUMBER_OF_PIECES())
        ? output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())
        : 1);
  }
}

} // namespace lumitree::filters
