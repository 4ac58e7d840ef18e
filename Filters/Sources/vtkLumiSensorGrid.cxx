// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiSensorGrid.h"

#include "LumiUnits.h"

#include "Accel/Vec3.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkLumiSensorGrid);

namespace
{

using lumitree::Vec3;
using lumitree::operator+;
using lumitree::operator-;
using lumitree::operator*;

Vec3 ToVec3(const double* from)
{
  return { from[0], from[1], from[2] };
}

/// EN 12464-1, 4.4, in metres.
double StandardSpacing(double one, double two)
{
  const double longer = std::max(one, two);
  const double shorter = std::min(one, two);
  const double d = longer >= 2.0 * shorter ? shorter : longer;
  return std::min(10.0, 0.2 * std::pow(5.0, std::log10(d)));
}

} // namespace

vtkLumiSensorGrid::vtkLumiSensorGrid()
{
  this->SetNumberOfInputPorts(0);
}

int vtkLumiSensorGrid::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

int vtkLumiSensorGrid::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  vtkInformation* info = outputVector->GetInformationObject(0);
  const auto asked = [&](vtkInformationIntegerKey* key, int otherwise)
  { return info->Has(key) ? info->Get(key) : otherwise; };
  const int piece = asked(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
  const int pieces =
    std::max(1, asked(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1));

  const Vec3 sideOne = ToVec3(this->Point1) - ToVec3(this->Origin);
  const Vec3 sideTwo = ToVec3(this->Point2) - ToVec3(this->Origin);
  const double lengthOne = lumitree::length(sideOne);
  const double lengthTwo = lumitree::length(sideTwo);
  Vec3 normal = lumitree::cross(sideOne, sideTwo);
  const double area = lumitree::length(normal);
  if (!lumitree::isFinite(normal) || !(area > 0.0) || !(this->Margin >= 0.0) ||
    !(this->Spacing >= 0.0) || !std::isfinite(this->Spacing))
  {
    vtkErrorMacro("The corners must be finite and span an area, Margin and Spacing must not be "
                  "negative.");
    return 1;
  }
  normal = ((this->Flip ? -1.0 : 1.0) / area) * normal;
  // The margin is measured across the sides.
  const double marginOne = this->Margin * lengthTwo / area;
  const double marginTwo = this->Margin * lengthOne / area;
  const double shareOne = 1.0 - 2.0 * marginOne;
  const double shareTwo = 1.0 - 2.0 * marginTwo;
  if (!(shareOne > 0.0) || !(shareTwo > 0.0))
  {
    vtkErrorMacro("Margin leaves no room for sensors.");
    return 1;
  }
  const double metres = lumitree::filters::metresPerUnit(this->LengthUnit);
  const double spacing = this->Spacing > 0.0
    ? this->Spacing
    : StandardSpacing(shareOne * lengthOne * metres, shareTwo * lengthTwo * metres) / metres;
  const double wantedOne = std::ceil(shareOne * lengthOne / spacing * (1.0 - 1e-12));
  const double wantedTwo = std::ceil(shareTwo * lengthTwo / spacing * (1.0 - 1e-12));
  if (!(wantedOne * wantedTwo <= 1e8))
  {
    vtkErrorMacro("The grid would have more than 10^8 sensors.");
    return 1;
  }
  const auto countOne = static_cast<vtkIdType>(std::max(1.0, wantedOne));
  const auto countTwo = static_cast<vtkIdType>(std::max(1.0, wantedTwo));
  const vtkIdType first = countTwo * piece / pieces;
  const vtkIdType last = countTwo * (piece + 1) / pieces;
  const vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const vtkNew<vtkCellArray> cells;
  const vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  const Vec3 corner = ToVec3(this->Origin) + marginOne * sideOne + marginTwo * sideTwo;
  for (vtkIdType j = first; first < last && j <= last; ++j)
  {
    for (vtkIdType i = 0; i <= countOne; ++i)
    {
      const double u = shareOne * static_cast<double>(i) / static_cast<double>(countOne);
      const double v = shareTwo * static_cast<double>(j) / static_cast<double>(countTwo);
      const Vec3 p = corner + u * sideOne + v * sideTwo;
      points->InsertNextPoint(p.data());
    }
  }
  for (vtkIdType j = 0; j < last - first; ++j)
  {
    for (vtkIdType i = 0; i < countOne; ++i)
    {
      const vtkIdType a = j * (countOne + 1) + i;
      const vtkIdType b = a + countOne + 1;
      if (this->Flip)
      {
        cells->InsertNextCell({ a, b, b + 1, a + 1 });
      }
      else
      {
        cells->InsertNextCell({ a, a + 1, b + 1, b });
      }
      normals->InsertNextTuple(normal.data());
    }
  }
  output->SetPoints(points);
  output->SetPolys(cells);
  output->GetCellData()->SetNormals(normals);
  return 1;
}

void vtkLumiSensorGrid::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto triple = [&](const char* name, const double* v)
  { os << indent << name << ": (" << v[0] << ", " << v[1] << ", " << v[2] << ")\n"; };
  triple("Origin", this->Origin);
  triple("Point1", this->Point1);
  triple("Point2", this->Point2);
  os << indent << "Margin: " << this->Margin << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "Flip: " << (this->Flip ? "on" : "off") << "\n";
  os << indent << "LengthUnit: " << lumitree::filters::lengthUnitName(this->LengthUnit) << "\n";
}
