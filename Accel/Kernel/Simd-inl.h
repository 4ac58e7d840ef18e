// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Included once per instruction set (Highway's scheme), so without an ordinary guard.
#if defined(LUMITREE_SIMD_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LUMITREE_SIMD_INL
#undef LUMITREE_SIMD_INL
#else
#define LUMITREE_SIMD_INL
#endif

#include <hwy/highway.h>

#include <cmath>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace lumitree
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// N numbers in as many registers as the instruction set needs: the width of the algorithm is the
/// same everywhere, and so are the bits. Nothing is fused, no reciprocal is approximate.
template <class T, int N>
struct Pack
{
  using Tag = hn::CappedTag<T, N>;
  using Register = hn::Vec<Tag>;
  static constexpr int lanes = static_cast<int>(hn::MaxLanes(Tag()));
  static constexpr int parts = N / lanes;

  Register part[parts];

  static HWY_INLINE Pack load(const T* values)
  {
    Pack p;
    for (int i = 0; i < parts; ++i)
    {
      p.part[i] = hn::LoadU(Tag(), values + i * lanes);
    }
    return p;
  }

  static HWY_INLINE Pack all(T value)
  {
    Pack p;
    for (int i = 0; i < parts; ++i)
    {
      p.part[i] = hn::Set(Tag(), value);
    }
    return p;
  }

  HWY_INLINE void store(T* values) const
  {
    for (int i = 0; i < parts; ++i)
    {
      hn::StoreU(this->part[i], Tag(), values + i * lanes);
    }
  }
};

template <class P, class F>
HWY_INLINE P each(const P& a, const P& b, F f)
{
  P r;
  for (int i = 0; i < P::parts; ++i)
  {
    r.part[i] = f(a.part[i], b.part[i]);
  }
  return r;
}

template <class T, int N>
HWY_INLINE Pack<T, N> operator+(const Pack<T, N>& a, const Pack<T, N>& b)
{
  return each(a, b, [](auto x, auto y) HWY_ATTR { return hn::Add(x, y); });
}

template <class T, int N>
HWY_INLINE Pack<T, N> operator-(const Pack<T, N>& a, const Pack<T, N>& b)
{
  return each(a, b, [](auto x, auto y) HWY_ATTR { return hn::Sub(x, y); });
}

template <class T, int N>
HWY_INLINE Pack<T, N> operator*(const Pack<T, N>& a, const Pack<T, N>& b)
{
  return each(a, b, [](auto x, auto y) HWY_ATTR { return hn::Mul(x, y); });
}

template <class T, int N>
HWY_INLINE Pack<T, N> operator/(const Pack<T, N>& a, const Pack<T, N>& b)
{
  return each(a, b, [](auto x, auto y) HWY_ATTR { return hn::Div(x, y); });
}

/// value > accumulator ? value : accumulator, so that a NaN value is ignored.
template <class T, int N>
HWY_INLINE Pack<T, N> raise(const Pack<T, N>& value, const Pack<T, N>& accumulator)
{
#if HWY_ARCH_X86
  // maxps gives its second operand when either is NaN.
  return each(value, accumulator, [](auto x, auto y) HWY_ATTR { return hn::Max(x, y); });
#else
  return each(
    value, accumulator, [](auto x, auto y) HWY_ATTR { return hn::IfThenElse(hn::Gt(x, y), x, y); });
#endif
}

/// value < accumulator ? value : accumulator.
template <class T, int N>
HWY_INLINE Pack<T, N> lower(const Pack<T, N>& value, const Pack<T, N>& accumulator)
{
#if HWY_ARCH_X86
  return each(value, accumulator, [](auto x, auto y) HWY_ATTR { return hn::Min(x, y); });
#else
  return each(
    value, accumulator, [](auto x, auto y) HWY_ATTR { return hn::IfThenElse(hn::Lt(x, y), x, y); });
#endif
}

template <class T, int N>
HWY_INLINE Pack<T, N> absolute(const Pack<T, N>& a)
{
  return each(a, a, [](auto x, auto) HWY_ATTR { return hn::Abs(x); });
}

