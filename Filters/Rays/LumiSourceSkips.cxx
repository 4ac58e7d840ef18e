// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiSourceSkips.h"

#include "LumiReport.h"

#include "Accel/Parallel.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <string>

namespace lumitree::filters
{
namespace
{

constexpr std::size_t chunk = 8192;

/// Which source each ray has.
struct SourceIds
{
  vtkDataArray* cells = nullptr;
  vtkDataArray* points = nullptr;
  vtkDataArray* composites = nullptr;

  [[nodiscard]] static std::int64_t at(vtkDataArray* array, vtkIdType i, std::int64_t absent)
  {
    return array ? static_cast<std::int64_t>(array->GetComponent(i, 0)) : absent;
  }

  [[nodiscard]] std::vector<PrimitiveId> primitives(
    const SurfaceInput& surface, int process, vtkIdType i) const
  {
    std::vector<PrimitiveId> own;
    if (const auto leaf = surface.findLeaf(at(this->composites, i, 0), process))
    {
      const std::int64_t cell = at(this->cells, i, -1);
      const std::int64_t point = at(this->points, i, -1);
      if (cell >= 0)
      {
        own = surface.primitivesOfCell(*leaf, static_cast<vtkIdType>(cell));
      }
      else if (point >= 0)
      {
        own = surface.primitivesAroundPoint(*leaf, static_cast<vtkIdType>(point));
      }
    }
    return own;
  }
};

bool readIds(vtkDataSetAttributes* data, SourceIds& ids, vtkAlgorithm* reporter)
{
  ids.cells = data->GetArray("SourceCellId");
  ids.points = data->GetArray("SourcePointId");
  ids.composites = data->GetArray("SourceCompositeIndex");
  if (!ids.cells && !ids.points)
  {
    reportError(reporter,
      "SkipSource is on, but the rays have neither the array SourceCellId nor SourcePointId.");
    return false;
  }
  for (vtkDataArray* array : { ids.cells, ids.points, ids.composites })
  {
    if (array && array->GetNumberOfComponents() != 1)
    {
      reportError(reporter,
        std::string("The rays' array ") + array->GetName() + " must have one component, not " +
          std::to_string(array->GetNumberOfComponents()) + ".");
      return false;
    }
  }
  return true;
}

} // namespace

bool readSourceSkips(vtkDataSet* dataset, const RayInput& rays, const SurfaceInput& surface,
  int process, int threads, SourceSkips& skips, vtkAlgorithm* reporter)
{
  SourceIds ids;
  vtkDataSetAttributes* const data = rays.perCell
    ? static_cast<vtkDataSetAttributes*>(dataset->GetCellData())
    : dataset->GetPointData();
  if (!readIds(data, ids, reporter))
  {
    return false;
  }
  const std::size_t size = rays.batch.size;
  std::vector<std::vector<PrimitiveId>> parts((size + chunk - 1) / chunk);
  skips.offsets.assign(size + 1, 0);
  parallelFor(size, chunk, threads, nullptr,
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<PrimitiveId>& part = parts[begin / chunk];
      for (std::size_t i = begin; i < end; ++i)
      {
        const vtkIdType tuple = rays.perCell ? rays.segmentCells[i] : static_cast<vtkIdType>(i);
        const std::vector<PrimitiveId> own = ids.primitives(surface, process, tuple);
        part.insert(part.end(), own.begin(), own.end());
        skips.offsets[i + 1] = own.size();
      }
    });
  for (std::size_t i = 0; i < size; ++i)
  {
    skips.offsets[i + 1] += skips.offsets[i];
  }
  skips.primitives.reserve(skips.offsets[size]);
  for (const std::vector<PrimitiveId>& part : parts)
  {
    skips.primitives.insert(skips.primitives.end(), part.begin(), part.end());
  }
  return true;
}

} // namespace lumitree::filters
