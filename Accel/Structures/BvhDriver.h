// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BvhDriver_h
#define Lumitree_Accel_Structures_BvhDriver_h

#include "Accel/BuildProgress.h"
#include "Accel/Structures/BvhSegment.h"
#include "Accel/Structures/BvhTree.h"

#include <algorithm>

namespace lumitree
{

/// Divides from the root on as a strategy says (BvhSegment.h). The nodes at the top one after the
/// other, then the subtrees below them side by side. Where a subtree begins depends on the number
/// of references alone, so the tree is the same for any number of threads.
template <class Strategy>
class BvhDriver
{
public:
  BvhDriver(Strategy& strategy, int leafSize, int maxDepth, BuildProgress& progress)
    : strategy_(strategy)
    , leafSize_(static_cast<std::size_t>(leafSize))
    , maxDepth_(maxDepth)
    , progress_(progress)
  {
  }

  /// Fills in nodes and references. The root's segment says how many references there are and for
  /// how many there is room.
  void build(const BvhSegment& root, BvhTree& tree)
  {
    this->tree_ = &tree;
    tree.nodes.assign(1, BvhTreeNode{});
    tree.references.resize(root.limit);
    const std::size_t small = std::max(leastSubtree, root.count() / subtrees);
    std::vector<BvhSegment> waiting = { root };
    std::vector<BvhSegment> roots;
    while (!waiting.empty())
    {
      BvhSegment segment = waiting.back();
      waiting.pop_back();
      this->progress_.advance(0);
      if (segment.count() <= small)
      {
        roots.push_back(segment);
        continue;
      }
      this->visit(segment, tree.nodes, waiting);
    }
    std::vector<std::vector<BvhTreeNode>> grown(roots.size());
    this->progress_.forEach(
      roots.size(), 1,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          grown[i] = this->grow(roots[i]);
        }
      },
      [&](std::size_t begin, std::size_t) { return roots[begin].count(); });
    std::size_t nodes = tree.nodes.size();
    for (const std::vector<BvhTreeNode>& subtree : grown)
    {
      nodes += subtree.size() - 1;
    }
    tree.nodes.reserve(nodes);
    for (std::size_t i = 0; i < roots.size(); ++i)
    {
      this->append(roots[i].node, grown[i]);
      grown[i] = {};
    }
    this->closeGaps(root.count());
  }

private:
  static constexpr std::size_t leastSubtree = 4096;
  static constexpr std::size_t subtrees = 128;

  /// Makes a node; its children wait.
  void visit(BvhSegment& segment, std::vector<BvhTreeNode>& nodes, std::vector<BvhSegment>& waiting)
  {
    BvhTreeNode& node = nodes[segment.node];
    BvhSegment left;
    BvhSegment right;
    int axis = 0;
    if (segment.depth == this->maxDepth_ || segment.count() < 2 ||
      !this->strategy_.split(segment, this->mustHalve(segment), left, right, axis))
    {
      PrimitiveId* const ids = this->tree_->references.data() + segment.begin;
      this->strategy_.ids(segment, ids);
      setBox(node, segment.bounds);
      // Ascending, so that a leaf does not depend on how its node came about. Two parts of one
      // primitive may have met again.
      std::sort(ids, ids + segment.count());
      node.first = static_cast<std::uint32_t>(segment.begin);
      node.content = static_cast<std::uint32_t>(std::unique(ids, ids + segment.count()) - ids);
      return;
    }
    setBox(node, segment.bounds);
    node.first = static_cast<std::uint32_t>(nodes.size());
    node.content = BvhTreeNode::interiorMark + static_cast<std::uint32_t>(axis);
    left.node = node.first;
    right.node = node.first + 1;
    left.depth = right.depth = segment.depth + 1;
    nodes.resize(nodes.size() + 2);
    waiting.push_back(right);
    waiting.push_back(left);
  }

  static void setBox(BvhTreeNode& node, const BuildBox& bounds)
  {
    for (int k = 0; k < 3; ++k)
    {
      node.lower[k] = bounds.lower[k];
      node.upper[k] = bounds.upper[k];
    }
  }

  std::vector<BvhTreeNode> grow(BvhSegment segment)
  {
    std::vector<BvhTreeNode> nodes(1);
    nodes.reserve(segment.count());
    std::vector<BvhSegment> waiting;
    waiting.reserve(static_cast<std::size_t>(this->maxDepth_) + 1);
    segment.node = 0;
    waiting.push_back(segment);
    while (!waiting.empty())
    {
      BvhSegment next = waiting.back();
      waiting.pop_back();
      if (next.count() > referencesPerReport)
      {
        this->progress_.advance(0);
      }
      this->visit(next, nodes, waiting);
    }
    return nodes;
  }

  /// Puts a subtree in the place of the node.
  void append(std::uint32_t node, const std::vector<BvhTreeNode>& subtree)
  {
    const auto offset = static_cast<std::uint32_t>(this->tree_->nodes.size() - 1);
    const auto moved = [offset](BvhTreeNode n)
    {
      n.first += n.isLeaf() ? 0 : offset;
      return n;
    };
    this->tree_->nodes[node] = moved(subtree.front());
    std::transform(
      subtree.begin() + 1, subtree.end(), std::back_inserter(this->tree_->nodes), moved);
  }

  /// Halving is all that the depth left allows.
  [[nodiscard]] bool mustHalve(const BvhSegment& segment) const
  {
    const int left = this->maxDepth_ - segment.depth;
    const auto holds = [&](int levels)
    { return levels < 32 && this->leafSize_ << levels >= segment.count(); };
    return left < 32 && holds(left) && !holds(left - 1);
  }

  /// Leaves side by side, in the order of the tree, where there was more room than references.
  void closeGaps(std::size_t references)
  {
    BvhTree& tree = *this->tree_;
    if (tree.references.size() == references && !tree.clipped)
    {
      return;
    }
    std::vector<PrimitiveId> packed;
    packed.reserve(tree.references.size());
    std::vector<std::uint32_t> waiting = { 0 };
    while (!waiting.empty())
    {
      BvhTreeNode& node = tree.nodes[waiting.back()];
      waiting.pop_back();
      if (!node.isLeaf())
      {
        waiting.push_back(node.first + 1);
        waiting.push_back(node.first);
        continue;
      }
      const auto first = tree.references.begin() + node.first;
      node.first = static_cast<std::uint32_t>(packed.size());
      packed.insert(packed.end(), first, first + node.content);
    }
    packed.shrink_to_fit();
    tree.references = std::move(packed);
  }

  static constexpr std::size_t referencesPerReport = 1024;

  Strategy& strategy_;
  std::size_t leafSize_;
  int maxDepth_;
  BuildProgress& progress_;
  BvhTree* tree_ = nullptr;
};

} // namespace lumitree

#endif
