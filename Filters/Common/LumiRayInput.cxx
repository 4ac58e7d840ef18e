// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiRayInput.h"

#include "LumiPoints.h"
#include "LumiReport.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace lumitree::filters
{
namespace
{

constexpr const char* defaultDirection = "RayDirection";

/// The point array of that name, checked; null when there is none.
vtkDataArray* findArray(vtkDataSet* rays, const std::string& name, int components)
{
  vtkAbstractArray* any = rays->GetPointData()->GetAbstractArray(name.c_str());
  if (!any)
  {
    return nullptr;
  }
  vtkDataArray* array = vtkDataArray::SafeDownCast(any);
  if (!array || (array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE) ||
    array->GetNumberOfComponents() != components ||
    array->GetNumberOfTuples() != rays->GetNumberOfPoints())
  {
    throw std::invalid_argument("the array " + name + " must be float or double, with " +
      std::to_string(components) + (components == 1 ? " component" : " components") +
      " and a tuple for each point");
  }
  return array;
}

ArrayView read(vtkDataArray* array, RayInput& result)
{
  const Values values = valuesOf(array);
  result.owners.push_back(values.owner);
  return values.view;
}

ArrayView keep(std::vector<double> values, RayInput& result)
{
  auto owner = std::make_shared<const std::vector<double>>(std::move(values));
  result.owners.push_back(owner);
  return ArrayView(owner->data());
}

ArrayView readPoints(vtkDataSet* rays, RayInput& result)
{
  if (vtkPointSet* points = vtkPointSet::SafeDownCast(rays))
  {
    return read(points->GetPoints()->GetData(), result);
  }
  std::vector<double> xyz(static_cast<std::size_t>(3 * rays->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < rays->GetNumberOfPoints(); ++i)
  {
    rays->GetPoint(i, xyz.data() + 3 * i);
  }
  return keep(std::move(xyz), result);
}

void addSegments(vtkIdList* points, vtkIdType cell, RayInput& result)
{
  for (vtkIdType k = 1; k < points->GetNumberOfIds(); ++k)
  {
    result.segmentPoints.push_back({ points->GetId(k - 1), points->GetId(k) });
    result.segmentCells.push_back(cell);
  }
}

/// Whether there are line cells; their segments are in result.
bool findSegments(vtkDataSet* rays, RayInput& result)
{
  bool any = false;
  vtkNew<vtkIdList> points;
  if (vtkPolyData* data = vtkPolyData::SafeDownCast(rays))
  {
    const vtkIdType before = data->GetNumberOfVerts();
    for (vtkIdType i = 0; i < data->GetNumberOfLines(); ++i)
    {
      any = true;
      data->GetLines()->GetCellAtId(i, points);
      addSegments(points, before + i, result);
    }
    return any;
  }
  for (vtkIdType i = 0; i < rays->GetNumberOfCells(); ++i)
  {
    const int type = rays->GetCellType(i);
    if (type == VTK_LINE || type == VTK_POLY_LINE)
    {
      any = true;
      rays->GetCellPoints(i, points);
      addSegments(points, i, result);
    }
  }
  return any;
}

void readSegments(vtkDataSet* rays, double tMin, double tMax, RayInput& result)
{
  std::vector<double> origins;
  std::vector<double> directions;
  origins.reserve(3 * result.segmentPoints.size());
  directions.reserve(3 * result.segmentPoints.size());
  for (const auto& [first, second] : result.segmentPoints)
  {
    if (std::min(first, second) < 0 || std::max(first, second) >= rays->GetNumberOfPoints())
    {
      throw std::invalid_argument("a line uses a point that does not exist");
    }
    double p[3];
    double q[3];
    rays->GetPoint(first, p);
    rays->GetPoint(second, q);
    for (int k = 0; k < 3; ++k)
    {
      origins.push_back(p[k]);
      directions.push_back(q[k] - p[k]);
    }
  }
  vtkPointSet* points = vtkPointSet::SafeDownCast(rays);
  result.doublePoints = !points || points->GetPoints()->GetDataType() != VTK_FLOAT;
  result.perCell = true;
  result.size = static_cast<vtkIdType>(result.segmentPoints.size());
  result.batch.origins = keep(std::move(origins), result);
  result.batch.directions = keep(std::move(directions), result);
  result.batch.tMin = std::max(tMin, 0.0);
  result.batch.tMax = std::min(tMax, 1.0);
}

void readPointRays(
  vtkDataSet* rays, vtkDataArray* origin, vtkDataArray* direction, RayInput& result)
{
  result.size = rays->GetNumberOfPoints();
  result.batch.origins = origin ? read(origin, result) : readPoints(rays, result);
  result.batch.directions = read(direction, result);
  result.doublePoints = result.batch.origins.type == ArrayView::Scalar::Double;
  if (vtkDataArray* limits = findArray(rays, "RayTMin", 1))
  {
    result.batch.tMins = read(limits, result);
  }
  if (vtkDataArray* limits = findArray(rays, "RayTMax", 1))
  {
    result.batch.tMaxs = read(limits, result);
  }
}

void readAny(vtkDataSet* rays, const std::string& name, double tMin, double tMax, RayInput& result)
{
  if (!rays)
  {
    throw std::invalid_argument("there is no dataset of rays");
  }
  result.batch.tMin = tMin;
  result.batch.tMax = tMax;
  if (rays->GetNumberOfPoints() == 0)
  {
    return;
  }
  vtkDataArray* origin = findArray(rays, "RayOrigin", 3);
  vtkDataArray* standard = origin ? findArray(rays, defaultDirection, 3) : nullptr;
  vtkDataArray* direction = standard ? standard : findArray(rays, name, 3);
  if (direction)
  {
    readPointRays(rays, standard ? origin : nullptr, direction, result);
  }
  else if (name == defaultDirection && findSegments(rays, result))
  {
    readSegments(rays, tMin, tMax, result);
  }
  else
  {
    throw std::invalid_argument(
      "there is no point array " + name + (name == defaultDirection ? " and no line cell" : ""));
  }
}

} // namespace

bool readRays(vtkDataSet* rays, const char* directionArray, double tMin, double tMax,
  RayInput& result, vtkAlgorithm* reporter)
{
  result = {};
  const bool named = directionArray && *directionArray;
  try
  {
    readAny(rays, named ? directionArray : defaultDirection, tMin, tMax, result);
  }
  catch (const std::exception& error)
  {
    result = {};
    reportError(reporter, std::string("The rays cannot be used: ") + error.what());
    return false;
  }
  result.batch.size = static_cast<std::size_t>(result.size);
  return true;
}

} // namespace lumitree::filters
