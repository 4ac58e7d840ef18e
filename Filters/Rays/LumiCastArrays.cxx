// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiCastArrays.h"

#include "LumiArrays.h"

#include "Accel/Parallel.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <limits>
#include <vector>

namespace lumitree::filters
{

namespace
{

constexpr std::size_t chunk = 8192;

void makeVertices(vtkIdType count, int threads, vtkPolyData* hits)
{
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> connectivity;
  vtkIdType* first = makeRoom(offsets.Get(), count + 1);
  vtkIdType* point = makeRoom(connectivity.Get(), count);
  parallelFor(static_cast<std::size_t>(count), chunk, threads, nullptr,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        first[i] = point[i] = static_cast<vtkIdType>(i);
      }
    });
  first[count] = count;
  vtkNew<vtkCellArray> vertices;
  vertices->SetData(offsets, connectivity);
  hits->SetVerts(vertices);
}

void addCounters(
  const RayCounters* counters, vtkIdType rays, int threads, vtkDataSetAttributes* data)
{
  int* nodes = addArray<vtkIntArray>(data, "NodesEntered", rays);
  int* cells = addArray<vtkIntArray>(data, "CellsStepped", rays);
  int* leaves = addArray<vtkIntArray>(data, "LeavesVisited", rays);
  int* primitives = addArray<vtkIntArray>(data, "PrimitivesTested", rays);
  parallelFor(static_cast<std::size_t>(rays), chunk, threads, nullptr,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        nodes[i] = static_cast<int>(counters[i].nodes);
        cells[i] = static_cast<int>(counters[i].cells);
        leaves[i] = static_cast<int>(counters[i].leaves);
        primitives[i] = static_cast<int>(counters[i].primitives);
      }
    });
}

} // namespace

HitLayout::HitLayout(const Cast& cast, int threads)
{
  const std::size_t rays = cast.size();
  this->offsets->SetName("HitOffset");
  vtkIdType* offset = makeRoom(this->offsets.Get(), static_cast<vtkIdType>(rays));

  // Count per chunk, sum the few chunks, fill: the places do not depend on who filled what when.
  std::vector<vtkIdType> firsts((rays + chunk - 1) / chunk);
  cast.withCounts(
    [&](auto countOf)
    {
      parallelFor(rays, chunk, threads, nullptr,
        [&](std::size_t begin, std::size_t end)
        {
          vtkIdType sum = 0;
          for (std::size_t i = begin; i < end; ++i)
          {
            sum += countOf(i);
          }
          firsts[begin / chunk] = sum;
        });
      for (vtkIdType& first : firsts)
      {
        const vtkIdType count = first;
        first = this->total;
        this->total += count;
      }
      parallelFor(rays, chunk, threads, nullptr,
        [&](std::size_t begin, std::size_t end)
        {
          vtkIdType next = firsts[begin / chunk];
          for (std::size_t i = begin; i < end; ++i)
          {
            offset[i] = next;
            next += countOf(i);
          }
        });
    });
}

HitTotals addRayArrays(const Cast& cast, const HitLayout* layout, const SurfaceInput& surface,
  const RayCounters* counters, int threads, vtkDataSetAttributes* data)
{
  const std::size_t rays = cast.size();
  const auto tuples = static_cast<vtkIdType>(rays);

  unsigned char* mask = addArray<vtkUnsignedCharArray>(data, "HitMask", tuples);
  vtkIdType* counts = addArray<vtkIdTypeArray>(data, "HitCount", tuples);
  unsigned char* inside = cast.query() == QueryKind::Crossings
    ? addArray<vtkUnsignedCharArray>(data, "Inside", tuples)
    : nullptr;
  double* t = nullptr;
  vtkIdType* cell = nullptr;
  int* composite = nullptr;
  if (layout)
  {
    data->AddArray(layout->offsets);
    t = addArray<vtkDoubleArray>(data, "T", tuples);
    cell = addArray<vtkIdTypeArray>(data, "CellId", tuples);
    composite = addArray<vtkIntArray>(data, "CompositeIndex", tuples);
  }

  const auto fillFirst = [&](std::size_t i, bool hit)
  {
    const SourceCell source =
      hit ? surface.surface->source(cast.hits(i)->primitive) : SourceCell{ -1, -1 };
    t[i] = hit ? cast.hits(i)->t : std::numeric_limits<double>::infinity();
    cell[i] = static_cast<vtkIdType>(source.cell);
    composite[i] = static_cast<int>(source.composite);
  };
  std::vector<HitTotals> parts((rays + chunk - 1) / chunk);
  cast.withCounts(
    [&](auto countOf)
    {
      parallelFor(rays, chunk, threads, nullptr,
        [&](std::size_t begin, std::size_t end)
        {
          HitTotals part;
          for (std::size_t i = begin; i < end; ++i)
          {
            const vtkIdType count = countOf(i);
            counts[i] = count;
            mask[i] = count > 0 ? 1 : 0;
            part.raysHit += mask[i];
            part.hits += static_cast<std::uint64_t>(count);
            if (inside)
            {
              inside[i] = static_cast<unsigned char>(count % 2);
            }
            if (t)
            {
              fillFirst(i, count > 0);
            }
          }
          parts[begin / chunk] = part;
        });
    });
  if (counters)
  {
    addCounters(counters, tuples, threads, data);
  }
  HitTotals totals;
  for (const HitTotals& part : parts)
  {
    totals.raysHit += part.raysHit;
    totals.hits += part.hits;
  }
  return totals;
}

