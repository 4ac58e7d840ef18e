// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiLeafCopies_h
#define LumiLeafCopies_h

#include "LumitreeFiltersCommonModule.h"

#include "vtkDataSet.h"
#include "vtkLumiABI.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <vector>

namespace lumitree::filters
{

/// A dataset of the output: a shallow copy of one of the input.
struct LeafCopy
{
  vtkSmartPointer<vtkDataSet> data;
  std::int64_t compositeIndex = 0;
};

/// Copies a dataset or a composite to an output of the same type, all but its values, and lists the
/// datasets. Tables inside a composite are copied and not listed.
LUMITREEFILTERSCOMMON_EXPORT std::vector<LeafCopy> copyLeaves(
  vtkDataObject* input, vtkDataObject* output);

} // namespace lumitree::filters
#endif
