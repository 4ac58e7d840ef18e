// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Kernel/Finish.h"

#include "Accel/Kernel/Precisions.h"
#include "Accel/Kernel/Queries.h"

namespace lumitree
{

void arrange(RayState& state, Precision precision)
{
  switch (precision)
  {
    case Precision::Fast:
      return arrange<FastPrecision>(state);
    case Precision::Watertight:
      return arrange<WatertightPrecision>(state);
    default:
      return arrange<ExactPrecision>(state);
  }
}

Hit finish(const RayState& state, const Candidate& c, Precision precision)
{
  Hit hit;
  hit.primitive = c.primitive;
  hit.t = c.t;
  hit.u = c.u;
  hit.v = c.v;
  // Half a float ulp is 2^-25 of t at least: a wider interval does not decide the float nearest to
  // t.
  if (precision == Precision::Exact && c.tHigh - c.tLow > 0x1p-26 * std::fabs(c.t))
  {
    hit.t = state.surface.isQuadric(c.primitive)
      ? nearestParameter(state, c)
      : exact::crossingParameter(state.ray, state.surface.vertices(c.primitive));
  }
  hit.t = std::min(std::max(hit.t, state.ray.tMin), state.ray.tMax);
  return hit;
}

} // namespace lumitree
