// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiInterpolation_h
#define LumiInterpolation_h

#include "Accel/Box.h"
#include "Accel/QuadricForm.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace lumitree::filters
{

/// Whether functions of that class are of second degree everywhere. One that only happens to be so
/// at the points tried must not be taken for one.
inline bool isOfSecondDegree(const std::string& name)
{
  return name == "vtkSphere" || name == "vtkPlane" || name == "vtkCylinder" || name == "vtkCone" ||
    name == "vtkQuadric" || name == "vtkPVPlane" || name == "vtkPVCylinder";
}

/// The form of second degree with the function's values in ten points around the middle of a box.
class Interpolation
{
public:
  Interpolation(std::function<double(const Vec3&)> function, const Box& box)
    : function_(std::move(function))
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
    // How far it may be from them, in parts of the largest.
    constexpr double tolerance = 1e-10;
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
      const double value = this->function_(x);
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
    return this->function_(this->centre_ + this->step_ * direction);
  }

  std::function<double(const Vec3&)> function_;
  Box box_;
  Vec3 centre_;
  double step_ = 1.0;
};

} // namespace lumitree::filters
#endif
