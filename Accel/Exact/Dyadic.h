// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Exact_Dyadic_h
#define Lumitree_Accel_Exact_Dyadic_h

#include <boost/multiprecision/cpp_int.hpp>

namespace lumitree::exact
{

/// A real number as integer times a power of two, without bounds: slower than Expansion and never out of range.
class Dyadic
{
public:
  Dyadic() = default;
  explicit Dyadic(double value);

  /// a - b
  static Dyadic difference(double a, double b) { return Dyadic(a) - Dyadic(b); }

  [[nodiscard]] int sign() const { return this->mantissa_.sign(); }

  /// a / b within a few units of the last place; b is not 0.
  static double quotient(const Dyadic& a, const Dyadic& b);

  friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b);

private:
  using Integer = boost::multiprecision::cpp_int;

  /// The leading 64 bits as a double, the rest moved into exponent.
  [[nodiscard]] double leading(int& exponent) const;

  Integer mantissa_ = 0;
  int exponent_ = 0;
};

} // namespace lumitree::exact

#endif
