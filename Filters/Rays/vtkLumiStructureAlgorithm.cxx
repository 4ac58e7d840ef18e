// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiStructureAlgorithm.h"

#include "vtkMultiProcessController.h"
#include "vtkSmartPointer.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN

struct vtkLumiStructureAlgorithm::Settings
{
  vtkSmartPointer<vtkMultiProcessController> Controller;
  std::string StructureFile;
};

vtkLumiStructureAlgorithm::vtkLumiStructureAlgorithm()
  : Held(new Settings)
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkLumiStructureAlgorithm::~vtkLumiStructureAlgorithm() = default;

void vtkLumiStructureAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Structure: " << this->Structure << "\n";
  os << indent << "Precision: " << this->Precision << "\n";
  os << indent << "BvhBuild: " << this->BvhBuild << "\n";
  os << indent << "KdBuild: " << this->KdBuild << "\n";
  os << indent << "LeafSize: " << this->LeafSize << "\n";
  os << indent << "MaxDepth: " << this->MaxDepth << "\n";
  os << indent << "GridDensity: " << this->GridDensity << "\n";
  os << indent << "GridResolution: " << this->GridResolution[0] << " " << this->GridResolution[1]
     << " " << this->GridResolution[2] << "\n";
  os << indent << "Mailboxing: " << (this->Mailboxing ? "on" : "off") << "\n";
  os << indent << "Refit: " << (this->Refit ? "on" : "off") << "\n";
  os << indent << "RefitLimit: " << this->RefitLimit << "\n";
  os << indent << "StructureFile: " << this->Held->StructureFile << "\n";
  os << indent << "StructureFileUse: " << this->StructureFileUse << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "Controller: " << this->Held->Controller.Get() << "\n";
}

void vtkLumiStructureAlgorithm::SetStructureFile(const char* path)
{
  const std::string file = path ? path : "";
  if (this->Held->StructureFile != file)
  {
    this->Held->StructureFile = file;
    this->Modified();
  }
}

const char* vtkLumiStructureAlgorithm::GetStructureFile()
{
  return this->Held->StructureFile.c_str();
}

void vtkLumiStructureAlgorithm::SetController(vtkMultiProcessController* controller)
{
  if (this->Held->Controller != controller)
  {
    this->Held->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkLumiStructureAlgorithm::GetController()
{
  return this->Held->Controller;
}

VTK_ABI_NAMESPACE_END
