// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiExtract_h
#define LumiExtract_h

#include "LumiCellSelection.h"

#include "vtkIdTypeArray.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace lumitree::filters
{

/// The polygons of a leaf and the way back to its cells and points.
struct ExtractedSurface
{
  vtkSmartPointer<vtkPolyData> polygons;
  vtkSmartPointer<vtkIdTypeArray> cellIds; ///< of each cell of polygons; null: the same
  /// Of each point, −1 for one that was made (inside a nonlinear face); null: the same.
  vtkSmartPointer<vtkIdTypeArray> pointIds;
};

/// A vtkPolyData as it is; of any other dataset the outer surface, hidden cells taken away (so that
/// what was behind them shows). The faces of duplicate cells are among it: they are recognised by
/// their cell. Throws std::runtime_error for a dataset whose surface VTK cannot relate to its
/// cells.
[[nodiscard]] ExtractedSurface extractSurface(vtkDataSet* data, const CellSelection& selection);

} // namespace lumitree::filters
#endif
