// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Exact/Quadratic.h"

namespace lumitree::exact
{

Quadratic planeAlong(const Ray& ray, const std::array<Vec3, 3>& triangle)
{
  Scene<Dyadic, Vec3, 1> scene;
  scene.origin = ray.origin;
  scene.direction = ray.direction;
  scene.triangles[0] = triangle;
  const auto t = parameter(scene, 0);
  return { Dyadic(), t.under, Dyadic() - t.over };
}

int compare(const Root& x, const Root& y)
{
  const Quadratic& q = y.of;
  const int value = signAt(q, x);
  if (q.a.sign() == 0)
  {
    return value * q.b.sign();
  }
  const int outside = value * q.a.sign();
  if (outside < 0)
  {
    return y.index == 0 ? 1 : -1;
  }
  const int side = q.a.sign() * signAt(q.derivative(), x);
  if (outside > 0 || side == 0)
  {
    return side;
  }
  // x is the lower root of q where q falls (times the sign of a), else the upper one.
  const int index = side < 0 ? 0 : 1;
  return index == y.index ? 0 : index - y.index;
}

bool isInside(const Ray& ray, const Quadric& quadric, const Root& root)
{
  if (!isWithinBounds(ray, quadric, root))
  {
    return false;
  }
  return !quadric.tree ||
    signOf(*quadric.tree,
      [&](std::size_t i)
      {
        const QuadricForm& form = quadric.tree->forms[i];
        return form == quadric.form ? 0 : signAt(Quadratic::along(ray, form), root);
      }) == 0;
}

double nearest(const Root& root)
{
  const Quadratic& q = root.of;
  if (q.a.sign() == 0)
  {
    return Dyadic::quotient(Dyadic() - q.c, q.b);
  }
  const Dyadic d = q.discriminant();
  const int sign = root.branch();
  // Where -b and the square root cancel, 2 c / (-b ∓ sqrt(D)) is the same root.
  const bool cancels = q.b.sign() * sign > 0;
  // Rounding is monotone, so once both ends round to the same double so does the root; a rational
  // root is soon known exactly, and another is no midpoint of doubles.
  for (int bits = 96;; bits *= 2)
  {
    const auto ends = Dyadic::squareRoot(d, bits);
    const auto value = [&](const Dyadic& s)
    {
      const Dyadic sum = withSign(s, cancels ? -sign : sign) - q.b;
      return cancels ? Dyadic::quotient(q.c + q.c, sum) : Dyadic::quotient(sum, q.a + q.a);
    };
    const double low = value(ends.first);
    if (low == value(ends.second))
    {
      return low;
    }
  }
}

} // namespace lumitree::exact
