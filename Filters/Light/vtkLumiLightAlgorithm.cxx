// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiLightAlgorithm.h"

#include "LumiUnits.h"

#include "vtkMultiProcessController.h"

VTK_ABI_NAMESPACE_BEGIN

vtkLumiLightAlgorithm::vtkLumiLightAlgorithm() = default;

vtkLumiLightAlgorithm::~vtkLumiLightAlgorithm() = default;

void vtkLumiLightAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LengthUnit: " << lumitree::filters::lengthUnitName(this->LengthUnit) << "\n";
}

void vtkLumiLightAlgorithm::SetOccludersConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

void vtkLumiLightAlgorithm::SetOccludersData(vtkDataObject* occluders)
{
  this->SetInputDataObject(1, occluders);
}

int vtkLumiLightAlgorithm::Rank()
{
  return this->GetController() ? this->GetController()->GetLocalProcessId() : 0;
}

int vtkLumiLightAlgorithm::Ranks()
{
  return this->GetController() ? this->GetController()->GetNumberOfProcesses() : 1;
}

VTK_ABI_NAMESPACE_END
