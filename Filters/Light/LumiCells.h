// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiCells_h
#define LumiCells_h

#include "Accel/Vec3.h"
#include "vtkLumiABI.h"

#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace lumitree::filters
{

/// Topological dimension of a VTK cell type, 0…3; −1 for an empty or unknown one.
[[nodiscard]] int cellDimension(int cellType);

/// Where the cells of a dataset are and which way they face. One per thread, after prepareCells.
class Cells
{
public:
  explicit Cells(vtkDataSet* data);

  /// The cell's points, until the next call.
  vtkIdList* points(vtkIdType cell);

  /// The centre in the cell's parametric coordinates, as vtkCellCenters has it.
  [[nodiscard]] Vec3 centre(vtkIdType cell);

  /// Of a cell of two dimensions: its area times its normal by winding. Corners of a polygon that
  /// is not flat count as projected along that normal (Newell's formula).
  [[nodiscard]] Vec3 areaVector(vtkIdType cell);

private:
  [[nodiscard]] Vec3 point(vtkIdType id) const;
  [[nodiscard]] Vec3 polygonArea(const int* order, int corners) const;

  vtkDataSet* data_;
  vtkNew<vtkIdList> ids_;
  vtkNew<vtkGenericCell> cell_;
};

/// Makes VTK build, on this thread, what it builds when cells are first asked for.
void prepareCells(vtkDataSet* data);

} // namespace lumitree::filters
#endif
