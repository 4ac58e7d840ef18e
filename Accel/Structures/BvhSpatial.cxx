// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/BvhSpatial.h"

#include <algorithm>
#include <array>

namespace lumitree
{
namespace
{

constexpr int binCount = 16;
constexpr double padding = 0x1p-44;
/// Planes through the node are tried where the sides of the object split overlap by this share of
/// the root's area and of the node's own, and where there are this many references; they are taken
/// where they cost so much less. Measured: large triangles among small ones take half the time per
/// ray; the city, where there is nothing to gain, loses less than with the first condition alone.
///@{
constexpr float leastOverlapOfRoot = 1e-5f;
constexpr float leastOverlapOfNode = 0.1f;
constexpr std::size_t leastReferences = 16;
constexpr float leastGain = 0.95f;
///@}
constexpr float infinity = std::numeric_limits<float>::infinity();

/// Bounds of a part of a triangle, to be rounded outward at the end.
class PartBounds
{
public:
  void add(const Vec3& p) { this->box_.extend(p); }

  [[nodiscard]] BuildBox rounded() const
  {
    BuildBox box;
    for (int k = 0; k < 3; ++k)
    {
      const double low = this->box_.lower[k] - padding;
      const double high = this->box_.upper[k] + padding;
      box.lower[k] = static_cast<float>(low - std::fabs(low) * 0x1p-23);
      box.upper[k] = static_cast<float>(high + std::fabs(high) * 0x1p-23);
    }
    box.lower[3] = box.upper[3] = 0.0f;
    return box;
  }

private:
  Box box_;
};

/// Bounds of the part between two planes across an axis; empty where there is none. Of a body,
/// whose corners are NaN, all that lies between them.
BuildBox partBetween(const std::array<Vec3, 3>& corners, int axis, float low, float high)
{
  PartBounds bounds;
  if (std::isnan(corners[0][0]))
  {
    constexpr double far = std::numeric_limits<double>::infinity();
    Vec3 lower = { -far, -far, -far };
    Vec3 upper = { far, far, far };
    lower[axis] = low;
    upper[axis] = high;
    bounds.add(lower);
    bounds.add(upper);
    return bounds.rounded();
  }
  for (int i = 0; i < 3; ++i)
  {
    const Vec3& a = corners[i];
    const Vec3& b = corners[(i + 1) % 3];
    if (low <= a[axis] && a[axis] <= high)
    {
      bounds.add(a);
    }
    for (const double plane : { static_cast<double>(low), static_cast<double>(high) })
    {
      if ((a[axis] < plane && plane < b[axis]) || (b[axis] < plane && plane < a[axis]))
      {
        const double s = (plane - a[axis]) / (b[axis] - a[axis]);
        bounds.add(a + s * (b - a));
      }
    }
  }
  return bounds.rounded();
}

BuildBox common(const BuildBox& a, const BuildBox& b)
{
  BuildBox box;
  box.lower = a.lower > b.lower ? a.lower : b.lower;
  box.upper = a.upper < b.upper ? a.upper : b.upper;
  return box;
}

bool isEmpty(const BuildBox& box)
{
  // The negation takes a NaN for empty, of which there is none.
  return !(
    box.lower[0] <= box.upper[0] && box.lower[1] <= box.upper[1] && box.lower[2] <= box.upper[2]);
}

float areaOf(const BuildBox& box)
{
  return isEmpty(box) ? 0.0f : box.halfArea();
}

BuildBox boxOf(const BuildReference& r)
{
  BuildBox box;
  box.lower = r.low();
  box.upper = r.high();
  return box;
}

void append(const BuildReference& whole, const BuildBox& box, BvhSegment& side, BuildReference& out)
{
  // Not the caller's reference once out is written: they may be one.
  BuildReference r = whole;
  for (int k = 0; k < 3; ++k)
  {
    r.lower[k] = box.lower[k];
    r.upper[k] = box.upper[k];
  }
  out = r;
  side.bounds.extend(r.low(), r.high());
  side.centres.extend(r.centre());
}

} // namespace

/// A plane through a node and what its sides would be.
struct SpatialStrategy::Plane
{
  int axis = -1;
  float position = 0.0f;
  float cost = infinity;
  BuildBox left;
  BuildBox right;
  std::size_t lefts = 0;
  std::size_t rights = 0;

