// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiCellOrder.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>

namespace lumitree::filters
{
namespace
{

/// The cell ids of a vtkPolyData that was filled with InsertNextCell are in the order of insertion
/// and not vertices, lines, polygons, strips. Only a polydata of several kinds can differ. Empty
/// when it does not.
std::vector<vtkIdType> idsByInsertion(vtkPolyData* data)
{
  const vtkIdType polys = data->GetNumberOfPolys();
  const vtkIdType strips = data->GetNumberOfStrips();
  const vtkIdType total = data->GetNumberOfCells();
  if (data->NeedToBuildCells() || polys == total || strips == total)
  {
    return {};
  }
  std::vector<vtkIdType> ofPolys;
  std::vector<vtkIdType> ofStrips;
  for (vtkIdType id = 0; id < total; ++id)
  {
    switch (data->GetCellType(id))
    {
      case VTK_TRIANGLE:
      case VTK_QUAD:
      case VTK_POLYGON:
        ofPolys.push_back(id);
        break;
      case VTK_TRIANGLE_STRIP:
        ofStrips.push_back(id);
        break;
      default:
        break;
    }
  }
  if (static_cast<vtkIdType>(ofPolys.size()) != polys ||
    static_cast<vtkIdType>(ofStrips.size()) != strips)
  {
    return {}; // cells were deleted, or polygons have less than three points: the usual order holds
  }
  ofPolys.insert(ofPolys.end(), ofStrips.begin(), ofStrips.end());
  return ofPolys;
}

/// The points of a face by their ids in the leaf, for comparison.
std::vector<vtkIdType> faceKey(const ExtractedSurface& surface, const PolygonCell& cell)
{
  vtkNew<vtkIdList> ids;
  vtkPolyData* data = surface.polygons;
  (cell.strip ? data->GetStrips() : data->GetPolys())->GetCellAtId(cell.index, ids);
  std::vector<vtkIdType> key(ids->begin(), ids->end());
  if (surface.pointIds)
  {
    for (vtkIdType& id : key)
    {
      id = surface.pointIds->GetValue(id);
    }
  }
  return key;
}

} // namespace

std::vector<PolygonCell> polygonsInOrder(
  const ExtractedSurface& surface, const CellSelection& selection)
{
  vtkPolyData* data = surface.polygons;
  const vtkIdType polys = data->GetNumberOfPolys();
  const vtkIdType strips = data->GetNumberOfStrips();
  const vtkIdType before = data->GetNumberOfVerts() + data->GetNumberOfLines();
  const std::vector<vtkIdType> inserted = idsByInsertion(data);

  std::vector<PolygonCell> cells;
  cells.reserve(static_cast<std::size_t>(polys + strips));
  for (vtkIdType i = 0; i < polys + strips; ++i)
  {
    PolygonCell cell;
    cell.strip = i >= polys;
    cell.index = cell.strip ? i - polys : i;
    const vtkIdType own = inserted.empty() ? before + i : inserted[static_cast<std::size_t>(i)];
    cell.cell = surface.cellIds ? surface.cellIds->GetValue(own) : own;
    if (selection[cell.cell] == CellState::Occludes)
    {
      cells.push_back(cell);
    }
  }

  const auto byCell = [](const PolygonCell& a, const PolygonCell& b) { return a.cell < b.cell; };
  if (!std::is_sorted(cells.begin(), cells.end(), byCell))
  {
    std::stable_sort(cells.begin(), cells.end(), byCell);
  }
  if (surface.cellIds)
  {
    for (auto first = cells.begin(); first != cells.end();)
    {
      const auto last = std::upper_bound(first, cells.end(), *first, byCell);
      if (last - first > 1)
      {
        std::stable_sort(first, last,
          [&](const PolygonCell& a, const PolygonCell& b)
          { return faceKey(surface, a) < faceKey(surface, b); });
      }
      first = last;
    }
  }
  return cells;
}

} // namespace lumitree::filters
