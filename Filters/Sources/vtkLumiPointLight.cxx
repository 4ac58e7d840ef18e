// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiPointLight.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkLumiPointLight);

std::string vtkLumiPointLight::Problem() const
{
  if (!std::all_of(this->Position, this->Position + 3, [](double x) { return std::isfinite(x); }))
  {
    return "Position must be finite.";
  }
  if (!(std::isfinite(this->Flux) && this->Flux >= 0.0))
  {
    return "Flux must be finite and not negative.";
  }
  return {};
}

void vtkLumiPointLight::Fill(vtkPolyData* output) const
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(this->Position);
  output->SetPoints(points);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  output->SetVerts(vertices);

  if (this->System == Photometric)
  {
    AddQuantity(output, "LuminousFlux", "lm", this->Flux);
  }
  else
  {
    AddQuantity(output, "RadiantFlux", "W", this->Flux);
  }
}

void vtkLumiPointLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Position: (" << this->Position[0] << ", " << this->Position[1] << ", "
     << this->Position[2] << ")\n";
  os << indent << "Flux: " << this->Flux << "\n";
}
