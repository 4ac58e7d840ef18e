// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Ray_h
#define Lumitree_Accel_Ray_h

#include "Accel/Vec3.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace lumitree
{

/// The closed segment { origin + t direction : tMin <= t <= tMax }. t is in units of |direction|,
/// which is never normalised. Limits may be infinite and tMin may be negative.
struct Ray
{
  Vec3 origin = { 0.0, 0.0, 0.0 };
  Vec3 direction = { 0.0, 0.0, 1.0 };
  double tMin = 0.0;
  double tMax = std::numeric_limits<double>::infinity();
};

/// Coordinates beyond this magnitude are treated like non-finite ones, so that differences of
/// coordinates cannot overflow.
inline constexpr double coordinateLimit = 1e300;

/// Whether a ray can be traced: finite origin and direction within coordinateLimit, direction not
/// zero, tMin <= tMax, neither NaN. A ray that is not valid hits nothing and is counted
/// (QueryReport).
[[nodiscard]] inline bool isValid(const Ray& ray)
{
  bool ok = ray.tMin <= ray.tMax;
  bool moves = false;
  for (int k = 0; k < 3; ++k)
  {
    ok = ok && std::fabs(ray.origin[k]) <= coordinateLimit &&
      std::fabs(ray.direction[k]) <= coordinateLimit;
    moves = moves || ray.direction[k] != 0.0;
  }
  return ok && moves;
}

/// n numbers or triples in the caller's memory, float or double, tightly packed.
struct ArrayView
{
  enum class Scalar : std::uint8_t
  {
    Float,
    Double
  };

  const void* data = nullptr;
  Scalar type = Scalar::Double;

  ArrayView() = default;
  ArrayView(const float* values)
    : data(values)
    , type(Scalar::Float)
  {
  }
  ArrayView(const double* values)
    : data(values)
  {
  }

  explicit operator bool() const { return this->data != nullptr; }

  [[nodiscard]] double scalar(std::size_t i) const
  {
    return this->type == Scalar::Float ? static_cast<const float*>(this->data)[i]
                                       : static_cast<const double*>(this->data)[i];
  }

  [[nodiscard]] Vec3 triple(std::size_t i) const
  {
    if (this->type == Scalar::Float)
    {
      const float* const p = static_cast<const float*>(this->data) + 3 * i;
      return { p[0], p[1], p[2] };
    }
    const double* const p = static_cast<const double*>(this->data) + 3 * i;
    return { p[0], p[1], p[2] };
  }
};

/// Sets of primitives that some rays must not hit: a shadow ray does not see the cells its receiver
/// belongs to. Ray i skips the primitives primitives[offsets[s]] … primitives[offsets[s + 1] - 1],
/// ascending, with s = setOfRay[i] (s = i when setOfRay is null). No sets when offsets is null.
struct SkipSets
{
  const std::uint32_t* setOfRay = nullptr;
  const std::uint64_t* offsets = nullptr;
  const std::uint32_t* primitives = nullptr;

  /// The set of ray i, where there are sets.
  ///@{
  [[nodiscard]] const std::uint32_t* first(std::size_t i) const
  {
    return this->primitives + this->offsets[this->setOfRay ? this->setOfRay[i] : i];
  }
  [[nodiscard]] const std::uint32_t* last(std::size_t i) const
  {
    return this->primitives + this->offsets[(this->setOfRay ? this->setOfRay[i] : i) + 1];
  }
  [[nodiscard]] bool skips(std::size_t i, std::uint32_t primitive) const
  {
    return std::binary_search(this->first(i), this->last(i), primitive);
  }
  ///@}
};

/// Rays in the caller's memory; nothing is copied. tMins and tMaxs may be left out, the two scalars
/// then hold for every ray.
struct RayBatch
{
  std::size_t size = 0;
  ArrayView origins;    ///< size triples
  ArrayView directions; ///< size triples
  ArrayView tMins;      ///< size numbers, or empty
  ArrayView tMaxs;      ///< size numbers, or empty
  double tMin = 0.0;
  double tMax = std::numeric_limits<double>::infinity();
  SkipSets skip;

  [[nodiscard]] Ray operator[](std::size_t i) const
  {
    Ray ray;
    this->read(i, ray);
    return ray;
  }

  /// Ray i, written in place.
  void read(std::size_t i, Ray& ray) const
  {
    ray.origin = this->origins.triple(i);
    ray.direction = this->directions.triple(i);
    ray.tMin = this->tMins ? this->tMins.scalar(i) : this->tMin;
    ray.tMax = this->tMaxs ? this->tMaxs.scalar(i) : this->tMax;
  }
};

} // namespace lumitree

#endif
