// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Quadric.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lumitree
{
namespace
{

/// How much wider boxes are than what they hold, in parts of its size.
constexpr double boxPad = 0x1p-20;

Quadric nothing()
{
  return {};
}

bool positive(double x)
{
  return x > 0.0 && std::isfinite(x);
}

/// A vector of length 1, axes of coordinates exactly; 0 where there is none.
Vec3 unit(const Vec3& a)
{
  const double largest = std::max({ std::fabs(a[0]), std::fabs(a[1]), std::fabs(a[2]) });
  if (!positive(largest))
  {
    return { 0.0, 0.0, 0.0 };
  }
  const Vec3 scaled = { a[0] / largest, a[1] / largest, a[2] / largest };
  const double norm = length(scaled);
  return { scaled[0] / norm, scaled[1] / norm, scaled[2] / norm };
}

bool isZero(const Vec3& a)
{
  return a[0] == 0.0 && a[1] == 0.0 && a[2] == 0.0;
}

void setMinusSquare(QuadricForm& form, double radius)
{
  form.coefficients[9] = -(radius * radius);
  form.residue = std::fma(-radius, radius, -form.coefficients[9]);
}

/// |n x y|² + along (n · y)² of a unit vector n.
QuadricForm aroundAxis(const Vec3& centre, const Vec3& n, double along)
{
  QuadricForm form;
  form.centre = centre;
  for (int k = 0; k < 3; ++k)
  {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    form.coefficients[k] = (n[i] * n[i] + n[j] * n[j]) + along * (n[k] * n[k]);
  }
  const double mixed = 2.0 * (along - 1.0);
  form.coefficients[3] = mixed * (n[0] * n[1]);
  form.coefficients[4] = mixed * (n[1] * n[2]);
  form.coefficients[5] = mixed * (n[0] * n[2]);
  return form;
}

void extendByDisc(Box& box, const Vec3& centre, const Vec3& n, double radius)
{
  for (int k = 0; k < 3; ++k)
  {
    const double reach = radius * std::hypot(n[(k + 1) % 3], n[(k + 2) % 3]);
    box.lower[k] = std::min(box.lower[k], centre[k] - reach);
    box.upper[k] = std::max(box.upper[k], centre[k] + reach);
  }
}

Box padded(Box box)
{
  const double pad = boxPad * box.size()[box.longestAxis()];
  for (int k = 0; k < 3; ++k)
  {
    // Far from the origin the pad may be less than what a coordinate can be rounded by.
    const double more = pad + 0x1p-50 * std::max(std::fabs(box.lower[k]), std::fabs(box.upper[k]));
    box.lower[k] -= more;
    box.upper[k] += more;
  }
  return box;
}

/// A disc in the plane through its centre, ended by a bound.
Quadric cap(const Vec3& centre, const Vec3& n, double radius, const QuadricForm& bound)
{
  Quadric q;
  q.form.centre = centre;
  std::copy(n.begin(), n.end(), q.form.coefficients.begin() + 6);
  q.bound = bound;
  extendByDisc(q.clip, centre, n, radius);
  q.clip = padded(q.clip);
  return q;
}

/// A surface of revolution that begins at its form's centre.
Quadric revolved(const QuadricForm& form, const Vec3& n, const Vec3& to, const Box& box)
{
  Quadric q;
  q.form = form;
  q.cuts[0] = { -1.0 * n, form.centre };
  q.cuts[1] = { n, to };
  q.clip = padded(box);
  return q;
}

} // namespace

Quadric Quadric::sphere(const Vec3& centre, double radius)
{
  if (!positive(radius))
  {
    return nothing();
  }
  Quadric q;
  q.form.centre = centre;
  q.form.coefficients = { 1.0, 1.0, 1.0 };
  setMinusSquare(q.form, radius);
  const Vec3 reach = { radius, radius, radius };
  q.clip.extend(centre - reach);
  q.clip.extend(centre + reach);
  q.clip = padded(q.clip);
  return q;
}

Quadric Quadric::ellipsoid(const Vec3& centre, const std::array<Vec3, 3>& semiAxes)
{
  Quadric q;
  q.form.centre = centre;
  Vec3 reach = { 0.0, 0.0, 0.0 };
  double shortest = std::numeric_limits<double>::infinity();
  for (const Vec3& axis : semiAxes)
  {
    shortest = std::min(shortest, length(axis));
  }
  if (!positive(shortest))
  {
    return nothing();
  }
  // Scaled so that no coefficient is far from 1: sum of (n · y shortest / |axis|)² = shortest².
  for (const Vec3& axis : semiAxes)
  {
    const Vec3 n = unit(axis);
    const double ratio = shortest / length(axis);
    const double weight = ratio * ratio;
    for (int k = 0; k < 3; ++k)
    {
      q.form.coefficients[k] += weight * (n[k] * n[k]);
      reach[k] = std::hypot(reach[k], axis[k]);
    }
    q.form.coefficients[3] += 2.0 * weight * (n[0] * n[1]);
    q.form.coefficients[4] += 2.0 * weight * (n[1] * n[2]);
    q.form.coefficients[5] += 2.0 * weight * (n[0] * n[2]);
  }
  setMinusSquare(q.form, shortest);
  q.clip.extend(centre - reach);
  q.clip.extend(centre + reach);
  q.clip = padded(q.clip);
  return q;
}

Quadric Quadric::cylinder(const Vec3& from, const Vec3& to, double radius)
{
  const Vec3 n = unit(to - from);
  if (!positive(radius) || isZero(n))
  {
    return nothing();
  }
  QuadricForm form = aroundAxis(from, n, 0.0);
  setMinusSquare(form, radius);
  Box box;
  extendByDisc(box, from, n, radius);
  extendByDisc(box, to, n, radius);
  return revolved(form, n, to, box);
}

std::vector<Quadric> Quadric::cappedCylinder(const Vec3& from, const Vec3& to, double radius)
{
  const Quadric tube = cylinder(from, to, radius);
  if (tube.clip.empty())
  {
    return { tube };
  }
  const Vec3& n = tube.cuts[1].normal;
  return { tube, cap(from, -1.0 * n, radius, tube.form), cap(to, n, radius, tube.form) };
}

Quadric Quadric::cone(const Vec3& apex, const Vec3& base, double radius)
{
  const Vec3 n = unit(base - apex);
  if (!positive(radius) || isZero(n))
  {
    return nothing();
  }
  const double slope = radius / length(base - apex);
  Box box;
  box.extend(apex);
  extendByDisc(box, base, n, radius);
  return revolved(aroundAxis(apex, n, -(slope * slope)), n, base, box);
}

std::vector<Quadric> Quadric::cappedCone(const Vec3& apex, const Vec3& base, double radius)
{
  const Quadric side = cone(apex, base, radius);
  if (side.clip.empty())
  {
    return { side };
  }
  return { side, cap(base, side.cuts[1].normal, radius, side.form) };
}

Quadric Quadric::paraboloid(const Vec3& vertex, const Vec3& end, double radius)
{
  const Vec3 n = unit(end - vertex);
  if (!positive(radius) || isZero(n))
  {
    return nothing();
  }
  QuadricForm form = aroundAxis(vertex, n, 0.0);
  const double rise = radius / length(end - vertex) * radius;
  for (int k = 0; k < 3; ++k)
  {
    form.coefficients[6 + k] = -rise * n[k];
  }
  Box box;
  extendByDisc(box, vertex, n, radius);
  extendByDisc(box, end, n, radius);
  return revolved(form, n, end, box);
}

Quadric Quadric::disc(const Vec3& centre, const Vec3& normal, double radius)
{
  const Vec3 n = unit(normal);
  if (!positive(radius) || isZero(n))
  {
    return nothing();
  }
  return cap(centre, n, radius, sphere(centre, radius).form);
}

Quadric Quadric::plane(const Vec3& point, const Vec3& normal, const Box& box)
{
  QuadricForm form;
  form.centre = point;
  std::copy(normal.begin(), normal.end(), form.coefficients.begin() + 6);
  return inBox(form, box);
}

std::vector<Quadric> Quadric::sides(const Box& box)
{
  std::vector<Quadric> all;
  const double size = box.empty() ? 0.0 : box.size()[box.longestAxis()];
  for (int k = 0; k < 3; ++k)
  {
    for (const bool upper : { false, true })
    {
      Vec3 normal = { 0.0, 0.0, 0.0 };
      normal[k] = upper ? 1.0 : -1.0;
      const double at = upper ? box.upper[k] : box.lower[k];
      Box side = box;
      // Across the plane the box need not decide.
      const double pad = boxPad * size + 0x1p-50 * std::fabs(at);
      side.lower[k] = at - pad;
      side.upper[k] = at + pad;
      all.push_back(plane(upper ? box.upper : box.lower, normal, box.empty() ? Box{} : side));
    }
  }
  return all;
}

Quadric Quadric::inBox(const QuadricForm& form, const Box& box)
{
  Quadric q;
  q.form = form;
  q.clip = box;
  return q;
}

std::vector<Quadric> Quadric::zerosOf(
  const std::shared_ptr<const ImplicitTree>& tree, const Box& box)
{
  tree->check();
  if (!tree->isSignOfForms())
  {
    throw std::invalid_argument("the zeros of a superquadric are no quadrics");
  }
  std::vector<Quadric> pieces;
  for (const QuadricForm& form : tree->forms)
  {
    const bool known = std::any_of(
      pieces.begin(), pieces.end(), [&](const Quadric& piece) { return piece.form == form; });
    if (!known)
    {
      pieces.push_back(inBox(form, box));
      pieces.back().tree = tree;
    }
  }
  return pieces;
}

} // namespace lumitree
