// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiRaysOutput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

namespace lumitree::filters
{

namespace
{

/// Whether the dataset's cells are the segments, one each.
bool cellsAreSegments(vtkDataSet* input, const RayInput& rays)
{
  if (input->GetNumberOfCells() != rays.size)
  {
    return false;
  }
  for (vtkIdType i = 0; i < rays.size; ++i)
  {
    if (rays.segmentCells[static_cast<std::size_t>(i)] != i)
    {
      return false;
    }
  }
  return true;
}

vtkSmartPointer<vtkCellArray> segmentCells(const RayInput& rays)
{
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> connectivity;
  offsets->SetNumberOfValues(rays.size + 1);
  connectivity->SetNumberOfValues(2 * rays.size);
  for (vtkIdType i = 0; i < rays.size; ++i)
  {
    const auto& ends = rays.segmentPoints[static_cast<std::size_t>(i)];
    offsets->SetValue(i, 2 * i);
    connectivity->SetValue(2 * i, ends[0]);
    connectivity->SetValue(2 * i + 1, ends[1]);
  }
  offsets->SetValue(rays.size, 2 * rays.size);
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, connectivity);
  return cells;
}

/// The segments as line cells over the input's own points.
void splitIntoSegments(vtkPointSet* input, const RayInput& rays, vtkPointSet* output)
{
  output->SetPoints(input->GetPoints());
  output->GetPointData()->PassData(input->GetPointData());
  output->GetFieldData()->PassData(input->GetFieldData());
  const vtkSmartPointer<vtkCellArray> cells = segmentCells(rays);
  if (auto* lines = vtkPolyData::SafeDownCast(output))
  {
    lines->SetLines(cells);
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(output))
  {
    grid->SetCells(VTK_LINE, cells);
  }

  output->GetCellData()->CopyAllocate(input->GetCellData(), rays.size);
  for (vtkIdType i = 0; i < rays.size; ++i)
  {
    output->GetCellData()->CopyData(
      input->GetCellData(), rays.segmentCells[static_cast<std::size_t>(i)], i);
  }
}

} // namespace

vtkDataSetAttributes* makeRaysOutput(vtkDataSet* input, const RayInput& rays, vtkDataSet* output)
{
  if (!rays.perCell)
  {
    output->ShallowCopy(input);
    return output->GetPointData();
  }
  const bool canSplit =
    vtkPolyData::SafeDownCast(input) || vtkUnstructuredGrid::SafeDownCast(input);
  if (!canSplit || cellsAreSegments(input, rays))
  {
    output->ShallowCopy(input);
  }
  else
  {
    splitIntoSegments(vtkPointSet::SafeDownCast(input), rays, vtkPointSet::SafeDownCast(output));
  }
  return output->GetCellData();
}

} // namespace lumitree::filters
