// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_ImplicitTree_h
#define Lumitree_Accel_ImplicitTree_h

#include "Accel/Implicit.h"
#include "Accel/QuadricForm.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace lumitree
{

/// With y = (matrix · x + shift), per axis divided by scale, e = phiRoundness, n = thetaRoundness:
///
///     f = (|y2|^(2/n) + |y0|^(2/n))^(n/e) + |y1|^(2/e) - 1,
///     f = |(|y2|^(2/n) + |y0|^(2/n))^(n/2) - alpha|^(2/e) + |y1|^(2/e) - 1 where alpha is above 0,
///
/// the superquadrics of Barr 1981, "Superquadrics and Angle-Preserving Transformations", as
/// vtkSuperquadric has them; the second is the toroidal one.
struct Superquadric
{
  std::array<Vec3, 3> matrix = { Vec3{ 1, 0, 0 }, Vec3{ 0, 1, 0 }, Vec3{ 0, 0, 1 } }; ///< rows
  Vec3 shift = { 0.0, 0.0, 0.0 };
  Vec3 scale = { 1.0, 1.0, 1.0 }; ///< none is 0
  double phiRoundness = 1.0;      ///< above 0
  double thetaRoundness = 1.0;    ///< above 0
  double alpha = 0.0;             ///< 0: not toroidal
};

/// A function made of others: steps that push and join values on a stack (at most maxDepth of
/// them), one of which is left at the end. Plain data, so it can be stored.
struct LUMITREE_ACCEL_EXPORT ImplicitTree
{
  enum class Operation : std::int32_t
  {
    Form = 0,         ///< pushes forms[index]
    Superquadric = 1, ///< pushes superquadrics[index]
    Minimum = 2,      ///< joins two: the union of what is negative
    Maximum = 3,      ///< joins two: what they have in common
    Negation = 4,
    Magnitude = 5
  };

  struct Step
  {
    Operation operation = Operation::Form;
    std::int32_t index = 0;
  };

  static constexpr std::size_t maxDepth = 32;

  std::vector<Step> steps;
  std::vector<QuadricForm> forms;
  std::vector<Superquadric> superquadrics;

  /// Throws std::invalid_argument where the steps make no sense or a number is not finite, a scale
  /// 0 or a roundness not above 0.
  void check() const;

  /// All that is in it, as numbers.
  [[nodiscard]] std::vector<double> numbers() const;

  /// Whether the sign of the function is known from the signs of its forms: then its zeros are
  /// pieces of quadrics (Quadric::zerosOf), and everything about them is exact.
  [[nodiscard]] bool isSignOfForms() const;

  /// The tree's value of any kind of number that has minimum(a, b), magnitude(a) and -a, given
  /// those of forms and superquadrics by index. check must have passed.
  template <class Value, class FormValue, class SuperquadricValue>
  [[nodiscard]] Value evaluate(FormValue form, SuperquadricValue superquadric) const
  {
    std::array<Value, maxDepth> stack;
    std::size_t top = 0; // one past it
    for (const Step& step : this->steps)
    {
      const auto i = static_cast<std::size_t>(step.index);
      switch (step.operation)
      {
        case Operation::Form:
          stack[top++] = form(i);
          break;
        case Operation::Superquadric:
          stack[top++] = superquadric(i);
          break;
        case Operation::Minimum:
          --top;
          stack[top - 1] = minimum(stack[top - 1], stack[top]);
          break;
        case Operation::Maximum:
          --top;
          stack[top - 1] = -minimum(-stack[top - 1], -stack[top]);
          break;
        case Operation::Negation:
          stack[top - 1] = -stack[top - 1];
          break;
        case Operation::Magnitude:
          stack[top - 1] = magnitude(stack[top - 1]);
          break;
      }
    }
    return stack[0];
  }
};

/// The function of a tree, bounded by intervals. Throws as check does.
[[nodiscard]] LUMITREE_ACCEL_EXPORT std::shared_ptr<const ImplicitFunction> functionOf(
  std::shared_ptr<const ImplicitTree> tree);

} // namespace lumitree

#endif
