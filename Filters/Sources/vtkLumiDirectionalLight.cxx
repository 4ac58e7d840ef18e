// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiDirectionalLight.h"

#include "LumiDirections.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

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
  if (!(std::isfinite(this->Length) && this->Length > 0.0))
  {
    return "Length must be finite and above 0.";
  }
  return {};
}

void vtkLumiDirectionalLight::Fill(vtkPolyData* output) const
{
  using namespace lumitree;
  const double* d = this->Direction;
  const Vec3 end = { this->Anchor[0], this->Anchor[1], this->Anchor[2] };
  const Vec3 start = end - this->Length * lumitree::filters::unit({ d[0], d[1], d[2] });
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(start.data());
  points->InsertNextPoint(end.data());
  output->SetPoints(points);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  output->SetLines(lines);

  vtkNew<vtkDoubleArray> direction;
  direction->SetName("LightDirection");
  direction->SetNumberOfComponents(3);
  direction->InsertNextTuple(this->Direction);
  output->GetFieldData()->AddArray(direction);
  if (this->System == Photometric)
  {
    AddQuantity(output, "NormalIlluminance", "lx", this->NormalIrradiance);
  }
  else
  {
    AddQuantity(output, "NormalIrradiance", "W/m^2", this->NormalIrradiance);
  }
}

void vtkLumiDirectionalLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print3 = [&](const char* name, const double* v)
  { os << indent << name << ": (" << v[0] << ", " << v[1] << ", " << v[2] << ")\n"; };
  print3("Direction", this->Direction);
  os << indent << "NormalIrradiance: " << this->NormalIrradiance << "\n";
  print3("Anchor", this->Anchor);
  os << indent << "Length: " << this->Length << "\n";
}
