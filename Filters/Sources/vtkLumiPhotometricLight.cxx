// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiPhotometricLight.h"

#include "LumiLightShapes.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include "Radiometry/PhotometricFile.h"
#include "Radiometry/PhotometricSource.h"
#include "Radiometry/Quantities.h"

#include <cmath>
#include <memory>
#include <stdexcept>

vtkStandardNewMacro(vtkLumiPhotometricLight);

vtkLumiPhotometricLight::vtkLumiPhotometricLight()
{
  this->System = Photometric;
}

vtkLumiPhotometricLight::~vtkLumiPhotometricLight()
{
  delete[] this->FileName;
}

std::string vtkLumiPhotometricLight::Problem() const
{
  if (!this->FileName || !*this->FileName)
  {
    return "FileName must name an IES or EULUMDAT file.";
  }
  if (this->System != Photometric)
  {
    return "A photometric file is Photometric. Its LuminousEfficacy makes radiation of it.";
  }
  if (!lumitree::filters::isFinite3(this->Position))
  {
    return "Position must be finite.";
  }
  if (!(std::isfinite(this->Scale) && this->Scale >= 0.0))
  {
    return "Scale must be finite and not negative.";
  }
  if (!(this->Tilt >= 0.0 && this->Tilt <= 180.0))
  {
    return "Tilt must be from 0 to 180.";
  }
  if (!(std::isfinite(this->Length) && this->Length >= 0.0))
  {
    return "Length must be finite and not negative.";
  }
  return {};
}

std::string vtkLumiPhotometricLight::FillFrom(
  vtkInformationVector**, vtkInformation*, vtkPolyData* output)
{
  using namespace lumitree;
  try
  {
    const auto web = std::make_shared<const PhotometricWeb>(readPhotometricFile(this->FileName));
    const double scale = this->Scale * web->tiltFactor(this->Tilt);
    const Vec3 position = { this->Position[0], this->Position[1], this->Position[2] };
    const Vec3 axis = { this->Direction[0], this->Direction[1], this->Direction[2] };
    const PhotometricSource source(
      web, position, axis, { this->Reference[0], this->Reference[1], this->Reference[2] }, scale);
    filters::drawIntensities(
      output, source, position, axis, this->Length, "LuminousIntensity [cd]");
    AddText(output, "PhotometricType", web->type == PhotometricWeb::Type::C ? "C" : "B");
    AddValues(output, "PhotometricVerticals [deg]", web->verticals);
    AddValues(output, "PhotometricHorizontals [deg]", web->horizontals);
    AddValues(output, "PhotometricLuminousIntensity [cd]", web->intensities);
    AddTuple(output, "PhotometricScale", &scale, 1);
    AddTuple(output, "LightAxis", this->Direction, 3);
    AddTuple(output, "LightReference", this->Reference, 3);
    AddQuantity(output, Quantity::Flux, *source.flux());
    if (web->statedFlux)
    {
      AddQuantity(output, "StatedLuminousFlux", "lm", *web->statedFlux);
    }
    AddText(output, "PhotometricFormat", web->format);
    AddText(output, "LuminaireName", web->name);
  }
  catch (const std::exception& problem)
  {
    return std::string(this->FileName) + ": " + problem.what();
  }
  return {};
}

void vtkLumiPhotometricLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print3 = [&](const char* name, const double* v)
  { os << indent << name << ": (" << v[0] << ", " << v[1] << ", " << v[2] << ")\n"; };
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(null)") << "\n";
  print3("Position", this->Position);
  print3("Direction", this->Direction);
  print3("Reference", this->Reference);
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "Tilt: " << this->Tilt << "\n";
  os << indent << "Length: " << this->Length << "\n";
}
