// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Exact/Dyadic.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace lumitree::exact
{

Dyadic::Dyadic(double value)
{
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  this->mantissa_ = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  this->exponent_ = value == 0.0 ? 0 : exponent - 53;
}

double Dyadic::leading(int& exponent) const
{
  const Integer magnitude = abs(this->mantissa_);
  exponent = this->exponent_;
  if (magnitude == 0)
  {
    return 0.0;
  }
  const int excess = static_cast<int>(msb(magnitude)) - 63;
  double value;
  if (excess > 0)
  {
    value = static_cast<double>(static_cast<std::uint64_t>(magnitude >> excess));
    exponent += excess;
  }
  else
  {
    value = static_cast<double>(static_cast<std::uint64_t>(magnitude));
  }
  return this->mantissa_.sign() < 0 ? -value : value;
}

double Dyadic::quotient(const Dyadic& a, const Dyadic& b)
{
  int aExponent = 0;
  int bExponent = 0;
  const double quotient = a.leading(aExponent) / b.leading(bExponent);
  return std::ldexp(quotient, aExponent - bExponent);
}

Dyadic operator+(const Dyadic& a, const Dyadic& b)
{
  Dyadic result;
  result.exponent_ = std::min(a.exponent_, b.exponent_);
  result.mantissa_ = (a.mantissa_ << (a.exponent_ - result.exponent_)) +
    (b.mantissa_ << (b.exponent_ - result.exponent_));
  return result;
}

Dyadic operator-(const Dyadic& a, const Dyadic& b)
{
  Dyadic negative = b;
  negative.mantissa_ = -negative.mantissa_;
  return a + negative;
}

Dyadic operator*(const Dyadic& a, const Dyadic& b)
{
  Dyadic result;
  result.mantissa_ = a.mantissa_ * b.mantissa_;
  result.exponent_ = a.exponent_ + b.exponent_;
  return result;
}

} // namespace lumitree::exact
