// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Exact_Limits_h
#define Lumitree_Accel_Exact_Limits_h

#include "Accel/Exact/FixedInteger.h"
#include "Accel/Exact/Formulas.h"

#include <cmath>
#include <cstdint>
#include <optional>

namespace lumitree::exact
{

/// Sign of (t - limit), t where the line crosses the plane of triangle 0, the limit finite. Numbers
/// made from doubles know it always.
template <class Number, class Scalar, std::size_t K>
std::optional<int> compareToLimit(
  const Scene<Number, std::array<Scalar, 3>, K>& scene, double limit)
{
  const auto t = parameter(scene, 0);
  return (t.over - Number(limit) * t.under).sign() * t.under.sign();
}

#if defined(LUMITREE_HAS_FIXED_INTEGERS)
/// The same on a lattice: nothing where the limit is too far from t to be worth the bits.
template <std::size_t N, class Integer, std::size_t K>
std::optional<int> compareToLimit(
  const Scene<FixedInteger<N>, std::array<Integer, 3>, K>& scene, double limit)
{
  using Factor = FixedInteger<1>;
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(limit, &exponent), 53));
  // over / under 2^tExponent against mantissa 2^(exponent - 53)
  const int shift = mantissa == 0 ? 0 : exponent - 53 - scene.tExponent;
  if (shift < -62 || shift > 62)
  {
    return std::nullopt;
  }
  const auto power = [](int e) { return Factor(std::int64_t{ 1 } << (e > 0 ? e : 0)); };
  const auto t = parameter(scene, 0);
  const auto left = t.over * power(-shift) * Factor(std::int64_t{ 1 });
  const auto right = t.under * Factor(mantissa) * power(shift);
  return (left - right).sign() * t.under.sign();
}
#endif

} // namespace lumitree::exact

#endif