  /// Which sides a reference goes to: bit 0 the left, bit 1 the right.
  [[nodiscard]] unsigned sidesOf(const BuildReference& r) const
  {
    if (r.upper[this->axis] <= this->position)
    {
      return 1;
    }
    if (r.lower[this->axis] >= this->position)
    {
      return 2;
    }
    BuildBox asLeft = this->left;
    BuildBox asRight = this->right;
    asLeft.extend(boxOf(r));
    asRight.extend(boxOf(r));
    const auto n = [](std::size_t count) { return static_cast<float>(count); };
    const float leftArea = areaOf(this->left);
    const float rightArea = areaOf(this->right);
    const float both = leftArea * n(this->lefts) + rightArea * n(this->rights);
    const float onlyLeft = asLeft.halfArea() * n(this->lefts) + rightArea * n(this->rights - 1);
    const float onlyRight = leftArea * n(this->lefts - 1) + asRight.halfArea() * n(this->rights);
    return both <= onlyLeft && both <= onlyRight ? 3 : (onlyLeft <= onlyRight ? 1 : 2);
  }
};

SpatialStrategy::SpatialStrategy(const Surface& surface, const WideBvhFrame& frame,
  BuildReferences& references, const BvhSegment& root, int leafSize, BuildProgress& progress)
  : surface_(surface)
  , frame_(frame)
  , references_(references)
  , binned_(references, leafSize, progress)
  , leafSize_(static_cast<std::size_t>(leafSize))
  , leastOverlap_(leastOverlapOfRoot * root.bounds.halfArea())
{
}

bool SpatialStrategy::split(
  BvhSegment& segment, bool halve, BvhSegment& left, BvhSegment& right, int& axis)
{
  const std::size_t count = segment.count();
  const bool fitsLeaf = count <= this->leafSize_;
  if (fitsLeaf && count <= bvhBlock)
  {
    return false;
  }
  const BinnedPlane object = halve ? BinnedPlane{} : this->binned_.best(segment);
  Plane spatial;
  const float area = segment.bounds.halfArea();
  if (!halve && segment.limit > segment.end && count >= leastReferences &&
    (object.axis < 0 ||
      areaOf(common(object.left, object.right)) >
        std::max(this->leastOverlap_, leastOverlapOfNode * area)))
  {
    spatial = this->bestPlane(segment);
  }
  if (fitsLeaf && std::min(object.cost, spatial.cost) + area >= area * blocksOf(count))
  {
    return false;
  }
  if (spatial.cost < leastGain * object.cost && this->divide(segment, spatial, left, right))
  {
    axis = spatial.axis;
    return true;
  }
  if (object.axis >= 0)
  {
    axis = object.axis;
    this->binned_.divide(segment, object, left, right);
  }
  else
  {
    axis = segment.bounds.longestAxis();
    halveSegment(this->references_, axis, segment, left, right);
  }
  this->share(segment, left, right);
  return true;
}

void SpatialStrategy::ids(BvhSegment& segment, PrimitiveId* out) const
{
  this->binned_.ids(segment, out);
}

BuildBox SpatialStrategy::partOf(const BuildReference& r, int axis, float low, float high) const
{
  BuildBox part = boxOf(r);
  if (!this->surface_.isTriangle(r.id))
  {
    part.lower[axis] = std::max(part.lower[axis], low);
    part.upper[axis] = std::min(part.upper[axis], high);
    return part;
  }
  std::array<Vec3, 3> corners = this->surface_.vertices(r.id);
  for (Vec3& p : corners)
  {
    p = this->frame_.scale * (p - this->frame_.centre);
  }
  return common(part, partBetween(corners, axis, low, high));
}

SpatialStrategy::Plane SpatialStrategy::bestPlane(const BvhSegment& segment) const
{
  struct Bin
  {
    BuildBox box;
    std::size_t begins = 0;
    std::size_t ends = 0;
  };
  Plane best;
  const Float4 sides = segment.bounds.sides();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(sides[axis] > 0x1p-60f))
    {
      continue;
    }
    // Plane b is the lower one of bin b; the outer bins reach as far as anything does.
    std::array<float, binCount + 1> planes;
    for (int b = 0; b <= binCount; ++b)
    {
      planes[b] = segment.bounds.lower[axis] +
        sides[axis] * (static_cast<float>(b) / static_cast<float>(binCount));
    }
    const float scale = static_cast<float>(binCount) / sides[axis];
    const auto binOf = [&](float x)
    {
      auto b = static_cast<int>((x - planes[0]) * scale);
      b = std::clamp(b, 0, binCount - 1);
      b -= b > 0 && x < planes[b] ? 1 : 0;
      b += b + 1 < binCount && x >= planes[b + 1] ? 1 : 0;
      return b;
    };
    std::array<Bin, binCount> bins;
    for (std::size_t i = segment.begin; i < segment.end; ++i)
    {
      const BuildReference& r = this->references_[i];
      const int first = binOf(r.lower[axis]);
      const int last = std::max(first, binOf(r.upper[axis]));
      ++bins[first].begins;
      ++bins[last].ends;
      const BuildBox whole = boxOf(r);
      if (first == last)
      {
        bins[first].box.extend(whole);
        continue;
      }
      for (int b = first; b <= last; ++b)
      {
        const BuildBox part = this->partOf(
          r, axis, b == 0 ? -infinity : planes[b], b + 1 == binCount ? infinity : planes[b + 1]);
        if (!isEmpty(part))
        {
          bins[b].box.extend(part);
        }
      }
    }
    std::array<BuildBox, binCount + 1> above;
    std::array<std::size_t, binCount + 1> endAbove{};
    for (int b = binCount - 1; b > 0; --b)
    {
      above[b] = above[b + 1];
      above[b].extend(bins[b].box);
      endAbove[b] = endAbove[b + 1] + bins[b].ends;
    }
    BuildBox below;
    std::size_t begun = 0;
    for (int b = 1; b < binCount; ++b)
    {
      below.extend(bins[b - 1].box);
      begun += bins[b - 1].begins;
      const std::size_t rights = endAbove[b];
      if (begun == 0 || rights == 0)
      {
        continue;
      }
      const float cost = areaOf(below) * blocksOf(begun) + areaOf(above[b]) * blocksOf(rights);
      if (cost < best.cost)
      {
        best = { axis, planes[b], cost, below, above[b], begun, rights };
      }
    }
  }
  return best;
}

