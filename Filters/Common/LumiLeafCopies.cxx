// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiLeafCopies.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"

namespace lumitree::filters
{

std::vector<LeafCopy> copyLeaves(vtkDataObject* input, vtkDataObject* output)
{
  std::vector<LeafCopy> leaves;
  auto* from = vtkCompositeDataSet::SafeDownCast(input);
  if (!from)
  {
    output->ShallowCopy(input);
    leaves.push_back({ vtkDataSet::SafeDownCast(output), 0 });
    return leaves;
  }
  auto* to = vtkCompositeDataSet::SafeDownCast(output);
  to->CopyStructure(from);
  to->GetFieldData()->PassData(from->GetFieldData());
  const auto iterator = vtk::TakeSmartPointer(from->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkDataObject* object = iterator->GetCurrentDataObject();
    const auto copy = vtk::TakeSmartPointer(object->NewInstance());
    copy->ShallowCopy(object);
    to->SetDataSet(iterator, copy);
    if (auto* data = vtkDataSet::SafeDownCast(copy))
    {
      leaves.push_back({ data, static_cast<std::int64_t>(iterator->GetCurrentFlatIndex()) });
    }
  }
  return leaves;
}

} // namespace lumitree::filters
