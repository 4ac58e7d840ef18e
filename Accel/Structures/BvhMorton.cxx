// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/BvhMorton.h"

#include <algorithm>
#include <array>

namespace lumitree
{
namespace
{

constexpr int bitsPerAxis = 14;
constexpr int digitBits = 11;
constexpr std::size_t digits = std::size_t{ 1 } << digitBits;
constexpr std::size_t chunk = 65536;

/// A code and the reference that has it.
struct Coded
{
  std::uint64_t code;
  std::uint32_t reference;
};

/// The bits of a number below 2^21, two zeros between each.
std::uint64_t spread(std::uint64_t x)
{
  x = (x | x << 32) & 0x1f00000000ffffull;
  x = (x | x << 16) & 0x1f0000ff0000ffull;
  x = (x | x << 8) & 0x100f00f00f00f00full;
  x = (x | x << 4) & 0x10c30c30c30c30c3ull;
  x = (x | x << 2) & 0x1249249249249249ull;
  return x;
}

/// One pass of a radix sort that keeps the order of equal digits.
void sortByDigit(
  const RawArray<Coded>& from, RawArray<Coded>& to, int shift, BuildProgress& progress)
{
  const std::size_t n = from.size();
  std::vector<std::array<std::uint32_t, digits>> places((n + chunk - 1) / chunk);
  const auto digit = [shift](const Coded& c) { return c.code >> shift & (digits - 1); };
  progress.forEach(n, chunk,
    [&](std::size_t begin, std::size_t end)
    {
      auto& counts = places[begin / chunk];
      counts.fill(0);
      for (std::size_t i = begin; i < end; ++i)
      {
        ++counts[digit(from[i])];
      }
    });
  std::uint32_t next = 0;
  for (std::size_t d = 0; d < digits; ++d)
  {
    for (auto& counts : places)
    {
      const std::uint32_t count = counts[d];
      counts[d] = next;
      next += count;
    }
  }
  progress.forEach(n, chunk,
    [&](std::size_t begin, std::size_t end)
    {
      auto& place = places[begin / chunk];
      for (std::size_t i = begin; i < end; ++i)
      {
        to[place[digit(from[i])]++] = from[i];
      }
    });
}

} // namespace

MortonStrategy::MortonStrategy(
  const BuildReferences& references, const BvhSegment& root, int leafSize, BuildProgress& progress)
  : codes_(references.size())
  , references_(references.size())
  , leafSize_(std::min(static_cast<std::size_t>(leafSize), bvhBlock))
{
  constexpr int passes = (3 * bitsPerAxis + digitBits - 1) / digitBits;
  const std::size_t n = references.size();
  progress.stage(0.4, (2 * passes + 2) * n);
  Float4 scale = float4(0.0f);
  const Float4 sides = root.centres.sides();
  for (int k = 0; k < 3; ++k)
  {
    scale[k] = sides[k] > 0x1p-80f ? (1 << bitsPerAxis) * 0.999999f / sides[k] : 0.0f;
  }
  RawArray<Coded> coded(n);
  progress.forEach(n, chunk,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Float4 place = (references[i].centre() - root.centres.lower) * scale;
        coded[i].reference = static_cast<std::uint32_t>(i);
        coded[i].code = 0;
        for (int k = 0; k < 3; ++k)
        {
          coded[i].code |= spread(static_cast<std::uint64_t>(place[k])) << k;
        }
      }
    });
  RawArray<Coded> other(n);
  for (int pass = 0; pass < passes; ++pass)
  {
    sortByDigit(coded, other, pass * digitBits, progress);
    std::swap(coded, other);
  }
  progress.forEach(n, chunk,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        this->codes_[i] = coded[i].code;
        this->references_[i] = references[coded[i].reference];
      }
    });
}

bool MortonStrategy::split(
  BvhSegment& segment, bool halve, BvhSegment& left, BvhSegment& right, int& axis)
{
  if (segment.count() <= this->leafSize_)
  {
    return false;
  }
  const std::uint64_t* const codes = this->codes_.data();
  std::size_t middle = segment.begin + segment.count() / 2;
  const std::uint64_t changes = codes[segment.begin] ^ codes[segment.end - 1];
  axis = 0;
  if (changes != 0 && !halve)
  {
    int bit = 63;
    while (!(changes >> bit & 1u))
    {
      --bit;
    }
    axis = bit % 3;
    middle =
      static_cast<std::size_t>(std::partition_point(codes + segment.begin, codes + segment.end,
                                 [bit](std::uint64_t code) { return !(code >> bit & 1u); }) -
        codes);
  }
  left.begin = segment.begin;
  left.end = right.begin = middle;
  right.end = segment.end;
  return true;
}

void MortonStrategy::ids(BvhSegment& segment, PrimitiveId* out) const
{
  for (std::size_t i = segment.begin; i < segment.end; ++i)
  {
    const BuildReference& r = this->references_[i];
    *out++ = r.id;
    segment.bounds.extend(r.low(), r.high());
  }
}

void boundFromBelow(BvhTree& tree)
{
  // Children come after their parents.
  for (std::size_t i = tree.nodes.size(); i-- > 0;)
  {
    BvhTreeNode& node = tree.nodes[i];
    if (!node.isLeaf())
    {
      const BvhTreeNode& left = tree.nodes[node.first];
      const BvhTreeNode& right = tree.nodes[node.first + 1];
      for (int k = 0; k < 3; ++k)
      {
        node.lower[k] = std::min(left.lower[k], right.lower[k]);
        node.upper[k] = std::max(left.upper[k], right.upper[k]);
      }
    }
  }
}

} // namespace lumitree
