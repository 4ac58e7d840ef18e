// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiRayAlgorithm.h"

#include "LumiPorts.h"

#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkSmartPointer.h"

#include <limits>

VTK_ABI_NAMESPACE_BEGIN

namespace filters = lumitree::filters;

struct vtkLumiRayAlgorithm::Settings
{
  vtkSmartPointer<vtkMultiProcessController> Controller;
};

vtkLumiRayAlgorithm::vtkLumiRayAlgorithm()
  : TMax(std::numeric_limits<double>::infinity())
  , Held(new Settings)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  this->SetInputArrayToProcess(0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "RayDirection");
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkLumiRayAlgorithm::~vtkLumiRayAlgorithm() = default;

void vtkLumiRayAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Query: " << this->Query << "\n";
  os << indent << "Structure: " << this->Structure << "\n";
  os << indent << "Precision: " << this->Precision << "\n";
  os << indent << "BvhBuild: " << this->BvhBuild << "\n";
  os << indent << "LeafSize: " << this->LeafSize << "\n";
  os << indent << "TMin: " << this->TMin << "\n";
  os << indent << "TMax: " << this->TMax << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "Controller: " << this->Held->Controller.Get() << "\n";
}

void vtkLumiRayAlgorithm::SetRaysConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

void vtkLumiRayAlgorithm::SetRaysData(vtkDataObject* rays)
{
  this->SetInputDataInternal(1, rays);
}

void vtkLumiRayAlgorithm::SetController(vtkMultiProcessController* controller)
{
  if (this->Held->Controller != controller)
  {
    this->Held->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkLumiRayAlgorithm::GetController()
{
  return this->Held->Controller;
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
    filters::describeOutput(inputs[1]->GetInformationObject(0), // null without rays
      outputs->GetInformationObject(port), port == this->RaysOutputPort());
  }
  return 1;
}

int vtkLumiRayAlgorithm::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  filters::requestSurface(inputs[0]->GetInformationObject(0), this->Held->Controller);
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
