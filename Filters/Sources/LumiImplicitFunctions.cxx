// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiImplicitFunctions.h"

#include "LumiFunctionTree.h"
#include "LumiInterpolation.h"

#include "vtkBox.h"
#include "vtkCylinder.h"
#include "vtkImplicitFunction.h"
#include "vtkLinearTransform.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkQuadric.h"
#include "vtkSphere.h"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

namespace lumitree::filters
{
namespace
{

Vec3 vector(const double* x)
{
  return { x[0], x[1], x[2] };
}

Box common(const Box& a, const Box& b)
{
  Box box;
  for (int k = 0; k < 3; ++k)
  {
    box.lower[k] = std::max(a.lower[k], b.lower[k]);
    box.upper[k] = std::min(a.upper[k], b.upper[k]);
  }
  return box;
}

/// The box in the coordinates before its transform; nothing where its sides turn.
std::optional<Box> boxOf(vtkBox* function)
{
  double b[6];
  function->GetBounds(b);
  Box box = { { b[0], b[2], b[4] }, { b[1], b[3], b[5] } };
  vtkAbstractTransform* const transform = function->GetTransform();
  if (!transform)
  {
    return box;
  }
  auto* linear = vtkLinearTransform::SafeDownCast(transform);
  if (!linear)
  {
    return std::nullopt;
  }
  linear->Update();
  for (int i = 0; i < 3; ++i)
  {
    const auto element = [&](int j) { return linear->GetMatrix()->GetElement(i, j); };
    if (element((i + 1) % 3) != 0.0 || element((i + 2) % 3) != 0.0 || element(i) == 0.0)
    {
      return std::nullopt;
    }
    const double first = (box.lower[i] - element(3)) / element(i);
    const double second = (box.upper[i] - element(3)) / element(i);
    box.lower[i] = std::min(first, second);
    box.upper[i] = std::max(first, second);
  }
  return box;
}

/// The sides of a box, within another.
std::vector<Quadric> sidesOf(vtkBox* function, const Box& within)
{
  const std::optional<Box> own = boxOf(function);
  if (!own)
  {
    return {};
  }
  std::vector<Quadric> sides = Quadric::sides(*own);
  for (Quadric& side : sides)
  {
    side.clip = common(side.clip, within);
  }
  return sides;
}

/// The exact conversions; nothing where there is none.
std::vector<Quadric> byOwnNumbers(vtkImplicitFunction* function, const Box& box)
{
  // Subclasses may mean something else: only the classes themselves.
  const std::string name = function->GetClassName();
  if (name == "vtkBox" || name == "vtkPVBox")
  {
    return sidesOf(static_cast<vtkBox*>(function), box);
  }
  if (function->GetTransform())
  {
    return {};
  }
  if (name == "vtkSphere")
  {
    auto* sphere = static_cast<vtkSphere*>(function);
    const Quadric whole = Quadric::sphere(vector(sphere->GetCenter()), sphere->GetRadius());
    return { Quadric::inBox(whole.form, whole.clip.empty() ? Box{} : common(box, whole.clip)) };
  }
  if (name == "vtkPlane")
  {
    auto* plane = static_cast<vtkPlane*>(function);
    return { Quadric::plane(vector(plane->GetOrigin()), vector(plane->GetNormal()), box) };
  }
  if (name == "vtkCylinder")
  {
    auto* cylinder = static_cast<vtkCylinder*>(function);
    const Vec3 centre = vector(cylinder->GetCenter());
    const Vec3 axis = vector(cylinder->GetAxis());
    return { Quadric::inBox(
      Quadric::cylinder(centre, centre + axis, cylinder->GetRadius()).form, box) };
  }
  if (name == "vtkQuadric")
  {
    QuadricForm form;
    const double* coefficients = static_cast<vtkQuadric*>(function)->GetCoefficients();
    std::copy(coefficients, coefficients + 10, form.coefficients.begin());
    return { Quadric::inBox(form, box) };
  }
  return {};
}

} // namespace

FunctionBodies bodiesOf(vtkImplicitFunction* function, const Box& box, double step)
{
  FunctionBodies bodies;
  bodies.quadrics = byOwnNumbers(function, box);
  if (!bodies.quadrics.empty())
  {
    return bodies;
  }
  if (isOfSecondDegree(function->GetClassName()))
  {
    const Interpolation interpolation(
      [&](const Vec3& x) { return function->FunctionValue(x.data()); }, box);
    if (interpolation.fits())
    {
      bodies.quadrics = { Quadric::inBox(interpolation.form, box) };
      return bodies;
    }
  }
  bodies.tree = treeOf(function, box);
  if (bodies.tree && bodies.tree->isSignOfForms())
  {
    bodies.quadrics = Quadric::zerosOf(bodies.tree, box);
    return bodies;
  }
  bodies.guarantee = bodies.tree ? Guarantee::Intervals : Guarantee::Sampled;
  bodies.implicit =
    Implicit{ bodies.tree ? functionOf(bodies.tree) : sampledFunction(function), box, step };
  return bodies;
}

} // namespace lumitree::filters
