// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiIlluminationAlgorithm.h"

#include "LumiPorts.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"

VTK_ABI_NAMESPACE_BEGIN

namespace filters = lumitree::filters;

vtkLumiIlluminationAlgorithm::vtkLumiIlluminationAlgorithm()
{
  this->SetNumberOfInputPorts(3);
}

vtkLumiIlluminationAlgorithm::~vtkLumiIlluminationAlgorithm() = default;

void vtkLumiIlluminationAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ReceiverLocation: " << this->ReceiverLocation << "\n";
  os << indent << "RelativeTolerance: " << this->RelativeTolerance << "\n";
  os << indent << "MaximumRays: " << this->MaximumRays << "\n";
}

void vtkLumiIlluminationAlgorithm::AddLightsConnection(vtkAlgorithmOutput* output)
{
  this->AddInputConnection(2, output);
}

void vtkLumiIlluminationAlgorithm::AddLightsData(vtkDataObject* lights)
{
  this->AddInputDataObject(2, lights);
}

void vtkLumiIlluminationAlgorithm::RemoveAllLights()
{
  this->RemoveAllInputConnections(2);
}

int vtkLumiIlluminationAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  // Composites are named, too: otherwise the pipeline would run these filters block by block, and
  // one block would not be in the way of another.
  filters::acceptAnyDataSet(info);
  if (port == 2)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  }
  // Lights are needed, but their absence is reported here, once, and not by the pipeline at each
  // update.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 0 ? 0 : 1);
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), port == 2 ? 1 : 0);
  return 1;
}

int vtkLumiIlluminationAlgorithm::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return filters::makeOutputLike(
    vtkDataObject::GetData(inputVector[0]), outputVector->GetInformationObject(0));
}

int vtkLumiIlluminationAlgorithm::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (const int port : { 1, 2 })
  {
    for (int i = 0; i < inputVector[port]->GetNumberOfInformationObjects(); ++i)
    {
      filters::requestPiece(
        inputVector[port]->GetInformationObject(i), this->Rank(), this->Ranks());
    }
  }
  return 1;
}

VTK_ABI_NAMESPACE_END
