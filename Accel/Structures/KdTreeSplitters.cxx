// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/KdTreeSplitters.h"

#include <memory>

namespace lumitree
{
namespace
{

/// Cost of a step down, in tests of a block of four triangles.
constexpr double stepCost = 0.5;
/// What a plane costs that leaves one side empty.
constexpr double emptyBonus = 0.8;

/// Leaf tests go by blocks of four triangles.
double testCost(std::size_t count)
{
  return static_cast<double>((count + 3) / 4);
}

/// The area of a cell's parts, as shares of the cell's own. Sizes are scaled first, so that no
/// product overflows.
class Areas
{
public:
  Areas(const Box& cell, int axis)
    : lower_(cell.lower[axis])
    , upper_(cell.upper[axis])
  {
    const Vec3 size = cell.size();
    const double longest = size[cell.longestAxis()];
    const auto scaled = [&](int k) { return size[k % 3] / longest; };
    this->cross_ = scaled(axis + 1) * scaled(axis + 2);
    this->around_ = scaled(axis + 1) + scaled(axis + 2);
    this->length_ = scaled(axis);
    this->total_ = this->cross_ + this->length_ * this->around_;
  }

  [[nodiscard]] bool isZero() const { return !(this->total_ > 0.0); }

  [[nodiscard]] double below(double position) const { return this->share(position - this->lower_); }
  [[nodiscard]] double above(double position) const { return this->share(this->upper_ - position); }

private:
  [[nodiscard]] double share(double length) const
  {
    const double part = length / (this->upper_ - this->lower_) * this->length_;
    return (this->cross_ + part * this->around_) / this->total_;
  }

  double lower_;
  double upper_;
  double cross_ = 0.0;
  double around_ = 0.0;
  double length_ = 0.0;
  double total_ = 0.0;
};

/// Finds the cheapest plane. Keeps its memory from node to node.
class PlaneSearch
{
public:
  KdSplit best(const Box& cell, const std::vector<KdReference>& references)
  {
    this->split_ = {};
    this->cost_ = testCost(references.size());
    if (references.size() > 1)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        this->search(cell, axis, references);
      }
    }
    return this->split_;
  }

private:
  void search(const Box& cell, int axis, const std::vector<KdReference>& references)
  {
    const Areas areas(cell, axis);
    if (!(cell.lower[axis] < cell.upper[axis]) || areas.isZero())
    {
      return;
    }
    this->gather(axis, references);
    std::size_t begun = 0;  // references that begin below the plane
    std::size_t ended = 0;  // and those that end below or at it
    std::size_t passed = 0; // references flat on this axis, below the plane
    while (
      begun < this->begins_.size() || ended < this->ends_.size() || passed < this->flats_.size())
    {
      const double position = std::min(
        { next(this->begins_, begun), next(this->ends_, ended), next(this->flats_, passed) });
      while (next(this->ends_, ended) == position)
      {
        ++ended;
      }
      std::size_t inPlane = 0;
      while (next(this->flats_, passed + inPlane) == position)
      {
        ++inPlane;
      }
      const std::size_t below = begun + passed;
      const std::size_t above =
        this->begins_.size() - ended + this->flats_.size() - passed - inPlane;
      const bool atLower = position <= cell.lower[axis];
      const bool atUpper = position >= cell.upper[axis];
      const double shareBelow = areas.below(position);
      const double shareAbove = areas.above(position);
      // At the cell's own faces a plane only serves to take off what lies in it.
      if (!atUpper && (inPlane > 0 || !atLower))
      {
        this->offer({ axis, position, true }, shareBelow, below + inPlane, shareAbove, above);
      }
      if (!atLower && inPlane > 0)
      {
        this->offer({ axis, position, false }, shareBelow, below, shareAbove, above + inPlane);
      }
      passed += inPlane;
      while (next(this->begins_, begun) == position)
      {
        ++begun;
      }
    }
  }

  void gather(int axis, const std::vector<KdReference>& references)
  {
    this->begins_.clear();
    this->ends_.clear();
    this->flats_.clear();
    for (const KdReference& r : references)
    {
      const double lower = r.bounds.lower[axis];
      const double upper = r.bounds.upper[axis];
      if (lower == upper)
      {
        this->flats_.push_back(lower);
        continue;
      }
      this->begins_.push_back(lower);
      this->ends_.push_back(upper);
    }
    std::sort(this->begins_.begin(), this->begins_.end());
    std::sort(this->ends_.begin(), this->ends_.end());
    std::sort(this->flats_.begin(), this->flats_.end());
  }

  void offer(const KdSplit& split, double shareBelow, std::size_t below, double shareAbove,
    std::size_t above)
  {
    const double bonus = below == 0 || above == 0 ? emptyBonus : 1.0;
    const double cost =
      bonus * (stepCost + shareBelow * testCost(below) + shareAbove * testCost(above));
    if (cost < this->cost_)
    {
      this->cost_ = cost;
      this->split_ = split;
    }
  }

  static double next(const std::vector<double>& sorted, std::size_t i)
  {
    return i < sorted.size() ? sorted[i] : std::numeric_limits<double>::infinity();
  }

  std::vector<double> begins_;
  std::vector<double> ends_;
  std::vector<double> flats_;
  KdSplit split_;
  double cost_ = 0.0;
};

} // namespace

KdSplitter spatialMedianSplitter(int leafSize)
{
  return [leafSize](const Box& cell, const std::vector<KdReference>& references) -> KdSplit
  {
    const int axis = cell.longestAxis();
    const double middle = cell.centre()[axis];
    // Between neighbouring numbers there is no middle.
    const bool divides = cell.lower[axis] < middle && middle < cell.upper[axis];
    if (!divides || references.size() <= static_cast<std::size_t>(leafSize))
    {
      return {};
    }
    return { axis, middle, true };
  };
}

KdSplitter kdSahSplitter()
{
  const auto search = std::make_shared<PlaneSearch>();
  return [search](const Box& cell, const std::vector<KdReference>& references)
  { return search->best(cell, references); };
}

} // namespace lumitree
