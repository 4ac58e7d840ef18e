// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Kernel/OverlapIndex.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lumitree
{
namespace
{

/// Flat structures (grids) get levels of this many in between.
constexpr std::size_t siblings = 8;

/// Planes that nodes are tested against. Those beyond are for the primitives alone.
constexpr std::size_t nodePlanes = 64;

double magnitudeOf(const Vec3& a)
{
  return std::max({ std::fabs(a[0]), std::fabs(a[1]), std::fabs(a[2]) });
}

} // namespace

/// A half-space as it is tested.
struct OverlapIndex::Plane
{
  Vec3 normal;
  double limit;
  int least[3];    ///< of Node::box: the corner where normal · x is least
  int greatest[3]; ///< the opposite one

  [[nodiscard]] bool beyond(double x, double y, double z) const
  {
    return (this->normal[0] * x + this->normal[1] * y) + this->normal[2] * z > this->limit;
  }
  [[nodiscard]] bool beyond(const Vec3& p) const { return this->beyond(p[0], p[1], p[2]); }
  [[nodiscard]] bool beyond(const double* box, const int* corner) const
  {
    return this->beyond(box[corner[0]], box[corner[1]], box[corner[2]]);
  }
};

/// Puts the nodes of a view in depth-first order.
class OverlapIndex::Builder
{
public:
  Builder(OverlapIndex& index, const HierarchyView& view)
    : index_(index)
    , view_(view)
    , firstChild_(view.nodes.size() + 1, 0)
    , children_(view.nodes.size())
  {
    for (const HierarchyNode& node : view.nodes)
    {
      if (node.parent >= 0)
      {
        ++this->firstChild_[static_cast<std::size_t>(node.parent) + 1];
      }
    }
    for (std::size_t i = 0; i < view.nodes.size(); ++i)
    {
      this->firstChild_[i + 1] += this->firstChild_[i];
    }
    std::vector<std::size_t> next(this->firstChild_.begin(), this->firstChild_.end() - 1);
    for (std::size_t i = 0; i < view.nodes.size(); ++i)
    {
      if (view.nodes[i].parent >= 0)
      {
        this->children_[next[static_cast<std::size_t>(view.nodes[i].parent)]++] = i;
      }
    }
  }

  void appendNode(std::size_t i, std::size_t depth)
  {
    const HierarchyNode& node = this->view_.nodes[i];
    if (node.referenceCount == 0)
    {
      return;
    }
    const std::size_t at = this->begin(depth);
    if (node.leaf)
    {
      const auto first = this->view_.references.begin() + node.firstReference;
      this->index_.references_.insert(
        this->index_.references_.end(), first, first + node.referenceCount);
      Box box;
      std::for_each(first, first + node.referenceCount,
        [&](PrimitiveId id) { box.extend(this->index_.surface_.box(id)); });
      this->end(at, box);
      this->index_.nodes_[at].leaf = true;
    }
    else
    {
      this->appendChildren(this->firstChild_[i], this->firstChild_[i + 1], depth + 1);
      this->end(at, this->below(at));
    }
  }

private:
  /// Those of one parent, in groups where they are many.
  void appendChildren(std::size_t first, std::size_t last, std::size_t depth)
  {
    const std::size_t count = last - first;
    if (count <= siblings)
    {
      for (std::size_t c = first; c < last; ++c)
      {
        this->appendNode(this->children_[c], depth);
      }
      return;
    }
    for (std::size_t g = 0; g < siblings; ++g)
    {
      const std::size_t at = this->begin(depth);
      this->appendChildren(
        first + count * g / siblings, first + count * (g + 1) / siblings, depth + 1);
      this->end(at, this->below(at));
    }
  }

  std::size_t begin(std::size_t depth)
  {
    Node node{};
    node.firstReference = static_cast<std::uint32_t>(this->index_.references_.size());
    node.depth = static_cast<std::uint16_t>(depth);
    this->index_.depth_ = std::max(this->index_.depth_, depth);
    this->index_.nodes_.push_back(node);
    return this->index_.nodes_.size() - 1;
  }

  void end(std::size_t at, const Box& box)
  {
    Node& node = this->index_.nodes_[at];
    std::copy(box.lower.begin(), box.lower.end(), node.box);
    std::copy(box.upper.begin(), box.upper.end(), node.box + 3);
    node.next = static_cast<std::uint32_t>(this->index_.nodes_.size());
    node.referenceCount =
      static_cast<std::uint32_t>(this->index_.references_.size()) - node.firstReference;
  }

  [[nodiscard]] Box below(std::size_t at) const
  {
    Box box;
    for (std::size_t c = at + 1; c < this->index_.nodes_.size(); c = this->index_.nodes_[c].next)
    {
      const double* const b = this->index_.nodes_[c].box;
      box.extend(Vec3{ b[0], b[1], b[2] });
      box.extend(Vec3{ b[3], b[4], b[5] });
    }
    return box;
  }

  OverlapIndex& index_;
  const HierarchyView& view_;
  std::vector<std::size_t> firstChild_; ///< per node of the view, in children_
  std::vector<std::size_t> children_;
};

OverlapIndex::OverlapIndex(const Surface& surface, const HierarchyView& view)
  : surface_(surface)
{
  if (!view.nodes.empty())
  {
    Builder(*this, view).appendNode(0, 0);
  }
}

std::vector<OverlapIndex::Plane> OverlapIndex::prepare(const ConvexRegion& region) const
{
  const Box& bounds = this->surface_.bounds();
  Vec3 m = { 0.0, 0.0, 0.0 };
  if (!bounds.empty())
  {
    for (int k = 0; k < 3; ++k)
    {
      m[k] = std::max(std::fabs(bounds.lower[k]), std::fabs(bounds.upper[k]));
    }
  }
  std::vector<Plane> planes;
  planes.reserve(region.size());
  for (const HalfSpace& half : region)
  {
    if (!isFinite(half.normal) || std::isnan(half.offset))
    {
      throw std::invalid_argument(
        "a half-space of the region has a normal that is not finite or an offset that is NaN");
    }
    int exponent = 0;
    std::frexp(magnitudeOf(half.normal), &exponent);
    const double offset = std::ldexp(half.offset, 1 - exponent);
    Plane plane{};
    double sum = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      plane.normal[k] = std::ldexp(half.normal[k], 1 - exponent);
      plane.least[k] = plane.normal[k] >= 0.0 ? k : k + 3;
      plane.greatest[k] = plane.normal[k] >= 0.0 ? k + 3 : k;
      sum += std::fabs(plane.normal[k]) * m[k];
    }
    const double floor = 0x1p-1070 * (1.0 + (m[0] + m[1] + m[2]));
    plane.limit =
      std::isinf(offset) ? offset : offset + (0x1p-50 * sum + 0x1p-52 * std::fabs(offset) + floor);
    planes.push_back(plane);
  }
  return planes;
}

