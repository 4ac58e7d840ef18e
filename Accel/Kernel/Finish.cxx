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

Hit finish(const RayState& state, PrimitiveId primitive, Precision precision)
{
  const auto vertices = state.surface.vertices(primitive);
  const Crossing x = crossing(state.filter, vertices);
  Hit hit;
  hit.primitive = primitive;
  hit.t = x.t;
  hit.u = x.u;
  hit.v = x.v;
  // Half a float ulp is 2^-25 of t at least: a wider interval does not decide the float nearest to t.
  if (precision == Precision::Exact && x.tHigh - x.tLow > 0x1p-26 * std::fabs(x.t))
  {
    hit.t = exact::crossingParameter(state.ray, vertices);
  }
  hit.t = std::min(std::max(hit.t, state.ray.tMin), state.ray.tMax);
  return hit;
}

} // namespace lumitree
