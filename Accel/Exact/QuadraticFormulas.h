// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Exact_QuadraticFormulas_h
#define Lumitree_Accel_Exact_QuadraticFormulas_h

#include "Accel/Exact/Formulas.h"
#include "Accel/Quadric.h"
#include "Accel/Ray.h"

#include <cmath>

/// Signs of polynomials at roots of polynomials, for any ordered kind of number that is exact:
/// Number(double), Number(), sums, differences, products and sign(); and
/// Number::fromOrigin(ray, point), the ray's origin less a point.
namespace lumitree::exact
{

/// a t² + b t + c
template <class Number>
struct BasicQuadratic
{
  Number a;
  Number b;
  Number c;

  /// The form along the line of a ray.
  static BasicQuadratic along(const Ray& ray, const QuadricForm& form)
  {
    std::array<Number, 10> a;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
      a[i] = Number(form.coefficients[i]);
    }
    const auto d = lift<Number>(ray.direction);
    const std::array<Number, 3> y = Number::fromOrigin(ray, form.centre);
    BasicQuadratic q;
    q.c = a[9] + Number(form.residue);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t n = (k + 1) % 3;
      const Number ad = a[k] * d[k];
      q.a = q.a + (ad + a[3 + k] * d[n]) * d[k];
      q.b = q.b + ad * y[k] + ad * y[k] + a[3 + k] * (d[k] * y[n] + d[n] * y[k]) + a[6 + k] * d[k];
      q.c = q.c + (a[k] * y[k] + a[3 + k] * y[n] + a[6 + k]) * y[k];
    }
    return q;
  }

  /// normal · (x - point) along it.
  static BasicQuadratic along(const Ray& ray, const QuadricCut& cut)
  {
    const auto n = lift<Number>(cut.normal);
    return { Number(), dot(n, lift<Number>(ray.direction)),
      dot(n, Number::fromOrigin(ray, cut.point)) };
  }

  /// x[axis] - point[axis] along it.
  static BasicQuadratic along(const Ray& ray, std::size_t axis, const Vec3& point)
  {
    return { Number(), Number(ray.direction[axis]), Number::fromOrigin(ray, point)[axis] };
  }

  /// 0 at t = limit, which is finite.
  static BasicQuadratic at(double limit) { return { Number(), Number(1.0), Number(-limit) }; }

  [[nodiscard]] BasicQuadratic derivative() const
  {
    return { Number(), this->a + this->a, this->b };
  }

  [[nodiscard]] Number discriminant() const
  {
    const Number ac = this->a * this->c;
    const Number twice = ac + ac;
    return this->b * this->b - (twice + twice);
  }

  /// Number of distinct real roots; 0 also where every t is one.
  [[nodiscard]] int roots() const
  {
    if (this->a.sign() == 0)
    {
      return this->b.sign() != 0 ? 1 : 0;
    }
    return 1 + this->discriminant().sign();
  }
};

/// A root of a quadratic that has it: 0 the lower, 1 the upper one of two.
template <class Number>
struct BasicRoot
{
  BasicQuadratic<Number> of;
  int index = 0;

  /// The sign of the square root in the root (-b ± sqrt(discriminant)) / (2 a).
  [[nodiscard]] int branch() const
  {
    return this->index == 0 ? -this->of.a.sign() : this->of.a.sign();
  }
};

template <class Number>
Number withSign(const Number& x, int sign)
{
  return sign < 0 ? Number() - x : x;
}

/// Sign of x + y sqrt(d), d not negative.
template <class Number>
int signOfSum(const Number& x, const Number& y, const Number& d)
{
  const int sx = x.sign();
  const int sy = y.sign() * d.sign();
  if (sx * sy >= 0)
  {
    return sx != 0 ? sx : sy;
  }
  return sx * (x * x - y * y * d).sign();
}

/// Sign of p at the root.
template <class Number>
int signAt(const BasicQuadratic<Number>& p, const BasicRoot<Number>& root)
{
  const BasicQuadratic<Number>& q = root.of;
  if (q.a.sign() == 0)
  {
    // t = -c / b
    return ((p.a * q.c - p.b * q.b) * q.c + p.c * q.b * q.b).sign();
  }
  // p a - p.a q is m t + n with the sign of p times that of a; and t = (-b ± sqrt(D)) / (2 a).
  const Number m = p.b * q.a - p.a * q.b;
  const Number n = p.c * q.a - p.a * q.c;
  const Number an = q.a * n;
  return signOfSum((an + an) - m * q.b, withSign(m, root.branch()), q.discriminant());
}

/// Sign of (root - limit); the limit may be infinite.
template <class Number>
int compare(const BasicRoot<Number>& x, double limit)
{
  if (std::isinf(limit))
  {
    return limit > 0.0 ? -1 : 1;
  }
  return signAt(BasicQuadratic<Number>::at(limit), x);
}

/// Whether the point of the ray at the root of the quadric's form is in its box, its cuts and its
/// bound. Its tree is another matter.
template <class Number>
bool isWithinBounds(const Ray& ray, const Quadric& quadric, const BasicRoot<Number>& root)
{
  using Along = BasicQuadratic<Number>;
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (signAt(Along::along(ray, k, quadric.clip.lower), root) < 0 ||
      signAt(Along::along(ray, k, quadric.clip.upper), root) > 0)
    {
      return false;
    }
  }
  return signAt(Along::along(ray, quadric.cuts[0]), root) <= 0 &&
    signAt(Along::along(ray, quadric.cuts[1]), root) <= 0 &&
    signAt(Along::along(ray, quadric.bound), root) <= 0;
}

/// A sign as the trees of quadrics ask for it.
struct Sign
{
  int value = 0;
};

inline Sign operator-(Sign a)
{
  return { -a.value };
}

inline Sign minimum(Sign a, Sign b)
{
  return b.value < a.value ? b : a;
}

inline Sign magnitude(Sign a)
{
  return { a.value != 0 ? 1 : 0 };
}

/// The tree's sign given those of its forms.
template <class FormSign>
int signOf(const ImplicitTree& tree, FormSign form)
{
  return tree
    .evaluate<Sign>(
      [&](std::size_t i) { return Sign{ form(i) }; }, [](std::size_t) { return Sign{}; })
    .value;
}

} // namespace lumitree::exact

#endif
