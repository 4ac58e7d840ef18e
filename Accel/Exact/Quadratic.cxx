// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Exact/Quadratic.h"

#include "Accel/Exact/Formulas.h"

#include <cmath>

namespace lumitree::exact
{
namespace
{

using Dyadics = std::array<Dyadic, 3>;

Dyadic twice(const Dyadic& x)
{
  return x + x;
}

Dyadic discriminant(const Quadratic& q)
{
  return q.b * q.b - twice(twice(q.a * q.c));
}

/// Sign of x + y sqrt(d), d not negative.
int signOfSum(const Dyadic& x, const Dyadic& y, const Dyadic& d)
{
  const int sx = x.sign();
  const int sy = y.sign() * d.sign();
  if (sx * sy >= 0)
  {
    return sx != 0 ? sx : sy;
  }
  return sx * (x * x - y * y * d).sign();
}

/// The sign of the square root in the root (-b ± sqrt(discriminant)) / (2 a).
int branch(const Root& root)
{
  return root.index == 0 ? -root.of.a.sign() : root.of.a.sign();
}

Dyadic withSign(const Dyadic& x, int sign)
{
  return sign < 0 ? Dyadic() - x : x;
}

} // namespace

Quadratic Quadratic::along(const Ray& ray, const QuadricForm& form)
{
  std::array<Dyadic, 10> a;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    a[i] = Dyadic(form.coefficients[i]);
  }
  const Dyadics d = lift<Dyadic>(ray.direction);
  const Dyadics y = between<Dyadic>(ray.origin, form.centre);
  Quadratic q;
  q.c = a[9] + Dyadic(form.residue);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t n = (k + 1) % 3;
    q.a = q.a + (a[k] * d[k] + a[3 + k] * d[n]) * d[k];
    q.b =
      q.b + twice(a[k] * d[k] * y[k]) + a[3 + k] * (d[k] * y[n] + d[n] * y[k]) + a[6 + k] * d[k];
    q.c = q.c + (a[k] * y[k] + a[3 + k] * y[n] + a[6 + k]) * y[k];
  }
  return q;
}

Quadratic Quadratic::along(const Ray& ray, const QuadricCut& cut)
{
  const Dyadics n = lift<Dyadic>(cut.normal);
  return { Dyadic(), dot(n, lift<Dyadic>(ray.direction)),
    dot(n, between<Dyadic>(ray.origin, cut.point)) };
}

Quadratic Quadratic::along(const Ray& ray, int axis, double position)
{
  return { Dyadic(), Dyadic(ray.direction[axis]), Dyadic::difference(ray.origin[axis], position) };
}

Quadratic Quadratic::along(const Ray& ray, const std::array<Vec3, 3>& triangle)
{
  Scene<Dyadic, Vec3, 1> scene;
  scene.origin = ray.origin;
  scene.direction = ray.direction;
  scene.triangles[0] = triangle;
  const auto t = parameter(scene, 0);
  return { Dyadic(), t.under, Dyadic() - t.over };
}

Quadratic Quadratic::at(double limit)
{
  return { Dyadic(), Dyadic(1.0), Dyadic(-limit) };
}

int Quadratic::roots() const
{
  if (this->a.sign() == 0)
  {
    return this->b.sign() != 0 ? 1 : 0;
  }
  return 1 + discriminant(*this).sign();
}

int signAt(const Quadratic& p, const Root& root)
{
  const Quadratic& q = root.of;
  if (q.a.sign() == 0)
  {
    // t = -c / b
    return ((p.a * q.c - p.b * q.b) * q.c + p.c * q.b * q.b).sign();
  }
  // p a - p.a q is m t + n with the sign of p times that of a; and t = (-b ± sqrt(D)) / (2 a).
  const Dyadic m = p.b * q.a - p.a * q.b;
  const Dyadic n = p.c * q.a - p.a * q.c;
  return signOfSum(twice(q.a * n) - m * q.b, withSign(m, branch(root)), discriminant(q));
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
  const int side = q.a.sign() * signAt({ Dyadic(), twice(q.a), q.b }, x);
  if (outside > 0 || side == 0)
  {
    return side;
  }
  // x is the lower root of q where q falls (times the sign of a), else the upper one.
  const int index = side < 0 ? 0 : 1;
  return index == y.index ? 0 : index - y.index;
}

int compare(const Root& x, double limit)
{
  if (std::isinf(limit))
  {
    return limit > 0.0 ? -1 : 1;
  }
  return signAt({ Dyadic(), Dyadic(1.0), Dyadic(-limit) }, x);
}

bool isInside(const Ray& ray, const Quadric& quadric, const Root& root)
{
  for (int k = 0; k < 3; ++k)
  {
    if (signAt(Quadratic::along(ray, k, quadric.clip.lower[k]), root) < 0 ||
      signAt(Quadratic::along(ray, k, quadric.clip.upper[k]), root) > 0)
    {
      return false;
    }
  }
  return signAt(Quadratic::along(ray, quadric.cuts[0]), root) <= 0 &&
    signAt(Quadratic::along(ray, quadric.cuts[1]), root) <= 0 &&
    signAt(Quadratic::along(ray, quadric.bound), root) <= 0;
}

double nearest(const Root& root)
{
  const Quadratic& q = root.of;
  if (q.a.sign() == 0)
  {
    return Dyadic::quotient(Dyadic() - q.c, q.b);
  }
  const Dyadic d = discriminant(q);
  const int sign = branch(root);
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
      return cancels ? Dyadic::quotient(twice(q.c), sum) : Dyadic::quotient(sum, twice(q.a));
    };
    const double low = value(ends.first);
    if (low == value(ends.second))
    {
      return low;
    }
  }
}

} // namespace lumitree::exact
