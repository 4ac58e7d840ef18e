// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/GridLattice.h"

#include <cmath>

namespace lumitree
{
namespace
{

constexpr double greatestCount = 0x1p20;
constexpr double relativeMargin = 0x1p-36;

} // namespace

std::array<int, 3> GridLattice::resolutionFor(const Box& bounds, double cells)
{
  std::array<int, 3> resolution = { 1, 1, 1 };
  if (bounds.empty())
  {
    return resolution;
  }
  const Vec3 size = bounds.size();
  // Logarithms: the product of three sizes may not be a double.
  std::array<bool, 3> divided;
  for (int k = 0; k < 3; ++k)
  {
    divided[k] = size[k] > 0.0;
  }
  bool settled = false;
  while (!settled)
  {
    settled = true;
    int axes = 0;
    double logVolume = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      axes += divided[k] ? 1 : 0;
      logVolume += divided[k] ? std::log(size[k]) : 0.0;
    }
    const double logEdge = axes > 0 ? (logVolume - std::log(cells)) / axes : 0.0;
    for (int k = 0; k < 3; ++k)
    {
      if (divided[k])
      {
        const double logCount = std::log(size[k]) - logEdge;
        // A thin axis leaves its share of the cells to the others.
        settled = settled && logCount >= 0.0;
        divided[k] = logCount >= 0.0;
        resolution[k] = logCount > 0.0
          ? static_cast<int>(std::min(greatestCount, std::nearbyint(std::exp(logCount))))
          : 1;
      }
    }
  }
  return resolution;
}

GridLattice::GridLattice(const Box& bounds, const std::array<int, 3>& resolution)
  : bounds_(bounds)
  , resolution_(resolution)
{
  if (bounds.empty())
  {
    this->bounds_.lower = this->bounds_.upper = { 0.0, 0.0, 0.0 };
  }
  const Vec3 size = this->bounds_.size();
  this->margin_ = relativeMargin * size[this->bounds_.longestAxis()];
  for (int k = 0; k < 3; ++k)
  {
    const int n = this->resolution_[k];
    const double lower = this->bounds_.lower[k];
    const double upper = this->bounds_.upper[k];
    this->planes_[k].resize(static_cast<std::size_t>(n) + 1);
    for (int i = 0; i < n; ++i)
    {
      this->planes_[k][i] = std::min(lower + size[k] * (static_cast<double>(i) / n), upper);
    }
    this->planes_[k][n] = upper;
    const double perUnit = n / size[k];
    this->slabsPerUnit_[k] = std::isfinite(perUnit) ? perUnit : 0.0;
  }
}

std::size_t GridLattice::cellCount() const
{
  return static_cast<std::size_t>(this->resolution_[0]) *
    static_cast<std::size_t>(this->resolution_[1]) * static_cast<std::size_t>(this->resolution_[2]);
}

int GridLattice::slabNear(int axis, double x) const
{
  const double slab = (x - this->bounds_.lower[axis]) * this->slabsPerUnit_[axis];
  const int last = this->resolution_[axis] - 1;
  // The first comparison is false for NaN.
  return slab > 0.0 ? (slab < last ? static_cast<int>(slab) : last) : 0;
}

Box GridLattice::box(const SlabRange& range) const
{
  Box box;
  for (int k = 0; k < 3; ++k)
  {
    box.lower[k] = std::max(this->low(k, range.first[k]), this->bounds_.lower[k]);
    box.upper[k] = std::min(this->high(k, range.last[k]), this->bounds_.upper[k]);
  }
  return box;
}

SlabRange GridLattice::slabsOf(const Box& box) const
{
  SlabRange range;
  for (int k = 0; k < 3; ++k)
  {
    int first = this->slabNear(k, box.lower[k]);
    int last = this->slabNear(k, box.upper[k]);
    while (first > 0 && this->high(k, first - 1) >= box.lower[k])
    {
      --first;
    }
    while (first + 1 < this->resolution_[k] && this->high(k, first) < box.lower[k])
    {
      ++first;
    }
    while (last + 1 < this->resolution_[k] && this->low(k, last + 1) <= box.upper[k])
    {
      ++last;
    }
    while (last > first && this->low(k, last) > box.upper[k])
    {
      --last;
    }
    range.first[k] = first;
    range.last[k] = last;
  }
  return range;
}

} // namespace lumitree
