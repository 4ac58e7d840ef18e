// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiGather.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#include <stdexcept>

namespace lumitree::filters
{

bool isDistributed(vtkMultiProcessController* controller)
{
  return controller && controller->GetNumberOfProcesses() > 1;
}

long long largestOfAll(vtkMultiProcessController* controller, long long value)
{
  long long largest = value;
  if (isDistributed(controller))
  {
    controller->AllReduce(&value, &largest, 1, vtkCommunicator::MAX_OP);
  }
  return largest;
}

std::vector<GatheredObject> gatherObjects(vtkMultiProcessController* controller,
  const std::vector<vtkSmartPointer<vtkDataObject>>& mine, vtkDataObject* prototype)
{
  std::vector<GatheredObject> all;
  if (!isDistributed(controller))
  {
    for (const vtkSmartPointer<vtkDataObject>& object : mine)
    {
      all.push_back({ object, 0 });
    }
    return all;
  }

  const int ranks = controller->GetNumberOfProcesses();
  const auto count = static_cast<long long>(mine.size());
  std::vector<long long> counts(static_cast<std::size_t>(ranks), 0);
  bool failed = !controller->AllGather(&count, counts.data(), 1);
  for (int rank = 0; rank < ranks; ++rank)
  {
    for (long long i = 0; i < counts[static_cast<std::size_t>(rank)]; ++i)
    {
      const bool own = rank == controller->GetLocalProcessId();
      const auto object = own ? mine[static_cast<std::size_t>(i)]
                              : vtkSmartPointer<vtkDataObject>::Take(prototype->NewInstance());
      // Every rank goes through all of them, failed or not: a rank that left would block the
      // others.
      failed = !controller->Broadcast(object, rank) || failed;
      all.push_back({ object, rank });
    }
  }
  if (largestOfAll(controller, failed) != 0)
  {
    throw std::runtime_error("gathering data from all ranks failed");
  }
  return all;
}

} // namespace lumitree::filters
