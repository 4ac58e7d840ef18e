// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Hit_h
#define Lumitree_Accel_Hit_h

#include <cstdint>
#include <limits>
#include <vector>

namespace lumitree
{

/// Index of a primitive of a Surface; noPrimitive is a miss.
using PrimitiveId = std::uint32_t;
inline constexpr PrimitiveId noPrimitive = std::numeric_limits<PrimitiveId>::max();

/// What is not certain about a hit. Triangles and quadrics have none of these, except
/// UncertainOrder beside an implicit.
namespace HitFlag
{
enum : std::uint32_t
{
  Uncertain = 1,     ///< intervals could not tell that the implicit is met there: it nearly is
  Sampled = 2,       ///< of an implicit that is sampled: a sign change between two samples
  UncertainOrder = 4 ///< Exact: an implicit and another primitive of the ray are closer together
                     ///< than is known; by the t reported, then by primitive
};
}

/// Where a ray meets a primitive. The point is origin + t direction; on a triangle (v0, v1, v2) it
/// is also (1 - u - v) v0 + u v1 + v v2; on bodies u = v = 0. A miss has primitive ==
/// noPrimitive, t = infinity, u = v = 0.
struct Hit
{
  double t = std::numeric_limits<double>::infinity();
  double u = 0.0;
  double v = 0.0;
  PrimitiveId primitive = noPrimitive;
  std::uint32_t flags = 0; ///< of HitFlag
};

/// Every hit of a batch: those of ray i are hits[offsets[i]] … hits[offsets[i + 1] - 1], ordered by
/// (t, primitive). Exact orders by the exact t, of which the t reported is a rounding. It never
/// descends from one hit of a ray to the next.
struct AllHits
{
  std::vector<std::uint64_t> offsets; ///< rays + 1
  std::vector<Hit> hits;
};

} // namespace lumitree

#endif
