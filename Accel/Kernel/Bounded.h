// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_Bounded_h
#define Lumitree_Accel_Kernel_Bounded_h

#include <algorithm>
#include <cmath>
#include <limits>

namespace lumitree
{

/// A double and a bound of its distance from the real number it stands for. An operation adds what
/// its own rounding loses, u = 2^-53 of the result; the bound's own roundings, six at most, are
/// within the factor 1 + 2^-49, what underflows anywhere is within the floor. A bound that is not
/// finite says nothing. An error of 0 says that the number is known exactly.
struct Bounded
{
  double value = 0.0;
  double error = 0.0;

  Bounded() = default;
  Bounded(double v, double e = 0.0)
    : value(v)
    , error(e)
  {
  }

  [[nodiscard]] bool isZero() const { return this->value == 0.0 && this->error == 0.0; }
  [[nodiscard]] bool isFinite() const
  {
    return std::isfinite(this->value) && std::isfinite(this->error);
  }
  /// Certain signs; neither where nothing is certain.
  ///@{
  [[nodiscard]] bool surelyNegative() const { return this->value < -this->error; }
  [[nodiscard]] bool surelyPositive() const { return this->value > this->error; }
  ///@}

  /// The sum of two doubles to twice their precision; exact.
  static void twoSum(double a, double b, double& sum, double& rest)
  {
    sum = a + b;
    const double part = sum - a;
    rest = (a - (sum - part)) + (b - part);
  }

  static double grown(double error) { return error * (1.0 + 0x1p-49) + 0x1p-1070; }
  static constexpr double roundoff = 0x1p-53;
};

inline Bounded operator-(const Bounded& a)
{
  return { -a.value, a.error };
}

inline Bounded twice(const Bounded& a)
{
  return { 2.0 * a.value, 2.0 * a.error };
}

inline Bounded operator+(const Bounded& a, const Bounded& b)
{
  if (a.isZero() || b.isZero())
  {
    return a.isZero() ? b : a;
  }
  const double v = a.value + b.value;
  return { v, Bounded::grown(a.error + b.error + Bounded::roundoff * std::fabs(v)) };
}

inline Bounded operator-(const Bounded& a, const Bounded& b)
{
  return a + -b;
}

inline Bounded operator*(const Bounded& a, const Bounded& b)
{
  if (a.isZero() || b.isZero())
  {
    return {};
  }
  const double v = a.value * b.value;
  return { v,
    Bounded::grown(std::fabs(a.value) * b.error + std::fabs(b.value) * a.error + a.error * b.error +
      Bounded::roundoff * std::fabs(v)) };
}

/// |a / b - v| <= (|a error| + |v| |b error|) / (|b| - |b error|) and the quotient's rounding. b
/// must certainly not be 0, else nothing is said.
inline Bounded operator/(const Bounded& a, const Bounded& b)
{
  const double v = a.value / b.value;
  const double least = std::fabs(b.value) * (1.0 - 0x1p-50) - b.error;
  if (!(least > 0.0))
  {
    return { v, std::numeric_limits<double>::infinity() };
  }
  const double moved = std::fabs(v) * (1.0 + 0x1p-50) * b.error;
  return { v, Bounded::grown((a.error + moved) / least + Bounded::roundoff * std::fabs(v)) };
}

/// |sqrt(x) - sqrt(v)| <= |x - v| / sqrt(v). a is certainly positive.
inline Bounded squareRoot(const Bounded& a)
{
  const double v = std::sqrt(a.value);
  return { v, Bounded::grown(a.error / v * (1.0 + 0x1p-50) + Bounded::roundoff * v) };
}

} // namespace lumitree

#endif
