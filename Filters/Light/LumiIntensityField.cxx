// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiIntensityField.h"

#include "LumiUnits.h"

#include "Radiometry/Checks.h"
#include "Radiometry/Constants.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace lumitree::filters
{

namespace
{

void addNumber(vtkDataObject* object, const std::string& name, double value)
{
  const vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  array->InsertNextValue(value);
  object->GetFieldData()->AddArray(array);
}

} // namespace

void IntensityField::setDirections(
  const Vec3& axisGiven, const Vec3& referenceGiven, int planes, int steps)
{
  const Vec3 axis = checks::unit(axisGiven, "Axis");
  const Vec3 given = checks::unit(referenceGiven, "Reference");
  const Vec3 across = given - dot(given, axis) * axis;
  if (!(length(across) > 1e-9))
  {
    throw std::runtime_error("Axis and Reference are parallel.");
  }
  const Vec3 x = checks::unit(across, "Reference");
  const Vec3 y = cross(-1.0 * axis, x);
  this->web = {};
  this->directions.clear();
  for (int c = 0; c <= planes; ++c)
  {
    this->web.horizontals.push_back(360.0 * c / planes);
    const double turn = 2.0 * pi * (c % planes) / planes;
    for (int g = 0; g <= steps; ++g)
    {
      const double gamma = pi * g / steps;
      this->directions.push_back(std::cos(gamma) * axis + (std::sin(gamma) * std::cos(turn)) * x +
        (std::sin(gamma) * std::sin(turn)) * y);
    }
  }
  for (int g = 0; g <= steps; ++g)
  {
    this->web.verticals.push_back(180.0 * g / steps);
  }
}

void IntensityField::addNumbers(vtkDataObject* object) const
{
  const std::string unit(describe(Quantity::Flux, this->system).unit);
  addNumber(object, "EmittedFlux [" + unit + "]", this->emittedFlux);
  addNumber(object, "IntegratedFlux [" + unit + "]", this->web.flux());
  if (this->farField > 0.0)
  {
    addNumber(object, "FarFieldDistance", this->farField);
  }
}

void IntensityField::fillSolid(const Vec3& centre, double radius, vtkPolyData* solid) const
{
  const vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const vtkNew<vtkDoubleArray> values;
  const vtkNew<vtkDoubleArray> planes;
  const vtkNew<vtkDoubleArray> gammas;
  const auto quantity = describe(Quantity::Intensity, this->system);
  setUnit(values, std::string(quantity.name).c_str(), std::string(quantity.unit).c_str());
  planes->SetName("C");
  gammas->SetName("Gamma");
  double greatest = 0.0;
  for (const double intensity : this->web.intensities)
  {
    greatest = std::max(greatest, intensity);
  }
  const auto rows = this->web.verticals.size();
  for (std::size_t i = 0; i < this->directions.size(); ++i)
  {
    const double intensity = this->web.intensities[i];
    const double share = greatest > 0.0 ? intensity / greatest : 0.0;
    const Vec3 p = centre + (radius * share) * this->directions[i];
    points->InsertNextPoint(p.data());
    values->InsertNextValue(intensity);
    planes->InsertNextValue(this->web.horizontals[i / rows]);
    gammas->InsertNextValue(this->web.verticals[i % rows]);
  }
  const vtkNew<vtkCellArray> cells;
  const auto last = static_cast<vtkIdType>(rows) - 1;
  for (vtkIdType c = 0; c < this->planes(); ++c)
  {
    for (vtkIdType g = 0; g < last; ++g)
    {
      const vtkIdType a = c * (last + 1) + g;
      const vtkIdType b = a + last + 1;
      cells->InsertNextCell({ a, b, b + 1, a + 1 });
    }
  }
  solid->SetPoints(points);
  solid->SetPolys(cells);
  solid->GetPointData()->SetScalars(values);
  solid->GetPointData()->AddArray(planes);
  solid->GetPointData()->AddArray(gammas);
}

void IntensityField::fillTable(vtkTable* table) const
{
  const vtkNew<vtkDoubleArray> gammas;
  gammas->SetName("Gamma");
  for (const double gamma : this->web.verticals)
  {
    gammas->InsertNextValue(gamma);
  }
  table->AddColumn(gammas);
  const auto rows = this->web.verticals.size();
  for (int c = 0; c < this->planes(); ++c)
  {
    const vtkNew<vtkDoubleArray> column;
    char name[32];
    std::snprintf(name, sizeof name, "C %g", this->web.horizontals[c]);
    column->SetName(name);
    for (std::size_t g = 0; g < rows; ++g)
    {
      column->InsertNextValue(this->web.intensities[c * rows + g]);
    }
    table->AddColumn(column);
  }
}

} // namespace lumitree::filters
