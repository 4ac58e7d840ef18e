// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiSurfaceEdges.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace lumitree::filters
{
namespace
{

/// Disjoint sets whose members are equal or opposite to their root.
class SignedSets
{
public:
  explicit SignedSets(std::size_t n)
    : parent_(n)
    , opposite_(n, false)
  {
    std::iota(this->parent_.begin(), this->parent_.end(), 0u);
  }

  /// The root of i; afterwards opposite(i) is relative to it.
  std::uint32_t root(std::uint32_t i)
  {
    std::uint32_t top = i;
    bool sign = false;
    while (this->parent_[top] != top)
    {
      sign = sign != this->opposite_[top];
      top = this->parent_[top];
    }
    while (this->parent_[i] != top && i != top)
    {
      const std::uint32_t next = this->parent_[i];
      const bool rest = sign != this->opposite_[i];
      this->parent_[i] = top;
      this->opposite_[i] = sign;
      sign = rest;
      i = next;
    }
    return top;
  }

  [[nodiscard]] bool opposite(std::uint32_t i) const { return this->opposite_[i]; }

  /// Joins the sets of a and b, so that the two are opposite or equal. False when they are the
  /// other in a set already.
  bool join(std::uint32_t a, std::uint32_t b, bool areOpposite)
  {
    const std::uint32_t rootA = this->root(a);
    const std::uint32_t rootB = this->root(b);
    const bool signA = rootA != a && this->opposite_[a];
    const bool signB = rootB != b && this->opposite_[b];
    if (rootA == rootB)
    {
      return (signA != signB) == areOpposite;
    }
    const std::uint32_t low = std::min(rootA, rootB); // the first face is the root
    const std::uint32_t high = std::max(rootA, rootB);
    this->parent_[high] = low;
    this->opposite_[high] = (signA != signB) != areOpposite;
    return true;
  }

private:
  std::vector<std::uint32_t> parent_;
  std::vector<bool> opposite_;
};

struct Side
{
  std::uint32_t low;
  std::uint32_t high;
  EdgeUse use;
};

/// The corner of a face at a point.
std::uint32_t cornerAt(const std::vector<Face>& faces, std::uint32_t face, std::uint32_t point)
{
  const std::array<std::uint32_t, 3>& points = faces[face].points;
  const auto place = std::find(points.begin(), points.end(), point) - points.begin();
  return 3 * face + static_cast<std::uint32_t>(place);
}

} // namespace

EdgeTable::EdgeTable(const std::vector<Face>& faces)
{
  std::vector<Side> sides;
  sides.reserve(3 * faces.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::uint32_t from = faces[f].points[k];
      const std::uint32_t to = faces[f].points[(k + 1) % 3];
      sides.push_back({ std::min(from, to), std::max(from, to), { f, from < to } });
    }
  }
  std::sort(sides.begin(), sides.end(),
    [](const Side& a, const Side& b)
    { return std::tie(a.low, a.high, a.use.face) < std::tie(b.low, b.high, b.use.face); });
  this->uses.reserve(sides.size());
  for (const Side& side : sides)
  {
    if (this->edges.empty() || this->edges.back().low != side.low ||
      this->edges.back().high != side.high)
    {
      this->edges.push_back(
        { side.low, side.high, static_cast<std::uint32_t>(this->uses.size()), 0 });
    }
    ++this->edges.back().count;
    this->uses.push_back(side.use);
  }
}

const Edge* EdgeTable::find(std::uint32_t a, std::uint32_t b) const
{
  const std::uint32_t low = std::min(a, b);
  const std::uint32_t high = std::max(a, b);
  const auto found = std::lower_bound(this->edges.begin(), this->edges.end(), 0,
    [&](const Edge& edge, int) { return std::tie(edge.low, edge.high) < std::tie(low, high); });
  return found != this->edges.end() && found->low == low && found->high == high ? &*found : nullptr;
}

bool EdgeTable::isBalanced(const Edge& edge) const
{
  std::uint32_t forward = 0;
  for (std::uint32_t i = 0; i < edge.count; ++i)
  {
    forward += this->uses[edge.first + i].forward ? 1 : 0;
  }
  return 2 * forward == edge.count;
}

Patches::Patches(const std::vector<Face>& faces, const EdgeTable& table)
  : component(faces.size())
  , flipped(faces.size(), false)
{
  SignedSets together(faces.size());
  SignedSets wound(faces.size());
  for (const Edge& edge : table.edges)
  {
    const std::uint32_t first = table.uses[edge.first].face;
    for (std::uint32_t i = 1; i < edge.count; ++i)
    {
      together.join(first, table.uses[edge.first + i].face, false);
    }
    if (edge.count == 2)
    {
      const std::uint32_t second = table.uses[edge.first + 1].face;
      this->orientable = wound.join(first, second, table.isInconsistent(edge)) && this->orientable;
    }
  }
  std::vector<std::uint32_t> against(faces.size(), 0);
  std::vector<std::uint32_t> size(faces.size(), 0);
  for (std::uint32_t f = 0; f < faces.size(); ++f)
  {
    const std::uint32_t root = together.root(f);
    this->component[f] = root == f ? this->components++ : this->component[root];
    const std::uint32_t patch = wound.root(f);
    ++size[patch];
    against[patch] += wound.opposite(f) ? 1 : 0;
  }
  for (std::uint32_t f = 0; f < faces.size(); ++f)
  {
    const std::uint32_t patch = wound.root(f);
    const bool opposite = wound.opposite(f);
    this->flipped[f] = opposite != (2 * against[patch] > size[patch]);
  }
}

std::vector<bool> splitPoints(
  const std::vector<Face>& faces, const EdgeTable& table, std::size_t points)
{
  SignedSets corners(3 * faces.size());
  for (const Edge& edge : table.edges)
  {
    if (edge.count == 2)
    {
      const std::uint32_t a = table.uses[edge.first].face;
      const std::uint32_t b = table.uses[edge.first + 1].face;
      for (const std::uint32_t point : { edge.low, edge.high })
      {
        corners.join(cornerAt(faces, a, point), cornerAt(faces, b, point), false);
      }
    }
  }
  constexpr std::uint32_t none = ~0u;
  std::vector<std::uint32_t> fan(points, none);
  std::vector<bool> split(points, false);
  for (std::uint32_t f = 0; f < faces.size(); ++f)
  {
    for (std::uint32_t k = 0; k < 3; ++k)
    {
      const std::uint32_t point = faces[f].points[k];
      const std::uint32_t root = corners.root(3 * f + k);
      split[point] = split[point] || (fan[point] != none && fan[point] != root);
      fan[point] = root;
    }
  }
  return split;
}

} // namespace lumitree::filters
