// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/WideBvhCollapse.h"

#include "Accel/Structures/WideBvhNodes.h"

#include <algorithm>
#include <array>

namespace lumitree
{
namespace
{

/// The best ways to show one binary node.
struct Plan
{
  /// cost[i]: least cost of showing the subtree as at most i nodes, i = 1 … 7.
  std::array<float, wideArity> cost{};
  /// split[i]: of i nodes, how many go to the left child; 0: fewer than i are better (or i is 1).
  std::array<std::uint8_t, wideArity> split{};
  /// As one wide node: how many of its eight lanes go to the left child. 0: a leaf.
  std::uint8_t lanes = 0;
  std::uint32_t primitives = 0;
};

class Planner
{
public:
  Planner(const BvhTree& bvh, int leafSize)
    : bvh_(bvh)
    , leafSize_(static_cast<std::uint32_t>(leafSize))
    , plans_(bvh.nodes.size())
  {
    // Children come after their parents.
    for (std::size_t i = bvh.nodes.size(); i-- > 0;)
    {
      this->plan(i);
    }
  }

  [[nodiscard]] std::vector<CollapsedNode> nodes() const
  {
    std::vector<CollapsedNode> kept(1);
    std::vector<std::uint32_t> lanes;
    for (std::uint32_t i = 0; i < kept.size(); ++i)
    {
      const std::uint32_t binary = kept[i].binary;
      const Plan& plan = this->plans_[binary];
      kept[i].leaf = plan.lanes == 0 && i > 0;
      if (kept[i].leaf)
      {
        continue;
      }
      lanes.clear();
      if (plan.lanes == 0)
      {
        lanes.push_back(binary);
      }
      else
      {
        const std::uint32_t left = this->bvh_.nodes[binary].first;
        this->gather(left, plan.lanes, lanes);
        this->gather(left + 1, wideArity - plan.lanes, lanes);
      }
      this->putDearestFirst(lanes);
      kept[i].firstChild = static_cast<std::uint32_t>(kept.size());
      kept[i].childCount = static_cast<std::uint32_t>(lanes.size());
      for (const std::uint32_t lane : lanes)
      {
        CollapsedNode child;
        child.binary = lane;
        kept.push_back(child);
      }
    }
    return kept;
  }

private:
  /// By effort; equal ones stay as they are. At most eight: each is put where it belongs.
  void putDearestFirst(std::vector<std::uint32_t>& lanes) const
  {
    const auto isDearer = [this](std::uint32_t a, std::uint32_t b)
    { return this->effort(a) > this->effort(b); };
    for (auto next = lanes.begin(); next != lanes.end(); ++next)
    {
      std::rotate(std::upper_bound(lanes.begin(), next, *next, isDearer), next, next + 1);
    }
  }

  /// What a ray that meets the node's box costs on the way through it.
  [[nodiscard]] float effort(std::uint32_t binary) const
  {
    const float area = this->bvh_.nodes[binary].halfArea();
    return area > 0.0f ? this->plans_[binary].cost[1] / area : 0.0f;
  }

  void plan(std::size_t i)
  {
    const BvhTreeNode& node = this->bvh_.nodes[i];
    Plan& plan = this->plans_[i];
    const float area = node.halfArea();
    if (node.isLeaf())
    {
      plan.primitives = node.count();
      plan.cost.fill(area * blocks(node.count()));
      return;
    }
    const Plan& left = this->plans_[node.first];
    const Plan& right = this->plans_[node.first + 1];
    plan.primitives = left.primitives + right.primitives;

    const auto best = [&](int lanes, std::uint8_t& split)
    {
      float least = std::numeric_limits<float>::infinity();
      for (int k = 1; k < lanes; ++k)
      {
        const float cost =
          left.cost[std::min(k, wideArity - 1)] + right.cost[std::min(lanes - k, wideArity - 1)];
        if (cost < least)
        {
          least = cost;
          split = static_cast<std::uint8_t>(k);
        }
      }
      return least;
    };

    const float asNode = best(wideArity, plan.lanes) + area;
    const float asLeaf = plan.primitives <= this->leafSize_
      ? area * blocks(plan.primitives)
      : std::numeric_limits<float>::infinity();
    plan.cost[1] = std::min(asNode, asLeaf);
    plan.lanes = asLeaf <= asNode ? 0 : plan.lanes;
    for (int lanes = 2; lanes < wideArity; ++lanes)
    {
      std::uint8_t split = 0;
      const float cost = best(lanes, split);
      const bool better = cost < plan.cost[lanes - 1];
      plan.cost[lanes] = better ? cost : plan.cost[lanes - 1];
      plan.split[lanes] = better ? split : 0;
    }
  }

  /// Appends the nodes that show the subtree in at most `lanes` lanes.
  void gather(std::uint32_t binary, int lanes, std::vector<std::uint32_t>& out) const
  {
    const Plan& plan = this->plans_[binary];
    int used = this->bvh_.nodes[binary].isLeaf() ? 1 : std::min(lanes, wideArity - 1);
    while (used > 1 && plan.split[used] == 0)
    {
      --used;
    }
    if (used == 1)
    {
      out.push_back(binary);
      return;
    }
    const std::uint32_t left = this->bvh_.nodes[binary].first;
    this->gather(left, plan.split[used], out);
    this->gather(left + 1, used - plan.split[used], out);
  }

  static float blocks(std::uint32_t primitives) { return static_cast<float>((primitives + 3) / 4); }

  const BvhTree& bvh_;
  std::uint32_t leafSize_;
  std::vector<Plan> plans_;
};

} // namespace

std::vector<CollapsedNode> collapse(const BvhTree& bvh, int leafSize)
{
  return Planner(bvh, leafSize).nodes();
}

} // namespace lumitree
