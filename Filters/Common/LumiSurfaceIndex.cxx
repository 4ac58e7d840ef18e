// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiSurfaceIndex.h"

#include <algorithm>

namespace lumitree::filters
{
namespace
{

void fill(const SurfaceIndex& index, std::size_t leaf, PointTable& table)
{
  const PrimitiveId first = index.firstPrimitive[leaf];
  const PrimitiveId end = index.firstPrimitive[leaf + 1];
  const auto forEach = [&](auto&& visit)
  {
    for (PrimitiveId primitive = first; primitive < end; ++primitive)
    {
      if (!index.surface->isTriangle(primitive))
      {
        // Vertex cell q uses point q.
        visit(static_cast<std::size_t>(index.surface->source(primitive).cell), primitive);
        continue;
      }
      for (const std::uint32_t point : index.surface->triangle(primitive))
      {
        const vtkIdType id = index.originalPointId(leaf, point);
        if (id >= 0)
        {
          visit(static_cast<std::size_t>(id), primitive);
        }
      }
    }
  };

  std::size_t points = 0;
  forEach([&](std::size_t id, PrimitiveId) { points = std::max(points, id + 1); });
  table.offsets.assign(points + 1, 0);
  forEach([&](std::size_t id, PrimitiveId) { ++table.offsets[id + 1]; });
  for (std::size_t i = 0; i < points; ++i)
  {
    table.offsets[i + 1] += table.offsets[i];
  }
  table.primitives.resize(table.offsets[points]);
  std::vector<std::uint64_t> next(table.offsets.begin(), table.offsets.end() - 1);
  forEach([&](std::size_t id, PrimitiveId primitive) { table.primitives[next[id]++] = primitive; });
}

} // namespace

SurfaceIndex::SurfaceIndex(std::size_t leaves)
  : tables_(leaves)
{
}

vtkIdType SurfaceIndex::originalPointId(std::size_t leaf, std::uint32_t point) const
{
  const auto local = static_cast<vtkIdType>(point - this->firstPoint[leaf]);
  return this->pointIds[leaf] ? this->pointIds[leaf]->GetValue(local) : local;
}

PrimitiveId SurfaceIndex::endOfCell(std::size_t leaf, PrimitiveId primitive) const
{
  const std::int64_t cell = this->surface->source(primitive).cell;
  PrimitiveId end = primitive + 1;
  while (end < this->firstPrimitive[leaf + 1] && this->surface->source(end).cell == cell)
  {
    ++end;
  }
  return end;
}

const PointTable& SurfaceIndex::pointTable(std::size_t leaf) const
{
  PointTable& table = this->tables_[leaf];
  std::call_once(table.once, fill, std::cref(*this), leaf, std::ref(table));
  return table;
}

} // namespace lumitree::filters
