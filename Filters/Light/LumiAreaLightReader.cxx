// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiAreaLightReader.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include "Radiometry/Constants.h"
#include "Radiometry/PolygonSource.h"
#include "Radiometry/PolygonTriangles.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace lumitree::filters
{

namespace
{

// Farther from its plane than this share of its size a polygon is not flat; coordinates stored as
// float are off by less.
constexpr double flatness = 1e-6;

struct Part
{
  vtkIdType cell;
  EmittingPolygon polygon;
};

void addPolygon(vtkIdType cell, std::vector<Vec3> corners, std::vector<Part>& parts)
{
  if (corners.size() < 3)
  {
    return;
  }
  const Vec3 area = polygonAreaVector(corners);
  const double size = length(area);
  double bulge = 0.0;
  for (const Vec3& corner : corners)
  {
    bulge = std::max(bulge, std::fabs(dot(area, corner - corners[0])));
  }
  if (corners.size() == 3 || !(bulge > flatness * size * std::sqrt(size)))
  {
    parts.push_back({ cell, { std::move(corners), {}, 0.0, false } });
    return;
  }
  for (const auto& t : triangulatePolygon(corners))
  {
    parts.push_back({ cell, { { corners[t[0]], corners[t[1]], corners[t[2]] }, {}, 0.0, false } });
  }
}

std::vector<Part> partsOf(vtkPolyData* data)
{
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    data->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  constexpr int left = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  std::vector<Part> parts;
  const vtkNew<vtkIdList> ids;
  const auto corner = [&](vtkIdType k)
  {
    Vec3 point;
    data->GetPoint(ids->GetId(k), point.data());
    if (!isFinite(point))
    {
      throw std::runtime_error("a corner of its polygons is not finite");
    }
    return point;
  };
  vtkIdType cell = data->GetNumberOfVerts() + data->GetNumberOfLines();
  for (vtkIdType i = 0; i < data->GetNumberOfPolys(); ++i, ++cell)
  {
    if (ghosts && (ghosts->GetValue(cell) & left))
    {
      continue;
    }
    data->GetPolys()->GetCellAtId(i, ids);
    std::vector<Vec3> corners;
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      corners.push_back(corner(k));
    }
    addPolygon(cell, std::move(corners), parts);
  }
  for (vtkIdType i = 0; i < data->GetNumberOfStrips(); ++i, ++cell)
  {
    if (ghosts && (ghosts->GetValue(cell) & left))
    {
      continue;
    }
    data->GetStrips()->GetCellAtId(i, ids);
    for (vtkIdType k = 0; k + 2 < ids->GetNumberOfIds(); ++k)
    {
      const vtkIdType turned = k % 2;
      addPolygon(cell, { corner(k), corner(k + 1 + turned), corner(k + 2 - turned) }, parts);
    }
  }
  return parts;
}

} // namespace

std::unique_ptr<const Source> readAreaLight(const LightFields& fields, double factor)
{
  const bool twoSided = fields.flag("LightTwoSided");
  const double sides = twoSided ? 2.0 : 1.0;
  const double metres = fields.metresPerUnit();
  std::vector<Part> parts = partsOf(fields.data());
  if (parts.empty())
  {
    throw std::runtime_error("an area light needs polygons");
  }
  const auto areaOf = [&](const Part& part)
  { return length(polygonAreaVector(part.polygon.corners)) * metres * metres; };
  vtkCellData* cellData = fields.data()->GetCellData();
  vtkDataArray* values = nullptr;
  Quantity quantity = Quantity::Radiance;
  for (const Quantity candidate : { Quantity::Radiance, Quantity::Exitance, Quantity::Flux })
  {
    if (vtkDataArray* array = cellData->GetArray(arrayName(candidate, fields.system()).c_str()))
    {
      values = array;
      quantity = candidate;
    }
  }
  if (!values)
  {
    double area = 0.0;
    for (const Part& part : parts)
    {
      area += sides * areaOf(part);
    }
    const double radiance = fields.radiance(area);
    for (Part& part : parts)
    {
      part.polygon.radiance = radiance;
    }
  }
  else
  {
    if (values->GetNumberOfComponents() != 1)
    {
      throw std::runtime_error(
        "its cell array \"" + std::string(values->GetName()) + "\" must have one component");
    }
    // The parts of a cell share its flux.
    std::vector<double> areas(static_cast<std::size_t>(fields.data()->GetNumberOfCells()), 0.0);
    for (const Part& part : parts)
    {
      areas[static_cast<std::size_t>(part.cell)] += areaOf(part);
    }
    for (Part& part : parts)
    {
      const double value = values->GetComponent(part.cell, 0);
      if (!(value >= 0.0) || !std::isfinite(value))
      {
        std::ostringstream message;
        message << "its \"" << values->GetName() << "\" is " << value << " in cell " << part.cell
                << ", but must be finite and not negative";
        throw std::runtime_error(message.str());
      }
      const double area = areas[static_cast<std::size_t>(part.cell)];
      const double share = quantity == Quantity::Radiance
        ? 1.0
        : (quantity == Quantity::Exitance ? 1.0 / pi : 1.0 / (pi * sides * area));
      part.polygon.radiance = area > 0.0 ? factor * value * share : 0.0;
    }
  }
  std::vector<EmittingPolygon> polygons;
  polygons.reserve(parts.size());
  for (Part& part : parts)
  {
    part.polygon.twoSided = twoSided;
    polygons.push_back(std::move(part.polygon));
  }
  return std::make_unique<PolygonSource>(std::move(polygons), metres);
}

} // namespace lumitree::filters
