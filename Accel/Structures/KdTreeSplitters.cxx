// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/KdTreeSplitters.h"

#include "Accel/Hierarchy.h"

namespace lumitree
{
namespace
{

/// What a plane costs that leaves one side empty.
constexpr double emptyBonus = 0.8;

/// The area of a cell's parts, as shares of the cell's own. Sizes are scaled first, so that no
/// product overflows.
class Areas
{
public:
  Areas(const Box& cell, int axis)
    : lower_(cell.lower[axis])
    , upper_(cell.upper[axis])
  {
    const Vec3 size = cell.size();
    const double longest = size[cell.longestAxis()];
    const auto scaled = [&](int k) { return size[k % 3] / longest; };
    const double cross = scaled(axis + 1) * scaled(axis + 2);
    const double sides = scaled(axis) * (scaled(axis + 1) + scaled(axis + 2));
    this->total_ = cross + sides;
    this->cross_ = cross / this->total_;
    this->sides_ = sides / this->total_;
  }

  [[nodiscard]] bool isZero() const { return !(this->total_ > 0.0); }

  [[nodiscard]] double below(double position) const { return this->share(position - this->lower_); }
  [[nodiscard]] double above(double position) const { return this->share(this->upper_ - position); }

private:
  [[nodiscard]] double share(double length) const
  {
    return this->cross_ + length / (this->upper_ - this->lower_) * this->sides_;
  }

  double lower_;
  double upper_;
  double cross_ = 0.0;
  double sides_ = 0.0;
  double total_ = 0.0;
};

} // namespace

KdSplit spatialMedianSplit(const Box& cell, std::size_t references, int leafSize)
{
  const int axis = cell.longestAxis();
  const double middle = cell.centre()[axis];
  // Between neighbouring numbers there is no middle.
  const bool divides = cell.lower[axis] < middle && middle < cell.upper[axis];
  if (!divides || references <= static_cast<std::size_t>(leafSize))
  {
    return {};
  }
  return { axis, middle, true };
}

KdOffer kdLeafOffer(std::size_t references)
{
  return { {}, leafCost(references) };
}

KdOffer cheapestAcross(int axis, const Box& cell, std::size_t references,
  const std::vector<KdEvent>& events, const KdOffer& before)
{
  KdOffer best = before;
  const Areas areas(cell, axis);
  if (references < 2 || !(cell.lower[axis] < cell.upper[axis]) || areas.isZero())
  {
    return best;
  }
  const auto offer = [&](double position, bool inPlaneBelow, double shareBelow, std::size_t below,
                       double shareAbove, std::size_t above)
  {
    const double bonus = below == 0 || above == 0 ? emptyBonus : 1.0;
    const double cost =
      bonus * (kdStepCost + shareBelow * leafCost(below) + shareAbove * leafCost(above));
    if (cost < best.cost)
    {
      best = { { axis, position, inPlaneBelow }, cost };
    }
  };
  std::size_t below = 0;          // references that begin below the plane, flat ones included
  std::size_t above = references; // those that do not end below or at it
  const KdEvent* event = events.data();
  const KdEvent* const end = event + events.size();
  while (event != end)
  {
    const double position = event->position;
    const auto pass = [&](KdEvent::Kind kind)
    {
      const KdEvent* const first = event;
      while (event != end && event->position == position && event->kind() == kind)
      {
        ++event;
      }
      return static_cast<std::size_t>(event - first);
    };
    const std::size_t ended = pass(KdEvent::End);
    const std::size_t inPlane = pass(KdEvent::Flat);
    const std::size_t begun = pass(KdEvent::Begin);
    above -= ended + inPlane;
    const bool atLower = position <= cell.lower[axis];
    const bool atUpper = position >= cell.upper[axis];
    const double shareBelow = areas.below(position);
    const double shareAbove = areas.above(position);
    // At the cell's own faces a plane only serves to take off what lies in it.
    if (!atUpper && (inPlane > 0 || !atLower))
    {
      offer(position, true, shareBelow, below + inPlane, shareAbove, above);
    }
    if (!atLower && inPlane > 0)
    {
      offer(position, false, shareBelow, below, shareAbove, above + inPlane);
    }
    below += inPlane + begun;
  }
  return best;
}

KdSplit KdPlaneSearch::best(const Box& cell, const std::vector<KdReference>& references)
{
  KdOffer best = kdLeafOffer(references.size());
  for (int axis = 0; axis < 3 && references.size() > 1; ++axis)
  {
    this->events_.clear();
    std::uint32_t index = 0;
    for (const KdReference& r : references)
    {
      appendEvents(r.bounds, axis, index++, this->events_);
    }
    std::sort(this->events_.begin(), this->events_.end());
    best = cheapestAcross(axis, cell, references.size(), this->events_, best);
  }
  return best.split;
}

} // namespace lumitree
