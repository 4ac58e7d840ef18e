// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Kernel/ImplicitRoots.h"

#include "Accel/Hit.h"
#include "Accel/Kernel/RayBox.h"
#include "Accel/Kernel/Shifted.h"

#include <cmath>

namespace lumitree
{
namespace
{

/// a / b, b without 0.
Interval quotient(const Interval& a, const Interval& b)
{
  const double q[4] = { a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high };
  for (const double x : q)
  {
    if (std::isnan(x))
    {
      return Interval::everything();
    }
  }
  return Interval::rounded(*std::min_element(q, q + 4), *std::max_element(q, q + 4));
}

/// A width that t cannot resolve.
double finest(double t0, const Interval& s)
{
  return 0x1p-51 * (std::fabs(t0) * 0.25 + std::max(std::fabs(s.low), std::fabs(s.high))) +
    0x1p-1060;
}

int signOf(double x)
{
  return x > 0.0 ? 1 : (x < 0.0 ? -1 : 0);
}

} // namespace

/// Neighbouring intervals in which nothing could be decided.
struct ImplicitRoots::Cluster
{
  bool open = false;
  Interval s;
  int signLow = 0;  ///< before it
  int lastSign = 0; ///< where the function was decided last
};

ImplicitRoots::ImplicitRoots(const Ray& ray, const Implicit& implicit)
  : ray_(ray)
  , implicit_(implicit)
  , t0_(nearMiddle(ray, implicit.clip))
{
  this->t0_ = std::isfinite(this->t0_) ? this->t0_ : 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    this->middle_[k] = shifted(ray.origin[k], 0.0, this->t0_, ray.direction[k]);
  }
  this->speed_ = std::hypot(ray.direction[0], ray.direction[1], ray.direction[2]);
  this->tolerance_ = toleranceOf(implicit) / this->speed_;
}

std::vector<ImplicitRoot> ImplicitRoots::find(bool firstOnly, bool uncertain)
{
  this->firstOnly_ = firstOnly;
  this->uncertain_ = uncertain;
  // The box is met by the line; limits come later, so that samples do not depend on them.
  Ray line = this->ray_;
  line.tMin = -std::numeric_limits<double>::infinity();
  line.tMax = std::numeric_limits<double>::infinity();
  double enter = 0.0;
  double exit = 0.0;
  if (!RayBox(line).meets(this->implicit_.clip, line.tMax, enter, exit))
  {
    return {};
  }
  // From far away the bounds of t are wide: s goes by the points' distance from the middle as well.
  const double reach = length(this->implicit_.clip.size()) / this->speed_;
  const double low = std::max(enter - this->t0_, -reach);
  const double high = std::min(exit - this->t0_, reach);
  if (this->implicit_.function->isBounded())
  {
    this->isolate(std::max(low, std::max(this->ray_.tMin, enter) - this->t0_),
      std::min(high, std::min(this->ray_.tMax, exit) - this->t0_));
  }
  else
  {
    this->sample(low, high);
  }
  return std::move(this->roots_);
}

Jet ImplicitRoots::boundOver(const Interval& s)
{
  ++this->bounds_;
  std::array<Jet, 3> x;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Interval middle = { this->middle_[k].value - this->middle_[k].error,
      this->middle_[k].value + this->middle_[k].error };
    x[k] = { middle + s * Interval(this->ray_.direction[k]), Interval(this->ray_.direction[k]) };
  }
  return this->implicit_.function->bound(x);
}

int ImplicitRoots::signAt(double s)
{
  return this->boundOver(s).value.sign();
}

Vec3 ImplicitRoots::pointAt(double s) const
{
  return { this->middle_[0].value + s * this->ray_.direction[0],
    this->middle_[1].value + s * this->ray_.direction[1],
    this->middle_[2].value + s * this->ray_.direction[2] };
}

double ImplicitRoots::valueAt(double s) const
{
  return this->implicit_.function->value(this->pointAt(s));
}

void ImplicitRoots::isolate(double low, double high)
{
  if (!(low <= high))
  {
    return;
  }
  std::vector<Interval> stack{ { low, high } };
  Cluster cluster;
  cluster.lastSign = this->signAt(low);
  while (!stack.empty() && !this->done())
  {
    const Interval s = stack.back();
    stack.pop_back();
    const double middle = s.middle();
    const Jet whole = this->boundOver(s);
    const Interval inside = this->boundOver(middle).value;
    const Interval byMean = inside + whole.slope * (s - Interval(middle));
    const int sign = common(whole.value, byMean).sign();
    if (sign != 0)
    {
      this->close(cluster, sign);
      continue;
    }
    if (whole.slope.sign() != 0)
    {
      const int first = this->signAt(s.low);
      const int second = this->signAt(s.high);
      if (first * second != 0)
      {
        this->close(cluster, first);
        if (first != second && !this->done())
        {
          this->refine(s, first);
          cluster.lastSign = second;
        }
        continue;
      }
    }
    const double enough = inside.sign() == 0 ? 0x1p12 * this->tolerance_ : this->tolerance_;
    const bool small = s.width() <= std::max(enough, finest(this->t0_, s));
    if (small || this->bounds_ > mostBounds)
    {
      if (!cluster.open)
      {
        cluster.open = true;
        cluster.signLow = cluster.lastSign;
        cluster.s.low = s.low;
      }
      cluster.s.high = s.high;
      continue;
    }
    stack.emplace_back(middle, s.high);
    stack.emplace_back(s.low, middle);
  }
  if (!this->done())
  {
    this->close(cluster, this->signAt(high));
  }
}

