// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_Queries_h
#define Lumitree_Accel_Kernel_Queries_h

#include "Accel/Kernel/RayState.h"

#include <tuple>

namespace lumitree
{

/// A query alone owns order, ties and duplicates: offer takes a candidate that is hit and lowers
/// tStop as far as the query allows. Of a quadric's two roots it is offered both, or the nearer one
/// where everyRoot is false.

struct ClosestQuery
{
  static constexpr bool everyRoot = false;

  template <class Precision>
  static void offer(RayState& state, const Candidate& c)
  {
    if (state.best.primitive == noPrimitive ||
      (c.primitive != state.best.primitive && Precision::before(state, c, state.best)) ||
      (c.primitive == state.best.primitive && c.key < state.best.key))
    {
      state.best = c;
      state.tStop = std::min(state.ray.tMax, Precision::stopAt(c));
    }
  }
};

struct AnyQuery
{
  static constexpr bool everyRoot = false;

  template <class Precision>
  static void offer(RayState& state, const Candidate& c)
  {
    state.best = c;
    state.tStop = -std::numeric_limits<double>::infinity();
  }
};

/// Keeps what is at the least t.
struct TiesQuery
{
  static constexpr bool everyRoot = false;

  template <class Precision>
  static void offer(RayState& state, const Candidate& c)
  {
    const int order = state.found.empty() ? -1 : Precision::compare(state, c, state.found.front());
    if (order < 0)
    {
      state.found.clear();
      state.tStop = std::min(state.ray.tMax, Precision::stopAt(c));
    }
    if (order <= 0)
    {
      state.found.push_back(c);
    }
  }
};

/// All, Count and Crossings: every candidate is kept; a structure that holds a primitive in several
/// leaves offers it several times.
struct CollectQuery
{
  static constexpr bool everyRoot = true;

  template <class Precision>
  static void offer(RayState& state, const Candidate& c)
  {
    state.found.push_back(c);
  }
};

/// A structure may have offered a primitive from several leaves: keeps the one with the lowest key,
/// of a quadric one per root.
inline void dropDuplicates(RayState& state)
{
  auto& found = state.found;
  std::sort(found.begin(), found.end(),
    [](const Candidate& a, const Candidate& b)
    { return std::tie(a.primitive, a.root, a.key) < std::tie(b.primitive, b.root, b.key); });
  found.erase(std::unique(found.begin(), found.end(),
                [](const Candidate& a, const Candidate& b)
                { return a.primitive == b.primitive && a.root == b.root; }),
    found.end());
}

/// Drops duplicates and puts what was found in the precision's order.
template <class Precision>
void arrange(RayState& state)
{
  dropDuplicates(state);
  std::sort(state.found.begin(), state.found.end(),
    [&](const Candidate& a, const Candidate& b) { return Precision::before(state, a, b); });
}

/// Drops what is not at the least t, and duplicates; ascending by primitive.
template <class Precision>
void keepLeast(RayState& state)
{
  dropDuplicates(state);
  auto& found = state.found;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const int order = kept == 0 ? -1 : Precision::compare(state, found[i], found[0]);
    kept = order < 0 ? 0 : kept;
    if (order <= 0)
    {
      found[kept++] = found[i];
    }
  }
  found.resize(kept);
}

} // namespace lumitree

#endif
