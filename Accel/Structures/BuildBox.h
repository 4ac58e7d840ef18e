// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BuildBox_h
#define Lumitree_Accel_Structures_BuildBox_h

#include "Accel/Hit.h"

#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>

namespace lumitree
{

/// x, y, z and a lane that nobody looks at, in one register: GCC's and Clang's vectors, as Highway
/// has none for what every x86 processor can do.
///@{
using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

inline Float4 float4(float value)
{
  return Float4{ value, value, value, value };
}
///@}

/// A box of floats while a hierarchy is built.
struct BuildBox
{
  Float4 lower = float4(std::numeric_limits<float>::infinity());
  Float4 upper = float4(-std::numeric_limits<float>::infinity());

  void extend(Float4 low, Float4 high)
  {
    this->lower = low < this->lower ? low : this->lower;
    this->upper = high > this->upper ? high : this->upper;
  }
  void extend(Float4 point) { this->extend(point, point); }
  void extend(const BuildBox& box) { this->extend(box.lower, box.upper); }

  /// Lengths of the sides; -infinity for an empty box.
  [[nodiscard]] Float4 sides() const { return this->upper - this->lower; }

  /// Half the surface; of boxes that are not empty only.
  [[nodiscard]] float halfArea() const
  {
    const Float4 s = this->sides();
    return s[0] * s[1] + s[1] * s[2] + s[2] * s[0];
  }

  [[nodiscard]] int longestAxis() const
  {
    const Float4 s = this->sides();
    return s[0] >= s[1] ? (s[0] >= s[2] ? 0 : 2) : (s[1] >= s[2] ? 1 : 2);
  }
};

template <class Vector>
Vector loadVector(const void* from)
{
  Vector v;
  std::memcpy(&v, from, sizeof(v));
  return v;
}

/// A primitive, or a part of one, while a hierarchy is built; in the frame, rounded outward.
struct alignas(16) BuildReference
{
  float lower[3];
  PrimitiveId id;
  float upper[3];
  std::uint32_t unused; ///< a number, never a NaN or denormal by chance: 0

  /// The last lane is cleared: an id is no number to calculate with.
  [[nodiscard]] Float4 low() const
  {
    constexpr Int4 kept = { -1, -1, -1, 0 };
    return reinterpret_cast<Float4>(loadVector<Int4>(this) & kept);
  }
  [[nodiscard]] Float4 high() const
  {
    return loadVector<Float4>(reinterpret_cast<const char*>(this) + 16);
  }

  /// Twice the centre.
  [[nodiscard]] Float4 centre() const { return this->low() + this->high(); }
  [[nodiscard]] float centre(int axis) const { return this->lower[axis] + this->upper[axis]; }
};

/// Elements that are not set to anything, for what is written whole before it is read.
template <class T>
class RawArray
{
public:
  RawArray() = default;
  explicit RawArray(std::size_t size)
    : data_(new T[size])
    , size_(size)
  {
  }
  [[nodiscard]] std::size_t size() const { return this->size_; }
  [[nodiscard]] T* data() { return this->data_.get(); }
  [[nodiscard]] const T* data() const { return this->data_.get(); }
  [[nodiscard]] T& operator[](std::size_t i) { return this->data_[i]; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return this->data_[i]; }

private:
  std::unique_ptr<T[]> data_;
  std::size_t size_ = 0;
};

using BuildReferences = RawArray<BuildReference>;

} // namespace lumitree

#endif
