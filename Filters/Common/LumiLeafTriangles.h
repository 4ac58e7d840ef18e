// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiLeafTriangles_h
#define LumiLeafTriangles_h

#include "LumiExtract.h"

#include "vtkDataSet.h"

#include "Accel/Surface.h"

#include <cstdint>
#include <vector>

namespace lumitree::filters
{

/// A leaf as triangles, ordered by (cell, sub-triangle), as quadrics, or as implicits.
struct LeafTriangles
{
  PointArray points;
  std::vector<Triangle> triangles; ///< indices into points
  std::vector<Quadric> quadrics;
  std::vector<Implicit> implicits;
  std::vector<std::int64_t> cells;          ///< one per primitive: its cell in the leaf
  vtkSmartPointer<vtkIdTypeArray> pointIds; ///< of each point in the leaf; null: the same
  std::uint64_t hiddenCells = 0;
  std::uint64_t duplicateCells = 0;
  std::uint64_t passedOver = 0;
};

/// Throws std::invalid_argument for what readBodies refuses, cells that name points that do not
/// exist and for more than 2^32 − 2 points or triangles.
[[nodiscard]] LeafTriangles trianglesOf(vtkDataSet* leaf, int threads = 0);

} // namespace lumitree::filters
#endif
