// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/BvhBinned.h"

#include "Accel/Parallel.h"

#include <algorithm>
#include <array>
#include <utility>

namespace lumitree
{
namespace
{

constexpr int mostBins = 32;
constexpr std::size_t chunk = 16384;
constexpr std::ptrdiff_t fewReferences = 128;

/// From a centre to its bin, on all axes at once. Axes without extent put all in bin 0.
class Mapping
{
public:
  Mapping(const BuildBox& centres, std::size_t references)
    : count_(static_cast<int>(std::min<std::size_t>(mostBins, 4 + references / 20)))
    , base_(centres.lower)
  {
    const Float4 sides = centres.sides();
    for (int k = 0; k < 3; ++k)
    {
      // Less than the number of bins by more than two roundings, so that the last centre stays in
      // the last bin.
      this->scale_[k] =
        sides[k] > 0x1p-80f ? static_cast<float>(this->count_) * 0.999999f / sides[k] : 0.0f;
    }
  }

  [[nodiscard]] int count() const { return this->count_; }

  [[nodiscard]] Int4 of(Float4 centre) const
  {
    return __builtin_convertvector((centre - this->base_) * this->scale_, Int4);
  }

  [[nodiscard]] BinnedPlane plane(int axis) const
  {
    BinnedPlane plane;
    plane.axis = axis;
    plane.base = this->base_[axis];
    plane.scale = this->scale_[axis];
    return plane;
  }

private:
  int count_;
  Float4 base_;
  Float4 scale_ = float4(0.0f);
};

struct Bins
{
  std::array<std::array<BuildBox, 3>, mostBins> box;
  std::array<std::array<std::uint32_t, 3>, mostBins> count;

  explicit Bins(int used)
  {
    std::fill_n(this->box.begin(), used, std::array<BuildBox, 3>{});
    std::fill_n(this->count.begin(), used, std::array<std::uint32_t, 3>{});
  }

  void put(const Mapping& mapping, const BuildReference& r)
  {
    const Float4 low = r.low();
    const Float4 high = r.high();
    const Int4 bin = mapping.of(low + high);
    this->put(bin[0], 0, low, high);
    this->put(bin[1], 1, low, high);
    this->put(bin[2], 2, low, high);
  }

  void put(int bin, int axis, Float4 low, Float4 high)
  {
    const auto b = static_cast<std::size_t>(bin);
    this->box[b][axis].extend(low, high);
    ++this->count[b][axis];
  }

