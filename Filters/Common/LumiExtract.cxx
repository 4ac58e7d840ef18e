// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiExtract.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkExplicitStructuredGrid.h"
#include "vtkExtractCells.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace lumitree::filters
{
namespace
{

constexpr const char* cellIdsName = "LumitreeCellIds";
constexpr const char* pointIdsName = "LumitreePointIds";

vtkSmartPointer<vtkIdTypeArray> countUp(vtkIdType n, const char* name)
{
  auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
  ids->SetName(name);
  ids->SetNumberOfValues(n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    ids->SetValue(i, i);
  }
  return ids;
}

/// The dataset without its arrays, with the numbers of its cells and points in their place. VTK's
/// surface filters treat ghosts differently from version to version (the newer ones leave a hole
/// where a hidden cell was), so they get to see none; and the ids that they offer to pass on are
/// wrong for nonlinear cells.
vtkSmartPointer<vtkDataSet> numbered(vtkDataSet* data)
{
  auto copy = vtkSmartPointer<vtkDataSet>::Take(data->NewInstance());
  copy->CopyStructure(data);
  copy->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  copy->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  copy->GetPointData()->AddArray(countUp(copy->GetNumberOfPoints(), pointIdsName));
  copy->GetCellData()->AddArray(countUp(copy->GetNumberOfCells(), cellIdsName));
  return copy;
}

/// The cells that are not hidden, as an unstructured grid.
vtkSmartPointer<vtkDataSet> withoutHidden(vtkDataSet* data, const CellSelection& selection)
{
  vtkNew<vtkIdList> kept;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    if (selection[i] != CellState::Hidden)
    {
      kept->InsertNextId(i);
    }
  }
  vtkNew<vtkExtractCells> extract;
  extract->SetInputData(data);
  extract->SetCellList(kept);
  extract->Update();
  return extract->GetOutput();
}

/// Gives the points of the surface the coordinates that they have in the dataset, and their ids: of
/// images VTK makes them floats, which would move the surface. Points that were made (inside
/// nonlinear faces) carry an interpolated number, which is the id of another point: they get −1 and
/// stay where they are.
void restorePoints(vtkDataSet* data, vtkPolyData* polygons, vtkIdTypeArray* pointIds)
{
  vtkNew<vtkPoints> points;
  const int type = vtkPointSet::SafeDownCast(data)
    ? vtkPointSet::SafeDownCast(data)->GetPoints()->GetDataType()
    : VTK_DOUBLE;
  points->SetDataType(type == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE);
  points->SetNumberOfPoints(polygons->GetNumberOfPoints());
  const auto matches = [](double a, double b)
  { return static_cast<float>(a) == static_cast<float>(b) || std::isnan(a); };
  for (vtkIdType i = 0; i < polygons->GetNumberOfPoints(); ++i)
  {
    double made[3];
    double original[3] = { 0.0, 0.0, 0.0 };
    polygons->GetPoint(i, made);
    const vtkIdType id = pointIds->GetValue(i);
    const bool exists = id >= 0 && id < data->GetNumberOfPoints();
    if (exists)
    {
      data->GetPoint(id, original);
    }
    const bool same = exists && std::equal(made, made + 3, original, matches);
    points->SetPoint(i, same ? original : made);
    pointIds->SetValue(i, same ? id : -1);
  }
  polygons->SetPoints(points);
}

} // namespace

ExtractedSurface extractSurface(vtkDataSet* data, const CellSelection& selection)
{
  ExtractedSurface result;
  result.polygons = vtkPolyData::SafeDownCast(data);
  if (result.polygons)
  {
    return result;
  }

  vtkSmartPointer<vtkDataSet> visible = numbered(data);
  // VTK's surface filter knows no explicit structured grids: it would give inner faces as well.
  if (selection.hidden > 0 || vtkExplicitStructuredGrid::SafeDownCast(data))
  {
    visible = withoutHidden(visible, selection);
  }
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(visible);
  surface->Update();
  result.polygons = surface->GetOutput();
  if (result.polygons->GetNumberOfCells() == 0)
  {
    return result;
  }

  result.cellIds =
    vtkIdTypeArray::SafeDownCast(result.polygons->GetCellData()->GetArray(cellIdsName));
  result.pointIds =
    vtkIdTypeArray::SafeDownCast(result.polygons->GetPointData()->GetArray(pointIdsName));
  if (!result.cellIds ||
    result.cellIds->GetNumberOfValues() != result.polygons->GetNumberOfCells() ||
    !result.pointIds ||
    result.pointIds->GetNumberOfValues() != result.polygons->GetNumberOfPoints())
  {
    throw std::runtime_error(std::string("VTK does not say which cells the surface of a ") +
      data->GetClassName() + " is of");
  }
  restorePoints(data, result.polygons, result.pointIds);
  return result;
}

} // namespace lumitree::filters
