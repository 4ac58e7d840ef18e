// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiLeafTriangles.h"

#include "LumiCellOrder.h"
#include "LumiJob.h"
#include "LumiPoints.h"
#include "LumiQuadrics.h"
#include "LumiTriangulate.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"

#include "Accel/Parallel.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace lumitree::filters
{
namespace
{

constexpr std::size_t chunkSize = 8192; // cells; enough work to outweigh making a vtkPolygon

/// What a chunk of cells gave.
struct Chunk
{
  std::vector<Triangle> triangles;
  std::vector<std::int64_t> cells;
  std::uint64_t passedOver = 0;
};

void checkPoints(vtkIdType n, const vtkIdType* ids, std::size_t points, std::int64_t cell)
{
  for (vtkIdType i = 0; i < n; ++i)
  {
    if (ids[i] < 0 || static_cast<std::size_t>(ids[i]) >= points)
    {
      throw std::invalid_argument("cell " + std::to_string(cell) + " uses point " +
        std::to_string(ids[i]) + " of " + std::to_string(points));
    }
  }
}

void triangulate(const std::vector<PolygonCell>& order, std::size_t begin, std::size_t end,
  const ExtractedSurface& surface, const PointArray& points, Chunk& chunk)
{
  Triangulator triangulator(points);
  vtkCellArray* polys = surface.polygons->GetPolys();
  vtkCellArray* strips = surface.polygons->GetStrips();
  vtkNew<vtkIdList> ids;
  for (std::size_t i = begin; i < end; ++i)
  {
    const PolygonCell& cell = order[i];
    // The only accessor that is thread-safe whatever the arrays' storage.
    (cell.strip ? strips : polys)->GetCellAtId(cell.index, ids);
    const vtkIdType n = ids->GetNumberOfIds();
    if (n < 3)
    {
      ++chunk.passedOver;
      continue;
    }
    checkPoints(n, ids->GetPointer(0), points.count, cell.cell);
    if (cell.strip)
    {
      triangulator.strip(n, ids->GetPointer(0), chunk.triangles);
    }
    else
    {
      triangulator.polygon(n, ids->GetPointer(0), chunk.triangles);
    }
    chunk.cells.resize(chunk.triangles.size(), cell.cell);
  }
}

/// Whether a leaf is nothing but triangles that all occlude, in the order of their cells: most
/// surfaces are, and then nothing needs to be sorted or cut.
bool isPlain(const ExtractedSurface& surface, const CellSelection& selection)
{
  vtkPolyData* data = surface.polygons;
  return !surface.cellIds && selection.states.empty() && data->GetNumberOfPolys() > 0 &&
    data->GetNumberOfPolys() == data->GetNumberOfCells() && data->GetPolys()->IsHomogeneous() == 3;
}

/// Takes the triangles of a plain leaf straight out of its connectivity.
void takeTriangles(vtkPolyData* data, int threads, LeafTriangles& result)
{
  vtkCellArray* polys = data->GetPolys();
  const auto count = static_cast<std::size_t>(polys->GetNumberOfCells());
  result.triangles.resize(count);
  result.cells.resize(count);
  const auto take = [&](const auto* corners)
  {
    parallelFor(count, chunkSize, threadsFor(threads), nullptr,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          vtkIdType ids[3];
          for (std::size_t k = 0; k < 3; ++k)
          {
            ids[k] = static_cast<vtkIdType>(corners[3 * i + k]);
            result.triangles[i][k] = static_cast<std::uint32_t>(ids[k]);
          }
          result.cells[i] = static_cast<std::int64_t>(i);
          checkPoints(3, ids, result.points.count, result.cells[i]);
        }
      });
  };
  if (polys->IsStorage64Bit())
  {
    take(polys->GetConnectivityArray64()->GetPointer(0));
  }
  else
  {
    take(polys->GetConnectivityArray32()->GetPointer(0));
  }
}

/// Bodies whose vertex is a ghost do not occlude either.
void takeBodies(vtkDataSet* leaf, const CellSelection& selection, LeafTriangles& result)
{
  const Bodies all = readBodies(leaf);
  const std::size_t count = all.implicit ? 1 : all.quadrics.size();
  for (std::size_t b = 0; b < count; ++b)
  {
    const auto cell = static_cast<vtkIdType>(b);
    if (selection[cell] != CellState::Occludes)
    {
      continue;
    }
    if (all.implicit)
    {
      result.implicits.push_back(*all.implicit);
    }
    else
    {
      result.quadrics.push_back(all.quadrics[b]);
    }
    result.cells.push_back(cell);
  }
}

} // namespace

LeafTriangles trianglesOf(vtkDataSet* leaf, int threads)
{
  LeafTriangles result;
  const CellSelection selection = selectCells(leaf);
  if (holdsQuadrics(leaf))
  {
    result.hiddenCells = selection.hidden;
    result.duplicateCells = selection.duplicate;
    takeBodies(leaf, selection, result);
    return result;
  }
  const ExtractedSurface surface = extractSurface(leaf, selection);
  result.hiddenCells = selection.hidden;
  result.duplicateCells = selection.duplicate;
  result.pointIds = surface.pointIds;
  result.passedOver = static_cast<std::uint64_t>(
    surface.polygons->GetNumberOfVerts() + surface.polygons->GetNumberOfLines());

  vtkPoints* points = surface.polygons->GetPoints();
  result.points = pointsOf(points ? points->GetData() : nullptr);
  if (result.points.count >= std::numeric_limits<std::uint32_t>::max())
  {
    throw std::invalid_argument("more than 2^32 - 2 points in one dataset");
  }

  if (isPlain(surface, selection))
  {
    takeTriangles(surface.polygons, threads, result);
    return result;
  }
  const std::vector<PolygonCell> order = polygonsInOrder(surface, selection);
  std::vector<Chunk> chunks((order.size() + chunkSize - 1) / chunkSize);
  parallelFor(order.size(), chunkSize, threadsFor(threads), nullptr,
    [&](std::size_t begin, std::size_t end)
    { triangulate(order, begin, end, surface, result.points, chunks[begin / chunkSize]); });

  std::size_t total = 0;
  for (const Chunk& chunk : chunks)
  {
    total += chunk.triangles.size();
  }
  if (total >= std::numeric_limits<std::uint32_t>::max())
  {
    throw std::invalid_argument("more than 2^32 - 2 triangles in one dataset");
  }
  result.triangles.reserve(total);
  result.cells.reserve(total);
  for (Chunk& chunk : chunks)
  {
    result.triangles.insert(result.triangles.end(), chunk.triangles.begin(), chunk.triangles.end());
    result.cells.insert(result.cells.end(), chunk.cells.begin(), chunk.cells.end());
    result.passedOver += chunk.passedOver;
    chunk = {}; // no second copy of everything
  }
  return result;
}

} // namespace lumitree::filters
