// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiVisits.h"

#include "LumiCast.h"
#include "LumiGather.h"

#include "Accel/Parallel.h"

#include "vtkCommunicator.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"

#include <algorithm>

namespace lumitree::filters
{

QueryReport Visits::cast(
  QueryKind query, const Accelerator& accelerator, const RayBatch& batch, const QueryOptions& given)
{
  constexpr std::size_t chunk = 8192;
  const Buffer<RayCounters> counters(batch.size);
  QueryOptions options = given;
  options.perRay = counters.data();
  options.perNode = this->perNode.data();
  const Cast answers(query, accelerator, batch, options);

  struct Sums
  {
    std::uint64_t nodes = 0;
    std::uint64_t cells = 0;
    std::uint64_t primitives = 0;
  };
  std::vector<Sums> sums((batch.size + chunk - 1) / chunk);
  parallelFor(batch.size, chunk, options.threads, nullptr,
    [&](std::size_t begin, std::size_t end)
    {
      Sums& sum = sums[begin / chunk];
      for (std::size_t i = begin; i < end; ++i)
      {
        sum.nodes += counters[i].nodes + counters[i].cells;
        sum.cells += counters[i].cells;
        sum.primitives += counters[i].primitives;
      }
    });
  this->rays += batch.size;
  for (const Sums& sum : sums)
  {
    this->nodesEntered += sum.nodes;
    this->cellsStepped += sum.cells;
    this->primitivesTested += sum.primitives;
  }
  return answers.report();
}

void Visits::sumOverRanks(vtkMultiProcessController* controller)
{
  if (!isDistributed(controller))
  {
    return;
  }
  std::uint64_t* const totals[] = { &this->rays, &this->nodesEntered, &this->cellsStepped,
    &this->primitivesTested, &this->failures };
  constexpr vtkIdType totalCount = 5;
  const auto nodes = static_cast<vtkIdType>(this->perNode.size());
  vtkNew<vtkIdTypeArray> mine;
  mine->SetNumberOfValues(nodes + totalCount);
  std::copy(this->perNode.begin(), this->perNode.end(), mine->GetPointer(0));
  for (vtkIdType i = 0; i < totalCount; ++i)
  {
    mine->SetValue(nodes + i, static_cast<vtkIdType>(*totals[i]));
  }
  vtkNew<vtkIdTypeArray> all;
  all->SetNumberOfValues(nodes + totalCount);
  controller->AllReduce(mine, all, vtkCommunicator::SUM_OP);
  std::copy_n(all->GetPointer(0), nodes, this->perNode.begin());
  for (vtkIdType i = 0; i < totalCount; ++i)
  {
    *totals[i] = static_cast<std::uint64_t>(all->GetValue(nodes + i));
  }
}

} // namespace lumitree::filters
