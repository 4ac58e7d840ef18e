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

/// Points that were made carry an interpolated number, which is none of theirs: they get −1.
void forgetMadePoints(vtkDataSet* data, vtkPolyData* polygons, vtkIdTypeArray* pointIds)
{
  for (vtkIdType i = 0; i < polygons->GetNumberOfPoints(); ++i)
  {
    const vtkIdType id = pointIds->GetValue(i);
    double surface[3];
    double original[3] = { 0.0, 0.0, 0.0 };
    polygons->GetPoint(i, surface);
    const bool exists = id >= 0 && id < data->GetNumberOfPoints();
    if (exists)
    {
      data->GetPoint(id, original);
    }
    // A point that is not a number is not equal to itself, and is no made one either: keep it.
    const auto matches = [](double a, double b) { return a == b || std::isnan(a); };
    if (!exists || !std::equal(surface, surface + 3, original, matches))
    {
      pointIds->SetValue(i, -1);
    }
  }
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
  forgetMadePoints(data, result.polygons, result.pointIds);
  return result;
}

} // namespace lumitree::filters
