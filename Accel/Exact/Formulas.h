// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Exact_Formulas_h
#define Lumitree_Accel_Exact_Formulas_h

#include <array>
#include <cstddef>

/// The polynomials whose signs are the answers, for any kind of number that is exact: sums,
/// differences and products of Number, and Number::difference of two coordinates. The type of a
/// product may differ from that of its factors.
namespace lumitree::exact
{

/// A line and K triangles, coordinates of the type that Number is made from.
template <class NumberType, class PointType, std::size_t K>
struct Scene
{
  using Number = NumberType;
  using Point = PointType;
  Point origin;
  Point direction;
  std::array<std::array<Point, 3>, K> triangles;
  /// t is 2^tExponent times what these coordinates say.
  int tExponent = 0;
};

template <class Number, class Point>
std::array<Number, 3> between(const Point& to, const Point& from)
{
  return { Number::difference(to[0], from[0]), Number::difference(to[1], from[1]),
    Number::difference(to[2], from[2]) };
}

template <class Number, class Point>
std::array<Number, 3> lift(const Point& a)
{
  return { Number(a[0]), Number(a[1]), Number(a[2]) };
}

template <class Number>
auto cross(const std::array<Number, 3>& a, const std::array<Number, 3>& b)
{
  using Product = decltype(a[0] * b[0]);
  return std::array<Product, 3>{ a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0] };
}

template <class A, class B>
auto dot(const std::array<A, 3>& a, const std::array<B, 3>& b)
{
  return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}

/// Whether the line meets the closed triangle, not being parallel to its plane: the edge functions
/// d · (Q x P), P and Q an edge's ends less the origin, are of one sign, and not all 0.
template <class S>
bool meets(const S& s)
{
  using Number = typename S::Number;
  const auto& t = s.triangles[0];
  const auto d = lift<Number>(s.direction);
  const auto a = between<Number>(t[0], s.origin);
  const auto b = between<Number>(t[1], s.origin);
  const auto c = between<Number>(t[2], s.origin);
  const int u = dot(cross(c, b), d).sign();
  const int v = dot(cross(a, c), d).sign();
  if (u * v < 0)
  {
    return false;
  }
  const int w = dot(cross(b, a), d).sign();
  const bool oneSided = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
  return oneSided && (u != 0 || v != 0 || w != 0);
}

/// Sign of the first component that is not 0: of the product with (e, e^2, e^3).
template <class Number>
int firstSign(const std::array<Number, 3>& a)
{
  const int x = a[0].sign();
  const int y = x != 0 ? x : a[1].sign();
  return y != 0 ? y : a[2].sign();
}

/// Sign of the edge function d · (Q x P), P and Q less the origin, after the origin is moved by
/// m = (e, e^2, e^3). The move adds m · ((Q - P) x d), so its first component that is not 0 decides
/// where the edge function is 0. 0 only for an edge parallel to the line.
template <class S, class Point>
int movedEdgeSign(const S& s, const Point& p, const Point& q)
{
  using Number = typename S::Number;
  const auto d = lift<Number>(s.direction);
  const int sign = dot(cross(between<Number>(q, s.origin), between<Number>(p, s.origin)), d).sign();
  return sign != 0 ? sign : firstSign(cross(between<Number>(q, p), d));
}

/// Whether the moved line meets the triangle. If it does, then inside. The edge functions' sum does
/// not move: it is 0 for a line parallel to the plane, and then they are not of one sign.
template <class S>
bool meetsMoved(const S& s)
{
  const auto& t = s.triangles[0];
  const int u = movedEdgeSign(s, t[1], t[2]);
  return u != 0 && movedEdgeSign(s, t[2], t[0]) == u && movedEdgeSign(s, t[0], t[1]) == u;
}

/// over / under
template <class Number>
struct Fraction
{
  Number over;
  Number under;
};

/// t where the line crosses the plane of triangle i.
template <class S>
auto parameter(const S& s, std::size_t i)
{
  using Number = typename S::Number;
  const auto& t = s.triangles[i];
  const auto normal = cross(between<Number>(t[1], t[0]), between<Number>(t[2], t[0]));
  using Product = decltype(dot(normal, lift<Number>(s.direction)));
  return Fraction<Product>{ dot(normal, between<Number>(t[0], s.origin)),
    dot(normal, lift<Number>(s.direction)) };
}

/// Which way t moves with the line: t = n · (V - o) / (n · d), less n · m / (n · d).
template <class S>
int signOfMove(const S& s)
{
  using Number = typename S::Number;
  const auto& t = s.triangles[0];
  const auto normal = cross(between<Number>(t[1], t[0]), between<Number>(t[2], t[0]));
  return -firstSign(normal) * dot(normal, lift<Number>(s.direction)).sign();
}

/// Sign of (t of triangle 0 - t of triangle 1).
template <class S>
int compare(const S& s)
{
  const auto t0 = parameter(s, 0);
  const auto t1 = parameter(s, 1);
  return (t0.over * t1.under - t1.over * t0.under).sign() * t0.under.sign() * t1.under.sign();
}

/// Whether the points of the triangle lie on one line.
template <class Number, class Point>
bool collinear(const std::array<Point, 3>& t)
{
  const auto normal = cross(between<Number>(t[1], t[0]), between<Number>(t[2], t[0]));
  return normal[0].sign() == 0 && normal[1].sign() == 0 && normal[2].sign() == 0;
}

} // namespace lumitree::exact

#endif
