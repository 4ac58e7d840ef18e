// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiReplicate.h"

#include "LumiPoints.h"
#include "LumiQuadrics.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTypeInt64Array.h"

#include <limits>
#include <stdexcept>
#include <string>

namespace lumitree::filters
{
namespace
{

// Ids travel as 64-bit integers: VTK's legacy format, which carries datasets between ranks, cuts
// vtkIdType arrays down to 32 bits.
constexpr const char* cellIdsName = "LumitreeCellIds";
constexpr const char* pointIdsName = "LumitreePointIds";
constexpr const char* headerName = "LumitreeLeaf";

constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();

vtkSmartPointer<vtkTypeInt64Array> newIds(const char* name, std::size_t n)
{
  auto ids = vtkSmartPointer<vtkTypeInt64Array>::New();
  ids->SetName(name);
  ids->SetNumberOfValues(static_cast<vtkIdType>(n));
  return ids;
}

/// Copies tuple from[i] to i; a negative one gives zeros.
void copyTuples(vtkDataSetAttributes* source, vtkTypeInt64Array* from, vtkDataSetAttributes* target)
{
  const vtkIdType n = from->GetNumberOfValues();
  target->CopyAllOn();
  target->CopyFieldOff(vtkDataSetAttributes::GhostArrayName());
  target->CopyAllocate(source, n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    const auto id = static_cast<vtkIdType>(from->GetValue(i));
    if (id >= 0)
    {
      target->CopyData(source, id, i);
    }
    else
    {
      target->NullData(i);
    }
  }
}

/// The ids as packed: a reader makes its own choice of class for 64-bit integers.
vtkSmartPointer<vtkTypeInt64Array> idsIn(vtkFieldData* data, const char* name, std::size_t n)
{
  auto ids = vtkSmartPointer<vtkTypeInt64Array>::New();
  vtkDataArray* array = vtkDataArray::SafeDownCast(data->GetAbstractArray(name));
  const std::size_t found =
    array ? static_cast<std::size_t>(array->GetNumberOfValues()) : 0; // an empty one is not sent
  if (found != n)
  {
    throw std::runtime_error("a gathered surface has " + std::to_string(found) + " values of " +
      name + ", not " + std::to_string(n));
  }
  if (array)
  {
    ids->DeepCopy(array);
  }
  return ids;
}

void addHeader(const LeafTriangles& own, std::int64_t compositeIndex, vtkPolyData* packed)
{
  const auto header = newIds(headerName, 4);
  header->SetValue(0, compositeIndex);
  header->SetValue(1, static_cast<std::int64_t>(own.hiddenCells));
  header->SetValue(2, static_cast<std::int64_t>(own.duplicateCells));
  header->SetValue(3, static_cast<std::int64_t>(own.passedOver));
  packed->GetFieldData()->AddArray(header);
}

/// Quadrics go whole, with the polygons that show them.
vtkSmartPointer<vtkPolyData> packQuadrics(
  const LeafTriangles& own, vtkDataSet* leaf, std::int64_t compositeIndex)
{
  auto packed = vtkSmartPointer<vtkPolyData>::New();
  packed->ShallowCopy(leaf);
  addHeader(own, compositeIndex, packed);
  return packed;
}

} // namespace

vtkSmartPointer<vtkPolyData> pack(
  const LeafTriangles& triangles, vtkDataSet* leaf, std::int64_t compositeIndex, bool arrays)
{
  if (holdsQuadrics(leaf))
  {
    return packQuadrics(triangles, leaf, compositeIndex);
  }
  const PointArray& all = triangles.points;
  std::vector<std::uint32_t> renumbered(all.count, unused);
  std::vector<std::uint32_t> used;
  vtkNew<vtkCellArray> cells;
  for (const Triangle& triangle : triangles.triangles)
  {
    vtkIdType ids[3];
    for (int k = 0; k < 3; ++k)
    {
      const std::uint32_t point = triangle[static_cast<std::size_t>(k)];
      if (renumbered[point] == unused)
      {
        renumbered[point] = static_cast<std::uint32_t>(used.size());
        used.push_back(point);
      }
      ids[k] = renumbered[point];
    }
    cells->InsertNextCell(3, ids);
  }

  const auto pointIds = newIds(pointIdsName, used.size());
  vtkNew<vtkPoints> points;
  points->SetDataType(all.values.type == ArrayView::Scalar::Float ? VTK_FLOAT : VTK_DOUBLE);
  points->SetNumberOfPoints(static_cast<vtkIdType>(used.size()));
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    points->SetPoint(id, all.values.triple(used[i]).data());
    pointIds->SetValue(id, triangles.pointIds ? triangles.pointIds->GetValue(used[i]) : used[i]);
  }
  const auto cellIds = newIds(cellIdsName, triangles.cells.size());
  std::copy(triangles.cells.begin(), triangles.cells.end(), cellIds->GetPointer(0));

  auto packed = vtkSmartPointer<vtkPolyData>::New();
  packed->SetPoints(points);
  packed->SetPolys(cells);
  if (arrays)
  {
    copyTuples(leaf->GetPointData(), pointIds, packed->GetPointData());
    copyTuples(leaf->GetCellData(), cellIds, packed->GetCellData());
  }
  packed->GetPointData()->AddArray(pointIds);
  packed->GetCellData()->AddArray(cellIds);
  addHeader(triangles, compositeIndex, packed);
  return packed;
}

SurfacePart unpack(vtkPolyData* packed, int process)
{
  SurfacePart part;
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->ShallowCopy(packed);
  LeafTriangles& own = part.triangles;
  const auto header = idsIn(data->GetFieldData(), headerName, 4);
  part.leaf.compositeIndex = header->GetValue(0);
  part.leaf.process = process;
  part.leaf.data = data;
  data->GetFieldData()->RemoveArray(headerName);
  if (holdsQuadrics(data))
  {
    own = trianglesOf(data);
    return part;
  }
  own.hiddenCells = static_cast<std::uint64_t>(header->GetValue(1));
  own.duplicateCells = static_cast<std::uint64_t>(header->GetValue(2));
  own.passedOver = static_cast<std::uint64_t>(header->GetValue(3));
  own.points = pointsOf(data->GetPoints() ? data->GetPoints()->GetData() : nullptr);

  vtkCellArray* cells = data->GetPolys();
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    cells->GetCellAtId(i, ids);
    own.triangles.push_back({ static_cast<std::uint32_t>(ids->GetId(0)),
      static_cast<std::uint32_t>(ids->GetId(1)), static_cast<std::uint32_t>(ids->GetId(2)) });
  }

  const auto cellIds = idsIn(data->GetCellData(), cellIdsName, own.triangles.size());
  own.cells.assign(cellIds->GetPointer(0), cellIds->GetPointer(0) + own.triangles.size());
  const auto pointIds = idsIn(data->GetPointData(), pointIdsName, own.points.count);
  own.pointIds = vtkSmartPointer<vtkIdTypeArray>::New();
  own.pointIds->DeepCopy(pointIds);
  data->GetCellData()->RemoveArray(cellIdsName);
  data->GetPointData()->RemoveArray(pointIdsName);
  return part;
}

} // namespace lumitree::filters
