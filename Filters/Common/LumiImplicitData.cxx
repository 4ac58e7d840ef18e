// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiImplicitData.h"

#include "LumiQuadrics.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImplicitFunction.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <mutex>
#include <stdexcept>
#include <string>

namespace lumitree::filters
{
namespace
{

constexpr int superquadricSize = 18; // matrix, shift, scale, two roundnesses, alpha

/// Of the array ImplicitBox: the function whose values are sampled.
vtkInformationObjectBaseKey* functionKey()
{
  static vtkInformationObjectBaseKey* const key =
    vtkInformationObjectBaseKey::MakeKey("FUNCTION", "LumiImplicitData");
  return key;
}

class SampledFunction final : public ImplicitFunction
{
public:
  explicit SampledFunction(vtkImplicitFunction* function)
    : function_(function)
  {
  }

  [[nodiscard]] double value(const Vec3& x) const override
  {
    const std::lock_guard<std::mutex> lock(oneAtATime());
    return this->function_->FunctionValue(x.data());
  }

  [[nodiscard]] Vec3 gradient(const Vec3& x) const override
  {
    const std::lock_guard<std::mutex> lock(oneAtATime());
    Vec3 g;
    this->function_->FunctionGradient(x.data(), g.data());
    return g;
  }

private:
  static std::mutex& oneAtATime()
  {
    static std::mutex mutex;
    return mutex;
  }

  vtkSmartPointer<vtkImplicitFunction> function_;
};

template <class Array>
Array* addArray(vtkFieldData* fields, const char* name, int components, std::size_t tuples)
{
  const vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  fields->AddArray(array);
  return array;
}

template <class Array>
Array* arrayOf(vtkFieldData* fields, const char* name, int components)
{
  auto* const array = Array::SafeDownCast(fields->GetAbstractArray(name));
  if (fields->HasArray(name) && (!array || array->GetNumberOfComponents() != components))
  {
    throw std::invalid_argument(std::string("the field array ") + name + " must have " +
      std::to_string(components) + " components, of the type in the data model");
  }
  return array;
}

} // namespace

void writeTree(const ImplicitTree& tree, vtkFieldData* fields)
{
  auto* const steps = addArray<vtkIntArray>(fields, implicitStepsName, 2, tree.steps.size());
  for (std::size_t i = 0; i < tree.steps.size(); ++i)
  {
    const ImplicitTree::Step& step = tree.steps[i];
    const int tuple[2] = { static_cast<int>(step.operation), step.index };
    steps->SetTypedTuple(static_cast<vtkIdType>(i), tuple);
  }
  auto* const forms =
    addArray<vtkDoubleArray>(fields, implicitFormsName, formSize, tree.forms.size());
  for (std::size_t i = 0; i < tree.forms.size(); ++i)
  {
    putForm(tree.forms[i], forms->GetPointer(static_cast<vtkIdType>(i) * formSize));
  }
  auto* const superquadrics = addArray<vtkDoubleArray>(
    fields, implicitSuperquadricsName, superquadricSize, tree.superquadrics.size());
  for (std::size_t i = 0; i < tree.superquadrics.size(); ++i)
  {
    const Superquadric& s = tree.superquadrics[i];
    double* out = superquadrics->GetPointer(static_cast<vtkIdType>(i) * superquadricSize);
    for (const Vec3& row : { s.matrix[0], s.matrix[1], s.matrix[2], s.shift, s.scale,
           Vec3{ s.phiRoundness, s.thetaRoundness, s.alpha } })
    {
      out = std::copy(row.begin(), row.end(), out);
    }
  }
}

std::shared_ptr<const ImplicitTree> readTree(vtkFieldData* fields)
{
  auto* const steps = arrayOf<vtkIntArray>(fields, implicitStepsName, 2);
  if (!steps)
  {
    return nullptr;
  }
  auto tree = std::make_shared<ImplicitTree>();
  for (vtkIdType i = 0; i < steps->GetNumberOfTuples(); ++i)
  {
    tree->steps.push_back({ static_cast<ImplicitTree::Operation>(steps->GetTypedComponent(i, 0)),
      steps->GetTypedComponent(i, 1) });
  }
  auto* const forms = arrayOf<vtkDoubleArray>(fields, implicitFormsName, formSize);
  for (vtkIdType i = 0; forms && i < forms->GetNumberOfTuples(); ++i)
  {
    tree->forms.push_back(formOf(forms->GetPointer(i * formSize)));
  }
  auto* const superquadrics =
    arrayOf<vtkDoubleArray>(fields, implicitSuperquadricsName, superquadricSize);
  for (vtkIdType i = 0; superquadrics && i < superquadrics->GetNumberOfTuples(); ++i)
  {
    const double* in = superquadrics->GetPointer(i * superquadricSize);
    Superquadric s;
    Vec3 rest;
    for (Vec3* row : { &s.matrix[0], &s.matrix[1], &s.matrix[2], &s.shift, &s.scale, &rest })
    {
      std::copy(in, in + 3, row->begin());
      in += 3;
    }
    s.phiRoundness = rest[0];
    s.thetaRoundness = rest[1];
    s.alpha = rest[2];
    tree->superquadrics.push_back(s);
  }
  tree->check();
  return tree;
}

void writeImplicit(const Implicit& implicit, vtkImplicitFunction* sampled, vtkFieldData* fields)
{
  auto* const array = addArray<vtkDoubleArray>(fields, implicitBoxName, 7, 1);
  for (int k = 0; k < 3; ++k)
  {
    array->SetValue(2 * k, implicit.clip.lower[k]);
    array->SetValue(2 * k + 1, implicit.clip.upper[k]);
  }
  array->SetValue(6, implicit.step);
  if (sampled)
  {
    array->GetInformation()->Set(functionKey(), sampled);
  }
}

std::optional<Implicit> readImplicit(vtkFieldData* fields)
{
  auto* const array = arrayOf<vtkDoubleArray>(fields, implicitBoxName, 7);
  if (!array)
  {
    return std::nullopt;
  }
  if (array->GetNumberOfTuples() != 1)
  {
    throw std::invalid_argument("the field array ImplicitBox must have one tuple");
  }
  Implicit implicit;
  for (int k = 0; k < 3; ++k)
  {
    implicit.clip.lower[k] = array->GetValue(2 * k);
    implicit.clip.upper[k] = array->GetValue(2 * k + 1);
  }
  implicit.step = array->GetValue(6);
  if (const auto tree = readTree(fields))
  {
    implicit.function = functionOf(tree);
    return implicit;
  }
  auto* const function = array->HasInformation()
    ? vtkImplicitFunction::SafeDownCast(array->GetInformation()->Get(functionKey()))
    : nullptr;
  if (!function)
  {
    throw std::invalid_argument(
      "the function of a sampled implicit is not in the data: it does not "
      "outlive its process, nor go to another; make it there");
  }
  implicit.function = sampledFunction(function);
  return implicit;
}

std::shared_ptr<const ImplicitFunction> sampledFunction(vtkImplicitFunction* function)
{
  return std::make_shared<const SampledFunction>(function);
}

} // namespace lumitree::filters
