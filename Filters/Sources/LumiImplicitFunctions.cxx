// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiImplicitFunctions.h"

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

/// How far a function of second degree may be from its own values, in parts of the largest.
constexpr double tolerance = 1e-10;

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

/// What is of second degree everywhere. A function that only happens to be so at the points tried
/// must not be taken for one.
bool isQuadric(vtkImplicitFunction* function)
{
  const std::string name = function->GetClassName();
  return name == "vtkSphere" || name == "vtkPlane" || name == "vtkCylinder" || name == "vtkCone" ||
    name == "vtkQuadric" || name == "vtkPVPlane" || name == "vtkPVCylinder";
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

/// The form of second degree with the function's values in ten points around the middle of a box.
class Interpolation
{
public:
  Interpolation(vtkImplicitFunction* function, const Box& box)
    : function_(function)
    , box_(box)
    , centre_(box.centre())
  {
    const double size = 0.5 * box.size()[box.longestAxis()];
    // A power of two: no coefficient is rounded by it.
    this->step_ = size > 0.0 ? std::exp2(std::floor(std::log2(size))) : 1.0;
    const double here = this->at({ 0, 0, 0 });
    const double h = this->step_;
    Vec3 ahead;
    this->form.centre = this->centre_;
    auto& a = this->form.coefficients;
    for (int k = 0; k < 3; ++k)
    {
      Vec3 direction = { 0, 0, 0 };
      direction[k] = 1.0;
      ahead[k] = this->at(direction);
      const double behind = this->at(-1.0 * direction);
      a[k] = ((ahead[k] - here) + (behind - here)) / 2 / (h * h);
      a[6 + k] = (ahead[k] - behind) / 2 / h;
    }
    a[9] = here;
    for (int k = 0; k < 3; ++k)
    {
      const int next = (k + 1) % 3;
      Vec3 direction = { 0, 0, 0 };
      direction[k] = direction[next] = 1.0;
      const double mixed = ((this->at(direction) - ahead[k]) - (ahead[next] - here)) / (h * h);
      a[3 + k] = mixed;
    }
  }

  /// Whether the form has the function's values elsewhere, too.
  [[nodiscard]] bool fits() const
  {
    double largest = 0.0;
    double worst = 0.0;
    constexpr int n = 6; // positions an axis
    for (int i = 0; i < n * n * n; ++i)
    {
      const int index[3] = { i % n, i / n % n, i / (n * n) };
      Vec3 x;
      for (int k = 0; k < 3; ++k)
      {
        const double share = static_cast<double>(index[k]) / (n - 1);
        x[k] = (1.0 - share) * this->box_.lower[k] + share * this->box_.upper[k];
      }
      const double expected = valueAt(this->form, x);
      const double value = this->function_->FunctionValue(x.data());
      largest = std::max(largest, std::fabs(value));
      const double error = std::fabs(value - expected);
      worst = error > worst || std::isnan(error) ? error : worst;
    }
    return worst <= tolerance * largest;
  }

  QuadricForm form;

private:
  [[nodiscard]] double at(const Vec3& direction) const
  {
    Vec3 x = this->centre_ + this->step_ * direction;
    return this->function_->FunctionValue(x.data());
  }

  vtkImplicitFunction* function_;
  Box box_;
  Vec3 centre_;
  double step_ = 1.0;
};

} // namespace

std::vector<Quadric> quadricsOf(vtkImplicitFunction* function, const Box& box)
{
  std::vector<Quadric> exact = byOwnNumbers(function, box);
  if (!exact.empty())
  {
    return exact;
  }
  if (isQuadric(function))
  {
    const Interpolation interpolation(function, box);
    if (interpolation.fits())
    {
      return { Quadric::inBox(interpolation.form, box) };
    }
  }
  throw std::invalid_argument(std::string("a ") + function->GetClassName() +
    (function->GetTransform() ? " with this transform" : "") +
    " cannot be met exactly; contour it, and give the mesh");
}

} // namespace lumitree::filters
