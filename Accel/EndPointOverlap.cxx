// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/EndPointOverlap.h"

#include <numeric>

namespace lumitree
{
namespace
{

using Polygon = std::vector<Vec3>;

double area(const Polygon& polygon)
{
  Vec3 sum = { 0, 0, 0 };
  for (std::size_t i = 2; i < polygon.size(); ++i)
  {
    sum = sum + cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  }
  return length(sum) / 2;
}

/// The part of a convex polygon where sign · x[axis] <= sign · plane (Sutherland and Hodgman 1974).
void clip(const Polygon& polygon, int axis, double sign, double plane, Polygon& result)
{
  result.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Vec3& a = polygon[i];
    const Vec3& b = polygon[(i + 1) % polygon.size()];
    const double outA = sign * (a[axis] - plane);
    const double outB = sign * (b[axis] - plane);
    if (outA <= 0)
    {
      result.push_back(a);
    }
    if ((outA < 0 && outB > 0) || (outA > 0 && outB < 0))
    {
      result.push_back(a + (outA / (outA - outB)) * (b - a));
    }
  }
}

Polygon clipped(Polygon polygon, const Box& box)
{
  Polygon next;
  for (int k = 0; k < 3 && !polygon.empty(); ++k)
  {
    clip(polygon, k, 1.0, box.upper[k], next);
    clip(next, k, -1.0, box.lower[k], polygon);
  }
  return polygon;
}

/// For each of n items the places in `of` where it stands.
struct Inverse
{
  template <class Of>
  Inverse(std::size_t n, std::size_t places, Of&& of)
    : first(n + 1, 0)
    , list(places)
  {
    for (std::size_t i = 0; i < places; ++i)
    {
      ++this->first[of(i) + 1];
    }
    std::partial_sum(this->first.begin(), this->first.end(), this->first.begin());
    std::vector<std::size_t> next(this->first.begin(), this->first.end() - 1);
    for (std::size_t i = 0; i < places; ++i)
    {
      this->list[next[of(i)]++] = i;
    }
  }

  std::vector<std::size_t> first;
  std::vector<std::size_t> list;
};

class Overlap
{
public:
  Overlap(const HierarchyView& view, const Surface& surface)
    : view_(view)
    , surface_(surface)
    , children_(view.nodes.size(), view.nodes.empty() ? 0 : view.nodes.size() - 1,
        [&](std::size_t i) { return static_cast<std::size_t>(view.nodes[i + 1].parent); })
    , leafOf_(view.references.size(), 0)
    , holders_(surface.size(), view.references.size(),
        [&](std::size_t i) { return static_cast<std::size_t>(view.references[i]); })
    , seen_(view.nodes.size(), noPrimitive)
  {
    for (std::size_t n = 0; n < view.nodes.size(); ++n)
    {
      const HierarchyNode& node = view.nodes[n];
      for (std::uint32_t r = 0; node.leaf && r < node.referenceCount; ++r)
      {
        this->leafOf_[node.firstReference + r] = n;
      }
    }
  }

  double sum()
  {
    double total = 0.0;
    double all = 0.0;
    for (const PrimitiveId i : this->surface_.hittable())
    {
      if (!this->surface_.isTriangle(i))
      {
        continue;
      }
      const auto corners = this->surface_.vertices(i);
      const Polygon triangle(corners.begin(), corners.end());
      all += area(triangle);
      this->markHolders(i);
      total += this->below(0, i, triangle);
    }
    return all > 0.0 ? total / all : 0.0;
  }

private:
  /// Marks the leaves that hold a primitive and all that is above them.
  void markHolders(PrimitiveId primitive)
  {
    for (std::size_t h = this->holders_.first[primitive]; h < this->holders_.first[primitive + 1];
         ++h)
    {
      auto n = static_cast<std::int64_t>(this->leafOf_[this->holders_.list[h]]);
      while (n >= 0 && this->seen_[static_cast<std::size_t>(n)] != primitive)
      {
        this->seen_[static_cast<std::size_t>(n)] = primitive;
        n = this->view_.nodes[static_cast<std::size_t>(n)].parent;
      }
    }
  }

  double below(std::size_t n, PrimitiveId primitive, const Polygon& polygon)
  {
    const HierarchyNode& node = this->view_.nodes[n];
    const Polygon inside = clipped(polygon, node.box);
    if (inside.size() < 3)
    {
      return 0.0;
    }
    double sum = 0.0;
    if (this->seen_[n] != primitive)
    {
      sum += area(inside) * costOf(this->view_, n);
    }
    for (std::size_t c = this->children_.first[n]; c < this->children_.first[n + 1]; ++c)
    {
      sum += this->below(this->children_.list[c] + 1, primitive, inside);
    }
    return sum;
  }

  const HierarchyView& view_;
  const Surface& surface_;
  Inverse children_; ///< of each node, the nodes that follow these
  std::vector<std::size_t> leafOf_;
  Inverse holders_; ///< of each primitive, its references
  std::vector<PrimitiveId> seen_;
};

} // namespace

double endPointOverlap(const HierarchyView& view, const Surface& surface)
{
  return view.nodes.empty() ? 0.0 : Overlap(view, surface).sum();
}

} // namespace lumitree