void ImplicitRoots::close(Cluster& cluster, int signHigh)
{
  if (cluster.open && !this->done())
  {
    const bool certain = cluster.signLow * signHigh < 0;
    // At an end of the segment the sign may not be certain: what double arithmetic says.
    const int before =
      cluster.signLow != 0 ? cluster.signLow : signOf(this->valueAt(cluster.s.low));
    const int after = signHigh != 0 ? signHigh : signOf(this->valueAt(cluster.s.high));
    this->add(cluster.s, certain, (before < 0) != (after < 0));
  }
  cluster.open = false;
  cluster.lastSign = signHigh;
}

void ImplicitRoots::refine(Interval s, int signLow)
{
  for (int i = 0; i < 100 && s.width() > finest(this->t0_, s); ++i)
  {
    const double middle = s.middle();
    const Interval value = this->boundOver(middle).value;
    // Newton's step on intervals holds the root.
    const Interval slope = this->boundOver(s).slope;
    const Interval newton =
      slope.sign() != 0 ? common(s, Interval(middle) - quotient(value, slope)) : s;
    if (newton.width() <= 0.5 * s.width())
    {
      s = newton;
    }
    else if (value.sign() != 0)
    {
      (value.sign() == signLow ? s.low : s.high) = middle;
    }
    else
    {
      break;
    }
  }
  this->add(s, true, true);
}

bool ImplicitRoots::isBeside(double s) const
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Bounded x = this->middle_[k] + Bounded(s) * Bounded(this->ray_.direction[k]);
    if ((x - Bounded(this->implicit_.clip.lower[k])).surelyNegative() ||
      (x - Bounded(this->implicit_.clip.upper[k])).surelyPositive())
    {
      return true;
    }
  }
  return false;
}

void ImplicitRoots::add(const Interval& s, bool certain, bool passes)
{
  const double middle = s.middle();
  ImplicitRoot root;
  root.t = this->t0_ + middle;
  const Interval t = Interval(this->t0_) + s;
  root.tLow = std::min(t.low, root.t);
  root.tHigh = std::max(t.high, root.t);
  const bool bounded = this->implicit_.function->isBounded();
  if (bounded)
  {
    // Isolated between the limits, up to the rounding of t.
    certain = certain && root.tLow >= this->ray_.tMin && root.tHigh <= this->ray_.tMax;
    root.t = std::min(std::max(root.t, this->ray_.tMin), this->ray_.tMax);
    root.tLow = std::min(root.tLow, root.t);
    root.tHigh = std::max(root.tHigh, root.t);
  }
  root.passes = passes;
  if (!bounded)
  {
    root.flags = HitFlag::Sampled;
  }
  else if (!certain)
  {
    root.flags = HitFlag::Uncertain;
  }
  if (root.t >= this->ray_.tMin && root.t <= this->ray_.tMax && !this->isBeside(middle) &&
    (certain || passes || this->uncertain_))
  {
    this->roots_.push_back(root);
  }
}

void ImplicitRoots::sample(double low, double high)
{
  const double step = stepOf(this->implicit_) / this->speed_;
  const auto place = [&](double t) { return (t - this->t0_ - low) / step; };
  const double last = std::ceil((high - low) / step);
  const double from = std::max(0.0, std::floor(place(this->ray_.tMin)));
  const double to = std::min(last, std::ceil(place(this->ray_.tMax)));
  int sign = 0; // the last one that was not 0
  double before = low;
  for (double i = from; i <= to && !this->done(); i += 1.0)
  {
    const double s = std::min(low + i * step, high);
    const double value = this->valueAt(s);
    const int here = std::isnan(value) ? 0 : signOf(value);
    if (sign * here < 0)
    {
      Interval bracket = { before, s };
      for (int n = 0; n < 60 && bracket.width() > 0x1p-12 * this->tolerance_; ++n)
      {
        const double middle = bracket.middle();
        const double between = this->valueAt(middle);
        (signOf(between) == here ? bracket.high : bracket.low) = middle;
      }
      this->add(bracket, true, true);
    }
    // A zero belongs to what was before; nothing is known across a NaN.
    sign = std::isnan(value) ? 0 : (here != 0 ? here : sign);
    before = s;
  }
}

} // namespace lumitree
