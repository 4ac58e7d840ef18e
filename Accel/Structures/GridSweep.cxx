// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/GridSweep.h"

namespace lumitree
{

GridSweep::GridSweep(const GridLattice& lattice, const RayBox& ray)
  : lattice_(lattice)
  , t_(ray.tMin())
  , end_(std::min(ray.tMax(), greatest))
{
  std::ptrdiff_t stride = 1;
  for (int k = 0; k < 3; ++k)
  {
    Axis& axis = this->axes_[k];
    axis.count = lattice.count(k);
    axis.origin = ray.origin()[k];
    axis.reciprocal = ray.reciprocal(k);
    const bool backward = ray.negative(k);
    axis.plane = lattice.planes(k).data() + (backward ? axis.count : 0);
    axis.step = backward ? -1 : 1;
    axis.cell = backward ? (axis.count - 1) * stride : 0;
    axis.stride = backward ? -stride : stride;
    stride *= axis.count;
    if (std::isfinite(axis.reciprocal))
    {
      this->t_ = std::max(this->t_, earlier(crossing(axis, 0)));
      this->end_ = std::min(this->end_, later(crossing(axis, axis.count)));
    }
    else
    {
      this->placeStill(axis, std::isnan(axis.reciprocal));
    }
  }
  if (!(this->t_ <= this->end_))
  {
    return;
  }
  for (int k = 0; k < 3; ++k)
  {
    Axis& axis = this->axes_[k];
    if (std::isfinite(axis.reciprocal))
    {
      axis.direction = 1.0 / axis.reciprocal;
      this->placeMoving(axis, this->slabAt(k));
    }
  }
}

bool GridSweep::leap()
{
  double t = infinity;
  std::array<int, 3> ends;
  for (int k = 0; k < 3; ++k)
  {
    const Axis& axis = this->axes_[k];
    if (axis.first != axis.last)
    {
      return false;
    }
    ends[k] = blockEnd(axis);
    if (ends[k] < axis.count && std::isfinite(axis.reciprocal))
    {
      t = std::min(t, earlier(crossing(axis, ends[k])));
    }
  }
  if (!(t > this->t_))
  {
    return false;
  }
  // Up to then no plane around the block is crossed, so every cell on the way is one of the block.
  this->t_ = t;
  if (!(t <= this->end_))
  {
    return true;
  }
  this->fresh_ = -1;
  int left = 0;
  for (int k = 0; k < 3; ++k)
  {
    Axis& axis = this->axes_[k];
    if (std::isfinite(axis.reciprocal))
    {
      this->placeMoving(axis, this->slabAt(k));
      if (axis.last >= ends[k])
      {
        ++left;
        this->fresh_ = k;
      }
    }
  }
  if (left != 1 || this->axes_[this->fresh_].last > ends[this->fresh_])
  {
    this->fresh_ = -1; // more than one slab is new
  }
  return true;
}

int GridSweep::slabAt(int k) const
{
  const Axis& axis = this->axes_[k];
  const int slab = this->lattice_.slabNear(k, axis.origin + this->t_ * axis.direction);
  return axis.step > 0 ? slab : axis.count - 1 - slab;
}

void GridSweep::placeStill(Axis& axis, bool unknown)
{
  axis.begin = axis.finish = infinity;
  const auto outside = [&](double nearPlane, double farPlane)
  {
    return axis.step > 0 ? axis.origin < nearPlane || axis.origin > farPlane
                         : axis.origin > nearPlane || axis.origin < farPlane;
  };
  const auto slabOutside = [&](int slab)
  { return !unknown && outside(axis.plane[slab * axis.step], axis.plane[(slab + 1) * axis.step]); };
  axis.last = axis.count - 1;
  if (!unknown && outside(axis.plane[0], axis.plane[axis.count * axis.step]))
  {
    this->end_ = -infinity;
    this->t_ = infinity;
    return;
  }
  while (slabOutside(axis.first))
  {
    ++axis.first;
  }
  while (slabOutside(axis.last))
  {
    --axis.last;
  }
}

void GridSweep::placeMoving(Axis& axis, int guess)
{
  axis.first = axis.last = guess;
  while (axis.first > 0 && later(crossing(axis, axis.first)) >= this->t_)
  {
    --axis.first;
  }
  while (axis.first + 1 < axis.count && later(crossing(axis, axis.first + 1)) < this->t_)
  {
    ++axis.first;
  }
  axis.last = std::max(axis.last, axis.first);
  while (axis.last + 1 < axis.count && earlier(crossing(axis, axis.last + 1)) <= this->t_)
  {
    ++axis.last;
  }
  while (axis.last > axis.first && earlier(crossing(axis, axis.last)) > this->t_)
  {
    --axis.last;
  }
  axis.finish = later(crossing(axis, axis.first + 1));
  axis.begin = beginAfter(axis);
}

} // namespace lumitree
