// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Rays_LumiArrays_h
#define Lumitree_Filters_Rays_LumiArrays_h

#include "vtkFieldData.h"
#include "vtkNew.h"

namespace lumitree::filters
{

/// Adds an array of that many tuples, replacing one of the same name; returns its memory, not yet
/// filled.
template <class Array>
typename Array::ValueType* addArray(
  vtkFieldData* data, const char* name, vtkIdType tuples, int components = 1)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  data->AddArray(array);
  return array->GetPointer(0);
}

} // namespace lumitree::filters

#endif
