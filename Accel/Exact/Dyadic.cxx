// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Exact/Dyadic.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace lumitree::exact
{

Dyadic::Dyadic(double value)
{
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  this->mantissa_ = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  this->exponent_ = value == 0.0 ? 0 : exponent - 53;
}

Dyadic Dyadic::from(const Dyadic& value, int exponent)
{
  return { value.mantissa_, value.exponent_ + exponent };
}

Dyadic Dyadic::fromLimbs(const std::uint64_t* limbs, std::size_t n, int exponent)
{
  // Only the top limb has a sign.
  Integer sum = static_cast<std::int64_t>(limbs[n - 1]);
  for (std::size_t i = n - 1; i-- > 0;)
  {
    sum <<= 64;
    sum += limbs[i];
  }
  return { sum, exponent };
}

double Dyadic::quotient(const Dyadic& a, const Dyadic& b)
{
  const int sign = a.sign() * b.sign();
  if (sign == 0)
  {
    return 0.0;
  }
  // A quotient of 65 or 66 bits, then its leading 64; what is cut off leaves a 1 in the last place.
  // Rounding looks at the 11 bits or more that a double has no room for, and so at whether they are
  // 0, half, or beside it.
  Integer over = abs(a.mantissa_);
  Integer under = abs(b.mantissa_);
  const int shift = 65 + static_cast<int>(msb(under)) - static_cast<int>(msb(over));
  (shift > 0 ? over : under) <<= std::abs(shift);
  Integer whole;
  Integer rest;
  divide_qr(over, under, whole, rest);
  const int excess = static_cast<int>(msb(whole)) - 63;
  const auto leading = static_cast<std::uint64_t>(whole >> excess);
  const bool cut = rest != 0 || (whole & ((1u << excess) - 1u)) != 0;
  const std::uint64_t bits = leading | (cut ? 1u : 0u);
  const int exponent = a.exponent_ - b.exponent_ - shift + excess;

  // A double's last place is 2^-1074 at least.
  const int drop = std::max(11, -1074 - exponent);
  if (drop > 64)
  {
    return sign * 0.0;
  }
  const std::uint64_t kept = drop < 64 ? bits >> drop : 0;
  const std::uint64_t dropped = drop < 64 ? bits << (64 - drop) : bits;
  const std::uint64_t half = std::uint64_t{ 1 } << 63;
  const bool up = dropped > half || (dropped == half && kept % 2 == 1);
  return sign * std::ldexp(static_cast<double>(kept + (up ? 1 : 0)), exponent + drop);
}

std::pair<Dyadic, Dyadic> Dyadic::squareRoot(const Dyadic& a, int bits)
{
  if (a.sign() == 0)
  {
    return {};
  }
  int shift = std::max(0, 2 * bits - static_cast<int>(msb(a.mantissa_)));
  shift += (a.exponent_ - shift) % 2 != 0 ? 1 : 0;
  Integer rest;
  const Integer root = sqrt(Integer(a.mantissa_ << shift), rest);
  const int exponent = (a.exponent_ - shift) / 2;
  const Dyadic low(root, exponent);
  return { low, rest == 0 ? low : Dyadic(root + 1, exponent) };
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
