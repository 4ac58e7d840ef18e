// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Exact_Lattice_h
#define Lumitree_Accel_Exact_Lattice_h

#include "Accel/Exact/FixedInteger.h"

#include "Accel/Ray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#if defined(LUMITREE_HAS_FIXED_INTEGERS)

namespace lumitree::exact
{

/// The coordinates of points, or of a direction, as integers in units of one power of two: the one
/// that makes the largest of them b bits long. Nearly all data fits 61 bits, data of very uneven
/// magnitude 124.
///
/// With |x| < 2^b, differences are below 2^(b + 1), components of a cross product of two of them
/// below 2^(2b + 3), dot products of such with a third below 2^(3b + 6) (with a direction 2^(3b +
/// 5)), and differences of two products of those below 2^(6b + 12). FixedInteger<L>, L = 1 for b =
/// 61 and 2 for b = 124, keeps 64 L, 128 L, 192 L and 384 L bits for them with the sign: 63 > 62,
/// 127 > 125, 191 > 189, 383 > 378, and 127 > 125, 255 > 251, 383 > 378, 767 > 756.
template <class Integer>
class Lattice
{
public:
  using Number = FixedInteger<sizeof(Integer) / 8>;
  using Point = std::array<Integer, 3>;
  static constexpr int bits = sizeof(Integer) == 8 ? 61 : 124;

  /// For numbers up to largest, which is finite.
  explicit Lattice(double largest)
    : exponent_(std::clamp(bits - 1 - exponentOf(largest), -1000, 1000))
    , scale_(powerOfTwo(this->exponent_))
    , unit_(powerOfTwo(-this->exponent_))
  {
  }

  /// Integers are the numbers times two to this power.
  [[nodiscard]] int exponent() const { return this->exponent_; }

  /// Whether every coordinate of from is an integer in these units; to becomes these. Powers of two
  /// scale exactly, except where the result underflows: then the integer is 0, which is not from on
  /// the way back.
  [[nodiscard]] bool place(const Vec3& from, Point& to) const
  {
    bool exact = true;
    for (int k = 0; k < 3; ++k)
    {
      exact &= truncate(from[k] * this->scale_, to[k]) * this->unit_ == from[k];
    }
    return exact;
  }

  template <std::size_t N>
  [[nodiscard]] bool place(const std::array<Vec3, N>& from, std::array<Point, N>& to) const
  {
    bool exact = true;
    for (std::size_t i = 0; i < N; ++i)
    {
      exact &= this->place(from[i], to[i]);
    }
    return exact;
  }

private:
  /// The integer next to x towards 0, and the same as a double, which has room for it.
  ///@{
  static double truncate(double x, std::int64_t& integer)
  {
    integer = static_cast<std::int64_t>(x);
    return static_cast<double>(integer);
  }
  static double truncate(double x, Int128& integer)
  {
    // Compilers convert to 128 bits slowly.
    const auto upper = static_cast<std::int64_t>(x * 0x1p-62);
    const double head = static_cast<double>(upper) * 0x1p62;
    const auto lower = static_cast<std::int64_t>(x - head);
    integer = static_cast<Int128>(upper) * (std::int64_t{ 1 } << 62) + lower;
    return head + static_cast<double>(lower);
  }
  ///@}

  /// e with x < 2^(e + 1), the least one for normal numbers.
  static int exponentOf(double x)
  {
    std::uint64_t pattern;
    std::memcpy(&pattern, &x, sizeof(pattern));
    return static_cast<int>(pattern >> 52) - 1023;
  }

  static double powerOfTwo(int e)
  {
    const std::uint64_t pattern = static_cast<std::uint64_t>(1023 + e) << 52;
    double x;
    std::memcpy(&x, &pattern, sizeof(x));
    return x;
  }

  int exponent_;
  double scale_;
  double unit_;
};

/// The largest magnitude of a coordinate.
///@{
inline double largest(const Vec3& v)
{
  return std::max({ std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2]) });
}
inline double largest(const std::array<Vec3, 3>& t)
{
  return std::max({ largest(t[0]), largest(t[1]), largest(t[2]) });
}
///@}

} // namespace lumitree::exact

#endif

#endif
