// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiRayAlgorithm.h"

#include "LumiPorts.h"

#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

#include <limits>

VTK_ABI_NAMESPACE_BEGIN

namespace filters = lumitree::filters;

vtkLumiRayAlgorithm::vtkLumiRayAlgorithm()
  : TMax(std::numeric_limits<double>::infinity())
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  this->SetInputArrayToProcess(0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "RayDirection");
}

vtkLumiRayAlgorithm::~vtkLumiRayAlgorithm() = default;

void vtkLumiRayAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Query: " << this->Query << "\n";
  os << indent << "TMin: " << this->TMin << "\n";
  os << indent << "TMax: " << this->TMax << "\n";
}

void vtkLumiRayAlgorithm::SetRaysConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

void vtkLumiRayAlgorithm::SetRaysData(vtkDataObject* rays)
{
  this->SetInputDataInternal(1, rays);
}

int vtkLumiRayAlgorithm::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  filters::acceptAnyDataSet(info);
  return 1;
}

int vtkLumiRayAlgorithm::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    if (port == this->SurfaceOutputPort())
    {
      continue; // VTK has given it that of the surface
    }
    filters::describeOutput(inputs[1]->GetInformationObject(0), // null without rays
      outputs->GetInformationObject(port), port == this->RaysOutputPort());
  }
  return 1;
}

int vtkLumiRayAlgorithm::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  filters::requestSurface(inputs[0]->GetInformationObject(0), this->GetController());
  if (vtkInformation* rays = inputs[1]->GetInformationObject(0))
  {
    const int from = request->Get(vtkExecutive::FROM_OUTPUT_PORT());
    const int asked = from < 0 ? 0 : from;
    filters::requestRays(
      rays, outputs->GetInformationObject(asked), asked == this->RaysOutputPort());
  }
  return 1;
}

VTK_ABI_NAMESPACE_END
