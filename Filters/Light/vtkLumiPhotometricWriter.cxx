// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiPhotometricWriter.h"

#include "LumiLightReader.h"
#include "LumiPhotometricText.h"
#include "vtkLumiRadiantIntensity.h"

#include "Radiometry/PhotometricSource.h"
#include "Radiometry/PhotometricWeb.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkVariant.h"

#include <exception>
#include <stdexcept>
#include <string>

VTK_ABI_NAMESPACE_BEGIN

namespace filters = lumitree::filters;

namespace
{

bool IsLight(vtkPolyData* data)
{
  return data->GetFieldData()->GetAbstractArray("LightType") != nullptr;
}

/// The table that a photometric solid shows: plane by plane, each from gamma 0 on.
lumitree::PhotometricWeb WebOf(vtkPolyData* solid)
{
  vtkPointData* data = solid->GetPointData();
  vtkDataArray* planes = data->GetArray("C");
  vtkDataArray* gammas = data->GetArray("Gamma");
  vtkDataArray* intensities = data->GetArray("LuminousIntensity [cd]");
  if (!intensities)
  {
    intensities = data->GetArray("RadiantIntensity [W/sr]");
  }
  if (!planes || !gammas || !intensities || planes->GetNumberOfTuples() < 1)
  {
    throw std::runtime_error("The input is neither a light nor a photometric solid.");
  }
  lumitree::PhotometricWeb web;
  const vtkIdType count = planes->GetNumberOfTuples();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double plane = planes->GetComponent(i, 0);
    if (web.horizontals.empty() || plane != web.horizontals.back())
    {
      web.horizontals.push_back(plane);
    }
    if (web.horizontals.size() == 1)
    {
      web.verticals.push_back(gammas->GetComponent(i, 0));
    }
    web.intensities.push_back(intensities->GetComponent(i, 0));
  }
  web.check();
  return web;
}

} // namespace

vtkStandardNewMacro(vtkLumiPhotometricWriter);

vtkLumiPhotometricWriter::vtkLumiPhotometricWriter() = default;

vtkLumiPhotometricWriter::~vtkLumiPhotometricWriter()
{
  this->SetFileName(nullptr);
}

void vtkLumiPhotometricWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto triple = [&](const char* name, const double* v)
  { os << indent << name << ": (" << v[0] << ", " << v[1] << ", " << v[2] << ")\n"; };
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Planes: " << this->Planes << "\n";
  os << indent << "Steps: " << this->Steps << "\n";
  triple("Axis", this->Axis);
  triple("Reference", this->Reference);
}

int vtkLumiPhotometricWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

void vtkLumiPhotometricWriter::WriteData()
{
  const std::string name = this->FileName ? this->FileName : "";
  try
  {
    auto* data = vtkPolyData::SafeDownCast(this->GetInput());
    if (!data)
    {
      throw std::runtime_error("There is nothing to write.");
    }
    lumitree::PhotometricWeb web;
    const lumitree::PhotometricSource* own = nullptr;
    filters::Light light;
    if (IsLight(data))
    {
      light = filters::readLight(data, 1.0);
      own = dynamic_cast<const lumitree::PhotometricSource*>(light.source.get());
    }
    if (own)
    {
      web = own->web();
      for (double& intensity : web.intensities)
      {
        intensity *= own->scale();
      }
      auto* named = data->GetFieldData()->GetAbstractArray("LuminaireName");
      web.name =
        named && named->GetNumberOfValues() > 0 ? named->GetVariantValue(0).ToString() : light.name;
    }
    else if (light.source)
    {
      const vtkNew<vtkLumiRadiantIntensity> table;
      const vtkNew<vtkCallbackCommand> quiet; // what is wrong is reported here
      std::string problem;
      quiet->SetClientData(&problem);
      quiet->SetCallback([](vtkObject*, unsigned long, void* told, void*)
        { *static_cast<std::string*>(told) = "It has no intensity: it is infinitely far."; });
      table->AddObserver(vtkCommand::ErrorEvent, quiet);
      table->SetInputData(data);
      table->SetPlanes(this->Planes);
      table->SetSteps(this->Steps);
      table->SetAxis(this->Axis);
      table->SetReference(this->Reference);
      table->Update();
      if (!problem.empty())
      {
        throw std::runtime_error(problem);
      }
      web = WebOf(vtkPolyData::SafeDownCast(table->GetOutputDataObject(0)));
      web.name = light.name;
    }
    else
    {
      web = WebOf(data);
    }
    filters::writePhotometricFile(web, name);
  }
  catch (const std::exception& problem)
  {
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
    vtkErrorMacro(<< "The photometric file \"" << name << "\" is not written. " << problem.what());
  }
}

VTK_ABI_NAMESPACE_END
