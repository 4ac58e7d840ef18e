// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiExtract_h
#define LumiExtract_h

#include "vtkIdTypeArray.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <vector>

namespace lumitree::filters
{

enum class CellState : unsigned char
{
  Occludes,
  Duplicate,
  Hidden
};

/// What becomes of each cell of a dataset when it occludes.
struct CellSelection
{
  std::vector<CellState> states; ///< one per cell; empty: all occlude
  std::uint64_t hidden = 0;
  std::uint64_t duplicate = 0;

  [[nodiscard]] CellState operator[](vtkIdType cell) const
  {
    return this->states.empty() ? CellState::Occludes
                                : this->states[static_cast<std::size_t>(cell)];
  }
};

/// Reads the ghost arrays. Hidden are cells marked HIDDENCELL or REFINEDCELL, and cells with a
/// HIDDENPOINT (its coordinates mean nothing); DUPLICATECELLs are on another rank, which sees them.
[[nodiscard]] CellSelection selectCells(vtkDataSet* data);

/// The polygons of a leaf and the way back to its cells and points.
struct ExtractedSurface
{
  vtkSmartPointer<vtkPolyData> polygons;
  vtkSmartPointer<vtkIdTypeArray> cellIds; ///< of each cell of polygons; null: the same
  vtkSmartPointer<vtkIdTypeArray>
    pointIds; ///< of each point, −1 for one that was made; null: the same
};

/// A vtkPolyData as it is; of any other dataset the outer surface, hidden cells taken away (so that
/// what was behind them shows). The faces of duplicate cells are among it: they are recognised by
/// their cell.
[[nodiscard]] ExtractedSurface extractSurface(vtkDataSet* data, const CellSelection& selection);

} // namespace lumitree::filters
#endif
