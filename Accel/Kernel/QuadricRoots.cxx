// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Kernel/QuadricRoots.h"

#include "Accel/Kernel/Shifted.h"

namespace lumitree
{
namespace
{

using Point = std::array<Bounded, 3>;

/// Value, and derivative along d, of a form at the point y from its centre.
struct Expansion
{
  Bounded a; ///< of s²
  Bounded b; ///< of s
  Bounded c;
};

Bounded valueOf(const QuadricForm& form, const Point& y)
{
  const auto& f = form.coefficients;
  Bounded c = Bounded(f[9]) + Bounded(form.residue);
  for (int k = 0; k < 3; ++k)
  {
    const int n = (k + 1) % 3;
    c = c + (Bounded(f[k]) * y[k] + Bounded(f[3 + k]) * y[n] + Bounded(f[6 + k])) * y[k];
  }
  return c;
}

Expansion expansionOf(const QuadricForm& form, const Point& y, const Vec3& d)
{
  const auto& f = form.coefficients;
  Expansion e;
  e.c = valueOf(form, y);
  for (int k = 0; k < 3; ++k)
  {
    const int n = (k + 1) % 3;
    const Bounded square(f[k]);
    const Bounded mixed(f[3 + k]);
    const Bounded dk(d[k]);
    const Bounded dn(d[n]);
    e.a = e.a + (square * dk + mixed * dn) * dk;
    e.b = e.b + (twice(square * y[k]) + mixed * y[n] + Bounded(f[6 + k])) * dk + mixed * y[k] * dn;
  }
  return e;
}

bool isTrivial(const QuadricForm& form)
{
  return form.residue == 0.0 &&
    std::all_of(
      form.coefficients.begin(), form.coefficients.end(), [](double x) { return x == 0.0; });
}

} // namespace

QuadricRoots::QuadricRoots(const Ray& ray, const Quadric& quadric)
  : ray_(ray)
  , quadric_(quadric)
{
  // Any t0 is right.
  this->t0_ = nearMiddle(ray, quadric.clip);
  if (!std::isfinite(this->t0_))
  {
    return;
  }
  for (int k = 0; k < 3; ++k)
  {
    this->middle_[k] = shifted(ray.origin[k], quadric.form.centre[k], this->t0_, ray.direction[k]);
  }
  const Expansion e = expansionOf(quadric.form, this->middle_, ray.direction);
  this->solve(e.a, e.b, e.c);
}

void QuadricRoots::solve(const Bounded& a, const Bounded& b, const Bounded& c)
{
  if (a.isZero())
  {
    if (b.isZero())
    {
      this->constant_ = true;
      this->known_ = Known::Roots;
      return;
    }
    this->known_ = b.surelyNegative() || b.surelyPositive() ? Known::Roots : Known::Nothing;
    if (b.value != 0.0)
    {
      this->add(-c / b);
    }
  }
  else
  {
    const Bounded d = b * b - twice(twice(a * c));
    const bool degree = a.surelyNegative() || a.surelyPositive();
    if (!d.isFinite())
    {
      return;
    }
    if (d.surelyNegative())
    {
      // Of either degree: a line would have d = b².
      this->known_ = Known::Roots;
      return;
    }
    if (d.surelyPositive())
    {
      const Bounded root = squareRoot(d);
      const Bounded sum = b.value < 0.0 ? b - root : b + root;
      const Bounded q = Bounded(-0.5 * sum.value, 0.5 * sum.error);
      const Bounded first = q / a;
      const Bounded second = c / q;
      // q / a is the lower root where -sqrt(D) / a is negative.
      const bool ascending = (b.value < 0.0) == (a.value < 0.0);
      this->known_ = degree ? Known::Roots : Known::Nothing;
      this->add(ascending ? first : second);
      this->add(ascending ? second : first);
    }
    else if (degree)
    {
      // Both roots, if there are any, are within sqrt(D) / 2 a of the middle.
      this->known_ = d.isZero() ? Known::Roots : Known::TwoOneOrNone;
      this->apparentlyNone_ = d.value < 0.0;
      const Bounded middle = -b / twice(a);
      double spread = 0.0;
      if (!d.isZero())
      {
        const Bounded half = squareRoot(Bounded((d.value + d.error) * (1.0 + 0x1p-50))) / twice(a);
        spread = std::fabs(half.value) * (1.0 + 0x1p-50) + half.error;
      }
      this->add({ middle.value, middle.error + spread * (1.0 + 0x1p-49) });
    }
  }
  for (int i = 0; i < this->count_; ++i)
  {
    const Root& r = this->roots_[i];
    if (!std::isfinite(r.t) || !std::isfinite(r.tLow) || !std::isfinite(r.tHigh))
    {
      this->known_ = Known::Nothing;
    }
  }
}

void QuadricRoots::add(const Bounded& s)
{
  Root& root = this->roots_[this->count_++];
  root.s = s;
  const Bounded t = Bounded(this->t0_) + s;
  root.t = t.value;
  const double pad = t.error + 0x1p-52 * std::fabs(t.value) + 0x1p-1070;
  root.tLow = t.value - pad;
  root.tHigh = t.value + pad;
}

template <class F>
void QuadricRoots::eachConstraint(int root, F f) const
{
  Point y;
  const Vec3& centre = this->quadric_.form.centre;
  for (int k = 0; k < 3; ++k)
  {
    y[k] = this->middle_[k] + this->roots_[root].s * Bounded(this->ray_.direction[k]);
    f(y[k] + (Bounded(centre[k]) - Bounded(this->quadric_.clip.lower[k])));
    f((Bounded(this->quadric_.clip.upper[k]) - Bounded(centre[k])) - y[k]);
  }
  for (const QuadricCut& cut : this->quadric_.cuts)
  {
    Bounded distance;
    for (int k = 0; k < 3; ++k)
    {
      distance =
        distance - Bounded(cut.normal[k]) * (y[k] + (Bounded(centre[k]) - Bounded(cut.point[k])));
    }
    if (!distance.isZero())
    {
      f(distance);
    }
  }
  if (!isTrivial(this->quadric_.bound))
  {
    for (int k = 0; k < 3; ++k)
    {
      y[k] = y[k] + (Bounded(centre[k]) - Bounded(this->quadric_.bound.centre[k]));
    }
    f(-valueOf(this->quadric_.bound, y));
  }
}

SignRange QuadricRoots::treeSign(int root, SignRange own, bool& certain) const
{
  certain = true;
  Point y; // less the form's centre
  for (int k = 0; k < 3; ++k)
  {
    y[k] = this->middle_[k] + this->roots_[root].s * Bounded(this->ray_.direction[k]);
  }
  const ImplicitTree& tree = *this->quadric_.tree;
  const Vec3& centre = this->quadric_.form.centre;
  return tree.evaluate<SignRange>(
    [&](std::size_t i)
    {
      const QuadricForm& form = tree.forms[i];
      if (form == this->quadric_.form)
      {
        return own;
      }
      Point z;
      for (int k = 0; k < 3; ++k)
      {
        z[k] = y[k] + (Bounded(centre[k]) - Bounded(form.centre[k]));
      }
      const SignRange sign = SignRange::of(valueOf(form, z));
      certain = certain && sign.surelyNotZero();
      return sign;
    },
    [](std::size_t) {
      return SignRange{ -1, 1 };
    });
}

int QuadricRoots::inside(int root) const
{
  bool out = false;
  bool in = true;
  this->eachConstraint(root,
    [&](const Bounded& distance)
    {
      out = out || distance.surelyNegative();
      in = in && distance.value >= distance.error;
    });
  if (this->quadric_.tree && !out)
  {
    bool certain = true;
    const SignRange sign = this->treeSign(root, {}, certain);
    out = sign.surelyNotZero();
    in = in && sign.surelyZero();
  }
  return out ? -1 : (in ? 1 : 0);
}

int QuadricRoots::movedInside(int root) const
{
  bool out = false;
  bool in = true;
  this->eachConstraint(root,
    [&](const Bounded& distance)
    {
      out = out || distance.surelyNegative();
      in = in && distance.surelyPositive();
    });
  if (this->quadric_.tree && !out)
  {
    // Whichever way the form changes its sign, the tree changes its own or does not. Where another
    // form may be 0 as well, exact arithmetic finds which of them passes.
    bool certain = true;
    const int below = this->treeSign(root, { -1, -1 }, certain).low;
    const int above = this->treeSign(root, { 1, 1 }, certain).low;
    out = certain && below * above >= 0;
    in = in && certain && below * above < 0;
  }
  return out ? -1 : (in ? 1 : 0);
}

bool QuadricRoots::apparentlyInside(int root) const
{
  bool in = true;
  this->eachConstraint(root, [&](const Bounded& distance) { in = in && distance.value >= 0.0; });
  bool certain = true;
  return in && !(this->quadric_.tree && this->treeSign(root, {}, certain).surelyNotZero());
}

} // namespace lumitree