  void add(const Bins& other, int used)
  {
    for (int b = 0; b < used; ++b)
    {
      for (int k = 0; k < 3; ++k)
      {
        this->box[b][k].extend(other.box[b][k]);
        this->count[b][k] += other.count[b][k];
      }
    }
  }
};

/// Neighbours are in one bin more often than not, and each waits for the one before: every other
/// one has bins of its own.
Bins binned(const Mapping& mapping, const BuildReference* begin, const BuildReference* end)
{
  Bins even(mapping.count());
  if (end - begin < fewReferences)
  {
    for (const BuildReference* r = begin; r != end; ++r)
    {
      even.put(mapping, *r);
    }
    return even;
  }
  Bins odd(mapping.count());
  const BuildReference* r = begin;
  for (; r + 1 < end; r += 2)
  {
    even.put(mapping, r[0]);
    odd.put(mapping, r[1]);
  }
  if (r != end)
  {
    even.put(mapping, *r);
  }
  even.add(odd, mapping.count());
  return even;
}

BinnedPlane cheapest(const Mapping& mapping, const Bins& bins)
{
  const int used = mapping.count();
  int axis = -1;
  int at = 0;
  float least = std::numeric_limits<float>::infinity();
  for (int k = 0; k < 3; ++k)
  {
    std::array<float, mostBins> rightCost;
    BuildBox right;
    std::uint32_t count = 0;
    for (int b = used - 1; b > 0; --b)
    {
      right.extend(bins.box[b][k]);
      count += bins.count[b][k];
      rightCost[b] =
        count > 0 ? right.halfArea() * blocksOf(count) : std::numeric_limits<float>::infinity();
    }
    BuildBox left;
    count = 0;
    for (int b = 1; b < used; ++b)
    {
      left.extend(bins.box[b - 1][k]);
      count += bins.count[b - 1][k];
      if (count > 0)
      {
        const float cost = left.halfArea() * blocksOf(count) + rightCost[b];
        if (cost < least)
        {
          least = cost;
          axis = k;
          at = b;
        }
      }
    }
  }
  if (axis < 0)
  {
    return {};
  }
  BinnedPlane plane = mapping.plane(axis);
  plane.bin = at;
  plane.cost = least;
  for (int b = 0; b < used; ++b)
  {
    (b < at ? plane.left : plane.right).extend(bins.box[b][axis]);
  }
  return plane;
}

} // namespace

BinnedStrategy::BinnedStrategy(BuildReferences& references, int leafSize, BuildProgress& progress)
  : references_(references)
  , leafSize_(static_cast<std::size_t>(leafSize))
  , progress_(progress)
  , together_(concurrency(progress.threads()) > 1)
{
}

bool BinnedStrategy::split(
  BvhSegment& segment, bool halve, BvhSegment& left, BvhSegment& right, int& axis)
{
  const std::size_t count = segment.count();
  const bool fitsLeaf = count <= this->leafSize_;
  if (fitsLeaf && count <= bvhBlock)
  {
    return false;
  }
  const BinnedPlane plane = halve ? BinnedPlane{} : this->best(segment);
  const float area = segment.bounds.halfArea();
  // One step down costs about as much as a block of primitives.
  if (fitsLeaf && plane.cost + area >= area * blocksOf(count))
  {
    return false;
  }
  if (plane.axis < 0)
  {
    axis = segment.bounds.longestAxis();
    halveSegment(this->references_, axis, segment, left, right);
    return true;
  }
  axis = plane.axis;
  this->divide(segment, plane, left, right);
  return true;
}

void BinnedStrategy::ids(BvhSegment& segment, PrimitiveId* out) const
{
  for (std::size_t i = segment.begin; i < segment.end; ++i)
  {
    *out++ = this->references_[i].id;
  }
}

BinnedPlane BinnedStrategy::best(const BvhSegment& segment) const
{
  const Mapping mapping(segment.centres, segment.count());
  const BuildReference* const all = this->references_.data() + segment.begin;
  if (!this->isShared(segment))
  {
    return cheapest(mapping, binned(mapping, all, all + segment.count()));
  }
  std::vector<Bins> parts((segment.count() + chunk - 1) / chunk, Bins(mapping.count()));
  parallelFor(segment.count(), chunk, this->progress_.threads(), nullptr,
    [&](std::size_t begin, std::size_t end)
    {
      this->progress_.advance(0);
      parts[begin / chunk] = binned(mapping, all + begin, all + end);
    });
  Bins bins(mapping.count());
  for (const Bins& part : parts)
  {
    bins.add(part, mapping.count());
  }
  return cheapest(mapping, bins);
}

void BinnedStrategy::divide(
  const BvhSegment& segment, const BinnedPlane& plane, BvhSegment& left, BvhSegment& right)
{
  left.bounds = plane.left;
  right.bounds = plane.right;
  if (this->isShared(segment))
  {
    this->divideShared(segment, plane, left, right);
    return;
  }
  BuildReference* low = this->references_.data() + segment.begin;
  BuildReference* high = this->references_.data() + segment.end;
  BuildBox below;
  BuildBox above;
  while (true)
  {
    while (low != high && plane.isLeft(*low))
    {
      below.extend((low++)->centre());
    }
    while (low != high && !plane.isLeft(high[-1]))
    {
      above.extend((--high)->centre());
    }
    if (low == high)
    {
      break;
    }
    std::swap(*low, high[-1]);
  }
  left.centres = below;
  right.centres = above;
  const auto middle = static_cast<std::size_t>(low - this->references_.data());
  left.begin = segment.begin;
  left.end = right.begin = middle;
  right.end = segment.end;
}

/// The order within the sides differs from that of divide, but no tree depends on it. Chunk by
/// chunk into other memory and back, in the order they have.
void BinnedStrategy::divideShared(
  const BvhSegment& segment, const BinnedPlane& plane, BvhSegment& left, BvhSegment& right)
{
  struct Part
  {
    std::size_t left = 0;
    std::size_t right = 0;
    BuildBox below;
    BuildBox above;
  };
  const std::size_t count = segment.count();
  const int threads = this->progress_.threads();
  BuildReference* const all = this->references_.data() + segment.begin;
  std::vector<Part> parts((count + chunk - 1) / chunk);
  if (this->spare_.size() == 0)
  {
    this->spare_ = BuildReferences(this->references_.size());
  }
  parallelFor(count, chunk, threads, nullptr,
    [&](std::size_t begin, std::size_t end)
    {
      this->progress_.advance(0);
      Part part;
      for (std::size_t i = begin; i < end; ++i)
      {
        const bool isLeft = plane.isLeft(all[i]);
        (isLeft ? part.below : part.above).extend(all[i].centre());
        ++(isLeft ? part.left : part.right);
      }
      parts[begin / chunk] = part;
    });
  std::size_t lefts = 0;
  for (Part& part : parts)
  {
    left.centres.extend(part.below);
    right.centres.extend(part.above);
    lefts += part.left;
  }
  std::size_t nextLeft = 0;
  std::size_t nextRight = lefts;
  for (Part& part : parts)
  {
    nextLeft += std::exchange(part.left, nextLeft);
    nextRight += std::exchange(part.right, nextRight);
  }
  BuildReference* const out = this->spare_.data() + segment.begin;
  parallelFor(count, chunk, threads, nullptr,
    [&](std::size_t begin, std::size_t end)
    {
      Part& part = parts[begin / chunk];
      for (std::size_t i = begin; i < end; ++i)
      {
        out[plane.isLeft(all[i]) ? part.left++ : part.right++] = all[i];
      }
    });
  parallelFor(count, chunk, threads, nullptr,
    [&](std::size_t begin, std::size_t end) { std::copy(out + begin, out + end, all + begin); });
  left.begin = segment.begin;
  left.end = right.begin = segment.begin + lefts;
  right.end = segment.end;
}

void halveSegment(BuildReferences& references, int axis, const BvhSegment& segment,
  BvhSegment& left, BvhSegment& right)
{
  const auto at = [&](std::size_t i) { return references.data() + i; };
  const std::size_t middle = segment.begin + segment.count() / 2;
  std::nth_element(at(segment.begin), at(middle), at(segment.end),
    [axis](const BuildReference& a, const BuildReference& b) {
      return a.centre(axis) < b.centre(axis) || (a.centre(axis) == b.centre(axis) && a.id < b.id);
    });
  left.begin = segment.begin;
  left.end = right.begin = middle;
  right.end = segment.end;
  for (BvhSegment* side : { &left, &right })
  {
    for (std::size_t i = side->begin; i < side->end; ++i)
    {
      side->bounds.extend(references[i].low(), references[i].high());
      side->centres.extend(references[i].centre());
    }
  }
}

} // namespace lumitree
