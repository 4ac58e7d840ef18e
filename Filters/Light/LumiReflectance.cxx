// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiReflectance.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"

#include <stdexcept>

namespace lumitree::filters
{

std::vector<double> readReflectances(const SurfaceInput& surface, double otherwise)
{
  std::vector<vtkDataArray*> arrays;
  bool some = false;
  for (const SurfaceLeaf& leaf : surface.leaves)
  {
    vtkDataArray* array = leaf.data->GetCellData()->GetArray("Reflectance");
    if (array && array->GetNumberOfComponents() != 1)
    {
      throw std::runtime_error("The cell array \"Reflectance\" must have one component.");
    }
    arrays.push_back(array);
    some = some || array;
  }
  std::vector<double> result;
  if (!some)
  {
    return result;
  }
  const auto count = static_cast<PrimitiveId>(surface.surface->size());
  result.reserve(count);
  for (PrimitiveId i = 0; i < count; ++i)
  {
    vtkDataArray* array = arrays[surface.leafOf(i)];
    const double value = array ? array->GetComponent(surface.leafCellId(i), 0) : otherwise;
    if (!(value >= 0.0 && value <= 1.0))
    {
      throw std::runtime_error("The cell array \"Reflectance\" must be 0 to 1 everywhere.");
    }
    result.push_back(value);
  }
  return result;
}

} // namespace lumitree::filters
