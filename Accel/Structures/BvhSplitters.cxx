// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/BvhBuilder.h"

#include <algorithm>
#include <array>

namespace lumitree
{
namespace
{

constexpr int binCount = 16;

/// The object in the middle by centre along the axis, ties by id, so that the division is the same
/// everywhere.
BvhSplit splitAtMedian(int axis, BuildReference* begin, BuildReference* end)
{
  BuildReference* const middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end,
    [axis](const BuildReference& a, const BuildReference& b) {
      return a.centre[axis] < b.centre[axis] || (a.centre[axis] == b.centre[axis] && a.id < b.id);
    });
  return { middle, axis };
}

struct Bin
{
  Box box;
  std::size_t count = 0;
};

/// The bins of one axis over the bounds of the centres.
struct Binning
{
  double origin = 0.0;
  double scale = 0.0; ///< 0: all centres in one place

  Binning(const Box& centres, int axis)
    : origin(centres.lower[axis])
  {
    const double extent = centres.upper[axis] - centres.lower[axis];
    const double perUnit = binCount / extent;
    this->scale = extent > 0.0 && std::isfinite(perUnit) ? perUnit : 0.0;
  }

  [[nodiscard]] int of(double centre) const
  {
    const double bin = (centre - this->origin) * this->scale;
    return std::min(binCount - 1, static_cast<int>(bin));
  }
};

struct Plane
{
  int axis = -1;
  int bin = 0; ///< bins below this one go left
  double cost = std::numeric_limits<double>::infinity();
};

/// Leaf tests go by blocks of four primitives.
double tests(std::size_t count)
{
  return static_cast<double>((count + 3) / 4);
}

Plane bestPlane(int axis, const std::array<Bin, binCount>& bins)
{
  std::array<double, binCount> rightCost{};
  Bin right;
  for (int i = binCount - 1; i > 0; --i)
  {
    right.box.extend(bins[i].box);
    right.count += bins[i].count;
    rightCost[i] = right.count > 0 ? right.box.area() * tests(right.count)
                                   : std::numeric_limits<double>::infinity();
  }
  Plane best;
  Bin left;
  for (int i = 1; i < binCount; ++i)
  {
    left.box.extend(bins[i - 1].box);
    left.count += bins[i - 1].count;
    const double cost = left.box.area() * tests(left.count) + rightCost[i];
    if (left.count > 0 && cost < best.cost)
    {
      best = { axis, i, cost };
    }
  }
  return best;
}

Plane bestPlane(const Box& centres, const BuildReference* begin, const BuildReference* end)
{
  Plane best;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Binning binning(centres, axis);
    if (binning.scale == 0.0)
    {
      continue;
    }
    std::array<Bin, binCount> bins;
    for (const BuildReference* r = begin; r != end; ++r)
    {
      Bin& bin = bins[binning.of(r->centre[axis])];
      bin.box.extend(r->box);
      ++bin.count;
    }
    const Plane plane = bestPlane(axis, bins);
    best = plane.cost < best.cost ? plane : best;
  }
  return best;
}

} // namespace

BvhSplitter medianSplitter(int leafSize)
{
  return [leafSize](const Box& bounds, BuildReference* begin, BuildReference* end) {
    return end - begin <= leafSize ? BvhSplit{} : splitAtMedian(bounds.longestAxis(), begin, end);
  };
}

BvhSplitter binnedSahSplitter(int leafSize)
{
  return [leafSize](const Box& bounds, BuildReference* begin, BuildReference* end) -> BvhSplit
  {
    const std::size_t count = static_cast<std::size_t>(end - begin);
    if (count <= 1)
    {
      return {};
    }
    const bool fitsLeaf = count <= static_cast<std::size_t>(leafSize);
    if (fitsLeaf && count <= 4)
    {
      return {};
    }
    Box centres;
    for (const BuildReference* r = begin; r != end; ++r)
    {
      centres.extend(r->centre);
    }
    const Plane plane = bestPlane(centres, begin, end);
    // One step down costs about as much as a block of primitives.
    if (fitsLeaf && plane.cost + bounds.area() >= bounds.area() * tests(count))
    {
      return {};
    }
    if (plane.axis < 0)
    {
      return splitAtMedian(bounds.longestAxis(), begin, end);
    }
    const Binning binning(centres, plane.axis);
    BuildReference* const middle = std::partition(begin, end,
      [&](const BuildReference& r) { return binning.of(r.centre[plane.axis]) < plane.bin; });
    return { middle, plane.axis };
  };
}

} // namespace lumitree
