// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiSurfaceReportOutput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <string>
#include <utility>

namespace lumitree::filters
{
namespace
{

template <class Array>
vtkSmartPointer<Array> arrayOf(const char* name, std::size_t tuples)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  return array;
}

template <class Array>
void addColumn(vtkTable* table, const char* name, const typename Array::ValueType& value)
{
  vtkNew<Array> column;
  column->SetName(name);
  column->InsertNextValue(value);
  table->AddColumn(column);
}

void addString(vtkTable* table, const char* name, const std::string& value)
{
  vtkNew<vtkStringArray> column;
  column->SetName(name);
  column->InsertNextValue(value);
  table->AddColumn(column);
}

vtkSmartPointer<vtkPoints> newPoints(const Surface& surface)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(surface.scalar() == ArrayView::Scalar::Double ? VTK_DOUBLE : VTK_FLOAT);
  return points;
}

std::string verdict(const SurfaceCheck& check)
{
  if (check.points == 0)
  {
    return "there is no surface";
  }
  std::string text = check.closed ? "closed" : "not closed";
  text += check.manifold ? ", manifold" : ", not manifold";
  text += check.consistent ? ", wound alike"
    : check.orientable     ? ", not wound alike"
                           : ", not orientable";
  if (check.volume < 0)
  {
    text += ", inside out";
  }
  text += check.closed ? "; rays do not leak" : "; rays pass through its holes";
  text += check.closed && check.even ? "; inside and outside are defined"
                                     : "; inside and outside are not defined";
  return text;
}

} // namespace

void makeSurfaceOutput(const Surface& surface, const SurfaceCheck& check, vtkPolyData* output)
{
  const auto points = newPoints(surface);
  points->SetNumberOfPoints(static_cast<vtkIdType>(surface.pointCount()));
  const auto boundary = arrayOf<vtkUnsignedCharArray>("Boundary", surface.pointCount());
  const auto nonManifold = arrayOf<vtkUnsignedCharArray>("NonManifold", surface.pointCount());
  for (std::size_t i = 0; i < surface.pointCount(); ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    points->SetPoint(id, surface.point(i).data());
    boundary->SetValue(id, check.boundary[i]);
    nonManifold->SetValue(id, check.nonManifold[i]);
  }
  const std::size_t count = check.defects.size();
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(static_cast<vtkIdType>(count), static_cast<vtkIdType>(3 * count));
  const auto cellIds = arrayOf<vtkIdTypeArray>("CellId", count);
  const auto composites = arrayOf<vtkIntArray>("CompositeIndex", count);
  const auto components = arrayOf<vtkIdTypeArray>("Component", count);
  const auto defects = arrayOf<vtkIntArray>("Defect", count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    const Triangle& t = surface.triangle(static_cast<PrimitiveId>(i));
    cells->InsertNextCell({ t[0], t[1], t[2] });
    const SourceCell source = surface.source(static_cast<PrimitiveId>(i));
    cellIds->SetValue(id, source.cell);
    composites->SetValue(id, static_cast<int>(source.composite));
    components->SetValue(id, check.components[i]);
    defects->SetValue(id, static_cast<int>(check.defects[i]));
  }
  output->SetPoints(points);
  output->SetPolys(cells);
  output->GetPointData()->AddArray(boundary);
  output->GetPointData()->AddArray(nonManifold);
  output->GetCellData()->AddArray(cellIds);
  output->GetCellData()->AddArray(composites);
  output->GetCellData()->AddArray(components);
  output->GetCellData()->SetScalars(defects);
}

void makeEdgesOutput(const Surface& surface, const SurfaceCheck& check, vtkPolyData* output)
{
  const auto points = newPoints(surface);
  std::vector<vtkIdType> place(surface.pointCount(), -1);
  vtkNew<vtkCellArray> lines;
  const auto kinds = arrayOf<vtkIntArray>("Kind", check.lines.size());
  const auto faces = arrayOf<vtkIdTypeArray>("Faces", check.lines.size());
  const auto closed = arrayOf<vtkUnsignedCharArray>("Closed", check.lines.size());
  for (std::size_t i = 0; i < check.lines.size(); ++i)
  {
    const EdgeLine& line = check.lines[i];
    lines->InsertNextCell(static_cast<int>(line.points.size()));
    for (const std::uint32_t point : line.points)
    {
      if (place[point] < 0)
      {
        place[point] = points->InsertNextPoint(surface.point(point).data());
      }
      lines->InsertCellPoint(place[point]);
    }
    const auto id = static_cast<vtkIdType>(i);
    kinds->SetValue(id, static_cast<int>(line.kind));
    faces->SetValue(id, line.faces);
    closed->SetValue(id, line.points.front() == line.points.back() ? 1 : 0);
  }
  output->SetPoints(points);
  output->SetLines(lines);
  output->GetCellData()->AddArray(faces);
  output->GetCellData()->AddArray(closed);
  output->GetCellData()->SetScalars(kinds);
}

void makeReportTable(const Surface& surface, const SurfaceCheck& check, vtkTable* table)
{
  const auto number = [&](const char* name, std::uint64_t value)
  { addColumn<vtkIdTypeArray>(table, name, static_cast<vtkIdType>(value)); };
  const auto flag = [&](const char* name, bool value)
  { addColumn<vtkUnsignedCharArray>(table, name, value ? 1 : 0); };
  addString(table, "Verdict", verdict(check));
  flag("Closed", check.closed);
  flag("Manifold", check.manifold);
  flag("ConsistentlyOriented", check.consistent);
  flag("Orientable", check.orientable);
  flag("WatertightApplies", check.closed);
  flag("InsideOutsideApplies", check.closed && check.even);
  number("Triangles", surface.triangleCount());
  number("Points", check.points);
  number("MergedPoints", check.mergedPoints);
  number("Edges", check.edges);
  number("Components", check.componentCount);
  addColumn<vtkIdTypeArray>(
    table, "EulerCharacteristic", static_cast<vtkIdType>(check.eulerCharacteristic));
  number("BoundaryEdges", check.boundaryEdges);
  number("BoundaryLoops", check.boundaryLoops);
  number("NonManifoldEdges", check.nonManifoldEdges);
  number("NonManifoldPoints", check.nonManifoldPoints);
  number("InconsistentEdges", check.inconsistentEdges);
  for (const auto& [name, defect] : { std::pair("NonFinite", Defect::NonFinite),
         std::pair("Degenerate", Defect::Degenerate), std::pair("Duplicate", Defect::Duplicate),
         std::pair("Refused", Defect::Refused), std::pair("Flipped", Defect::Flipped) })
  {
    number(name, check.counts[static_cast<int>(defect)]);
  }
  addColumn<vtkDoubleArray>(table, "Area", check.area);
  addColumn<vtkDoubleArray>(table, "Volume", check.volume);
}

} // namespace lumitree::filters
