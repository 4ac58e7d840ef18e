// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/WideBvhOrder.h"

#include <array>
#include <cmath>

namespace lumitree
{
namespace
{

/// The binary splits that a wide node was made of, at most seven.
class Splits
{
public:
  Splits(const BvhTree& binary, const std::vector<CollapsedNode>& kept, const CollapsedNode& node)
    : binary_(binary)
    , kept_(kept)
    , node_(node)
    , root_(this->add(node.binary))
  {
  }

  /// The lanes from far to near for directions of that octant, four bits each.
  [[nodiscard]] std::uint32_t order(unsigned octant) const
  {
    std::uint32_t order = 0;
    int at = 0;
    this->visit(this->root_, octant, order, at);
    // Lanes without a child are met by no ray; each lane is named once all the same.
    for (std::uint32_t lane = this->node_.childCount; lane < wideArity; ++lane)
    {
      order |= lane << (4 * at++);
    }
    return order;
  }

private:
  struct Split
  {
    int left; ///< a split, or ~lane
    int right;
    unsigned rightIsNear; ///< bit o: for directions of octant o
  };

  int add(std::uint32_t binary)
  {
    for (std::uint32_t lane = 0; lane < this->node_.childCount; ++lane)
    {
      if (this->kept_[this->node_.firstChild + lane].binary == binary)
      {
        return ~static_cast<int>(lane);
      }
    }
    const std::uint32_t first = this->binary_.nodes[binary].first;
    const BvhTreeNode& left = this->binary_.nodes[first];
    const BvhTreeNode& right = this->binary_.nodes[first + 1];
    int axis = 0;
    float step = 0.0f; // twice the way from the left box's centre to the right one's
    for (int k = 0; k < 3; ++k)
    {
      const float along = (right.lower[k] + right.upper[k]) - (left.lower[k] + left.upper[k]);
      axis = std::fabs(along) > std::fabs(step) ? k : axis;
      step = axis == k ? along : step;
    }
    // The octants whose direction is negative along each axis.
    constexpr std::array<unsigned, 3> negative = { 0b10101010, 0b11001100, 0b11110000 };
    Split split;
    split.rightIsNear = step >= 0.0f ? negative[axis] : ~negative[axis];
    split.left = this->add(first);
    split.right = this->add(first + 1);
    this->splits_[this->count_] = split;
    return this->count_++;
  }

  void visit(int child, unsigned octant, std::uint32_t& order, int& at) const
  {
    if (child < 0)
    {
      order |= static_cast<std::uint32_t>(~child) << (4 * at++);
      return;
    }
    const Split& split = this->splits_[child];
    const bool rightIsNear = (split.rightIsNear >> octant & 1u) != 0;
    this->visit(rightIsNear ? split.left : split.right, octant, order, at);
    this->visit(rightIsNear ? split.right : split.left, octant, order, at);
  }

  const BvhTree& binary_;
  const std::vector<CollapsedNode>& kept_;
  const CollapsedNode& node_;
  std::array<Split, wideArity - 1> splits_;
  int count_ = 0;
  int root_;
};

} // namespace

void orderLanes(const BvhTree& binary, const std::vector<CollapsedNode>& kept,
  const CollapsedNode& node, WideBvhNode& wide)
{
  const Splits splits(binary, kept, node);
  for (unsigned octant = 0; octant < 8; ++octant)
  {
    wide.order[octant] = splits.order(octant);
  }
}

} // namespace lumitree
