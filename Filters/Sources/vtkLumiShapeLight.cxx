// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiShapeLight.h"

#include "LumiDirections.h"
#include "LumiLightShapes.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include "Radiometry/Quantities.h"

#include <cmath>

vtkStandardNewMacro(vtkLumiShapeLight);

namespace filters = lumitree::filters;

namespace
{

lumitree::Vec3 Vector(const double* v)
{
  return { v[0], v[1], v[2] };
}

} // namespace

const char* vtkLumiShapeLight::Type() const
{
  constexpr const char* types[] = { "sphere", "disk", "area", "tube", "line" };
  return types[this->Shape];
}

std::string vtkLumiShapeLight::Problem() const
{
  using namespace lumitree;
  if (!filters::isFinite3(this->Origin) || !filters::isFinite3(this->Point1) ||
    !filters::isFinite3(this->Point2))
  {
    return "Origin, Point1 and Point2 must be finite.";
  }
  const Vec3 first = Vector(this->Point1) - Vector(this->Origin);
  const Vec3 second = Vector(this->Point2) - Vector(this->Origin);
  if ((this->Shape == Tube || this->Shape == Line) && filters::isZero(filters::unit(first)))
  {
    return "Origin and Point1 must not be the same.";
  }
  if (this->Shape == Rectangle &&
    !(lumitree::length(cross(filters::unit(first), filters::unit(second))) > 1e-12))
  {
    return "Origin, Point1 and Point2 must not lie on a line.";
  }
  if (this->Shape == Disk && filters::isZero(filters::unit(Vector(this->Normal))))
  {
    return "Normal must be finite and not zero.";
  }
  if (!(std::isfinite(this->Radius) && this->Radius > 0.0))
  {
    return "Radius must be finite and above 0.";
  }
  if (!(std::isfinite(this->Emission) && this->Emission >= 0.0))
  {
    return "Emission must be finite and not negative.";
  }
  if (this->Shape == Line && this->EmissionQuantity == Exitance)
  {
    return "A line has no exitance; give its flux, or its intensity per metre (Radiance).";
  }
  return {};
}

void vtkLumiShapeLight::Fill(vtkPolyData* output) const
{
  using lumitree::Quantity;
  const lumitree::Vec3 origin = Vector(this->Origin);
  const lumitree::Vec3 point1 = Vector(this->Point1);
  switch (this->Shape)
  {
    case Disk:
      filters::drawDisk(output, origin, Vector(this->Normal), this->Radius);
      AddTuple(output, "LightCentre", this->Origin, 3);
      AddTuple(output, "LightNormal", this->Normal, 3);
      AddTuple(output, "LightRadius", &this->Radius, 1);
      AddInteger(output, "LightTwoSided", this->TwoSided ? 1 : 0);
      break;
    case Rectangle:
      filters::drawQuad(output, origin, point1, Vector(this->Point2));
      AddInteger(output, "LightTwoSided", this->TwoSided ? 1 : 0);
      break;
    case Tube:
      filters::drawTube(output, origin, point1, this->Radius);
      AddTuple(output, "LightBegin", this->Origin, 3);
      AddTuple(output, "LightEnd", this->Point1, 3);
      AddTuple(output, "LightRadius", &this->Radius, 1);
      break;
    case Line:
      filters::drawLine(output, origin, point1);
      AddTuple(output, "LightBegin", this->Origin, 3);
      AddTuple(output, "LightEnd", this->Point1, 3);
      AddText(output, "LineDistribution",
        this->LineDistribution == Lambertian ? "lambertian" : "isotropic");
      break;
    default:
      filters::drawSphere(output, origin, this->Radius);
      AddTuple(output, "LightCentre", this->Origin, 3);
      AddTuple(output, "LightRadius", &this->Radius, 1);
  }
  if (this->Shape == Line && this->EmissionQuantity == Radiance)
  {
    if (this->System == Photometric)
    {
      AddQuantity(output, "LuminousIntensityPerMetre", "cd/m", this->Emission);
    }
    else
    {
      AddQuantity(output, "RadiantIntensityPerMetre", "W/(sr m)", this->Emission);
    }
    return;
  }
  constexpr Quantity quantities[] = { Quantity::Radiance, Quantity::Exitance, Quantity::Flux };
  AddQuantity(output, quantities[this->EmissionQuantity], this->Emission);
}

void vtkLumiShapeLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print3 = [&](const char* name, const double* v)
  { os << indent << name << ": (" << v[0] << ", " << v[1] << ", " << v[2] << ")\n"; };
  os << indent << "Shape: " << this->Type() << "\n";
  print3("Origin", this->Origin);
  print3("Point1", this->Point1);
  print3("Point2", this->Point2);
  print3("Normal", this->Normal);
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "TwoSided: " << (this->TwoSided ? "on" : "off") << "\n";
  os << indent << "LineDistribution: " << this->LineDistribution << "\n";
  os << indent << "EmissionQuantity: " << this->EmissionQuantity << "\n";
  os << indent << "Emission: " << this->Emission << "\n";
}
