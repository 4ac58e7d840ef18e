// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Exact_Dyadic_h
#define Lumitree_Accel_Exact_Dyadic_h

#include "Accel/Exact/FixedInteger.h"
#include "Accel/Ray.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace lumitree::exact
{

/// A real number as integer times a power of two, without bounds: slower than FixedInteger and
/// never out of range.
class Dyadic
{
public:
  Dyadic() = default;
  explicit Dyadic(double value);

  /// a - b
  static Dyadic difference(double a, double b) { return Dyadic(a) - Dyadic(b); }

  /// A ray's origin less a point.
  static std::array<Dyadic, 3> fromOrigin(const Ray& ray, const Vec3& point)
  {
    return { difference(ray.origin[0], point[0]), difference(ray.origin[1], point[1]),
      difference(ray.origin[2], point[2]) };
  }

  [[nodiscard]] int sign() const { return this->mantissa_.sign(); }

  /// The other kinds of number, times 2^exponent.
  ///@{
  static Dyadic from(const Dyadic& value, int exponent);
#if defined(LUMITREE_HAS_FIXED_INTEGERS)
  template <std::size_t N>
  static Dyadic from(const FixedInteger<N>& value, int exponent)
  {
    return fromLimbs(value.limbs(), N, exponent);
  }
#endif
  ///@}

  /// The double nearest to a / b, of two equally near the even one; infinite beyond their range. b
  /// is not 0.
  static double quotient(const Dyadic& a, const Dyadic& b);

  /// The largest number of about `bits` bits whose square is not above a, and the least that is not
  /// below it: the root twice where it has so few bits. a is not negative.
  static std::pair<Dyadic, Dyadic> squareRoot(const Dyadic& a, int bits);

  friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b);

private:
  using Integer = boost::multiprecision::cpp_int;

  /// Of n limbs in two's complement, least significant first.
  static Dyadic fromLimbs(const std::uint64_t* limbs, std::size_t n, int exponent);

  Dyadic(Integer mantissa, int exponent)
    : mantissa_(std::move(mantissa))
    , exponent_(exponent)
  {
  }

  Integer mantissa_ = 0;
  int exponent_ = 0;
};

} // namespace lumitree::exact

#endif
