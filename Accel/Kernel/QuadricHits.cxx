// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Kernel/QuadricHits.h"

#include "Accel/Exact/Passages.h"
#include "Accel/Exact/Quadratic.h"
#include "Accel/Kernel/QuadricRoots.h"

namespace lumitree
{
namespace
{

exact::Root rootOf(const RayState& state, const Candidate& c)
{
  if (state.surface.isQuadric(c.primitive))
  {
    return { exact::Quadratic::along(state.ray, state.surface.quadric(c.primitive).form), c.root };
  }
  return { exact::planeAlong(state.ray, state.surface.vertices(c.primitive)), 0 };
}

/// Settles the roots of one quadric.
class Settling
{
public:
  Settling(RayState& state, PrimitiveId primitive, double tEnter)
    : state_(state)
    , quadric_(state.surface.quadric(primitive))
    , primitive_(primitive)
    , tEnter_(tEnter)
    , roots_(state.ray, this->quadric_)
  {
  }

  QuadricHits fast()
  {
    const int count = this->roots_.apparentlyNone() ? 0 : this->roots_.count();
    for (int i = 0; i < count; ++i)
    {
      const double t = this->roots_[i].t;
      if (std::isfinite(t) && t >= this->state_.ray.tMin && t <= this->state_.ray.tMax &&
        this->roots_.apparentlyInside(i))
      {
        this->add(i, this->roots_[i]);
      }
    }
    return this->hits_;
  }

  QuadricHits watertight()
  {
    if (this->roots_.known() == QuadricRoots::Known::Nothing)
    {
      this->decide();
      return this->hits_;
    }
    for (int i = 0; i < this->roots_.count(); ++i)
    {
      const QuadricRoots::Root& root = this->roots_[i];
      const int inside = this->roots_.inside(i);
      if (inside >= 0 && root.tHigh >= this->state_.ray.tMin && root.tLow <= this->state_.ray.tMax)
      {
        const bool sure = inside > 0 && this->roots_.known() == QuadricRoots::Known::Roots;
        this->state_.exactTests += sure ? 0 : 1;
        this->add(i, root);
      }
    }
    return this->hits_;
  }

  QuadricHits exact()
  {
    if (this->roots_.known() != QuadricRoots::Known::Roots)
    {
      this->decide();
      return this->hits_;
    }
    for (int i = 0; i < this->roots_.count(); ++i)
    {
      const QuadricRoots::Root& root = this->roots_[i];
      const Ray& ray = this->state_.ray;
      const int inside = this->roots_.inside(i);
      if (inside < 0 || root.tHigh < ray.tMin || root.tLow > ray.tMax)
      {
        continue;
      }
      if (inside == 0 || root.tLow < ray.tMin || root.tHigh > ray.tMax)
      {
        ++this->state_.exactTests;
        if (!this->isHit({ this->formAlong(), i }))
        {
          continue;
        }
      }
      this->add(i, root);
    }
    return this->hits_;
  }

  /// What is certain of the ray, with something to spare, holds for the moved one.
  QuadricHits passages()
  {
    const Ray& ray = this->state_.ray;
    bool known = this->roots_.known() == QuadricRoots::Known::Roots && !this->roots_.isConstant();
    std::array<bool, 2> passes = { false, false };
    for (int i = 0; known && i < this->roots_.count(); ++i)
    {
      const QuadricRoots::Root& root = this->roots_[i];
      const int inside = this->roots_.movedInside(i);
      const bool beyond = root.tHigh < ray.tMin || root.tLow > ray.tMax;
      const bool between = root.tLow > ray.tMin && root.tHigh < ray.tMax;
      known = inside < 0 || beyond || (inside > 0 && between);
      passes[static_cast<std::size_t>(i)] = inside > 0 && between;
    }
    if (!known)
    {
      ++this->state_.exactTests;
      passes = exact::movedPassages(ray, this->quadric_);
    }
    for (std::size_t i = 0; i < 2; ++i)
    {
      if (passes[i])
      {
        this->add(static_cast<int>(i), {});
      }
    }
    return this->hits_;
  }

private:
  [[nodiscard]] exact::Quadratic formAlong() const
  {
    return exact::Quadratic::along(this->state_.ray, this->quadric_.form);
  }

  [[nodiscard]] bool isHit(const exact::Root& root) const
  {
    const Ray& ray = this->state_.ray;
    return exact::compare(root, ray.tMin) >= 0 && exact::compare(root, ray.tMax) <= 0 &&
      exact::isInside(ray, this->quadric_, root);
  }

  /// Floating point knows too little: everything by exact arithmetic.
  void decide()
  {
    ++this->state_.exactTests;
    exact::Root root{ this->formAlong(), 0 };
    const int count = root.of.roots();
    for (; root.index < count; ++root.index)
    {
      const double t = this->isHit(root) ? exact::nearest(root) : HUGE_VAL;
      if (std::isfinite(t))
      {
        QuadricRoots::Root rounded;
        rounded.t = t;
        rounded.tLow = std::nextafter(t, -HUGE_VAL);
        rounded.tHigh = std::nextafter(t, HUGE_VAL);
        this->add(root.index, rounded);
      }
    }
  }

  void add(int index, const QuadricRoots::Root& root)
  {
    Candidate& c = this->hits_.hits[static_cast<std::size_t>(this->hits_.count++)];
    c.primitive = this->primitive_;
    c.root = static_cast<std::uint16_t>(index);
    c.t = root.t;
    c.tLow = root.tLow;
    c.tHigh = root.tHigh;
    c.key = std::max(root.t, this->tEnter_);
  }

  RayState& state_;
  const Quadric& quadric_;
  PrimitiveId primitive_;
  double tEnter_;
  QuadricRoots roots_;
  QuadricHits hits_;
};

} // namespace

QuadricHits quadricHits(RayState& state, PrimitiveId primitive, Precision precision)
{
  double tEnter = 0.0;
  const Box& box = state.surface.quadric(primitive).clip;
  if (!state.box().meets(box, std::min(state.tStop, state.ray.tMax), tEnter))
  {
    return {};
  }
  Settling settling(state, primitive, tEnter);
  switch (precision)
  {
    case Precision::Fast:
      return settling.fast();
    case Precision::Watertight:
      return settling.watertight();
    default:
      return settling.exact();
  }
}

QuadricHits quadricPassages(RayState& state, PrimitiveId primitive)
{
  double tEnter = 0.0;
  if (!state.box().meets(state.surface.quadric(primitive).clip, state.ray.tMax, tEnter))
  {
    return {};
  }
  return Settling(state, primitive, tEnter).passages();
}

int compareExactly(RayState& state, const Candidate& a, const Candidate& b)
{
  const bool implicitA = state.surface.isImplicit(a.primitive);
  const bool implicitB = state.surface.isImplicit(b.primitive);
  if (implicitA || implicitB)
  {
    // Its t, as the number it is, stands for an implicit: so the order of all is one order.
    state.uncertainOrder = state.index;
    return implicitA && implicitB ? (a.t < b.t ? -1 : (a.t > b.t ? 1 : 0))
      : implicitB                 ? exact::compare(rootOf(state, a), b.t)
                                  : -exact::compare(rootOf(state, b), a.t);
  }
  return exact::compare(rootOf(state, a), rootOf(state, b));
}

double nearestParameter(const RayState& state, const Candidate& c)
{
  return exact::nearest(rootOf(state, c));
}

} // namespace lumitree
