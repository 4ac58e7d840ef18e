// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiSpotLight.h"

#include "LumiDirections.h"
#include "LumiLightShapes.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include "Radiometry/Constants.h"
#include "Radiometry/CosineLobeSource.h"
#include "Radiometry/Quantities.h"
#include "Radiometry/SpotSource.h"

#include <cmath>
#include <memory>

vtkStandardNewMacro(vtkLumiSpotLight);

namespace filters = lumitree::filters;

std::string vtkLumiSpotLight::Problem() const
{
  if (!filters::isFinite3(this->Position))
  {
    return "Position must be finite.";
  }
  const double* d = this->Direction;
  if (filters::isZero(filters::unit({ d[0], d[1], d[2] })))
  {
    return "Direction must be finite and not zero.";
  }
  if (!(std::isfinite(this->Exponent) && this->Exponent >= 0.0))
  {
    return "Exponent must be finite and not negative.";
  }
  if (!(this->ConeAngle >= 0.0 && this->ConeAngle <= this->CutoffAngle && this->CutoffAngle > 0.0 &&
        this->CutoffAngle <= 180.0))
  {
    return "The angles must be 0 <= ConeAngle <= CutoffAngle <= 180, and CutoffAngle not 0.";
  }
  if (!(std::isfinite(this->Emission) && this->Emission >= 0.0))
  {
    return "Emission must be finite and not negative.";
  }
  if (!(std::isfinite(this->Length) && this->Length >= 0.0))
  {
    return "Length must be finite and not negative.";
  }
  return {};
}

void vtkLumiSpotLight::Fill(vtkPolyData* output) const
{
  using namespace lumitree;
  const Vec3 position = { this->Position[0], this->Position[1], this->Position[2] };
  const Vec3 axis = { this->Direction[0], this->Direction[1], this->Direction[2] };
  const bool lobe = this->Falloff == CosineLobe;
  const double cone = this->ConeAngle * pi / 180.0;
  const double cutoff = this->CutoffAngle * pi / 180.0;
  double axial = this->Emission;
  if (this->EmissionKind == Flux)
  {
    axial = lobe ? CosineLobeSource::axialIntensityOf(this->Emission, this->Exponent)
                 : SpotSource::axialIntensityOf(this->Emission, cone, cutoff);
  }
  std::unique_ptr<Source> source;
  if (lobe)
  {
    source = std::make_unique<CosineLobeSource>(axial, this->Exponent, position, axis);
    AddTuple(output, "LobeExponent", &this->Exponent, 1);
  }
  else
  {
    source = std::make_unique<SpotSource>(axial, cone, cutoff, position, axis);
    AddQuantity(output, "ConeAngle", "deg", this->ConeAngle);
    AddQuantity(output, "CutoffAngle", "deg", this->CutoffAngle);
  }
  const std::string name =
    arrayName(Quantity::Intensity, static_cast<lumitree::LightSystem>(this->System));
  filters::drawIntensities(output, *source, position, axis, this->Length, name.c_str());
  AddTuple(output, "LightAxis", this->Direction, 3);
  AddQuantity(
    output, this->EmissionKind == Flux ? Quantity::Flux : Quantity::Intensity, this->Emission);
}

void vtkLumiSpotLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print3 = [&](const char* name, const double* v)
  { os << indent << name << ": (" << v[0] << ", " << v[1] << ", " << v[2] << ")\n"; };
  print3("Position", this->Position);
  print3("Direction", this->Direction);
  os << indent << "Falloff: " << this->Falloff << "\n";
  os << indent << "Exponent: " << this->Exponent << "\n";
  os << indent << "ConeAngle: " << this->ConeAngle << "\n";
  os << indent << "CutoffAngle: " << this->CutoffAngle << "\n";
  os << indent << "EmissionKind: " << this->EmissionKind << "\n";
  os << indent << "Emission: " << this->Emission << "\n";
  os << indent << "Length: " << this->Length << "\n";
}
