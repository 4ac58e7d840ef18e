// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Kernel/RayBundle.h"

namespace lumitree
{
namespace
{

template <class T>
void gather(
  const void* data, const std::size_t* members, int size, double (*into)[RayBundle::capacity])
{
  const T* const triples = static_cast<const T*>(data);
  for (int i = 0; i < size; ++i)
  {
    const T* const triple = triples + 3 * members[i];
    into[0][i] = triple[0];
    into[1][i] = triple[1];
    into[2][i] = triple[2];
  }
}

void gather(
  const ArrayView& limits, double constant, const std::size_t* members, int size, double* into)
{
  for (int i = 0; i < size; ++i)
  {
    into[i] = limits ? limits.scalar(members[i]) : constant;
  }
}

} // namespace

void RayBundle::take(const RayBatch& rays, const std::size_t* members, int size, int along)
{
  this->origin = rays.origins.triple(members[0]);
  this->axis = along;
  this->count = size;
  this->unsettled = 0;
  this->failed = 0;
  this->skip = rays.skip;
  std::copy_n(members, size, this->index);
  const ArrayView& d = rays.directions;
  (d.type == ArrayView::Scalar::Float ? gather<float> : gather<double>)(d.data, members, size,
    this->direction);
  gather(rays.tMins, rays.tMin, members, size, this->tMin);
  gather(rays.tMaxs, rays.tMax, members, size, this->tMax);
  // The kernels also compute what is not asked for.
  for (int i = size; i < capacity; ++i)
  {
    for (auto& component : this->direction)
    {
      component[i] = component[0];
    }
    this->tMin[i] = this->tMin[0];
    this->tMax[i] = this->tMax[0];
  }
  std::fill_n(this->low, capacity, std::numeric_limits<double>::infinity());
  std::fill_n(this->high, capacity, std::numeric_limits<double>::infinity());
  std::fill_n(this->primitive, capacity, noPrimitive);
}

void RayBundle::load(int i)
{
  RayState& s = *this->state;
  s.ray.origin = this->origin;
  s.ray.direction = { this->direction[0][i], this->direction[1][i], this->direction[2][i] };
  s.ray.tMin = this->tMin[i];
  s.ray.tMax = this->tMax[i];
  s.start();
  s.index = this->index[i];
  s.setSkips(this->skip);
}

/// What was counted when it was first settled is not counted again.
bool RayBundle::settleBest(int i)
{
  RayState& s = *this->state;
  const Corners corners = s.surface.vertices(this->primitive[i]);
  const std::uint64_t before = s.exactTests;
  s.edges = edgeValues(s.ray, corners);
  s.settle(s, along(s.ray, corners), this->primitive[i]);
  s.exactTests = before;
  return s.best.primitive != noPrimitive;
}

void RayBundle::settle(int i, const Corners& corners, PrimitiveId id)
{
  this->load(i);
  RayState& s = *this->state;
  const std::uint64_t bit = std::uint64_t{ 1 } << i;
  if (this->primitive[i] != noPrimitive && !this->settleBest(i))
  {
    this->failed |= bit;
  }
  s.edges = edgeValues(s.ray, corners);
  s.settle(s, along(s.ray, corners), id);
  const Candidate& best = s.best;
  if (best.primitive == noPrimitive)
  {
    return;
  }
  this->primitive[i] = best.primitive;
  this->unsettled |= bit;
  const double nothingMatters = -std::numeric_limits<double>::infinity();
  this->low[i] = this->any ? nothingMatters : std::min(best.tLow, best.key);
  this->high[i] = this->any ? nothingMatters : std::max(best.tHigh, best.key);
}

bool RayBundle::finish(int i)
{
  const std::uint64_t bit = std::uint64_t{ 1 } << i;
  if ((this->failed & bit) != 0)
  {
    return false;
  }
  this->load(i);
  if (this->primitive[i] == noPrimitive)
  {
    return true;
  }
  if ((this->unsettled & bit) != 0)
  {
    return this->settleBest(i);
  }
  Candidate& best = this->state->best;
  best.primitive = this->primitive[i];
  best.key = this->t[i];
  best.t = this->t[i];
  best.tLow = this->t[i];
  best.tHigh = this->t[i];
  best.u = this->u[i];
  best.v = this->v[i];
  return true;
}

} // namespace lumitree
