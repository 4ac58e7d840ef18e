// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Accel/Reference/CGAL/CgalTree.h"
#include "Accel/Reference/CGAL/CgalTriangles.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iterator>

namespace lumitree
{
namespace
{

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Triangles = CgalTriangles<Kernel>;
using Rational = CGAL::Exact_rational;
using Vector = std::array<Rational, 3>;

/// origin + t direction, exactly.
Kernel::Point_3 pointAt(const Ray& ray, double t)
{
  const Kernel::FT parameter(t);
  return { Kernel::FT(ray.origin[0]) + parameter * Kernel::FT(ray.direction[0]),
    Kernel::FT(ray.origin[1]) + parameter * Kernel::FT(ray.direction[1]),
    Kernel::FT(ray.origin[2]) + parameter * Kernel::FT(ray.direction[2]) };
}

Vector difference(const Vec3& a, const Vec3& b)
{
  return { Rational(a[0]) - Rational(b[0]), Rational(a[1]) - Rational(b[1]),
    Rational(a[2]) - Rational(b[2]) };
}

Vector cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

Rational dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

bool isEven(double x)
{
  std::uint64_t pattern;
  std::memcpy(&pattern, &x, sizeof(pattern));
  return (pattern & 1u) == 0;
}

/// The nearest double, of two equally near the even one; to_double alone may cut off.
double rounded(const Rational& x)
{
  const double near = CGAL::to_double(x);
  double best = near;
  for (const double other : { std::nextafter(near, -HUGE_VAL), std::nextafter(near, HUGE_VAL) })
  {
    if (std::isfinite(other) && std::isfinite(best))
    {
      const Rational error = CGAL::abs(Rational(other) - x);
      const Rational least = CGAL::abs(Rational(best) - x);
      best = error < least || (error == least && isEven(other)) ? other : best;
    }
  }
  return best;
}

/// The place at which a line crosses a triangle's plane, in exact numbers.
struct ExactHit
{
  Rational t;
  PrimitiveId primitive;
  std::array<Vec3, 3> vertices;

  [[nodiscard]] Hit hit(const Ray& ray) const
  {
    // The point less vertex 0 is u (v1 - v0) + v (v2 - v0).
    const Vector e1 = difference(this->vertices[1], this->vertices[0]);
    const Vector e2 = difference(this->vertices[2], this->vertices[0]);
    Vector p = difference(ray.origin, this->vertices[0]);
    for (int k = 0; k < 3; ++k)
    {
      p[k] += this->t * Rational(ray.direction[k]);
    }
    const Vector normal = cross(e1, e2);
    const Rational area = dot(normal, normal);
    const Rational u = dot(normal, cross(p, e2)) / area;
    const Rational v = dot(normal, cross(e1, p)) / area;
    return { rounded(this->t), rounded(u), rounded(v), this->primitive };
  }
};

class EpeckTree final : public CgalTree
{
public:
  EpeckTree(const Surface& surface, BuildProgress& progress)
    : triangles_(surface, progress)
  {
  }

  void all(const Ray& ray, const PrimitiveId* skipFirst, const PrimitiveId* skipLast,
    std::vector<Hit>& hits) const override
  {
    hits.clear();
    for (const ExactHit& hit : this->exactHits(ray, skipFirst, skipLast))
    {
      hits.push_back(hit.hit(ray));
    }
  }

  void ties(const Ray& ray, const PrimitiveId* skipFirst, const PrimitiveId* skipLast,
    std::vector<Hit>& hits) const override
  {
    hits.clear();
    const std::vector<ExactHit> exact = this->exactHits(ray, skipFirst, skipLast);
    for (auto hit = exact.begin(); hit != exact.end() && hit->t == exact.front().t; ++hit)
    {
      hits.push_back(hit->hit(ray));
    }
  }

  [[nodiscard]] std::size_t memory() const override { return this->triangles_.memory(); }

private:
  /// Every hit, ordered by (t, primitive).
  [[nodiscard]] std::vector<ExactHit> exactHits(
    const Ray& ray, const PrimitiveId* skipFirst, const PrimitiveId* skipLast) const;

  /// The triangles that meet what is between the ray's limits, in any order.
  void candidates(const Ray& ray, std::vector<Triangles::Iterator>& found) const
  {
    const auto out = std::back_inserter(found);
    const bool begins = std::isfinite(ray.tMin);
    const bool ends = std::isfinite(ray.tMax);
    const Kernel::Vector_3 direction(ray.direction[0], ray.direction[1], ray.direction[2]);
    if (begins && ends && ray.tMin < ray.tMax)
    {
      this->triangles_.tree().all_intersected_primitives(
        Kernel::Segment_3(pointAt(ray, ray.tMin), pointAt(ray, ray.tMax)), out);
    }
    else if (begins && !ends)
    {
      this->triangles_.tree().all_intersected_primitives(
        Kernel::Ray_3(pointAt(ray, ray.tMin), direction), out);
    }
    else if (ends && !begins)
    {
      this->triangles_.tree().all_intersected_primitives(
        Kernel::Ray_3(pointAt(ray, ray.tMax), -direction), out);
    }
    else // unlimited, or one point, which is no segment to CGAL
    {
      this->triangles_.tree().all_intersected_primitives(
        Kernel::Line_3(Triangles::pointAt(ray.origin), direction), out);
    }
  }

  Triangles triangles_;
};

std::vector<ExactHit> EpeckTree::exactHits(
  const Ray& ray, const PrimitiveId* skipFirst, const PrimitiveId* skipLast) const
{
  std::vector<ExactHit> exact;
  // No point has an infinite parameter.
  if (ray.tMin == HUGE_VAL || ray.tMax == -HUGE_VAL)
  {
    return exact;
  }
  std::vector<Triangles::Iterator> found;
  this->candidates(ray, found);

  const Vector direction = { Rational(ray.direction[0]), Rational(ray.direction[1]),
    Rational(ray.direction[2]) };
  for (const auto& triangle : found)
  {
    const PrimitiveId id = this->triangles_.primitive(triangle);
    if (std::binary_search(skipFirst, skipLast, id))
    {
      continue;
    }
    const auto v = this->triangles_.surface().vertices(id);
    const Vector normal = cross(difference(v[1], v[0]), difference(v[2], v[0]));
    const Rational under = dot(normal, direction);
    if (under == 0)
    {
      continue;
    }
    const Rational t = dot(normal, difference(v[0], ray.origin)) / under;
    // What lies beyond the range of doubles is a miss, as for every structure.
    if ((std::isinf(ray.tMin) || t >= Rational(ray.tMin)) &&
      (std::isinf(ray.tMax) || t <= Rational(ray.tMax)) && std::isfinite(rounded(t)))
    {
      exact.push_back({ t, id, v });
    }
  }
  std::sort(exact.begin(), exact.end(),
    [](const ExactHit& a, const ExactHit& b)
    { return a.t < b.t || (a.t == b.t && a.primitive < b.primitive); });
  return exact;
}

} // namespace

std::unique_ptr<const CgalTree> makeEpeckTree(const Surface& surface, BuildProgress& progress)
{
  return std::make_unique<const EpeckTree>(surface, progress);
}

} // namespace lumitree