/// Where sign's sign bit is set yes, else no.
template <class T, int N>
HWY_INLINE Pack<T, N> whereNegative(
  const Pack<T, N>& sign, const Pack<T, N>& yes, const Pack<T, N>& no)
{
#if HWY_ARCH_X86 && HWY_TARGET != HWY_EMU128 && HWY_TARGET != HWY_SCALAR
  Pack<T, N> r;
  for (int i = 0; i < Pack<T, N>::parts; ++i)
  {
    r.part[i] = hn::IfNegativeThenElse(sign.part[i], yes.part[i], no.part[i]);
  }
  return r;
#else
  // Highway 1.0's portable target chooses wrongly.
  T signs[N];
  T values[N];
  T others[N];
  sign.store(signs);
  yes.store(values);
  no.store(others);
  for (int i = 0; i < N; ++i)
  {
    values[i] = std::signbit(signs[i]) ? values[i] : others[i];
  }
  return Pack<T, N>::load(values);
#endif
}

/// A truth value per lane.
template <class P>
struct Lanes
{
  using Register = hn::Mask<typename P::Tag>;
  Register part[P::parts];

  friend HWY_INLINE Lanes operator&(const Lanes& a, const Lanes& b)
  {
    Lanes r;
    for (int i = 0; i < P::parts; ++i)
    {
      r.part[i] = hn::And(a.part[i], b.part[i]);
    }
    return r;
  }

  friend HWY_INLINE Lanes operator|(const Lanes& a, const Lanes& b)
  {
    Lanes r;
    for (int i = 0; i < P::parts; ++i)
    {
      r.part[i] = hn::Or(a.part[i], b.part[i]);
    }
    return r;
  }

  /// Bit i is set where lane i is true.
  [[nodiscard]] HWY_INLINE unsigned bits() const
  {
    unsigned bits = 0;
    for (int i = 0; i < P::parts; ++i)
    {
      std::uint8_t stored[8] = {};
      hn::StoreMaskBits(typename P::Tag(), this->part[i], stored);
      bits |= static_cast<unsigned>(stored[0]) << (i * P::lanes);
    }
    return bits;
  }
};

template <class T, int N>
HWY_INLINE Lanes<Pack<T, N>> operator<=(const Pack<T, N>& a, const Pack<T, N>& b)
{
  Lanes<Pack<T, N>> r;
  for (int i = 0; i < Pack<T, N>::parts; ++i)
  {
    r.part[i] = hn::Le(a.part[i], b.part[i]);
  }
  return r;
}

template <class T, int N>
HWY_INLINE Lanes<Pack<T, N>> operator<(const Pack<T, N>& a, const Pack<T, N>& b)
{
  Lanes<Pack<T, N>> r;
  for (int i = 0; i < Pack<T, N>::parts; ++i)
  {
    r.part[i] = hn::Lt(a.part[i], b.part[i]);
  }
  return r;
}

using Float4 = Pack<float, 4>;
using Float8 = Pack<float, 8>;
using Double4 = Pack<double, 4>;

/// Rounded to nearest.
HWY_INLINE Float4 toFloat(const Double4& a)
{
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
  return { { hn::DemoteTo(Float4::Tag(), a.part[0]) } };
#else
  HWY_ALIGN float values[4];
  const hn::Rebind<float, Double4::Tag> half;
  for (int i = 0; i < Double4::parts; ++i)
  {
    hn::StoreU(hn::DemoteTo(half, a.part[i]), half, values + i * Double4::lanes);
  }
  return Float4::load(values);
#endif
}

HWY_INLINE Double4 loadDoubles(const double* values)
{
  return Double4::load(values);
}

HWY_INLINE Double4 loadDoubles(const float* values)
{
  Double4 p;
  const hn::Rebind<float, Double4::Tag> half;
  for (int i = 0; i < Double4::parts; ++i)
  {
    p.part[i] = hn::PromoteTo(Double4::Tag(), hn::LoadU(half, values + i * Double4::lanes));
  }
  return p;
}

} // namespace HWY_NAMESPACE
} // namespace lumitree
HWY_AFTER_NAMESPACE();

#endif
