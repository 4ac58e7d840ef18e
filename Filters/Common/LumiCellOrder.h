// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiCellOrder_h
#define LumiCellOrder_h

#include "LumiExtract.h"

#include <cstdint>
#include <vector>

namespace lumitree::filters
{

/// A polygon or a strip of an extracted surface.
struct PolygonCell
{
  std::int64_t cell = 0; ///< id in the leaf
  vtkIdType index = 0;   ///< among the polygons or among the strips
  bool strip = false;
};

/// Polygons and strips that occlude, ordered by the cell of the leaf that they belong to. Faces of
/// one cell are ordered by their points, so that the order is the same however the surface was
/// extracted.
[[nodiscard]] std::vector<PolygonCell> polygonsInOrder(
  const ExtractedSurface& surface, const CellSelection& selection);

} // namespace lumitree::filters
#endif
