// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_Precisions_h
#define Lumitree_Accel_Kernel_Precisions_h

#include "Accel/Exact/Predicates.h"
#include "Accel/Kernel/QuadricHits.h"
#include "Accel/Kernel/RayState.h"

#include <tuple>

namespace lumitree
{

/// A precision settles each candidate (does the segment hit the primitive?) and orders two that are
/// hit. In all of them a hit whose t is beyond the range of doubles is a miss: infinity is what a
/// miss reports.

/// The order of hits that floating point only nearly knows: by the key, then by primitive. The key
/// is t, but not less than the t at which the ray enters the primitive's own box, and a primitive
/// whose box the ray does not meet is not hit. So neither the hits nor their order depend on which
/// other boxes the structure put around the primitive.
struct OrderByKey
{
  /// Whether the ray meets the box of the candidate's triangle; if so, the candidate has its key.
  /// A triangle certainly met at a t that is known closer than its box is padded needs no look at
  /// the box: the exact t is between those at which the ray enters and leaves it, and tEnter is
  /// below that by the pad.
  [[gnu::always_inline]] static inline bool place(RayState& state, const Crossing& x, Candidate& c)
  {
    c.take(x);
    if (surelyHit(x.edges) && x.tHigh - x.tLow <= 0.5 * RayBox::relativePad * std::fabs(x.t))
    {
      return true;
    }
    double tEnter = 0.0;
    const bool met = meetsBox(state, c.primitive, tEnter);
    c.key = std::max(x.t, tEnter);
    return met;
  }

  /// Sign of (t of a - t of b).
  static int compare(RayState&, const Candidate& a, const Candidate& b)
  {
    return a.key < b.key ? -1 : (a.key > b.key ? 1 : 0);
  }

  static bool before(RayState&, const Candidate& a, const Candidate& b)
  {
    return std::tie(a.key, a.primitive, a.root) < std::tie(b.key, b.primitive, b.root);
  }

  static double stopAt(const Candidate& c) { return c.key; }

private:
  [[gnu::noinline, gnu::cold]] static bool meetsBox(
    RayState& state, PrimitiveId triangle, double& tEnter)
  {
    Box box;
    for (const Vec3& vertex : state.surface.vertices(triangle))
    {
      box.extend(vertex);
    }
    return state.box().meets(box, state.ray.tMax, tEnter);
  }
};

/// Floating point as it comes: a hit and its t are what double arithmetic says.
struct FastPrecision : OrderByKey
{
  static constexpr Precision precision = Precision::Fast;

  [[gnu::always_inline]] static inline bool settle(
    RayState& state, const Along& vertices, Candidate& c)
  {
    const Crossing x = crossing(state.ray, vertices, state.edges);
    return apparentlyHit(x.edges) && std::isfinite(x.t) && x.t >= state.ray.tMin &&
      x.t <= state.ray.tMax && place(state, x, c);
  }
};

/// Whatever the filter cannot rule out is a hit. Nothing passes through a closed mesh: a triangle
/// that contains an exact crossing point is never ruled out.
struct WatertightPrecision : OrderByKey
{
  static constexpr Precision precision = Precision::Watertight;

  [[gnu::always_inline]] static inline bool settle(
    RayState& state, const Along& vertices, Candidate& c)
  {
    const Crossing x = crossing(state.ray, vertices, state.edges);
    if (surelyBeyond(state.ray, x))
    {
      return false;
    }
    if (surelyHit(x.edges) && surelyBetween(state.ray, x))
    {
      return std::isfinite(x.t) && place(state, x, c);
    }
    // By the triangle's own bound: a block's depends on which triangles share it.
    const Crossing own = crossing(state.ray, state.surface.vertices(c.primitive));
    state.exactTests += surelyHit(own.edges) ? 0 : 1;
    return !surelyMissed(own.edges) && std::isfinite(own.t) && own.tHigh >= state.ray.tMin &&
      own.tLow <= state.ray.tMax && place(state, own, c);
  }
};

/// What rational arithmetic on the stored numbers says: the filter decides nearly always, exact
/// arithmetic the rest.
struct ExactPrecision
{
  static constexpr Precision precision = Precision::Exact;

