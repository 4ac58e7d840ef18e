// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiCellSelection_h
#define LumiCellSelection_h

#include "vtkLumiABI.h"
#include "vtkType.h"

#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
VTK_ABI_NAMESPACE_END

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

} // namespace lumitree::filters
#endif
