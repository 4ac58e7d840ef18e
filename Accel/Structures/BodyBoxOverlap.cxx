// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/BodyBoxOverlap.h"

#include <algorithm>

namespace lumitree
{
namespace
{

/// Far above the rounding of the bounds below (less than 40 operations), and above what the double
/// arithmetic of leaf tests can be wrong by, so that leaves hold what Fast and Watertight may find.
constexpr double relativePad = 0x1p-30;

/// No value of the form on the box is outside.
Interval rangeOf(const QuadricForm& form, const Box& box)
{
  const auto& a = form.coefficients;
  const Vec3 centre = box.centre();
  const Vec3 size = box.size();
  const Vec3 y = centre - form.centre;
  const Vec3 gradient = gradientAt(form, centre);
  Vec3 reach;
  double low = valueAt(form, centre);
  double high = low;
  for (int k = 0; k < 3; ++k)
  {
    const double half = 0.5 * size[k];
    const double square = a[k] * half * half;
    low += std::min(square, 0.0) - std::fabs(gradient[k]) * half;
    high += std::max(square, 0.0) + std::fabs(gradient[k]) * half;
    reach[k] = std::fabs(y[k]) + half;
  }
  double magnitude = std::fabs(a[9]) + std::fabs(form.residue);
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    const double mixed = std::fabs(a[3 + k]) * (0.5 * size[k]) * (0.5 * size[next]);
    low -= mixed;
    high += mixed;
    magnitude += std::fabs(a[k]) * reach[k] * reach[k] +
      std::fabs(a[3 + k]) * reach[k] * reach[next] + std::fabs(a[6 + k]) * reach[k];
  }
  const double pad = relativePad * magnitude;
  return { low - pad, high + pad };
}

/// Whether normal · (x - point) may be 0 or less somewhere in the box.
bool mayReach(const QuadricCut& cut, const Box& box)
{
  double low = 0.0;
  double magnitude = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const double n = cut.normal[k];
    const double x = n > 0.0 ? box.lower[k] : box.upper[k];
    low += n * (x - cut.point[k]);
    magnitude += std::fabs(n) * (std::fabs(x) + std::fabs(cut.point[k]));
  }
  // The negation keeps what overflowed.
  return !(low > relativePad * magnitude);
}

/// The tree's range; not told apart from 0 where nothing is known.
Interval rangeOf(const ImplicitTree& tree, const Box& box)
{
  return tree.evaluate<Interval>([&](std::size_t i) { return rangeOf(tree.forms[i], box); },
    [](std::size_t) { return Interval::everything(); });
}

/// The part of the box in the clip box; false where there is none.
bool clipTo(const Box& clip, const Box& box, Box& part)
{
  for (int k = 0; k < 3; ++k)
  {
    part.lower[k] = std::max(box.lower[k], clip.lower[k]);
    part.upper[k] = std::min(box.upper[k], clip.upper[k]);
    if (!(part.lower[k] <= part.upper[k]))
    {
      return false;
    }
  }
  return true;
}

/// value: of the function that decides, in double arithmetic.
template <class Body, class F>
bool mayHavePoints(const Body& body, F value, const Box& box, int depth)
{
  if (!mayMeet(body, box))
  {
    return false;
  }
  // Opposite signs in two corners: there are points between, unless cuts take them all.
  const bool below = value(box.lower) < 0.0;
  if (depth == 0 || (value(box.upper) < 0.0) != below || (value(box.centre()) < 0.0) != below)
  {
    return true;
  }
  const int axis = box.longestAxis();
  Box first = box;
  Box second = box;
  first.upper[axis] = second.lower[axis] = box.centre()[axis];
  return mayHavePoints(body, value, first, depth - 1) ||
    mayHavePoints(body, value, second, depth - 1);
}

constexpr int deepest = 9;

} // namespace

bool mayMeet(const Quadric& quadric, const Box& box)
{
  Box part;
  if (!clipTo(quadric.clip, box, part))
  {
    return false;
  }
  const Interval range = rangeOf(quadric.form, part);
  return !(range.low > 0.0) && !(range.high < 0.0) && mayReach(quadric.cuts[0], part) &&
    mayReach(quadric.cuts[1], part) && !(rangeOf(quadric.bound, part).low > 0.0) &&
    !(quadric.tree && rangeOf(*quadric.tree, part).sign() != 0);
}

bool mayMeet(const Implicit& implicit, const Box& box)
{
  Box part;
  if (!clipTo(implicit.clip, box, part))
  {
    return false;
  }
  std::array<Jet, 3> x;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double pad = relativePad *
      (std::max(std::fabs(part.lower[k]), std::fabs(part.upper[k])) +
        (implicit.clip.upper[k] - implicit.clip.lower[k]));
    x[k].value = { part.lower[k] - pad, part.upper[k] + pad };
  }
  return implicit.function->bound(x).value.sign() == 0;
}

bool mayMeet(const Surface& surface, PrimitiveId body, const Box& box)
{
  return surface.isImplicit(body) ? mayMeet(surface.implicit(body), box)
                                  : mayMeet(surface.quadric(body), box);
}

bool mayHavePoints(const Quadric& quadric)
{
  return mayHavePoints(
    quadric, [&](const Vec3& x) { return valueAt(quadric.form, x); }, quadric.clip, deepest);
}

bool mayHavePoints(const Implicit& implicit)
{
  return !implicit.function->isBounded() ||
    mayHavePoints(
      implicit, [&](const Vec3& x) { return implicit.function->value(x); }, implicit.clip, deepest);
}

} // namespace lumitree
