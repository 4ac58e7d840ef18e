// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Interval_h
#define Lumitree_Accel_Interval_h

#include <algorithm>
#include <cmath>
#include <limits>

namespace lumitree
{

/// All real numbers from low to high, which may be infinite. Operations round outward, by more than
/// what the sums and products of doubles lose (2^-53 of the result), so that what they are given
/// for x holds for every x (Moore, Kearfott and Cloud 2009, "Introduction to Interval Analysis",
/// ch. 2). Where nothing is known (NaN came up) the result is everything.
struct Interval
{
  double low = 0.0;
  double high = 0.0;

  Interval() = default;
  Interval(double x)
    : low(x)
    , high(x)
  {
    this->orEverything();
  }
  Interval(double a, double b)
    : low(a)
    , high(b)
  {
    this->orEverything();
  }

  static Interval everything()
  {
    return { -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity() };
  }

  /// From bounds that were rounded, by `units` times 2^-53 of them at most.
  static Interval rounded(double a, double b, double units = 2.0)
  {
    return { below(a, units), above(b, units) };
  }

  [[nodiscard]] bool contains(double x) const { return this->low <= x && x <= this->high; }
  [[nodiscard]] double width() const { return this->high - this->low; }
  [[nodiscard]] double middle() const { return 0.5 * this->low + 0.5 * this->high; }
  [[nodiscard]] bool isFinite() const
  {
    return std::isfinite(this->low) && std::isfinite(this->high);
  }
  /// 1 or -1 where no number has another sign, 0 else.
  [[nodiscard]] int sign() const { return this->low > 0.0 ? 1 : (this->high < 0.0 ? -1 : 0); }

private:
  static constexpr double floor = 0x1p-1070; // more than what underflows
  static constexpr double unit = 0x1p-53;

  static double below(double x, double units)
  {
    return std::isinf(x) ? std::min(x, std::numeric_limits<double>::max())
                         : x - (std::fabs(x) * (units * unit) + floor);
  }
  static double above(double x, double units)
  {
    return std::isinf(x) ? std::max(x, std::numeric_limits<double>::lowest())
                         : x + (std::fabs(x) * (units * unit) + floor);
  }

  void orEverything()
  {
    if (!(this->low <= this->high))
    {
      this->low = -std::numeric_limits<double>::infinity();
      this->high = std::numeric_limits<double>::infinity();
    }
  }
};

inline bool operator==(const Interval& a, const Interval& b)
{
  return a.low == b.low && a.high == b.high;
}

inline Interval operator-(const Interval& a)
{
  return { -a.high, -a.low };
}

inline Interval operator+(const Interval& a, const Interval& b)
{
  return Interval::rounded(a.low + b.low, a.high + b.high);
}

inline Interval operator-(const Interval& a, const Interval& b)
{
  return a + -b;
}

inline Interval operator*(const Interval& a, const Interval& b)
{
  // 0 times whatever is finite is 0, exactly.
  if (a == Interval(0.0) || b == Interval(0.0))
  {
    return a.isFinite() && b.isFinite() ? Interval(0.0) : Interval::everything();
  }
  const double products[4] = { a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high };
  for (const double p : products)
  {
    if (std::isnan(p))
    {
      return Interval::everything();
    }
  }
  return Interval::rounded(
    *std::min_element(products, products + 4), *std::max_element(products, products + 4));
}

/// What both hold; the first where they have nothing in common.
inline Interval common(const Interval& a, const Interval& b)
{
  const double low = std::max(a.low, b.low);
  const double high = std::min(a.high, b.high);
  return low <= high ? Interval{ low, high } : a;
}

inline Interval hull(const Interval& a, const Interval& b)
{
  return { std::min(a.low, b.low), std::max(a.high, b.high) };
}

inline Interval minimum(const Interval& a, const Interval& b)
{
  return { std::min(a.low, b.low), std::min(a.high, b.high) };
}

inline Interval magnitude(const Interval& a)
{
  return a.low >= 0.0 ? a : (a.high <= 0.0 ? -a : Interval{ 0.0, std::max(-a.low, a.high) });
}

inline Interval square(const Interval& a)
{
  const Interval m = magnitude(a);
  const Interval s = m * m;
  return { std::max(s.low, 0.0), s.high };
}

/// a to a constant power above 0, of a >= 0. std::pow is taken to be within 8 units in the last
/// place (the C libraries in use are within 1).
inline Interval power(const Interval& a, double exponent)
{
  if (exponent == 1.0 || exponent == 2.0)
  {
    return exponent == 1.0 ? a : square(a);
  }
  const Interval p = Interval::rounded(
    std::pow(std::max(a.low, 0.0), exponent), std::pow(std::max(a.high, 0.0), exponent), 18.0);
  return { std::max(p.low, 0.0), p.high };
}

/// A function and its derivative over an interval of t: bounds of both. Where the function has
/// kinks, of every slope that occurs (of Clarke's gradient), so that the mean value theorem holds.
struct Jet
{
  Interval value;
  Interval slope;
};

inline Jet operator-(const Jet& a)
{
  return { -a.value, -a.slope };
}

inline Jet operator+(const Jet& a, const Jet& b)
{
  return { a.value + b.value, a.slope + b.slope };
}

inline Jet operator*(const Jet& a, const Jet& b)
{
  return { a.value * b.value, a.value * b.slope + a.slope * b.value };
}

inline Jet operator*(double a, const Jet& b)
{
  return { Interval(a) * b.value, Interval(a) * b.slope };
}

inline Jet square(const Jet& a)
{
  return { square(a.value), Interval(2.0) * a.value * a.slope };
}

inline Jet minimum(const Jet& a, const Jet& b)
{
  const Interval value = minimum(a.value, b.value);
  return { value,
    a.value.high < b.value.low ? a.slope
                               : (b.value.high < a.value.low ? b.slope : hull(a.slope, b.slope)) };
}

inline Jet magnitude(const Jet& a)
{
  const int sign = a.value.sign();
  return { magnitude(a.value),
    sign > 0 ? a.slope : (sign < 0 ? -a.slope : hull(a.slope, -a.slope)) };
}

/// |a| to a constant power above 0.
inline Jet powerOfMagnitude(const Jet& a, double exponent)
{
  const Jet m = magnitude(a);
  const double less = exponent - 1.0;
  // Below exponent 1 the slope is infinite at 0.
  const Interval rise = less == 0.0
    ? Interval(1.0)
    : (less > 0.0 ? power(m.value, less)
                  : (m.value.low > 0.0 ? Interval::rounded(std::pow(m.value.high, less),
                                           std::pow(m.value.low, less), 18.0)
                                       : Interval{ 0.0, std::numeric_limits<double>::infinity() }));
  return { power(m.value, exponent), Interval::rounded(exponent, exponent) * rise * m.slope };
}

} // namespace lumitree

#endif
