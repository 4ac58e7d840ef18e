// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiFunctionTree.h"

#include "LumiInterpolation.h"

#include "vtkBox.h"
#include "vtkCollection.h"
#include "vtkCylinder.h"
#include "vtkImplicitBoolean.h"
#include "vtkImplicitFunctionCollection.h"
#include "vtkLinearTransform.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlanes.h"
#include "vtkQuadric.h"
#include "vtkSphere.h"
#include "vtkSuperquadric.h"

#include "Accel/Quadric.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace lumitree::filters
{
namespace
{

using Operation = ImplicitTree::Operation;

Vec3 vector(const double* x)
{
  return { x[0], x[1], x[2] };
}

/// From coordinates of the box to those of a function.
struct Map
{
  std::array<Vec3, 3> matrix = { Vec3{ 1, 0, 0 }, Vec3{ 0, 1, 0 }, Vec3{ 0, 0, 1 } };
  Vec3 shift = { 0, 0, 0 };
  bool identity = true;

  [[nodiscard]] Vec3 operator()(const Vec3& x) const
  {
    return Vec3{ dot(this->matrix[0], x), dot(this->matrix[1], x), dot(this->matrix[2], x) } +
      this->shift;
  }

  /// n · matrix
  [[nodiscard]] Vec3 back(const Vec3& n) const
  {
    return n[0] * this->matrix[0] + n[1] * this->matrix[1] + n[2] * this->matrix[2];
  }
};

class TreeMaker
{
public:
  explicit TreeMaker(const Box& box)
    : box_(box)
  {
  }

  /// False where the function is none of those known.
  bool add(vtkImplicitFunction* function, Map map)
  {
    if (vtkAbstractTransform* const transform = function->GetTransform())
    {
      auto* const linear = vtkLinearTransform::SafeDownCast(transform);
      if (!linear)
      {
        return false;
      }
      linear->Update();
      map = composed(linear->GetMatrix(), map);
    }
    // Subclasses may mean something else: only the classes themselves.
    const std::string name = function->GetClassName();
    if (name == "vtkImplicitBoolean")
    {
      return this->addBoolean(static_cast<vtkImplicitBoolean*>(function), map);
    }
    if (name == "vtkBox" || name == "vtkPVBox")
    {
      return this->addBox(static_cast<vtkBox*>(function), map);
    }
    if (name == "vtkPlanes")
    {
      return this->addPlanes(static_cast<vtkPlanes*>(function), map);
    }
    if (name == "vtkSuperquadric")
    {
      return this->addSuperquadric(static_cast<vtkSuperquadric*>(function), map);
    }
    if (name == "vtkPlane" || name == "vtkPVPlane")
    {
      auto* plane = static_cast<vtkPlane*>(function);
      this->addPlane(vector(plane->GetOrigin()), vector(plane->GetNormal()), map);
      return true;
    }
    return this->addForm(function, name, map);
  }

  ImplicitTree tree;

private:
  static Map composed(vtkMatrix4x4* matrix, const Map& inner)
  {
    Map map;
    map.identity = false;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const int row = static_cast<int>(i);
      const Vec3 own = { matrix->GetElement(row, 0), matrix->GetElement(row, 1),
        matrix->GetElement(row, 2) };
      map.matrix[i] = inner.back(own);
      map.shift[i] = dot(own, inner.shift) + matrix->GetElement(row, 3);
    }
    return map;
  }

  void push(const QuadricForm& form)
  {
    this->tree.steps.push_back(
      { Operation::Form, static_cast<std::int32_t>(this->tree.forms.size()) });
    this->tree.forms.push_back(form);
  }

  void join(Operation operation) { this->tree.steps.push_back({ operation, 0 }); }

  void addPlane(const Vec3& point, const Vec3& normal, const Map& map)
  {
    if (map.identity)
    {
      this->push(Quadric::plane(point, normal, Box{}).form);
      return;
    }
    QuadricForm form;
    form.centre = this->box_.centre();
    const Vec3 n = map.back(normal);
    std::copy(n.begin(), n.end(), form.coefficients.begin() + 6);
    form.coefficients[9] = dot(normal, map(form.centre) - point);
    this->push(form);
  }

  bool addBox(vtkBox* function, const Map& map)
  {
    double b[6];
    function->GetBounds(b);
    for (int side = 0; side < 6; ++side)
    {
      Vec3 normal = { 0, 0, 0 };
      normal[side / 2] = side % 2 == 0 ? -1.0 : 1.0;
      Vec3 point = { 0, 0, 0 };
      point[side / 2] = b[side];
      this->addPlane(point, normal, map);
      if (side > 0)
      {
        this->join(Operation::Maximum);
      }
    }
    return true;
  }

  bool addPlanes(vtkPlanes* function, const Map& map)
  {
    const vtkNew<vtkPlane> plane;
    for (int i = 0; i < function->GetNumberOfPlanes(); ++i)
    {
      function->GetPlane(i, plane);
      this->addPlane(vector(plane->GetOrigin()), vector(plane->GetNormal()), map);
      if (i > 0)
      {
        this->join(Operation::Maximum);
      }
    }
    return function->GetNumberOfPlanes() > 0;
  }

  bool addSuperquadric(vtkSuperquadric* function, const Map& map)
  {
    Superquadric s;
    s.matrix = map.matrix;
    s.shift = map.shift - vector(function->GetCenter());
    s.phiRoundness = function->GetPhiRoundness();
    s.thetaRoundness = function->GetThetaRoundness();
    const double size = function->GetSize();
    s.alpha = function->GetToroidal() ? 1.0 / function->GetThickness() : 0.0;
    s.scale =
      (size / (function->GetToroidal() ? s.alpha + 1.0 : 1.0)) * vector(function->GetScale());
    this->tree.steps.push_back(
      { Operation::Superquadric, static_cast<std::int32_t>(this->tree.superquadrics.size()) });
    this->tree.superquadrics.push_back(s);
    return true;
  }

  bool addBoolean(vtkImplicitBoolean* function, const Map& map)
  {
    vtkImplicitFunctionCollection* const operands = function->GetFunction();
    vtkCollectionSimpleIterator iterator;
    operands->InitTraversal(iterator);
    const int type = function->GetOperationType();
    bool first = true;
    while (vtkImplicitFunction* operand = operands->GetNextImplicitFunction(iterator))
    {
      if (!this->add(operand, map))
      {
        return false;
      }
      if (type == vtkImplicitBoolean::VTK_UNION_OF_MAGNITUDES)
      {
        this->join(Operation::Magnitude);
      }
      if (!first && type == vtkImplicitBoolean::VTK_DIFFERENCE)
      {
        this->join(Operation::Negation);
      }
      if (!first)
      {
        const bool union_ = type == vtkImplicitBoolean::VTK_UNION ||
          type == vtkImplicitBoolean::VTK_UNION_OF_MAGNITUDES;
        this->join(union_ ? Operation::Minimum : Operation::Maximum);
      }
      first = false;
    }
    if (first)
    {
      throw std::invalid_argument("a vtkImplicitBoolean has no functions");
    }
    return true;
  }

  /// What is of second degree everywhere: by its own numbers, or by its values.
  bool addForm(vtkImplicitFunction* function, const std::string& name, const Map& map)
  {
    if (map.identity && name == "vtkSphere")
    {
      auto* sphere = static_cast<vtkSphere*>(function);
      this->push(Quadric::sphere(vector(sphere->GetCenter()), sphere->GetRadius()).form);
      return sphere->GetRadius() > 0.0;
    }
    if (map.identity && name == "vtkQuadric")
    {
      QuadricForm form;
      std::copy_n(
        static_cast<vtkQuadric*>(function)->GetCoefficients(), 10, form.coefficients.begin());
      this->push(form);
      return true;
    }
    if (map.identity && name == "vtkCylinder")
    {
      auto* cylinder = static_cast<vtkCylinder*>(function);
      const Vec3 centre = vector(cylinder->GetCenter());
      this->push(
        Quadric::cylinder(centre, centre + vector(cylinder->GetAxis()), cylinder->GetRadius())
          .form);
      return cylinder->GetRadius() > 0.0;
    }
    if (!isOfSecondDegree(name))
    {
      return false;
    }
    const Interpolation interpolation(
      [&](const Vec3& x)
      {
        Vec3 y = map(x);
        return function->EvaluateFunction(y.data());
      },
      this->box_);
    this->push(interpolation.form);
    return interpolation.fits();
  }

  Box box_;
};

/// Whether the signs agree where neither value is next to nothing.
bool hasSignsOf(vtkImplicitFunction* function, const ImplicitFunction& tree, const Box& box)
{
  struct Pair
  {
    double own;
    double tree;
  };
  std::vector<Pair> pairs;
  Pair largest = { 0.0, 0.0 };
  constexpr int n = 6; // positions an axis
  for (int i = 0; i < n * n * n; ++i)
  {
    const int index[3] = { i % n, i / n % n, i / (n * n) };
    Vec3 x;
    for (int k = 0; k < 3; ++k)
    {
      const double share = static_cast<double>(index[k]) / (n - 1);
      x[k] = (1.0 - share) * box.lower[k] + share * box.upper[k];
    }
    pairs.push_back({ function->FunctionValue(x.data()), tree.value(x) });
    largest.own = std::max(largest.own, std::fabs(pairs.back().own));
    largest.tree = std::max(largest.tree, std::fabs(pairs.back().tree));
  }
  return std::none_of(pairs.begin(), pairs.end(),
    [&](const Pair& p)
    {
      const bool clear = std::fabs(p.own) > 1e-9 * std::min(largest.own, 1e3) &&
        std::fabs(p.tree) > 1e-9 * std::min(largest.tree, 1e3);
      return std::isnan(p.own) || (clear && (p.own < 0.0) != (p.tree < 0.0));
    });
}

} // namespace

std::shared_ptr<const ImplicitTree> treeOf(vtkImplicitFunction* function, const Box& box)
{
  TreeMaker maker(box);
  if (!maker.add(function, {}))
  {
    return nullptr;
  }
  auto tree = std::make_shared<const ImplicitTree>(std::move(maker.tree));
  return hasSignsOf(function, *functionOf(tree), box) ? tree : nullptr;
}

} // namespace lumitree::filters
