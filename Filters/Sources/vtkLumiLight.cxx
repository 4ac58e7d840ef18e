// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiLight.h"

#include "LumiRayOutput.h"
#include "LumiUnits.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

namespace
{

constexpr int schemaVersion = 1;

void AddInteger(vtkPolyData* output, const char* name, int value)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  output->GetFieldData()->AddArray(array);
}

void AddString(vtkPolyData* output, const char* name, const char* value)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  output->GetFieldData()->AddArray(array);
}

}

vtkLumiLight::vtkLumiLight()
{
  this->SetNumberOfInputPorts(0);
}

vtkLumiLight::~vtkLumiLight()
{
  delete[] this->Name;
}

void vtkLumiLight::AddQuantity(
  vtkPolyData* output, const char* quantity, const char* unit, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->InsertNextValue(value);
  lumitree::filters::setUnit(array, quantity, unit);
  output->GetFieldData()->AddArray(array);
}

int vtkLumiLight::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

int vtkLumiLight::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const std::string problem = this->Problem();
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 0;
  }
  vtkInformation* information = outputVector->GetInformationObject(0);
  if (!lumitree::filters::isFirstPiece(information))
  {
    return 1;
  }
  vtkPolyData* output = vtkPolyData::GetData(information);
  AddInteger(output, "LightSchema", schemaVersion);
  AddString(output, "LightType", this->Type());
  AddString(output, "LightName", this->Name && *this->Name ? this->Name : this->Type());
  AddInteger(output, "LightSystem", this->System);
  this->Fill(output);
  return 1;
}

void vtkLumiLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "System: " << this->System << "\n";
  os << indent << "Name: " << (this->Name ? this->Name : "(null)") << "\n";
}
