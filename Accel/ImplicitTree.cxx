// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/ImplicitTree.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace lumitree
{
namespace
{

using Point = std::array<Jet, 3>;

Jet constant(double x)
{
  return { x, 0.0 };
}

Jet boundOf(const QuadricForm& form, const Point& x)
{
  Point y;
  for (std::size_t k = 0; k < 3; ++k)
  {
    y[k] = x[k] + constant(-form.centre[k]);
  }
  const auto& a = form.coefficients;
  Jet sum = constant(a[9]) + constant(form.residue);
  for (std::size_t k = 0; k < 3; ++k)
  {
    // Coefficients of 0 would only widen what is infinite.
    if (a[k] != 0.0)
    {
      sum = sum + a[k] * square(y[k]);
    }
    if (a[3 + k] != 0.0)
    {
      sum = sum + a[3 + k] * (y[k] * y[(k + 1) % 3]);
    }
    if (a[6 + k] != 0.0)
    {
      sum = sum + a[6 + k] * y[k];
    }
  }
  return sum;
}

Jet boundOf(const Superquadric& s, const Point& x)
{
  Point y;
  for (std::size_t k = 0; k < 3; ++k)
  {
    y[k] = constant(s.shift[k]);
    for (std::size_t j = 0; j < 3; ++j)
    {
      if (s.matrix[k][j] != 0.0)
      {
        y[k] = y[k] + s.matrix[k][j] * x[j];
      }
    }
    const Interval reciprocal = Interval::rounded(1.0 / s.scale[k], 1.0 / s.scale[k]);
    y[k] = Jet{ reciprocal, 0.0 } * y[k];
  }
  const double e = s.phiRoundness;
  const double n = s.thetaRoundness;
  const Jet round = powerOfMagnitude(y[2], 2.0 / n) + powerOfMagnitude(y[0], 2.0 / n);
  const Jet tall = powerOfMagnitude(y[1], 2.0 / e);
  const Jet ring = s.alpha > 0.0
    ? powerOfMagnitude(powerOfMagnitude(round, n / 2.0) + constant(-s.alpha), 2.0 / e)
    : powerOfMagnitude(round, n / e);
  return (ring + tall) + constant(-1.0);
}

double valueOf(const Superquadric& s, const Vec3& x)
{
  Vec3 y;
  for (int k = 0; k < 3; ++k)
  {
    y[k] = std::fabs((dot(s.matrix[static_cast<std::size_t>(k)], x) + s.shift[k]) / s.scale[k]);
  }
  const double e = s.phiRoundness;
  const double n = s.thetaRoundness;
  const double round = std::pow(y[2], 2.0 / n) + std::pow(y[0], 2.0 / n);
  const double ring = s.alpha > 0.0
    ? std::pow(std::fabs(std::pow(round, n / 2.0) - s.alpha), 2.0 / e)
    : std::pow(round, n / e);
  return ring + std::pow(y[1], 2.0 / e) - 1.0;
}

/// Plain doubles, named as the tree asks for them.
struct Value
{
  double x = 0.0;
};

Value operator-(const Value& a)
{
  return { -a.x };
}

Value minimum(const Value& a, const Value& b)
{
  return { std::isnan(b.x) || b.x < a.x ? b.x : a.x };
}

Value magnitude(const Value& a)
{
  return { std::fabs(a.x) };
}

class TreeFunction final : public ImplicitFunction
{
public:
  explicit TreeFunction(std::shared_ptr<const ImplicitTree> tree)
    : tree_(std::move(tree))
  {
  }

  [[nodiscard]] double value(const Vec3& x) const override
  {
    return this->tree_
      ->evaluate<Value>([&](std::size_t i) { return Value{ valueAt(this->tree_->forms[i], x) }; },
        [&](std::size_t i) { return Value{ valueOf(this->tree_->superquadrics[i], x) }; })
      .x;
  }

  [[nodiscard]] Vec3 gradient(const Vec3& x) const override
  {
    Vec3 g;
    for (std::size_t k = 0; k < 3; ++k)
    {
      Point at = { constant(x[0]), constant(x[1]), constant(x[2]) };
      at[k].slope = 1.0;
      const Interval slope = this->bound(at).slope;
      g[k] = slope.isFinite() ? slope.middle() : 0.0;
    }
    return g;
  }

  [[nodiscard]] std::vector<double> numbers() const override { return this->tree_->numbers(); }

  [[nodiscard]] bool isBounded() const override { return true; }

  [[nodiscard]] Jet bound(const Point& x) const override
  {
    return this->tree_->evaluate<Jet>([&](std::size_t i)
      { return boundOf(this->tree_->forms[i], x); },
      [&](std::size_t i) { return boundOf(this->tree_->superquadrics[i], x); });
  }

private:
  std::shared_ptr<const ImplicitTree> tree_;
};

template <std::size_t N>
bool finite(const std::array<double, N>& numbers)
{
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

bool positive(double x)
{
  return x > 0.0 && std::isfinite(x);
}

void require(bool holds, const std::string& what)
{
  if (!holds)
  {
    throw std::invalid_argument("an implicit tree " + what);
  }
}

} // namespace

void ImplicitTree::check() const
{
  std::size_t depth = 0;
  for (const Step& step : this->steps)
  {
    const auto holds = [&](std::size_t size)
    { return step.index >= 0 && static_cast<std::size_t>(step.index) < size; };
    switch (step.operation)
    {
      case Operation::Form:
        require(holds(this->forms.size()), "names a form that it does not have");
        ++depth;
        break;
      case Operation::Superquadric:
        require(holds(this->superquadrics.size()), "names a superquadric that it does not have");
        ++depth;
        break;
      case Operation::Minimum:
      case Operation::Maximum:
        require(depth >= 2, "joins two values where there are fewer");
        --depth;
        break;
      case Operation::Negation:
      case Operation::Magnitude:
        require(depth >= 1, "changes a value where there is none");
        break;
      default:
        require(false, "has a step that is not known");
    }
    require(depth <= maxDepth, "holds more than 32 values at a time");
  }
  require(depth == 1, "must leave one value");
  for (const QuadricForm& form : this->forms)
  {
    require(finite(form.centre) && finite(form.coefficients) && std::isfinite(form.residue),
      "has a form with a number that is not finite");
  }
  for (const lumitree::Superquadric& s : this->superquadrics)
  {
    require(finite(s.matrix[0]) && finite(s.matrix[1]) && finite(s.matrix[2]) && finite(s.shift) &&
        finite(s.scale) && std::count(s.scale.begin(), s.scale.end(), 0.0) == 0 &&
        positive(s.phiRoundness) && positive(s.thetaRoundness) && std::isfinite(s.alpha),
      "has a superquadric whose numbers make no sense");
  }
}

std::vector<double> ImplicitTree::numbers() const
{
  std::vector<double> all = { static_cast<double>(this->steps.size()),
    static_cast<double>(this->forms.size()) };
  const auto put = [&](const auto& values) { all.insert(all.end(), values.begin(), values.end()); };
  for (const Step& step : this->steps)
  {
    all.push_back(static_cast<double>(step.operation));
    all.push_back(step.index);
  }
  for (const QuadricForm& form : this->forms)
  {
    put(form.centre);
    put(form.coefficients);
    all.push_back(form.residue);
  }
  for (const lumitree::Superquadric& s : this->superquadrics)
  {
    for (const Vec3& row : s.matrix)
    {
      put(row);
    }
    put(s.shift);
    put(s.scale);
    put(std::array<double, 3>{ s.phiRoundness, s.thetaRoundness, s.alpha });
  }
  return all;
}

bool ImplicitTree::isSignOfForms() const
{
  return std::none_of(this->steps.begin(), this->steps.end(),
    [](const Step& step) { return step.operation == Operation::Superquadric; });
}

std::shared_ptr<const ImplicitFunction> functionOf(std::shared_ptr<const ImplicitTree> tree)
{
  tree->check();
  return std::make_shared<const TreeFunction>(std::move(tree));
}

} // namespace lumitree
