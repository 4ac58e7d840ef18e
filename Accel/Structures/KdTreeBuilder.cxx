// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/KdTreeBuilder.h"

#include "Accel/Structures/KdTreeDivision.h"

#include <memory>
#include <stdexcept>

namespace lumitree
{
namespace
{

/// Subtrees are as large as this or as this share of the triangles.
///@{
constexpr std::size_t leastSubtree = 4096;
constexpr std::size_t subtreeShare = 128;
///@}
constexpr std::size_t referencesPerReport = 1024;

/// A tree by itself: the root is node 0, leaves name blocks from its own first block on.
struct Subtree
{
  std::vector<KdNode> nodes;
  std::vector<PrimitiveId> ids; ///< of leaves, as many places as their blocks have

  [[nodiscard]] std::size_t blocks() const { return this->ids.size() / blockWidth; }
};

/// What every part of a build knows.
struct Job
{
  const Surface& surface;
  const BuildOptions& options;
  int depthLimit;
  BuildProgress& progress;

  [[nodiscard]] bool bySah() const { return this->options.kdBuild == KdBuild::Sah; }

  /// Where to divide; axis -1 for a leaf.
  [[nodiscard]] KdSplit split(const KdPart& part) const
  {
    if (part.depth >= this->depthLimit)
    {
      return {};
    }
    if (!this->bySah())
    {
      return spatialMedianSplit(part.cell, part.references.size(), this->options.leafSize);
    }
    KdOffer best = kdLeafOffer(part.references.size());
    for (int axis = 0; axis < 3; ++axis)
    {
      best = cheapestAcross(
        axis, part.cell, part.references.size(), part.events[static_cast<std::size_t>(axis)], best);
    }
    return best.split;
  }
};

void makeInterior(KdNode& node, const KdSplit& split, std::size_t first)
{
  node.axis = static_cast<std::uint32_t>(split.axis) & 3u;
  node.position = split.position;
  node.first = static_cast<std::uint32_t>(first);
}

/// Grows a subtree, the part below a plane before the one above.
class Grower
{
public:
  explicit Grower(const Job& job)
    : job_(job)
  {
  }

  Subtree grow(KdPart& root)
  {
    this->tree_.nodes.emplace_back();
    this->grow(root, 0, 0);
    return std::move(this->tree_);
  }

private:
  /// Two parts per level are all that there is at a time; their memory is used again.
  struct Level
  {
    KdPart below;
    KdPart above;
  };

  void grow(KdPart& part, std::size_t index, std::size_t level)
  {
    if (part.references.size() > referencesPerReport)
    {
      this->job_.progress.advance(0);
    }
    const KdSplit split = this->job_.split(part);
    if (split.axis >= 0)
    {
      if (level == this->levels_.size())
      {
        this->levels_.push_back(std::make_unique<Level>());
      }
      Level& parts = *this->levels_[level];
      if (this->division_.divide(this->job_.surface, part, split, parts.below, parts.above))
      {
        for (int axis = 0; axis < 3 && this->job_.bySah(); ++axis)
        {
          this->division_.takeEvents(part, axis, parts.below, parts.above);
        }
        const std::size_t first = this->tree_.nodes.size();
        makeInterior(this->tree_.nodes[index], split, first);
        this->tree_.nodes.resize(first + 2);
        this->grow(parts.below, first, level + 1);
        this->grow(parts.above, first + 1, level + 1);
        return;
      }
    }
    this->makeLeaf(part, this->tree_.nodes[index]);
  }

  void makeLeaf(const KdPart& part, KdNode& leaf)
  {
    const std::size_t count = part.references.size();
    if (count > KdNode::largestLeaf)
    {
      throw std::length_error("too many triangles in one cell of a KD-tree");
    }
    leaf.count = static_cast<std::uint32_t>(count);
    leaf.first = static_cast<std::uint32_t>(this->tree_.blocks());
    for (const KdReference& r : part.references)
    {
      this->tree_.ids.push_back(r.id);
    }
    this->tree_.ids.resize(blockWidth * (leaf.first + (count + blockWidth - 1) / blockWidth));
  }

  const Job& job_;
  Subtree tree_;
  KdDivision division_;
  std::vector<std::unique_ptr<Level>> levels_;
};

/// The top of the tree: interior nodes, and subtrees below them.
class Top
{
public:
  explicit Top(const Job& job)
    : job_(job)
  {
  }

