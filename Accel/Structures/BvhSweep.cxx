// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/BvhSweep.h"

#include <algorithm>

namespace lumitree
{

SweepStrategy::SweepStrategy(
  const BuildReferences& references, int leafSize, BuildProgress& progress)
  : references_(references)
  , leafSize_(static_cast<std::size_t>(leafSize))
  , spare_(references.size())
  , rightCost_(references.size())
  , isLeft_(references.size())
{
  progress.stage(0.3, 3);
  for (RawArray<std::uint32_t>& order : this->order_)
  {
    order = RawArray<std::uint32_t>(references.size());
  }
  progress.forEach(3, 1,
    [&](std::size_t axis, std::size_t)
    {
      std::uint32_t* const order = this->order_[axis].data();
      const auto key = [&](std::uint32_t i)
      { return references[i].centre(static_cast<int>(axis)); };
      // References come in ascending order of id.
      std::vector<std::pair<float, std::uint32_t>> keys(references.size());
      for (std::uint32_t i = 0; i < references.size(); ++i)
      {
        keys[i] = { key(i), i };
      }
      std::sort(keys.begin(), keys.end());
      std::transform(
        keys.begin(), keys.end(), order, [](const auto& entry) { return entry.second; });
    });
}

bool SweepStrategy::split(
  BvhSegment& segment, bool halve, BvhSegment& left, BvhSegment& right, int& axis)
{
  const std::size_t count = segment.count();
  const bool fitsLeaf = count <= this->leafSize_;
  if (fitsLeaf && count <= bvhBlock)
  {
    return false;
  }
  Division division;
  if (halve)
  {
    division.axis = segment.bounds.longestAxis();
    division.left = count / 2;
  }
  else
  {
    division = this->best(segment);
  }
  const float area = segment.bounds.halfArea();
  if (fitsLeaf && division.cost + area >= area * blocksOf(count))
  {
    return false;
  }
  axis = division.axis;
  this->divide(segment, division, left, right);
  return true;
}

void SweepStrategy::ids(BvhSegment& segment, PrimitiveId* out) const
{
  for (std::size_t i = segment.begin; i < segment.end; ++i)
  {
    *out++ = this->references_[this->order_[0][i]].id;
  }
}

SweepStrategy::Division SweepStrategy::best(const BvhSegment& segment)
{
  Division best;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::uint32_t* const order = this->order_[axis].data();
    BuildBox right;
    for (std::size_t i = segment.end; --i > segment.begin;)
    {
      const BuildReference& r = this->references_[order[i]];
      right.extend(r.low(), r.high());
      this->rightCost_[i] = right.halfArea() * blocksOf(segment.end - i);
    }
    BuildBox left;
    for (std::size_t i = segment.begin; i + 1 < segment.end; ++i)
    {
      const BuildReference& r = this->references_[order[i]];
      left.extend(r.low(), r.high());
      const std::size_t count = i + 1 - segment.begin;
      const float cost = left.halfArea() * blocksOf(count) + this->rightCost_[i + 1];
      // Of divisions that cost the same (all in one place) the even one is the best.
      const auto uneven = [&](std::size_t n)
      { return std::max(n, segment.count() - n) - std::min(n, segment.count() - n); };
      if (cost < best.cost || (cost == best.cost && uneven(count) < uneven(best.left)))
      {
        best = { axis, count, cost };
      }
    }
  }
  return best;
}

void SweepStrategy::divide(
  const BvhSegment& segment, const Division& division, BvhSegment& left, BvhSegment& right)
{
  left.begin = segment.begin;
  left.end = right.begin = segment.begin + division.left;
  right.end = segment.end;
  const std::uint32_t* const order = this->order_[division.axis].data();
  for (std::size_t i = segment.begin; i < segment.end; ++i)
  {
    const bool isLeft = i < left.end;
    const BuildReference& r = this->references_[order[i]];
    this->isLeft_[order[i]] = isLeft;
    (isLeft ? left : right).bounds.extend(r.low(), r.high());
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (axis == division.axis)
    {
      continue;
    }
    std::uint32_t* const other = this->order_[axis].data();
    std::size_t kept = left.begin;
    std::size_t moved = right.begin;
    for (std::size_t i = segment.begin; i < segment.end; ++i)
    {
      const std::uint32_t r = other[i];
      if (this->isLeft_[r])
      {
        other[kept++] = r;
      }
      else
      {
        this->spare_[moved++] = r;
      }
    }
    std::copy(
      this->spare_.data() + right.begin, this->spare_.data() + right.end, other + right.begin);
  }
}

} // namespace lumitree
