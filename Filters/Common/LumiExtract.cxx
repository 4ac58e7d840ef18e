// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiExtract.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkExtractCells.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

namespace lumitree::filters
{
namespace
{

constexpr const char* cellIdsName = "LumitreeCellIds";
constexpr const char* pointIdsName = "LumitreePointIds";

constexpr unsigned char hiddenBits =
  vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;

bool anyBit(vtkUnsignedCharArray* ghosts, unsigned char bits)
{
  bool any = false;
  for (vtkIdType i = 0; ghosts && i < ghosts->GetNumberOfTuples() && !any; ++i)
  {
    any = (ghosts->GetValue(i) & bits) != 0;
  }
  return any;
}

/// A ghost array that does not fit its dataset says nothing.
vtkUnsignedCharArray* ofLength(vtkUnsignedCharArray* ghosts, vtkIdType length)
{
  return ghosts && ghosts->GetNumberOfValues() == length ? ghosts : nullptr;
}

bool usesHiddenPoint(vtkIdList* points, vtkUnsignedCharArray* pointGhosts)
{
  for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
  {
    if (pointGhosts->GetValue(points->GetId(i)) & vtkDataSetAttributes::HIDDENPOINT)
    {
      return true;
    }
  }
  return false;
}

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

/// The dataset without arrays. VTK's surface filters treat ghosts differently from version to
/// version (the newer ones leave a hole where a hidden cell was), so they get to see none.
vtkSmartPointer<vtkDataSet> bareCopy(vtkDataSet* data)
{
  auto bare = vtkSmartPointer<vtkDataSet>::Take(data->NewInstance());
  bare->CopyStructure(data);
  bare->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  bare->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  return bare;
}

/// The cells that are not hidden, with the ids they had.
vtkSmartPointer<vtkDataSet> withoutHidden(vtkDataSet* data, const CellSelection& selection)
{
  vtkSmartPointer<vtkDataSet> bare = bareCopy(data);
  bare->GetCellData()->AddArray(countUp(bare->GetNumberOfCells(), cellIdsName));
  bare->GetPointData()->AddArray(countUp(bare->GetNumberOfPoints(), pointIdsName));
  vtkNew<vtkIdList> list;
  for (vtkIdType i = 0; i < bare->GetNumberOfCells(); ++i)
  {
    if (selection[i] != CellState::Hidden)
    {
      list->InsertNextId(i);
    }
  }
  vtkNew<vtkExtractCells> extract;
  extract->SetInputData(bare);
  extract->SetCellList(list);
  extract->Update();
  return extract->GetOutput();
}

/// ids[outer[i]], where each list may be absent (the identity) and −1 stays.
vtkSmartPointer<vtkIdTypeArray> compose(vtkIdTypeArray* outer, vtkIdTypeArray* ids)
{
  auto result = vtkSmartPointer<vtkIdTypeArray>::New();
  result->SetNumberOfValues(outer->GetNumberOfTuples());
  for (vtkIdType i = 0; i < outer->GetNumberOfTuples(); ++i)
  {
    const vtkIdType id = outer->GetValue(i);
    result->SetValue(i, ids && id >= 0 ? ids->GetValue(id) : id);
  }
  return result;
}

} // namespace

CellSelection selectCells(vtkDataSet* data)
{
  CellSelection selection;
  vtkUnsignedCharArray* cellGhosts = ofLength(data->GetCellGhostArray(), data->GetNumberOfCells());
  vtkUnsignedCharArray* pointGhosts =
    ofLength(data->GetPointGhostArray(), data->GetNumberOfPoints());
  if (!anyBit(pointGhosts, vtkDataSetAttributes::HIDDENPOINT))
  {
    pointGhosts = nullptr;
  }
  if (!pointGhosts && !anyBit(cellGhosts, hiddenBits | vtkDataSetAttributes::DUPLICATECELL))
  {
    return selection;
  }
  const vtkIdType cells = data->GetNumberOfCells();
  selection.states.resize(static_cast<std::size_t>(cells), CellState::Occludes);
  vtkNew<vtkIdList> points;
  for (vtkIdType i = 0; i < cells; ++i)
  {
    const unsigned char ghost = cellGhosts ? cellGhosts->GetValue(i) : 0;
    bool hidden = (ghost & hiddenBits) != 0;
    if (!hidden && pointGhosts)
    {
      data->GetCellPoints(i, points);
      hidden = usesHiddenPoint(points, pointGhosts);
    }
    if (hidden)
    {
      selection.states[static_cast<std::size_t>(i)] = CellState::Hidden;
      ++selection.hidden;
    }
    else if (ghost & vtkDataSetAttributes::DUPLICATECELL)
    {
      selection.states[static_cast<std::size_t>(i)] = CellState::Duplicate;
      ++selection.duplicate;
    }
  }
  return selection;
}

ExtractedSurface extractSurface(vtkDataSet* data, const CellSelection& selection)
{
  ExtractedSurface result;
  result.polygons = vtkPolyData::SafeDownCast(data);
  if (result.polygons)
  {
    return result;
  }

  vtkSmartPointer<vtkDataSet> visible = bareCopy(data);
  vtkSmartPointer<vtkIdTypeArray> cellIds;
  vtkSmartPointer<vtkIdTypeArray> pointIds;
  if (selection.hidden > 0)
  {
    visible = withoutHidden(data, selection);
    cellIds = vtkIdTypeArray::SafeDownCast(visible->GetCellData()->GetArray(cellIdsName));
    pointIds = vtkIdTypeArray::SafeDownCast(visible->GetPointData()->GetArray(pointIdsName));
    visible->GetCellData()->Initialize();
    visible->GetPointData()->Initialize();
  }

  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(visible);
  surface->PassThroughCellIdsOn();
  surface->PassThroughPointIdsOn();
  surface->Update();
  result.polygons = surface->GetOutput();
  auto* outerCells = vtkIdTypeArray::SafeDownCast(
    result.polygons->GetCellData()->GetArray(surface->GetOriginalCellIdsName()));
  auto* outerPoints = vtkIdTypeArray::SafeDownCast(
    result.polygons->GetPointData()->GetArray(surface->GetOriginalPointIdsName()));
  if (outerCells && outerPoints)
  {
    result.cellIds = compose(outerCells, cellIds);
    result.pointIds = compose(outerPoints, pointIds);
  }
  return result;
}

} // namespace lumitree::filters
