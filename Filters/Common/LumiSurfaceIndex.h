// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiSurfaceIndex_h
#define LumiSurfaceIndex_h

#include "vtkIdTypeArray.h"
#include "vtkSmartPointer.h"

#include "Accel/Surface.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace lumitree::filters
{

/// The primitives that touch each point of a leaf: those of point i are primitives[offsets[i]] …
/// primitives[offsets[i + 1] - 1], ascending.
struct PointTable
{
  std::once_flag once;
  std::vector<std::uint64_t> offsets;
  std::vector<PrimitiveId> primitives;
};

/// The ways back from a surface to the datasets it was made from.
struct SurfaceIndex
{
  std::shared_ptr<const Surface> surface;
  std::vector<PrimitiveId> firstPrimitive; ///< one per leaf, and the end
  std::vector<std::size_t> firstPoint;     ///< one per leaf, and the end
  /// One per leaf: the leaf's id of each point, −1 for one that was made; null: the same.
  std::vector<vtkSmartPointer<vtkIdTypeArray>> pointIds;
  /// Leaves are gathered triangles: their own points and cells are numbered as in the surface.
  bool gathered = false;

  /// The leaf's id of a point of the surface.
  [[nodiscard]] vtkIdType originalPointId(std::size_t leaf, std::uint32_t point) const;

  /// Primitives first … end - 1 of the leaf that belong to the cell of the primitive.
  [[nodiscard]] PrimitiveId endOfCell(std::size_t leaf, PrimitiveId primitive) const;

  /// Made when first asked for: only filters with receivers on the surface need it.
  [[nodiscard]] const PointTable& pointTable(std::size_t leaf) const;

  explicit SurfaceIndex(std::size_t leaves);

private:
  mutable std::vector<PointTable> tables_;
};

} // namespace lumitree::filters
#endif
