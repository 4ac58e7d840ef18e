// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiSurfaceCost.h"

#include "LumiArrays.h"
#include "LumiGather.h"
#include "LumiLeafCopies.h"

#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <map>

namespace lumitree::filters
{
namespace
{

/// The arrays of one dataset.
struct CostArrays
{
  vtkIdType cells = 0;
  vtkIdType* tests = nullptr;
  vtkIdType* hits = nullptr;
  vtkIdType* references = nullptr;

  CostArrays() = default;
  explicit CostArrays(vtkDataSet* data)
    : cells(data->GetNumberOfCells())
  {
    vtkCellData* cellData = data->GetCellData();
    this->tests = addArray<vtkIdTypeArray>(cellData, "RayTests", this->cells);
    this->hits = addArray<vtkIdTypeArray>(cellData, "RayHits", this->cells);
    this->references = addArray<vtkIdTypeArray>(cellData, "LeafReferences", this->cells);
    for (vtkIdType* array : { this->tests, this->hits, this->references })
    {
      std::fill_n(array, this->cells, 0);
    }
    cellData->SetActiveScalars("RayTests");
  }
};

/// Calls visit(dataset, flat index) for each dataset.
template <class Visit>
void forEachDataset(vtkDataObject* object, Visit&& visit)
{
  if (auto* data = vtkDataSet::SafeDownCast(object))
  {
    visit(data, 0);
  }
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(object))
  {
    const auto iterator = vtk::TakeSmartPointer(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      if (auto* leaf = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject()))
      {
        visit(leaf, static_cast<std::int64_t>(iterator->GetCurrentFlatIndex()));
      }
    }
  }
}

} // namespace

void sumOverRanks(std::vector<PrimitiveCounters>& counters, vtkMultiProcessController* controller)
{
  if (!isDistributed(controller))
  {
    return;
  }
  vtkNew<vtkIdTypeArray> mine;
  mine->SetNumberOfValues(static_cast<vtkIdType>(2 * counters.size()));
  vtkNew<vtkIdTypeArray> all;
  all->SetNumberOfValues(mine->GetNumberOfValues());
  for (std::size_t i = 0; i < counters.size(); ++i)
  {
    mine->SetValue(static_cast<vtkIdType>(2 * i), static_cast<vtkIdType>(counters[i].tested));
    mine->SetValue(static_cast<vtkIdType>(2 * i + 1), static_cast<vtkIdType>(counters[i].hit));
  }
  controller->AllReduce(mine, all, vtkCommunicator::SUM_OP);
  for (std::size_t i = 0; i < counters.size(); ++i)
  {
    counters[i].tested = static_cast<std::uint64_t>(all->GetValue(static_cast<vtkIdType>(2 * i)));
    counters[i].hit = static_cast<std::uint64_t>(all->GetValue(static_cast<vtkIdType>(2 * i + 1)));
  }
}

void copySurface(vtkDataObject* input, vtkDataObject* output)
{
  if (input) // else a rank without data
  {
    copyLeaves(input, output);
  }
}

void addSurfaceCost(const SurfaceInput& surface, const Accelerator& accelerator,
  const std::vector<PrimitiveCounters>& counters, int process, vtkDataObject* output)
{
  std::map<std::int64_t, CostArrays> arrays;
  forEachDataset(
    output, [&](vtkDataSet* data, std::int64_t index) { arrays[index] = CostArrays(data); });

  std::vector<std::uint32_t> references(counters.size(), 0);
  for (const PrimitiveId primitive : accelerator.hierarchy().references)
  {
    ++references[primitive];
  }
  for (std::size_t leaf = 0; leaf < surface.leaves.size(); ++leaf)
  {
    const auto found = arrays.find(surface.leaves[leaf].compositeIndex);
    if (surface.leaves[leaf].process != process || found == arrays.end())
    {
      continue;
    }
    const CostArrays& cost = found->second;
    const PrimitiveId end = leaf + 1 < surface.leaves.size()
      ? surface.firstPrimitive[leaf + 1]
      : static_cast<PrimitiveId>(counters.size());
    for (PrimitiveId i = surface.firstPrimitive[leaf]; i < end; ++i)
    {
      const auto cell = static_cast<vtkIdType>(surface.surface->source(i).cell);
      if (cell >= 0 && cell < cost.cells)
      {
        cost.tests[cell] += static_cast<vtkIdType>(counters[i].tested);
        cost.hits[cell] += static_cast<vtkIdType>(counters[i].hit);
        cost.references[cell] += references[i];
      }
    }
  }
}

} // namespace lumitree::filters