  KdTreeNodes build(LeafBlocks& blocks)
  {
    KdPart root = this->rootPart();
    const std::size_t count = root.references.size();
    this->small_ = std::max(leastSubtree, count / subtreeShare);
    if (this->job_.bySah())
    {
      this->job_.progress.stage(0.15, kdSortWork * count);
      root.events = sortedEvents(root.references, this->job_.progress);
    }
    std::size_t levels = 1;
    while (count >> levels > this->small_)
    {
      ++levels;
    }
    this->job_.progress.stage(0.4, levels * count);
    this->divideTop(std::move(root));
    this->growSubtrees();
    return this->assemble(blocks);
  }

private:
  struct Node
  {
    KdSplit split;
    std::size_t first = 0;   ///< child, where it is divided
    std::size_t subtree = 0; ///< where it is not
  };

  struct Open
  {
    std::size_t node = 0;
    KdPart part;
    std::array<KdOffer, 3> offers;
    KdSplit split;
    KdDivision division;
    KdPart below;
    KdPart above;
  };

  KdPart rootPart() const
  {
    const Surface& surface = this->job_.surface;
    KdPart root;
    root.cell = surface.bounds();
    root.references.reserve(surface.hittable().size());
    for (const PrimitiveId id : surface.hittable())
    {
      root.references.push_back({ surface.box(id), id });
    }
    root.allowance = kdReferencesPerTriangle * root.references.size();
    if (root.references.size() >= mostKdReferences / kdReferencesPerTriangle)
    {
      throw std::length_error("too many triangles for a KD-tree");
    }
    return root;
  }

  void divideTop(KdPart root)
  {
    this->nodes_.emplace_back();
    std::vector<std::unique_ptr<Open>> level;
    this->add(std::move(root), 0, level);
    while (!level.empty())
    {
      this->chooseSplits(level);
      this->divide(level);
      std::vector<std::unique_ptr<Open>> next;
      for (const auto& open : level)
      {
        if (open->split.axis < 0)
        {
          this->addSubtree(std::move(open->part), open->node);
          continue;
        }
        Node& node = this->nodes_[open->node];
        const std::size_t first = this->nodes_.size();
        node.split = open->split;
        node.first = first;
        this->nodes_.resize(first + 2);
        this->add(std::move(open->below), first, next);
        this->add(std::move(open->above), first + 1, next);
      }
      level = std::move(next);
    }
  }

  void add(KdPart part, std::size_t node, std::vector<std::unique_ptr<Open>>& level)
  {
    if (part.references.size() <= this->small_)
    {
      this->addSubtree(std::move(part), node);
      return;
    }
    level.push_back(std::make_unique<Open>());
    level.back()->node = node;
    level.back()->part = std::move(part);
  }

  void addSubtree(KdPart part, std::size_t node)
  {
    this->nodes_[node].subtree = this->roots_.size();
    this->roots_.push_back(std::move(part));
  }

  void chooseSplits(const std::vector<std::unique_ptr<Open>>& level) const
  {
    if (!this->job_.bySah())
    {
      for (const auto& open : level)
      {
        open->split = this->job_.split(open->part);
      }
      return;
    }
    this->job_.progress.forEach(
      3 * level.size(), 1,
      [&](std::size_t begin, std::size_t)
      {
        Open& open = *level[begin / 3];
        const KdPart& part = open.part;
        open.offers[begin % 3] = cheapestAcross(static_cast<int>(begin % 3), part.cell,
          part.references.size(), part.events[begin % 3], kdLeafOffer(part.references.size()));
      },
      [](std::size_t, std::size_t) { return std::size_t{ 0 }; });
    for (const auto& open : level)
    {
      KdOffer best = kdLeafOffer(open->part.references.size());
      for (const KdOffer& offer : open->offers)
      {
        best = offer.cost < best.cost ? offer : best;
      }
      open->split = open->part.depth < this->job_.depthLimit ? best.split : KdSplit{};
    }
  }

  void divide(const std::vector<std::unique_ptr<Open>>& level) const
  {
    this->job_.progress.forEach(
      level.size(), 1,
      [&](std::size_t begin, std::size_t)
      {
        Open& open = *level[begin];
        if (open.split.axis >= 0 &&
          !open.division.divide(this->job_.surface, open.part, open.split, open.below, open.above))
        {
          open.split = {};
        }
      },
      [&](std::size_t begin, std::size_t) { return level[begin]->part.references.size(); });
    if (this->job_.bySah())
    {
      this->job_.progress.forEach(
        3 * level.size(), 1,
        [&](std::size_t begin, std::size_t)
        {
          Open& open = *level[begin / 3];
          if (open.split.axis >= 0)
          {
            open.division.takeEvents(
              open.part, static_cast<int>(begin % 3), open.below, open.above);
            open.part.events[begin % 3] = {};
          }
        },
        [](std::size_t, std::size_t) { return std::size_t{ 0 }; });
    }
  }

