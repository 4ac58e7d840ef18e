// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Exact/Expansion.h"

#include <cmath>
#include <utility>

namespace lumitree::exact
{
namespace
{

struct Two
{
  double high;
  double low;
};

/// a + b exactly (Knuth).
inline Two twoSum(double a, double b)
{
  const double high = a + b;
  const double bVirtual = high - a;
  const double aVirtual = high - bVirtual;
  return { high, (a - aVirtual) + (b - bVirtual) };
}

/// a + b exactly, given |a| >= |b| (Dekker).
inline Two fastTwoSum(double a, double b)
{
  const double high = a + b;
  return { high, b - (high - a) };
}

/// The upper 26 bits of a (Veltkamp).
inline double upperHalf(double a)
{
  const double c = 134217729.0 * a; // 2^27 + 1
  return c - (c - a);
}

/// a * b exactly (Dekker); without FMA, so that every instruction set gives the same bits.
inline Two twoProduct(double a, double b)
{
  const double high = a * b;
  const double aHigh = upperHalf(a);
  const double bHigh = upperHalf(b);
  const double aLow = a - aHigh;
  const double bLow = b - bHigh;
  const double rest = ((high - aHigh * bHigh) - aLow * bHigh) - aHigh * bLow;
  return { high, aLow * bLow - rest };
}

} // namespace

Expansion::Expansion(double value)
{
  this->push(value);
}

Expansion Expansion::difference(double a, double b)
{
  const Two d = twoSum(a, -b);
  Expansion e;
  e.push(d.low);
  e.push(d.high);
  return e;
}

int Expansion::sign() const
{
  return this->terms_.empty() ? 0 : (this->terms_.back() > 0.0 ? 1 : -1);
}

double Expansion::estimate() const
{
  double sum = 0.0;
  for (const double term : this->terms_)
  {
    sum += term;
  }
  return sum;
}

Expansion Expansion::leading(double& error) const
{
  error = 0.0;
  if (this->terms_.empty())
  {
    return {};
  }
  Terms packed; // largest first
  double carry = this->terms_.back();
  for (std::size_t i = this->terms_.size() - 1; i-- > 0;)
  {
    const Two s = fastTwoSum(carry, this->terms_[i]);
    carry = s.high;
    if (s.low != 0.0)
    {
      packed.push(s.high);
      carry = s.low;
    }
  }
  packed.push(carry);
  Expansion result;
  for (std::size_t i = packed.size(); i-- > 0;)
  {
    if (i < 3)
    {
      result.push(packed[i]);
    }
    else
    {
      error += std::fabs(packed[i]);
    }
  }
  error *= 1.0 + 0x1p-40;
  return result;
}

// Shewchuk's fast-expansion-sum: merge by magnitude, then sweep the carry through.
Expansion Expansion::sum(const Expansion& a, const Expansion& b, double signOfB)
{
  Expansion result;
  const std::size_t n = a.terms_.size();
  const std::size_t m = b.terms_.size();
  result.terms_.reserve(n + m);
  if (n + m == 0)
  {
    return result;
  }
  std::size_t i = 0;
  std::size_t j = 0;
  const auto next = [&] {
    const bool fromA =
      j == m || (i < n && std::fabs(a.terms_[i]) < std::fabs(b.terms_[j]));
    return fromA ? a.terms_[i++] : signOfB * b.terms_[j++];
  };
  double carry = next();
  while (i < n || j < m)
  {
    const Two s = twoSum(carry, next());
    result.push(s.low);
    carry = s.high;
  }
  result.push(carry);
  return result;
}

Expansion Expansion::scale(const Expansion& a, double factor)
{
  Expansion result;
  result.terms_.reserve(2 * a.terms_.size());
  double carry = 0.0;
  for (const double term : a.terms_)
  {
    const Two product = twoProduct(term, factor);
    const Two low = twoSum(carry, product.low);
    result.push(low.low);
    const Two high = fastTwoSum(product.high, low.high);
    result.push(high.low);
    carry = high.high;
  }
  result.push(carry);
  return result;
}

Expansion operator+(const Expansion& a, const Expansion& b)
{
  return Expansion::sum(a, b, 1.0);
}

Expansion operator-(const Expansion& a, const Expansion& b)
{
  return Expansion::sum(a, b, -1.0);
}

Expansion operator*(const Expansion& a, const Expansion& b)
{
  const bool aIsShorter = a.terms_.size() < b.terms_.size();
  const Expansion& shorter = aIsShorter ? a : b;
  const Expansion& longer = aIsShorter ? b : a;
  Expansion result;
  for (const double term : shorter.terms_)
  {
    result = result + Expansion::scale(longer, term);
  }
  return result;
}

} // namespace lumitree::exact
