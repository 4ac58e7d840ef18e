// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Rays_LumiArrays_h
#define Lumitree_Filters_Rays_LumiArrays_h

#include "LumiMemory.h"

#include "vtkAbstractArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"

namespace lumitree::filters
{

/// Gives an array memory for that many tuples, and returns it, not yet filled.
template <class Array>
typename Array::ValueType* makeRoom(Array* array, vtkIdType tuples, int components = 1)
{
  using Value = typename Array::ValueType;
  const vtkIdType size = tuples * components;
  auto* values = static_cast<Value*>(allocate(sizeof(Value) * static_cast<std::size_t>(size)));
  array->SetNumberOfComponents(components);
  array->SetArray(values, size, 0, vtkAbstractArray::VTK_DATA_ARRAY_FREE);
  return values;
}

/// Adds an array of that many tuples, replacing one of the same name; returns its memory, not yet
/// filled.
template <class Array>
typename Array::ValueType* addArray(
  vtkFieldData* data, const char* name, vtkIdType tuples, int components = 1)
{
  vtkNew<Array> array;
  array->SetName(name);
  typename Array::ValueType* values = makeRoom(array.Get(), tuples, components);
  data->AddArray(array);
  return values;
}

} // namespace lumitree::filters

#endif
