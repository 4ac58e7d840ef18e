// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiPoints.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace lumitree::filters
{
namespace
{

/// Of components that lie each for itself, without a virtual call for each value.
template <class T>
Values woven(vtkSOADataArrayTemplate<T>* array)
{
  const auto tuples = static_cast<std::size_t>(array->GetNumberOfTuples());
  const auto components = static_cast<std::size_t>(array->GetNumberOfComponents());
  auto values = std::make_shared<std::vector<T>>(tuples * components);
  for (std::size_t i = 0; i < tuples; ++i)
  {
    for (std::size_t k = 0; k < components; ++k)
    {
      (*values)[i * components + k] =
        array->GetTypedComponent(static_cast<vtkIdType>(i), static_cast<int>(k));
    }
  }
  return { ArrayView(static_cast<const T*>(values->data())), values };
}

template <class T>
Values copyOf(vtkDataArray* array)
{
  if (auto* apart = vtkSOADataArrayTemplate<T>::FastDownCast(array))
  {
    return woven(apart);
  }
  const vtkIdType tuples = array->GetNumberOfTuples();
  const int components = array->GetNumberOfComponents();
  auto values = std::make_shared<std::vector<T>>();
  values->reserve(static_cast<std::size_t>(tuples * components));
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    for (int k = 0; k < components; ++k)
    {
      values->push_back(static_cast<T>(array->GetComponent(i, k)));
    }
  }
  return { ArrayView(static_cast<const T*>(values->data())), values };
}

} // namespace

ArrayView viewOf(vtkDataArray* array)
{
  if (auto* doubles = vtkAOSDataArrayTemplate<double>::FastDownCast(array))
  {
    return ArrayView(static_cast<const double*>(doubles->GetPointer(0)));
  }
  if (auto* floats = vtkAOSDataArrayTemplate<float>::FastDownCast(array))
  {
    return ArrayView(static_cast<const float*>(floats->GetPointer(0)));
  }
  return {};
}

Values valuesOf(vtkDataArray* array)
{
  if (const ArrayView view = viewOf(array))
  {
    const vtkSmartPointer<vtkDataArray> kept = array;
    return { view, std::shared_ptr<const void>(view.data, [kept](const void*) {}) };
  }
  return array->GetDataType() == VTK_FLOAT ? copyOf<float>(array) : copyOf<double>(array);
}

PointArray pointsOf(vtkDataArray* array)
{
  PointArray points;
  if (array && array->GetNumberOfTuples() > 0)
  {
    const Values values = valuesOf(array);
    points.values = values.view;
    points.count = static_cast<std::size_t>(array->GetNumberOfTuples());
    points.owner = values.owner;
  }
  return points;
}

} // namespace lumitree::filters