/// Planes whose bit in open is 0 are known to leave nothing out.
bool OverlapIndex::leftOut(
  PrimitiveId primitive, const std::vector<Plane>& planes, std::uint64_t open) const
{
  const auto anyPlane = [&](auto beyond)
  {
    for (std::size_t i = 0; i < planes.size(); ++i)
    {
      if ((i >= nodePlanes || (open >> i & 1u) != 0) && beyond(planes[i]))
      {
        return true;
      }
    }
    return false;
  };
  if (!this->surface_.isTriangle(primitive))
  {
    const Box box = this->surface_.box(primitive);
    const double corners[6] = { box.lower[0], box.lower[1], box.lower[2], box.upper[0],
      box.upper[1], box.upper[2] };
    return anyPlane([&](const Plane& plane) { return plane.beyond(corners, plane.least); });
  }
  const auto corners = this->surface_.vertices(primitive);
  return anyPlane([&](const Plane& plane)
    { return plane.beyond(corners[0]) && plane.beyond(corners[1]) && plane.beyond(corners[2]); });
}

/// A structure may hold a primitive many times: these count once towards the limit.
void OverlapIndex::collect(
  const std::vector<Plane>& planes, std::vector<PrimitiveId>& primitives, std::size_t limit) const
{
  const std::size_t tested = std::min(planes.size(), nodePlanes);
  // Per depth, the planes that may leave out something below the node there.
  std::vector<std::uint64_t> openAt(this->depth_ + 2);
  openAt[0] = tested == nodePlanes ? ~std::uint64_t{ 0 } : (std::uint64_t{ 1 } << tested) - 1;
  std::size_t checked = limit;
  for (std::size_t n = 0; n < this->nodes_.size();)
  {
    if (primitives.size() > checked)
    {
      std::sort(primitives.begin(), primitives.end());
      primitives.erase(std::unique(primitives.begin(), primitives.end()), primitives.end());
      if (primitives.size() > limit)
      {
        return;
      }
      checked = limit + primitives.size(); // not again for each node
    }
    const Node& node = this->nodes_[n];
    std::uint64_t open = openAt[node.depth];
    bool out = false;
    for (std::size_t i = 0; i < tested && !out; ++i)
    {
      if ((open >> i & 1u) != 0)
      {
        out = planes[i].beyond(node.box, planes[i].least);
        open &= ~(std::uint64_t{ planes[i].beyond(node.box, planes[i].greatest) ? 0u : 1u } << i);
      }
    }
    if (out)
    {
      n = node.next;
      continue;
    }
    const auto first = this->references_.begin() + node.firstReference;
    const auto last = first + node.referenceCount;
    if (open == 0 && tested == planes.size())
    {
      primitives.insert(primitives.end(), first, last);
      n = node.next;
      continue;
    }
    if (node.leaf)
    {
      std::copy_if(first, last, std::back_inserter(primitives),
        [&](PrimitiveId id) { return !this->leftOut(id, planes, open); });
    }
    openAt[node.depth + 1u] = open;
    ++n;
  }
}

void OverlapIndex::overlap(
  const ConvexRegion& region, std::vector<PrimitiveId>& primitives, std::size_t limit) const
{
  primitives.clear();
  this->collect(this->prepare(region), primitives, limit);
  std::sort(primitives.begin(), primitives.end());
  primitives.erase(std::unique(primitives.begin(), primitives.end()), primitives.end());
}

} // namespace lumitree
