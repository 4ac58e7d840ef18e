// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiDirectionalLight.h"

#include "LumiDirections.h"
#include "LumiLightShapes.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include "Radiometry/Quantities.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkLumiDirectionalLight);

std::string vtkLumiDirectionalLight::Problem() const
{
  const double* d = this->Direction;
  if (lumitree::filters::isZero(lumitree::filters::unit({ d[0], d[1], d[2] })))
  {
    return "Direction must be finite and not zero.";
  }
  if (!(std::isfinite(this->NormalIrradiance) && this->NormalIrradiance >= 0.0))
  {
    return "NormalIrradiance must be finite and not negative.";
  }
  if (!std::all_of(this->Anchor, this->Anchor + 3, [](double x) { return std::isfinite(x); }))
  {
    return "Anchor must be finite.";
  }
  if (!(this->AngularDiameter >= 0.0 && this->AngularDiameter <= 180.0))
  {
    return "AngularDiameter must be from 0 to 180.";
  }
  if (!(std::isfinite(this->Length) && this->Length > 0.0))
  {
    return "Length must be finite and above 0.";
  }
  return {};
}

void vtkLumiDirectionalLight::Fill(vtkPolyData* output) const
{
  const double* d = this->Direction;
  const double* a = this->Anchor;
  lumitree::filters::drawRay(
    output, { a[0], a[1], a[2] }, lumitree::filters::unit({ d[0], d[1], d[2] }), this->Length);
  AddTuple(output, "LightDirection", this->Direction, 3);
  if (this->AngularDiameter > 0.0)
  {
    AddQuantity(output, "AngularDiameter", "deg", this->AngularDiameter);
  }
  AddQuantity(output, lumitree::Quantity::NormalIrradiance, this->NormalIrradiance);
}

void vtkLumiDirectionalLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print3 = [&](const char* name, const double* v)
  { os << indent << name << ": (" << v[0] << ", " << v[1] << ", " << v[2] << ")\n"; };
  print3("Direction", this->Direction);
  os << indent << "NormalIrradiance: " << this->NormalIrradiance << "\n";
  os << indent << "AngularDiameter: " << this->AngularDiameter << "\n";
  print3("Anchor", this->Anchor);
  os << indent << "Length: " << this->Length << "\n";
}