  [[gnu::always_inline]] static inline bool settle(
    RayState& state, const Along& vertices, Candidate& c)
  {
    const Crossing x = crossing(state.ray, vertices, state.edges);
    c.take(x);
    return std::isfinite(x.t) && !surelyBeyond(state.ray, x) &&
      ((surelyHit(x.edges) && surelyBetween(state.ray, x)) || settleExactly(state, x, c.primitive));
  }

  static int compare(RayState& state, const Candidate& a, const Candidate& b)
  {
    if (a.tHigh < b.tLow)
    {
      return -1;
    }
    if (b.tHigh < a.tLow)
    {
      return 1;
    }
    ++state.exactTests;
    const Surface& s = state.surface;
    return !s.isTriangle(a.primitive) || !s.isTriangle(b.primitive)
      ? compareExactly(state, a, b)
      : exact::compareCrossings(state.ray, s.vertices(a.primitive), s.vertices(b.primitive));
  }

  static bool before(RayState& state, const Candidate& a, const Candidate& b)
  {
    const int order = compare(state, a, b);
    return order < 0 || (order == 0 && a.primitive < b.primitive);
  }

  static double stopAt(const Candidate& c) { return c.tHigh; }

private:
  [[gnu::noinline, gnu::cold]] static bool settleExactly(
    RayState& state, const Crossing& x, PrimitiveId triangle)
  {
    if (surelyMissed(x.edges))
    {
      return false;
    }
    const Corners vertices = state.surface.vertices(triangle);
    if (!surelyHit(x.edges))
    {
      ++state.exactTests;
      if (!exact::lineMeetsTriangle(state.ray, vertices))
      {
        return false;
      }
    }
    return atLeast(state, vertices, x, state.ray.tMin) && atMost(state, vertices, x);
  }

  static bool atLeast(RayState& state, const Corners& vertices, const Crossing& x, double limit)
  {
    if (x.tLow >= limit)
    {
      return true;
    }
    if (x.tHigh < limit)
    {
      return false;
    }
    ++state.exactTests;
    return exact::compareCrossing(state.ray, vertices, limit) >= 0;
  }

  static bool atMost(RayState& state, const Corners& vertices, const Crossing& x)
  {
    if (x.tHigh <= state.ray.tMax)
    {
      return true;
    }
    if (x.tLow > state.ray.tMax)
    {
      return false;
    }
    ++state.exactTests;
    return exact::compareCrossing(state.ray, vertices, state.ray.tMax) <= 0;
  }
};

/// Whether the ray moved by (e, e^2, e^3), e > 0 and as small as need be, passes through the
/// triangle. It then does so inside, between the limits; if so, the ray itself hits the triangle by
/// the definition, so structures visit it.
struct ExactPassage
{
  static bool settle(RayState& state, const Along&, Candidate& c)
  {
    const Corners vertices = state.surface.vertices(c.primitive);
    const Crossing x = crossing(state.ray, vertices);
    if (!surelyHit(x.edges))
    {
      if (surelyMissed(x.edges))
      {
        return false;
      }
      ++state.exactTests;
      if (!exact::movedLineMeetsTriangle(state.ray, vertices))
      {
        return false;
      }
    }
    c.take(x);
    return std::isfinite(x.t) && isBeyond(state, vertices, x, state.ray.tMin) &&
      !isBeyond(state, vertices, x, state.ray.tMax);
  }

private:
  static bool isBeyond(RayState& state, const Corners& vertices, const Crossing& x, double limit)
  {
    if (x.tLow > limit)
    {
      return true;
    }
    if (x.tHigh < limit)
    {
      return false;
    }
    ++state.exactTests;
    return exact::compareMovedCrossing(state.ray, vertices, limit) > 0;
  }
};

} // namespace lumitree

#endif
