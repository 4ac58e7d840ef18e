// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Kernel/Finish.h"

#include "Accel/Kernel/Precisions.h"
#include "Accel/Kernel/Queries.h"

namespace lumitree
{

namespace
{

template <class PrecisionPolicy>
void arrangeFor(RayState& state, QueryKind query)
{
  if (query == QueryKind::Ties)
  {
    keepLeast<PrecisionPolicy>(state);
  }
  else
  {
    arrange<PrecisionPolicy>(state);
  }
}

/// Half a float ulp is 2^-25 of t at least: a wider interval does not decide the float nearest to
/// t.
bool isVague(double tLow, double tHigh, double t)
{
  return tHigh - tLow > 0x1p-26 * std::fabs(t);
}

/// By the triangle's own bound: a block's depends on which triangles share it.
bool isVague(const RayState& state, const Candidate& c)
{
  if (!state.surface.isTriangle(c.primitive))
  {
    return true;
  }
  const Crossing x = crossing(state.ray, state.surface.vertices(c.primitive));
  return isVague(x.tLow, x.tHigh, x.t);
}

} // namespace

void arrange(RayState& state, QueryKind query, Precision precision)
{
  switch (precision)
  {
    case Precision::Fast:
      return arrangeFor<FastPrecision>(state, query);
    case Precision::Watertight:
      return arrangeFor<WatertightPrecision>(state, query);
    default:
      return arrangeFor<ExactPrecision>(state, query);
  }
}

void finish(RayState& state, QueryKind query, const QueryOptions& options, std::vector<Hit>& hits)
{
  const bool sameT = query == QueryKind::Ties && options.precision == Precision::Exact;
  for (std::size_t i = 0; i < state.found.size(); ++i)
  {
    Hit hit = finish(state, state.found[i], options);
    if (i > 0)
    {
      hit.t = sameT ? hits.back().t : std::max(hit.t, hits.back().t);
    }
    hits.push_back(hit);
  }
}

Hit finish(RayState& state, const Candidate& c, const QueryOptions& options)
{
  Hit hit;
  hit.primitive = c.primitive;
  // What hits are ordered by, so that t ascends with them.
  hit.t = c.key;
  hit.u = c.u;
  hit.v = c.v;
  hit.flags = c.flags;
  if (state.uncertainOrder == state.index)
  {
    hit.flags |= HitFlag::UncertainOrder;
  }
  if (options.precision == Precision::Exact &&
    (options.roundedT || (isVague(c.tLow, c.tHigh, c.t) && isVague(state, c))) &&
    !state.surface.isImplicit(c.primitive))
  {
    ++state.exactParameters;
    hit.t = state.surface.isQuadric(c.primitive)
      ? nearestParameter(state, c)
      : exact::crossingParameter(state.ray, state.surface.vertices(c.primitive));
  }
  hit.t = std::min(std::max(hit.t, state.ray.tMin), state.ray.tMax);
  return hit;
}

} // namespace lumitree
