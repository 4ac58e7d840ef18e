// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Accel/Reference/CGAL/CgalTree.h"
#include "Accel/Reference/CGAL/CgalTriangles.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version_macros.h>

#include <algorithm>
#include <iterator>

namespace lumitree
{
namespace
{

/// The point in what CGAL says an intersection is, or null (a segment of a ray in the plane).
template <class Point, class Intersection>
const Point* pointOf(const Intersection& intersection)
{
#if CGAL_VERSION_MAJOR >= 6
  return std::get_if<Point>(&intersection);
#else
  return boost::get<Point>(&intersection);
#endif
}

/// A tree whose constructions are in doubles. All intersections are asked for: the first is that of
/// the nearest point only up to rounding, and of several at one point it is anyone.
template <class Kernel>
class DoublesTree final : public CgalTree
{
public:
  DoublesTree(const Surface& surface, BuildProgress& progress)
    : triangles_(surface, progress)
  {
  }

  void all(const Ray& ray, const PrimitiveId* skipFirst, const PrimitiveId* skipLast,
    std::vector<Hit>& hits) const override
  {
    hits.clear();
    const typename Kernel::Vector_3 direction(ray.direction[0], ray.direction[1], ray.direction[2]);
    const auto keep = [&](const auto& intersections)
    {
      for (const auto& found : intersections)
      {
        const PrimitiveId id = this->triangles_.primitive(found.second);
        const auto* const point = pointOf<typename Kernel::Point_3>(found.first);
        if (point && !std::binary_search(skipFirst, skipLast, id))
        {
          this->add(ray, { point->x(), point->y(), point->z() }, id, hits);
        }
      }
    };
    // Limits are applied to t: a rounded end of a segment would miss what lies at it.
    if (ray.tMin >= 0.0)
    {
      keep(this->intersections(typename Kernel::Ray_3(Triangles::pointAt(ray.origin), direction)));
    }
    else
    {
      keep(this->intersections(typename Kernel::Line_3(Triangles::pointAt(ray.origin), direction)));
    }
    std::sort(hits.begin(), hits.end(),
      [](const Hit& a, const Hit& b)
      { return a.t < b.t || (a.t == b.t && a.primitive < b.primitive); });
  }

  [[nodiscard]] std::size_t memory() const override { return this->triangles_.memory(); }

private:
  using Triangles = CgalTriangles<Kernel>;

  template <class Query>
  auto intersections(const Query& query) const
  {
    using Tree = typename Triangles::Tree;
    std::vector<typename Tree::template Intersection_and_primitive_id<Query>::Type> found;
    this->triangles_.tree().all_intersections(query, std::back_inserter(found));
    return found;
  }

  void add(const Ray& ray, const Vec3& point, PrimitiveId id, std::vector<Hit>& hits) const
  {
    // Along the longest component of the direction.
    int k = 0;
    for (int i = 1; i < 3; ++i)
    {
      k = std::fabs(ray.direction[i]) > std::fabs(ray.direction[k]) ? i : k;
    }
    const double t = (point[k] - ray.origin[k]) / ray.direction[k];
    if (!std::isfinite(t) || t < ray.tMin || t > ray.tMax)
    {
      return;
    }
    const auto v = this->triangles_.surface().vertices(id);
    const Vec3 e1 = v[1] - v[0];
    const Vec3 e2 = v[2] - v[0];
    const Vec3 normal = cross(e1, e2);
    const double area = dot(normal, normal);
    hits.push_back({ t, dot(normal, cross(point - v[0], e2)) / area,
      dot(normal, cross(e1, point - v[0])) / area, id });
  }

  Triangles triangles_;
};

} // namespace

std::unique_ptr<const CgalTree> makeEpickTree(const Surface& surface, BuildProgress& progress)
{
  return std::make_unique<const DoublesTree<CGAL::Exact_predicates_inexact_constructions_kernel>>(
    surface, progress);
}

std::unique_ptr<const CgalTree> makeCartesianTree(const Surface& surface, BuildProgress& progress)
{
  return std::make_unique<const DoublesTree<CGAL::Simple_cartesian<double>>>(surface, progress);
}

} // namespace lumitree
