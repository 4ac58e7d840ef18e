// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_Precisions_h
#define Lumitree_Accel_Kernel_Precisions_h

#include "Accel/Exact/Predicates.h"
#include "Accel/Kernel/RayState.h"

namespace lumitree
{

/// A precision says which lanes of the filter are candidates, settles each (does the segment hit the primitive?) and
/// orders two that are hit.

/// Floating point as it comes. The t of a candidate and its place in the order are what double arithmetic says.
struct FastPrecision
{
  static bool mayHit(const EdgeValues& e) { return apparentlyHit(e); }

  static bool settle(RayState& state, const EdgeValues&, double tEnter, Candidate& c)
  {
    const Crossing x = crossing(state.filter, state.surface.vertices(c.primitive));
    c.tLow = c.tHigh = x.t;
    c.key = std::max(x.t, tEnter);
    return x.t >= state.ray.tMin && x.t <= state.ray.tMax;
  }

  static bool before(RayState&, const Candidate& a, const Candidate& b)
  {
    return a.key < b.key || (a.key == b.key && a.primitive < b.primitive);
  }

  static double stopAt(const Candidate& c) { return c.key; }
};

/// Whatever the filter cannot rule out is a hit: nothing passes through a closed mesh, because of the triangles that
/// contain an exact crossing point none is ever ruled out.
struct WatertightPrecision
{
  static bool mayHit(const EdgeValues& e) { return !surelyMissed(e); }

  static bool settle(RayState& state, const EdgeValues& e, double tEnter, Candidate& c)
  {
    state.exactTests += surelyHit(e) ? 0 : 1;
    const Crossing x = crossing(state.filter, state.surface.vertices(c.primitive));
    c.tLow = x.tLow;
    c.tHigh = x.tHigh;
    c.key = std::max(x.t, tEnter);
    return x.tHigh >= state.ray.tMin && x.tLow <= state.ray.tMax;
  }

  static bool before(RayState& state, const Candidate& a, const Candidate& b)
  {
    return FastPrecision::before(state, a, b);
  }

  static double stopAt(const Candidate& c) { return c.key; }
};

/// What rational arithmetic on the stored numbers says: the filter decides nearly always, exact arithmetic the rest.
struct ExactPrecision
{
  static bool mayHit(const EdgeValues& e) { return !surelyMissed(e); }

  static bool settle(RayState& state, const EdgeValues& e, double, Candidate& c)
  {
    const auto vertices = state.surface.vertices(c.primitive);
    if (!surelyHit(e))
    {
      ++state.exactTests;
      if (!exact::lineMeetsTriangle(state.ray, vertices))
      {
        return false;
      }
    }
    const Crossing x = crossing(state.filter, vertices);
    c.tLow = x.tLow;
    c.tHigh = x.tHigh;
    c.key = x.t;
    return atLeast(state, vertices, x, state.ray.tMin) && atMost(state, vertices, x);
  }

  static bool before(RayState& state, const Candidate& a, const Candidate& b)
  {
    if (a.tHigh < b.tLow)
    {
      return true;
    }
    if (b.tHigh < a.tLow)
    {
      return false;
    }
    ++state.exactTests;
    const int order = exact::compareCrossings(
      state.ray, state.surface.vertices(a.primitive), state.surface.vertices(b.primitive));
    return order < 0 || (order == 0 && a.primitive < b.primitive);
  }

  static double stopAt(const Candidate& c) { return c.tHigh; }

private:
  static bool atLeast(
    RayState& state, const std::array<Vec3, 3>& vertices, const Crossing& x, double limit)
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

  static bool atMost(RayState& state, const std::array<Vec3, 3>& vertices, const Crossing& x)
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

} // namespace lumitree

#endif
