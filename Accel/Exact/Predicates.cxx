// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Exact/Predicates.h"

#include "Accel/Exact/Dyadic.h"
#include "Accel/Exact/Expansion.h"

namespace lumitree::exact
{
namespace
{

template <class Number>
using Vector = std::array<Number, 3>;

template <class Number>
Vector<Number> between(const Vec3& to, const Vec3& from)
{
  return { Number::difference(to[0], from[0]), Number::difference(to[1], from[1]),
    Number::difference(to[2], from[2]) };
}

template <class Number>
Vector<Number> cross(const Vector<Number>& a, const Vector<Number>& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

template <class Number>
Number dot(const Vector<Number>& a, const Vector<Number>& b)
{
  return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}

template <class Number>
Vector<Number> lift(const Vec3& a)
{
  return { Number(a[0]), Number(a[1]), Number(a[2]) };
}

/// d · ((q - p) x (p - o))
template <class Number>
int edgeSign(const Ray& ray, const Vec3& p, const Vec3& q)
{
  return dot(lift<Number>(ray.direction),
    cross(between<Number>(q, p), between<Number>(p, ray.origin)))
    .sign();
}

/// t = over / under
template <class Number>
struct Fraction
{
  Number over;
  Number under;
};

template <class Number>
Fraction<Number> parameter(const Ray& ray, const std::array<Vec3, 3>& t)
{
  const Vector<Number> normal = cross(between<Number>(t[1], t[0]), between<Number>(t[2], t[0]));
  return { dot(normal, between<Number>(t[0], ray.origin)),
    dot(normal, lift<Number>(ray.direction)) };
}

template <class Number>
bool meets(const Ray& ray, const std::array<Vec3, 3>& t)
{
  const int u = edgeSign<Number>(ray, t[1], t[2]);
  const int v = edgeSign<Number>(ray, t[2], t[0]);
  if (u * v < 0)
  {
    return false;
  }
  const int w = edgeSign<Number>(ray, t[0], t[1]);
  const bool oneSided = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
  return oneSided && (u != 0 || v != 0 || w != 0);
}

template <class Number>
int compareToLimit(const Ray& ray, const std::array<Vec3, 3>& triangle, double limit)
{
  const auto t = parameter<Number>(ray, triangle);
  return (t.over - Number(limit) * t.under).sign() * t.under.sign();
}

/// Sign of (a b - c d) of expansions. With 150 leading bits of each nearly always known; else the product of all terms.
int crossProductSign(
  const Expansion& a, const Expansion& b, const Expansion& c, const Expansion& d)
{
  double ea = 0.0;
  double eb = 0.0;
  double ec = 0.0;
  double ed = 0.0;
  const Expansion headA = a.leading(ea);
  const Expansion headB = b.leading(eb);
  const Expansion headC = c.leading(ec);
  const Expansion headD = d.leading(ed);
  const double error = (std::fabs(headA.estimate()) + ea) * eb + std::fabs(headB.estimate()) * ea +
    (std::fabs(headC.estimate()) + ec) * ed + std::fabs(headD.estimate()) * ec;
  const Expansion head = headA * headB - headC * headD;
  if (error == 0.0 || std::fabs(head.estimate()) > error * (1.0 + 0x1p-40))
  {
    return head.sign();
  }
  return (a * b - c * d).sign();
}

int crossProductSign(const Dyadic& a, const Dyadic& b, const Dyadic& c, const Dyadic& d)
{
  return (a * b - c * d).sign();
}

template <class Number>
int compare(const Ray& ray, const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b)
{
  const auto s = parameter<Number>(ray, a);
  const auto t = parameter<Number>(ray, b);
  return crossProductSign(s.over, t.under, t.over, s.under) * s.under.sign() * t.under.sign();
}

template <class Number>
double quotient(const Ray& ray, const std::array<Vec3, 3>& triangle)
{
  const auto t = parameter<Number>(ray, triangle);
  return Number::quotient(t.over, t.under);
}

template <class Number>
bool collinear(const std::array<Vec3, 3>& t)
{
  const Vector<Number> normal = cross(between<Number>(t[1], t[0]), between<Number>(t[2], t[0]));
  return normal[0].sign() == 0 && normal[1].sign() == 0 && normal[2].sign() == 0;
}

/// Expansions of degree 6 neither over- nor underflow when every input is 0 or within 2^-120 … 2^150: the lowest bit of
/// an input is then at least 2^-172, of a product of six 2^-1032, above 2^-1074; the highest value stays below
/// 2^(6 · 151 + 8) = 2^914, with room for Veltkamp's factor of 2^27.
bool fits(double x)
{
  const double magnitude = std::fabs(x);
  return magnitude == 0.0 || (magnitude >= 0x1p-120 && magnitude <= 0x1p150);
}

bool fits(const Vec3& v)
{
  return fits(v[0]) && fits(v[1]) && fits(v[2]);
}

bool fits(const Ray& ray)
{
  return fits(ray.origin) && fits(ray.direction);
}

bool fits(const std::array<Vec3, 3>& t)
{
  return fits(t[0]) && fits(t[1]) && fits(t[2]);
}

} // namespace

bool lineMeetsTriangle(const Ray& ray, const std::array<Vec3, 3>& t)
{
  return fits(ray) && fits(t) ? meets<Expansion>(ray, t) : meets<Dyadic>(ray, t);
}

int compareCrossing(const Ray& ray, const std::array<Vec3, 3>& t, double limit)
{
  if (std::isinf(limit))
  {
    return limit > 0.0 ? -1 : 1;
  }
  return fits(ray) && fits(t) && fits(limit) ? compareToLimit<Expansion>(ray, t, limit)
                                             : compareToLimit<Dyadic>(ray, t, limit);
}

int compareCrossings(const Ray& ray, const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b)
{
  return fits(ray) && fits(a) && fits(b) ? compare<Expansion>(ray, a, b)
                                         : compare<Dyadic>(ray, a, b);
}

double crossingParameter(const Ray& ray, const std::array<Vec3, 3>& t)
{
  return fits(ray) && fits(t) ? quotient<Expansion>(ray, t) : quotient<Dyadic>(ray, t);
}

bool isZeroArea(const std::array<Vec3, 3>& t)
{
  // Each component of the normal is off by less than 5 u times the sum of its products' magnitudes; one that is
  // certainly not 0 decides. Products that underflow decide nothing.
  const Vec3 a = t[1] - t[0];
  const Vec3 b = t[2] - t[0];
  for (int k = 0; k < 3; ++k)
  {
    const double first = a[(k + 1) % 3] * b[(k + 2) % 3];
    const double second = a[(k + 2) % 3] * b[(k + 1) % 3];
    if (std::fabs(first - second) > 0x1p-50 * (std::fabs(first) + std::fabs(second)) + 0x1p-1000)
    {
      return false;
    }
  }
  return fits(t) ? collinear<Expansion>(t) : collinear<Dyadic>(t);
}

} // namespace lumitree::exact
