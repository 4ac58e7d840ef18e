// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiLeaves.h"

#include "LumiPoints.h"
#include "LumiQuadrics.h"

#include "vtkCellArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <stdexcept>
#include <string>

namespace lumitree::filters
{
namespace
{

vtkDataSet* datasetOf(vtkDataObject* object)
{
  vtkDataSet* data = vtkDataSet::SafeDownCast(object);
  if (!data)
  {
    throw std::invalid_argument(std::string("a surface cannot be taken from a ") +
      object->GetClassName() + " (a dataset, or a composite of datasets, is needed)");
  }
  return data;
}

void add(GeometryKey& key, const void* pointer)
{
  key.push_back(reinterpret_cast<std::uintptr_t>(pointer));
}

void addArray(GeometryKey& key, vtkDataArray* array)
{
  add(key, array);
  if (array)
  {
    key.push_back(array->GetMTime());
    key.push_back(static_cast<std::uint64_t>(array->GetNumberOfValues()));
    add(key, viewOf(array).data);
  }
}

void addCells(GeometryKey& key, vtkCellArray* cells)
{
  add(key, cells);
  if (cells)
  {
    key.push_back(cells->GetMTime());
    addArray(key, cells->GetOffsetsArray());
    addArray(key, cells->GetConnectivityArray());
  }
}

void addPolyData(GeometryKey& key, vtkPolyData* data)
{
  vtkPoints* points = data->GetPoints();
  add(key, points);
  if (points)
  {
    key.push_back(points->GetMTime());
    addArray(key, points->GetData());
  }
  // Vertices and lines shift the ids of polygons; their number is all that matters.
  key.push_back(static_cast<std::uint64_t>(data->GetNumberOfVerts()));
  key.push_back(static_cast<std::uint64_t>(data->GetNumberOfLines()));
  addCells(key, data->GetNumberOfPolys() > 0 ? data->GetPolys() : nullptr);
  addCells(key, data->GetNumberOfStrips() > 0 ? data->GetStrips() : nullptr);
  addArray(key, data->GetCellGhostArray());
  addArray(key, data->GetPointGhostArray());
  if (holdsQuadrics(data))
  {
    for (const char* name : { quadricFormName, quadricBoxName, quadricCutsName, quadricBoundName,
           implicitStepsName, implicitFormsName, implicitSuperquadricsName, implicitBoxName })
    {
      addArray(key, vtkDataArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name)));
    }
  }
}

} // namespace

std::vector<InputLeaf> leavesOf(vtkDataObject* input)
{
  std::vector<InputLeaf> leaves;
  vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    if (input)
    {
      leaves.push_back({ datasetOf(input), 0 });
    }
    return leaves;
  }
  const auto nodes = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  nodes->SkipEmptyNodesOn();
  for (nodes->InitTraversal(); !nodes->IsDoneWithTraversal(); nodes->GoToNextItem())
  {
    vtkDataObject* object = nodes->GetCurrentDataObject();
    if (!vtkTable::SafeDownCast(object))
    {
      leaves.push_back(
        { datasetOf(object), static_cast<std::int64_t>(nodes->GetCurrentFlatIndex()) });
    }
  }
  return leaves;
}

GeometryKey keyOf(const std::vector<InputLeaf>& leaves)
{
  GeometryKey key;
  for (const InputLeaf& leaf : leaves)
  {
    key.push_back(static_cast<std::uint64_t>(leaf.compositeIndex));
    if (vtkPolyData* polygons = vtkPolyData::SafeDownCast(leaf.data))
    {
      addPolyData(key, polygons);
    }
    else
    {
      add(key, leaf.data);
      key.push_back(leaf.data->GetMTime());
    }
  }
  return key;
}

} // namespace lumitree::filters
