// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiSurfaceInput.h"

#include "LumiQuadrics.h"
#include "LumiSurfaceIndex.h"

#include <algorithm>

namespace lumitree::filters
{
namespace
{

/// The first primitive of the leaf whose cell is not before `cell`.
PrimitiveId lowerBound(const SurfaceIndex& index, std::size_t leaf, std::int64_t cell)
{
  PrimitiveId first = index.firstPrimitive[leaf];
  PrimitiveId end = index.firstPrimitive[leaf + 1];
  while (first < end)
  {
    const PrimitiveId middle = first + (end - first) / 2;
    if (index.surface->source(middle).cell < cell)
    {
      first = middle + 1;
    }
    else
    {
      end = middle;
    }
  }
  return first;
}

void append(PrimitiveId first, PrimitiveId end, std::vector<PrimitiveId>& primitives)
{
  for (PrimitiveId primitive = first; primitive < end; ++primitive)
  {
    primitives.push_back(primitive);
  }
}

} // namespace

std::size_t SurfaceInput::leafOf(PrimitiveId primitive) const
{
  const auto after =
    std::upper_bound(this->firstPrimitive.begin(), this->firstPrimitive.end(), primitive);
  return static_cast<std::size_t>(after - this->firstPrimitive.begin()) - 1;
}

std::optional<std::size_t> SurfaceInput::findLeaf(std::int64_t compositeIndex, int process) const
{
  for (std::size_t i = 0; i < this->leaves.size(); ++i)
  {
    if (this->leaves[i].compositeIndex == compositeIndex && this->leaves[i].process == process)
    {
      return i;
    }
  }
  return std::nullopt;
}

vtkIdType SurfaceInput::leafCellId(PrimitiveId primitive) const
{
  return this->index->gathered && this->surface->isTriangle(primitive)
    ? static_cast<vtkIdType>(primitive - this->firstPrimitive[this->leafOf(primitive)])
    : static_cast<vtkIdType>(this->surface->source(primitive).cell);
}

std::array<vtkIdType, 3> SurfaceInput::leafPointIds(PrimitiveId primitive) const
{
  const std::size_t leaf = this->leafOf(primitive);
  std::array<vtkIdType, 3> ids{ -1, -1, -1 };
  if (!this->surface->isTriangle(primitive))
  {
    ids[0] = this->leafCellId(primitive);
    return ids;
  }
  const Triangle& triangle = this->surface->triangle(primitive);
  for (std::size_t k = 0; k < 3; ++k)
  {
    ids[k] = this->index->gathered
      ? static_cast<vtkIdType>(triangle[k] - this->index->firstPoint[leaf])
      : this->index->originalPointId(leaf, triangle[k]);
  }
  return ids;
}

std::vector<PrimitiveId> SurfaceInput::primitivesOfCell(std::size_t leaf, vtkIdType cellId) const
{
  std::vector<PrimitiveId> primitives;
  if (holdsQuadrics(this->leaves[leaf].data))
  {
    cellId = quadricOf(this->leaves[leaf].data, cellId, false);
  }
  const PrimitiveId first = lowerBound(*this->index, leaf, cellId);
  if (first < this->index->firstPrimitive[leaf + 1] && this->surface->source(first).cell == cellId)
  {
    append(first, this->index->endOfCell(leaf, first), primitives);
  }
  return primitives;
}

std::vector<PrimitiveId> SurfaceInput::primitivesAroundPoint(
  std::size_t leaf, vtkIdType pointId) const
{
  std::vector<PrimitiveId> primitives;
  if (holdsQuadrics(this->leaves[leaf].data))
  {
    pointId = quadricOf(this->leaves[leaf].data, pointId, true);
  }
  const PointTable& table = this->index->pointTable(leaf);
  if (pointId < 0 || static_cast<std::size_t>(pointId) + 1 >= table.offsets.size())
  {
    return primitives;
  }
  const auto point = static_cast<std::size_t>(pointId);
  PrimitiveId end = 0; // of the cells that were appended
  for (std::uint64_t i = table.offsets[point]; i < table.offsets[point + 1]; ++i)
  {
    if (table.primitives[i] >= end)
    {
      const PrimitiveId first =
        lowerBound(*this->index, leaf, this->surface->source(table.primitives[i]).cell);
      end = this->index->endOfCell(leaf, first);
      append(first, end, primitives);
    }
  }
  return primitives;
}

} // namespace lumitree::filters
