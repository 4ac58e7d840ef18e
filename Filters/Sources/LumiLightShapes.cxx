// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiLightShapes.h"

#include "LumiDirections.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include "Radiometry/Constants.h"
#include "Radiometry/Frame.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lumitree::filters
{

namespace
{

constexpr int aroundCount = 48;
constexpr int alongCount = 36;

vtkPoints* newPoints(vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  output->SetPoints(points);
  return points;
}

/// Quads between rows of aroundCount points, from first on; each row closed.
vtkNew<vtkCellArray> gridCells(vtkIdType first, int rows)
{
  vtkNew<vtkCellArray> cells;
  for (int r = 0; r + 1 < rows; ++r)
  {
    for (int a = 0; a < aroundCount; ++a)
    {
      const vtkIdType b = (a + 1) % aroundCount;
      const vtkIdType row = first + r * aroundCount;
      cells->InsertNextCell({ row + a, row + aroundCount + a, row + aroundCount + b, row + b });
    }
  }
  return cells;
}

Vec3 circle(const Frame& frame, int step)
{
  const double phi = 2.0 * pi * step / aroundCount;
  return std::cos(phi) * frame.x + std::sin(phi) * frame.y;
}

/// Over the sphere around the frame's z from polar angle 0 to the last one.
template <class Function>
void grid(const Frame& frame, int rows, double last, const Function& add)
{
  for (int r = 0; r < rows; ++r)
  {
    const double theta = last * r / (rows - 1);
    for (int a = 0; a < aroundCount; ++a)
    {
      add(std::cos(theta) * frame.z + std::sin(theta) * circle(frame, a));
    }
  }
}

} // namespace

bool isFinite3(const double* values)
{
  return std::all_of(values, values + 3, [](double x) { return std::isfinite(x); });
}

void drawRay(vtkPolyData* output, const Vec3& end, const Vec3& direction, double length)
{
  drawLine(output, end - length * direction, end);
}

void drawLine(vtkPolyData* output, const Vec3& begin, const Vec3& end)
{
  vtkPoints* points = newPoints(output);
  points->InsertNextPoint(begin.data());
  points->InsertNextPoint(end.data());
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  output->SetLines(lines);
}

void drawPoint(vtkPolyData* output, const Vec3& position)
{
  newPoints(output)->InsertNextPoint(position.data());
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  output->SetVerts(vertices);
}

void drawIntensities(vtkPolyData* output, const Source& source, const Vec3& position,
  const Vec3& axis, double size, const char* arrayName)
{
  drawPoint(output, position);
  if (!(size > 0.0))
  {
    return;
  }
  constexpr int rows = 2 * alongCount + 1;
  const Frame frame = Frame::around(unit(axis));
  vtkNew<vtkDoubleArray> values;
  values->SetName(arrayName);
  std::vector<Vec3> directions;
  double largest = 0.0;
  grid(frame, rows, pi,
    [&](const Vec3& direction)
    {
      directions.push_back(direction);
      largest = std::max(largest, source.intensity(direction).value_or(0.0));
    });
  values->InsertNextValue(source.intensity(axis).value_or(0.0));
  for (const Vec3& direction : directions)
  {
    const double value = source.intensity(direction).value_or(0.0);
    values->InsertNextValue(value);
    const double reach = largest > 0.0 ? size * value / largest : 0.0;
    output->GetPoints()->InsertNextPoint((position + reach * direction).data());
  }
  output->SetPolys(gridCells(1, rows));
  output->GetPointData()->SetScalars(values);
}

void drawSphere(vtkPolyData* output, const Vec3& centre, double radius)
{
  vtkPoints* points = newPoints(output);
  grid(Frame::around({ 0.0, 0.0, 1.0 }), alongCount, pi,
    [&](const Vec3& direction) { points->InsertNextPoint((centre + radius * direction).data()); });
  output->SetPolys(gridCells(0, alongCount));
}

void drawDisk(vtkPolyData* output, const Vec3& centre, const Vec3& normal, double radius)
{
  vtkPoints* points = newPoints(output);
  const Frame frame = Frame::around(unit(normal));
  vtkNew<vtkCellArray> polygon;
  polygon->InsertNextCell(aroundCount);
  for (int a = 0; a < aroundCount; ++a)
  {
    polygon->InsertCellPoint(points->InsertNextPoint((centre + radius * circle(frame, a)).data()));
  }
  output->SetPolys(polygon);
}

void drawTube(vtkPolyData* output, const Vec3& begin, const Vec3& end, double radius)
{
  vtkPoints* points = newPoints(output);
  const Frame frame = Frame::around(unit(end - begin));
  for (const Vec3& foot : { end, begin })
  {
    for (int a = 0; a < aroundCount; ++a)
    {
      points->InsertNextPoint((foot + radius * circle(frame, a)).data());
    }
  }
  output->SetPolys(gridCells(0, 2));
}

void drawQuad(vtkPolyData* output, const Vec3& origin, const Vec3& point1, const Vec3& point2)
{
  vtkPoints* points = newPoints(output);
  for (const Vec3& corner : { origin, point1, point1 + point2 - origin, point2 })
  {
    points->InsertNextPoint(corner.data());
  }
  vtkNew<vtkCellArray> polygon;
  polygon->InsertNextCell({ 0, 1, 2, 3 });
  output->SetPolys(polygon);
}

void drawSky(vtkPolyData* output, const Source& sky, const Vec3& up, const Vec3& anchor,
  double radius, const char* arrayName)
{
  vtkPoints* points = newPoints(output);
  vtkNew<vtkDoubleArray> values;
  values->SetName(arrayName);
  // A little above the horizon, so that it is the sky's radiance down there, too.
  grid(Frame::around(unit(up)), alongCount, 0.5 * pi - 1e-6,
    [&](const Vec3& direction)
    {
      points->InsertNextPoint((anchor + radius * direction).data());
      values->InsertNextValue(sky.radiance(anchor, direction).value_or(0.0));
    });
  output->SetPolys(gridCells(0, alongCount));
  output->GetPointData()->SetScalars(values);
}

} // namespace lumitree::filters
