// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiAreaLight.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include "LumiUnits.h"

#include "Radiometry/Quantities.h"

#include <cmath>

vtkStandardNewMacro(vtkLumiAreaLight);

namespace
{

constexpr lumitree::Quantity Quantities[] = { lumitree::Quantity::Radiance,
  lumitree::Quantity::Exitance, lumitree::Quantity::Flux };

} // namespace

vtkLumiAreaLight::vtkLumiAreaLight()
{
  this->SetNumberOfInputPorts(1);
}

vtkLumiAreaLight::~vtkLumiAreaLight()
{
  delete[] this->EmissionArray;
}

int vtkLumiAreaLight::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

int vtkLumiAreaLight::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  input->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
  input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  if (input->Has(Pipeline::WHOLE_EXTENT()))
  {
    input->Set(Pipeline::UPDATE_EXTENT(), input->Get(Pipeline::WHOLE_EXTENT()), 6);
  }
  return 1;
}

std::string vtkLumiAreaLight::Problem() const
{
  if (!(std::isfinite(this->Emission) && this->Emission >= 0.0))
  {
    return "Emission must be finite and not negative.";
  }
  return {};
}

std::string vtkLumiAreaLight::FillFrom(
  vtkInformationVector** inputs, vtkInformation*, vtkPolyData* output)
{
  vtkDataSet* input = vtkDataSet::GetData(inputs[0]);
  const auto copy = vtk::TakeSmartPointer(input->NewInstance());
  copy->ShallowCopy(input);
  copy->GetFieldData()->Initialize(); // which may be another light's
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(copy);
  surface->Update();
  vtkPolyData* polygons = surface->GetOutput();
  if (polygons->GetNumberOfPolys() + polygons->GetNumberOfStrips() == 0)
  {
    return "The input has no polygons that could shine.";
  }
  const std::string name = lumitree::arrayName(
    Quantities[this->EmissionQuantity], static_cast<lumitree::LightSystem>(this->System));
  vtkSmartPointer<vtkDataArray> values;
  const std::string arrayName = this->EmissionArray ? this->EmissionArray : "";
  if (!arrayName.empty() && arrayName != "None") // which a list of arrays offers
  {
    vtkDataArray* given = polygons->GetCellData()->GetArray(arrayName.c_str());
    if (!given || given->GetNumberOfComponents() != 1)
    {
      return "The input has no cell array \"" + arrayName + "\" of one component.";
    }
    for (vtkIdType i = 0; i < given->GetNumberOfTuples(); ++i)
    {
      const double value = given->GetComponent(i, 0);
      if (!(std::isfinite(value) && value >= 0.0))
      {
        return "The values of \"" + arrayName + "\" must be finite and not negative.";
      }
    }
    values = vtk::TakeSmartPointer(given->NewInstance());
    values->DeepCopy(given);
    const lumitree::QuantityName named = lumitree::describe(
      Quantities[this->EmissionQuantity], static_cast<lumitree::LightSystem>(this->System));
    lumitree::filters::setUnit(
      values, std::string(named.name).c_str(), std::string(named.unit).c_str());
  }
  output->SetPoints(polygons->GetPoints());
  output->SetVerts(polygons->GetVerts());
  output->SetLines(polygons->GetLines());
  output->SetPolys(polygons->GetPolys());
  output->SetStrips(polygons->GetStrips());
  output->GetPointData()->ShallowCopy(polygons->GetPointData());
  output->GetCellData()->ShallowCopy(polygons->GetCellData());
  // Arrays of those names would be taken for what the cells emit.
  for (const lumitree::Quantity quantity : Quantities)
  {
    output->GetCellData()->RemoveArray(
      lumitree::arrayName(quantity, static_cast<lumitree::LightSystem>(this->System)).c_str());
  }
  if (values)
  {
    output->GetCellData()->AddArray(values);
    output->GetCellData()->SetActiveScalars(name.c_str());
  }
  else
  {
    this->AddQuantity(output, Quantities[this->EmissionQuantity], this->Emission);
  }
  AddInteger(output, "LightTwoSided", this->TwoSided ? 1 : 0);
  return {};
}

void vtkLumiAreaLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "EmissionQuantity: " << this->EmissionQuantity << "\n";
  os << indent << "Emission: " << this->Emission << "\n";
  os << indent << "EmissionArray: " << (this->EmissionArray ? this->EmissionArray : "(null)")
     << "\n";
  os << indent << "TwoSided: " << (this->TwoSided ? "on" : "off") << "\n";
}
