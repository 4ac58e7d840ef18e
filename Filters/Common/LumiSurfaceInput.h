// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiSurfaceInput_h
#define LumiSurfaceInput_h

#include "LumitreeFiltersCommonModule.h"

#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include "Accel/Surface.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace lumitree::filters
{

struct SurfaceIndex;

/// One dataset of the input, or one piece of it that came from another rank.
struct SurfaceLeaf
{
  /// On one rank the leaf as given (a shallow copy: later changes of the pipeline do not reach it).
  /// In a run over several ranks the triangles that were gathered, as a vtkPolyData with the leaf's
  /// point and cell arrays. Either way leafPointIds and leafCellId are ids of this dataset.
  vtkSmartPointer<vtkDataSet> data;
  std::int64_t compositeIndex = 0; ///< flat index within the composite; 0 for a plain dataset
  int process = 0;                 ///< rank whose piece it is
};

/// What an accelerator was made from: the triangles and quadrics of all leaves as one surface, and
/// the ways back to the cells and points that they came from. Primitives are ordered by (leaf,
/// cell, sub-triangle), and leaves of quadrics come after those of triangles. Immutable, except
/// that a look-up table is made when it is first asked for: any thread may read it.
struct LUMITREEFILTERSCOMMON_EXPORT SurfaceInput
{
  std::shared_ptr<const Surface> surface;
  /// By (triangles or quadrics), rank, and the order of the composite.
  std::vector<SurfaceLeaf> leaves;
  /// One per leaf, ascending; an empty leaf has its successor's.
  std::vector<PrimitiveId> firstPrimitive;

  /// Left out: HIDDENCELL, coarse AMR cells that are refined, cells with a HIDDENPOINT.
  std::uint64_t hiddenCells = 0;
  std::uint64_t duplicateCells = 0; ///< left out: DUPLICATECELL
  std::uint64_t passedOver = 0;     ///< vertices, lines, and polygons of less than three points

  /// The way back; shared by all that use this surface.
  std::shared_ptr<const SurfaceIndex> index;

  /// The leaf that a primitive belongs to.
  [[nodiscard]] std::size_t leafOf(PrimitiveId primitive) const;

  /// The leaf of that flat index and rank; nothing when the input has no such leaf.
  [[nodiscard]] std::optional<std::size_t> findLeaf(
    std::int64_t compositeIndex, int process = 0) const;

  /// The primitive's cell as an id of leaves[leafOf(primitive)].data: where its cell data stands.
  /// surface->source(primitive).cell is the id to report; on one rank the two are the same.
  [[nodiscard]] vtkIdType leafCellId(PrimitiveId primitive) const;

  /// The primitive's vertices (v0, v1, v2) as point ids of leaves[leafOf(primitive)].data: where
  /// their point data stands. −1 for a vertex that is no point of the leaf (a subdivided nonlinear
  /// face). Of a quadric its vertex cell's point, and −1 twice.
  [[nodiscard]] std::array<vtkIdType, 3> leafPointIds(PrimitiveId primitive) const;

  /// Every primitive of a cell, ascending: what a receiver on that cell must not see. cellId is the
  /// original id, local to the leaf's dataset. Empty when the cell gave none. Of a polygon that
  /// shows a quadric it is that quadric, and so for points.
  [[nodiscard]] std::vector<PrimitiveId> primitivesOfCell(std::size_t leaf, vtkIdType cellId) const;

  /// Every primitive of every cell that uses a point, ascending: what a receiver at that point must
  /// not see. pointId is the original id, local to the leaf's dataset. Empty inside a volume.
  [[nodiscard]] std::vector<PrimitiveId> primitivesAroundPoint(
    std::size_t leaf, vtkIdType pointId) const;
};

} // namespace lumitree::filters
#endif
