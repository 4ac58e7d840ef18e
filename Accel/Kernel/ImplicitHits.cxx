// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Kernel/ImplicitHits.h"

#include "Accel/Kernel/ImplicitRoots.h"

namespace lumitree
{
namespace
{

Candidate candidateOf(
  const ImplicitRoot& root, PrimitiveId primitive, std::size_t index, double tEnter)
{
  Candidate c;
  c.primitive = primitive;
  c.root = static_cast<std::uint16_t>(index);
  c.flags = root.flags;
  c.t = root.t;
  c.tLow = root.tLow;
  c.tHigh = root.tHigh;
  c.key = std::max(root.t, tEnter);
  return c;
}

/// Whether the implicit has been dealt with along this ray; it has from now on.
bool isKnown(RayState& state, PrimitiveId primitive)
{
  if (state.implicitsRay != state.index)
  {
    state.implicitsRay = state.index;
    state.implicits.clear();
  }
  const auto place = std::find(state.implicits.begin(), state.implicits.end(), primitive);
  const bool known = place != state.implicits.end();
  if (!known)
  {
    state.implicits.push_back(primitive);
  }
  return known;
}

} // namespace

std::vector<Candidate> implicitHits(
  RayState& state, PrimitiveId primitive, Precision precision, bool everyRoot)
{
  double tEnter = 0.0;
  const Implicit& implicit = state.surface.implicit(primitive);
  std::vector<Candidate> hits;
  if (!state.box().meets(implicit.clip, std::min(state.tStop, state.ray.tMax), tEnter) ||
    isKnown(state, primitive))
  {
    return hits;
  }
  const auto roots =
    ImplicitRoots(state.ray, implicit).find(!everyRoot, precision != Precision::Fast);
  for (std::size_t i = 0; i < roots.size(); ++i)
  {
    state.exactTests += (roots[i].flags & HitFlag::Uncertain) != 0 ? 1 : 0;
    hits.push_back(candidateOf(roots[i], primitive, i, tEnter));
  }
  return hits;
}

std::vector<Candidate> implicitPassages(RayState& state, PrimitiveId primitive)
{
  double tEnter = 0.0;
  const Implicit& implicit = state.surface.implicit(primitive);
  std::vector<Candidate> passages;
  if (!state.box().meets(implicit.clip, state.ray.tMax, tEnter) || isKnown(state, primitive))
  {
    return passages;
  }
  const auto roots = ImplicitRoots(state.ray, implicit).find(false, false);
  for (std::size_t i = 0; i < roots.size(); ++i)
  {
    if (roots[i].passes)
    {
      passages.push_back(candidateOf(roots[i], primitive, i, tEnter));
    }
  }
  return passages;
}

} // namespace lumitree