bool SpatialStrategy::divide(
  const BvhSegment& segment, const Plane& plane, BvhSegment& left, BvhSegment& right)
{
  std::size_t lefts = 0;
  std::size_t rights = 0;
  for (std::size_t i = segment.begin; i < segment.end; ++i)
  {
    const unsigned sides = plane.sidesOf(this->references_[i]);
    lefts += sides & 1u;
    rights += sides >> 1;
  }
  const std::size_t count = segment.count();
  if (lefts == 0 || rights == 0 || lefts >= count || rights >= count ||
    segment.begin + lefts + rights > segment.limit)
  {
    return false;
  }
  std::vector<BuildReference> moved;
  moved.reserve(rights);
  std::size_t kept = segment.begin;
  for (std::size_t i = segment.begin; i < segment.end; ++i)
  {
    const BuildReference r = this->references_[i];
    BuildBox below = boxOf(r);
    BuildBox above = below;
    unsigned sides = plane.sidesOf(r);
    if (sides == 3)
    {
      below = this->partOf(r, plane.axis, -infinity, plane.position);
      above = this->partOf(r, plane.axis, plane.position, infinity);
      // What is not on one side is on the other.
      sides = isEmpty(below) ? 2 : (isEmpty(above) ? 1 : 3);
    }
    if (sides & 1u)
    {
      append(r, below, left, this->references_[kept++]);
    }
    if (sides & 2u)
    {
      moved.emplace_back();
      append(r, above, right, moved.back());
    }
  }
  left.begin = segment.begin;
  left.end = right.begin = kept;
  right.end = kept + moved.size();
  std::copy(moved.begin(), moved.end(), this->references_.data() + kept);
  this->share(segment, left, right);
  return true;
}

void SpatialStrategy::share(const BvhSegment& segment, BvhSegment& left, BvhSegment& right)
{
  const std::size_t held = left.count() + right.count();
  const std::size_t room = segment.limit - segment.begin - held;
  const auto forLeft = static_cast<std::size_t>(
    static_cast<double>(room) * static_cast<double>(left.count()) / static_cast<double>(held));
  left.limit = left.end + std::min(forLeft, room);
  right.limit = segment.limit;
  BuildReference* const all = this->references_.data();
  std::copy_backward(all + right.begin, all + right.end, all + right.end + (left.limit - left.end));
  const std::size_t shift = left.limit - right.begin;
  right.begin += shift;
  right.end += shift;
}

} // namespace lumitree
