// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiCellSelection.h"

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

namespace lumitree::filters
{
namespace
{

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

} // namespace lumitree::filters