  void growSubtrees()
  {
    std::size_t references = 0;
    std::vector<std::size_t> weights;
    for (const KdPart& root : this->roots_)
    {
      weights.push_back(root.references.size());
      references += weights.back();
    }
    this->job_.progress.stage(0.9, references);
    this->subtrees_.resize(this->roots_.size());
    this->job_.progress.forEach(
      this->roots_.size(), 1,
      [&](std::size_t begin, std::size_t)
      {
        KdPart root = std::move(this->roots_[begin]);
        this->subtrees_[begin] = Grower(this->job_).grow(root);
      },
      [&](std::size_t begin, std::size_t) { return weights[begin]; });
  }

  /// One tree, nodes and leaves in the order of a walk from below to above.
  KdTreeNodes assemble(LeafBlocks& blocks)
  {
    KdTreeNodes tree;
    tree.cell = this->job_.surface.bounds();
    std::size_t count = this->nodes_.size();
    std::size_t blockCount = 0;
    for (const Subtree& subtree : this->subtrees_)
    {
      count += subtree.nodes.size() - 1;
      blockCount += subtree.blocks();
    }
    if (count >= ~std::uint32_t{ 0 } || blockCount >= ~std::uint32_t{ 0 })
    {
      throw std::length_error("too many triangles for a KD-tree");
    }
    tree.nodes.reserve(count);
    tree.nodes.emplace_back();
    std::visit([&](auto& store) { store.resize(blockCount); }, blocks);

    std::vector<std::size_t> firstBlocks(this->subtrees_.size());
    std::size_t nextBlock = 0;
    std::vector<std::pair<std::size_t, std::size_t>> waiting = { { 0, 0 } }; // here, in the tree
    while (!waiting.empty())
    {
      const auto [from, to] = waiting.back();
      waiting.pop_back();
      const Node& node = this->nodes_[from];
      if (node.split.axis >= 0)
      {
        const std::size_t first = tree.nodes.size();
        makeInterior(tree.nodes[to], node.split, first);
        tree.nodes.resize(first + 2);
        waiting.emplace_back(node.first + 1, first + 1);
        waiting.emplace_back(node.first, first);
        continue;
      }
      firstBlocks[node.subtree] = nextBlock;
      append(this->subtrees_[node.subtree], to, nextBlock, tree);
      nextBlock += this->subtrees_[node.subtree].blocks();
    }
    this->job_.progress.stage(0.99, this->subtrees_.size());
    this->job_.progress.forEach(this->subtrees_.size(), 1,
      [&](std::size_t begin, std::size_t)
      { this->fill(this->subtrees_[begin], firstBlocks[begin], blocks); });
    return tree;
  }

  /// Puts a subtree in the place of a node.
  static void append(
    const Subtree& subtree, std::size_t node, std::size_t firstBlock, KdTreeNodes& tree)
  {
    const auto offset = static_cast<std::uint32_t>(tree.nodes.size() - 1);
    const auto moved = [&](KdNode n)
    {
      n.first += n.isLeaf() ? static_cast<std::uint32_t>(firstBlock) : offset;
      return n;
    };
    tree.nodes[node] = moved(subtree.nodes.front());
    std::transform(
      subtree.nodes.begin() + 1, subtree.nodes.end(), std::back_inserter(tree.nodes), moved);
  }

  void fill(Subtree& subtree, std::size_t firstBlock, LeafBlocks& blocks) const
  {
    for (const KdNode& node : subtree.nodes)
    {
      if (node.isLeaf())
      {
        const PrimitiveId* const ids = subtree.ids.data() + std::size_t{ blockWidth } * node.first;
        const auto block = static_cast<std::uint32_t>(firstBlock + node.first);
        std::visit(
          [&](auto& store) { store.put(block, this->job_.surface, ids, node.count); }, blocks);
      }
    }
    subtree = {};
  }

  const Job& job_;
  std::size_t small_ = 0;
  std::vector<Node> nodes_;
  std::vector<KdPart> roots_;
  std::vector<Subtree> subtrees_;
};

} // namespace

KdTreeNodes buildKdTreeNodes(
  const Surface& surface, const BuildOptions& options, LeafBlocks& blocks, BuildProgress& progress)
{
  const auto count = static_cast<double>(std::max<std::size_t>(1, surface.hittable().size()));
  const int depthLimit = std::min(options.maxDepth, static_cast<int>(8.0 + 1.3 * std::log2(count)));
  return Top({ surface, options, depthLimit, progress }).build(blocks);
}

} // namespace lumitree