void makeHits(const Cast& cast, const HitLayout& layout, const RayBatch& rays,
  const SurfaceInput& input, const HitOptions& options, PrimitiveId* primitives, vtkPolyData* hits)
{
  const Surface& surface = *input.surface;
  const vtkIdType total = layout.total;
  const vtkIdType* offset = layout.offsets->GetPointer(0);

  double* doubles = nullptr;
  float* floats = nullptr;
  vtkNew<vtkPoints> points;
  if (options.doublePoints)
  {
    const vtkNew<vtkDoubleArray> xyz;
    doubles = makeRoom(xyz.Get(), total, 3);
    points->SetData(xyz);
  }
  else
  {
    const vtkNew<vtkFloatArray> xyz;
    floats = makeRoom(xyz.Get(), total, 3);
    points->SetData(xyz);
  }
  hits->SetPoints(points);
  makeVertices(total, options.threads, hits);

  vtkDataSetAttributes* data = hits->GetPointData();
  vtkIdType* rayId = addArray<vtkIdTypeArray>(data, "RayId", total);
  double* t = addArray<vtkDoubleArray>(data, "T", total);
  vtkIdType* cell = addArray<vtkIdTypeArray>(data, "CellId", total);
  int* composite = addArray<vtkIntArray>(data, "CompositeIndex", total);
  int* process = options.processIds ? addArray<vtkIntArray>(data, "ProcessId", total) : nullptr;
  double* uv = addArray<vtkDoubleArray>(data, "UV", total, 2);
  double* normal = addArray<vtkDoubleArray>(data, "Normals", total, 3);
  int* flags =
    surface.implicitCount() > 0 ? addArray<vtkIntArray>(data, "HitFlags", total) : nullptr;

  const auto place = [&](const Ray& ray, const Hit& hit, vtkIdType i)
  {
    const SourceCell source = surface.source(hit.primitive);
    const Vec3 p = ray.origin + hit.t * ray.direction;
    const Vec3 n = surface.normal(hit.primitive, p);
    primitives[i] = hit.primitive;
    t[i] = hit.t;
    cell[i] = static_cast<vtkIdType>(source.cell);
    composite[i] = static_cast<int>(source.composite);
    uv[2 * i] = hit.u;
    uv[2 * i + 1] = hit.v;
    if (flags)
    {
      flags[i] = static_cast<int>(hit.flags);
    }
    if (process)
    {
      process[i] = input.leaves[input.leafOf(hit.primitive)].process;
    }
    for (int k = 0; k < 3; ++k)
    {
      normal[3 * i + k] = n[k];
      if (doubles)
      {
        doubles[3 * i + k] = p[k];
      }
      else
      {
        floats[3 * i + k] = static_cast<float>(p[k]);
      }
    }
  };
  cast.withCounts(
    [&](auto countOf)
    {
      parallelFor(cast.size(), chunk, options.threads, nullptr,
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t r = begin; r < end; ++r)
          {
            const vtkIdType count = countOf(r);
            for (vtkIdType h = 0; h < count; ++h)
            {
              const vtkIdType i = offset[r] + h;
              rayId[i] = static_cast<vtkIdType>(r);
              place(rays[r], cast.hits(r)[h], i);
            }
          }
        });
    });
  data->SetActiveScalars("T");
  data->SetActiveNormals("Normals");
}

} // namespace lumitree::filters
