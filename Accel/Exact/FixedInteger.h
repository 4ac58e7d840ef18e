// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Exact_FixedInteger_h
#define Lumitree_Accel_Exact_FixedInteger_h

#include <cstddef>
#include <cstdint>

#if defined(__SIZEOF_INT128__)
/// Compilers without 128-bit integers do without FixedInteger; Dyadic answers everything.
#define LUMITREE_HAS_FIXED_INTEGERS

namespace lumitree::exact
{

__extension__ using Int128 = __int128;
__extension__ using UInt128 = unsigned __int128;

/// An integer of N 64-bit limbs in two's complement, least significant first. A product has the
/// limbs of both factors and so never overflows; a sum has those of its terms, and who adds knows
/// that a bit is left for the carry (Lattice.h).
template <std::size_t N>
class FixedInteger
{
public:
  FixedInteger() = default;
  explicit FixedInteger(std::int64_t value)
  {
    static_assert(N == 1);
    this->limbs_[0] = static_cast<std::uint64_t>(value);
  }
  explicit FixedInteger(Int128 value)
  {
    static_assert(N == 2);
    this->limbs_[0] = static_cast<std::uint64_t>(value);
    this->limbs_[1] = static_cast<std::uint64_t>(value >> 64);
  }

  /// a - b
  template <class Integer>
  static FixedInteger difference(Integer a, Integer b)
  {
    return FixedInteger(static_cast<Integer>(a - b));
  }

  [[nodiscard]] bool negative() const { return this->limbs_[N - 1] >> 63 != 0; }

  [[nodiscard]] int sign() const
  {
    std::uint64_t any = 0;
    for (std::size_t i = 0; i < N; ++i)
    {
      any |= this->limbs_[i];
    }
    return this->negative() ? -1 : (any != 0 ? 1 : 0);
  }

  [[nodiscard]] const std::uint64_t* limbs() const { return this->limbs_; }
  [[nodiscard]] std::uint64_t limb(std::size_t i) const { return this->limbs_[i]; }

  friend FixedInteger operator+(const FixedInteger& a, const FixedInteger& b)
  {
    FixedInteger r;
    UInt128 carry = 0;
#pragma GCC unroll 12
    for (std::size_t i = 0; i < N; ++i)
    {
      carry += static_cast<UInt128>(a.limbs_[i]) + b.limbs_[i];
      r.limbs_[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    return r;
  }

  friend FixedInteger operator-(const FixedInteger& a, const FixedInteger& b)
  {
    FixedInteger r;
    std::uint64_t borrow = 0;
#pragma GCC unroll 12
    for (std::size_t i = 0; i < N; ++i)
    {
      const UInt128 d = static_cast<UInt128>(a.limbs_[i]) - b.limbs_[i] - borrow;
      r.limbs_[i] = static_cast<std::uint64_t>(d);
      borrow = static_cast<std::uint64_t>(d >> 64) & 1u;
    }
    return r;
  }

  /// Sets limb i.
  void set(std::size_t i, std::uint64_t value)
  {
    this->limbs_[i] = value;
  }

private:
  std::uint64_t limbs_[N];
};

/// r -= x 2^(64 Shift) if so, modulo 2^(64 R).
template <std::size_t Shift, std::size_t R, std::size_t M>
void takeOff(FixedInteger<R>& r, const FixedInteger<M>& x, bool so)
{
  static_assert(Shift + M == R);
  const std::uint64_t mask = so ? ~std::uint64_t{ 0 } : 0;
  std::uint64_t borrow = 0;
#pragma GCC unroll 6
  for (std::size_t i = 0; i < M; ++i)
  {
    const UInt128 d = static_cast<UInt128>(r.limb(Shift + i)) - (x.limb(i) & mask) - borrow;
    r.set(Shift + i, static_cast<std::uint64_t>(d));
    borrow = static_cast<std::uint64_t>(d >> 64) & 1u;
  }
}

/// By school's method on the limbs as natural numbers. A factor -x stands there as 2^(64 N) - x;
/// what that adds, the other factor times 2^(64 N), is taken off at the end.
template <std::size_t N, std::size_t M>
FixedInteger<N + M> operator*(const FixedInteger<N>& a, const FixedInteger<M>& b)
{
  FixedInteger<N + M> r;
  if constexpr (N == 1 && M == 1)
  {
    r = FixedInteger<2>(static_cast<Int128>(static_cast<std::int64_t>(a.limb(0))) *
      static_cast<std::int64_t>(b.limb(0)));
  }
  else
  {
    for (std::size_t i = 0; i < N + M; ++i)
    {
      r.set(i, 0);
    }
#pragma GCC unroll 6
    for (std::size_t i = 0; i < N; ++i)
    {
      UInt128 carry = 0;
#pragma GCC unroll 6
      for (std::size_t j = 0; j < M; ++j)
      {
        carry += static_cast<UInt128>(a.limb(i)) * b.limb(j) + r.limb(i + j);
        r.set(i + j, static_cast<std::uint64_t>(carry));
        carry >>= 64;
      }
      r.set(i + M, static_cast<std::uint64_t>(carry));
    }
    takeOff<N>(r, b, a.negative());
    takeOff<M>(r, a, b.negative());
  }
  return r;
}

} // namespace lumitree::exact

#endif

#endif
