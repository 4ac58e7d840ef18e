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

#include "Radiometry/LuminousEfficacy.h"
#include "Radiometry/Quantities.h"

#include <limits>
#include <stdexcept>

namespace
{

constexpr int schemaVersion = 1;

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

void vtkLumiLight::AddQuantity(vtkPolyData* output, lumitree::Quantity quantity, double value) const
{
  const lumitree::QuantityName named =
    lumitree::describe(quantity, static_cast<lumitree::LightSystem>(this->System));
  AddQuantity(output, std::string(named.name).c_str(), std::string(named.unit).c_str(), value);
}

void vtkLumiLight::AddTuple(
  vtkPolyData* output, const char* name, const double* values, int components)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->InsertNextTuple(values);
  output->GetFieldData()->AddArray(array);
}

void vtkLumiLight::AddValues(
  vtkPolyData* output, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  output->GetFieldData()->AddArray(array);
}

void vtkLumiLight::AddText(vtkPolyData* output, const char* name, const std::string& text)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(text);
  output->GetFieldData()->AddArray(array);
}

void vtkLumiLight::AddInteger(vtkPolyData* output, const char* name, int value)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  output->GetFieldData()->AddArray(array);
}

double vtkLumiLight::LuminousEfficacyOfSpectrum(vtkDataArray* spectrum)
{
  constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
  if (!spectrum || spectrum->GetNumberOfComponents() != 2)
  {
    return undefined;
  }
  std::vector<lumitree::SpectralValue> values;
  for (vtkIdType i = 0; i < spectrum->GetNumberOfTuples(); ++i)
  {
    values.push_back({ spectrum->GetComponent(i, 0), spectrum->GetComponent(i, 1) });
  }
  try
  {
    return lumitree::luminousEfficacy(values);
  }
  catch (const std::invalid_argument&)
  {
    return undefined;
  }
}

std::string vtkLumiLight::FillFrom(vtkInformationVector**, vtkInformation*, vtkPolyData* output)
{
  this->Fill(output);
  return {};
}

int vtkLumiLight::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

int vtkLumiLight::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  std::string problem = this->Problem();
  if (problem.empty() && !(this->LuminousEfficacy >= 0.0 && this->LuminousEfficacy <= 683.0))
  {
    problem = "LuminousEfficacy must be from 0 to 683.";
  }
  vtkInformation* information = outputVector->GetInformationObject(0);
  vtkPolyData* output = vtkPolyData::GetData(information);
  if (problem.empty() && lumitree::filters::isFirstPiece(information))
  {
    AddInteger(output, "LightSchema", schemaVersion);
    AddText(output, "LightType", this->Type());
    AddText(output, "LightName", this->Name && *this->Name ? this->Name : this->Type());
    AddInteger(output, "LightSystem", this->System);
    if (this->LuminousEfficacy > 0.0)
    {
      AddQuantity(output, "LuminousEfficacy", "lm/W", this->LuminousEfficacy);
    }
    problem = this->FillFrom(inputVector, information, output);
  }
  if (!problem.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< problem);
    return 0;
  }
  return 1;
}

void vtkLumiLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "System: " << this->System << "\n";
  os << indent << "LuminousEfficacy: " << this->LuminousEfficacy << "\n";
  os << indent << "Name: " << (this->Name ? this->Name : "(null)") << "\n";
}
