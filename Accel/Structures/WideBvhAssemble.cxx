// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/BvhFrame.h"
#include "Accel/Structures/WideBvhFill.h"
#include "Accel/Structures/WideBvhTopology.h"

#include <algorithm>

namespace lumitree
{
namespace
{

constexpr std::size_t chunk = 1024;

/// A box in the tree's frame, empty until something is put in.
struct FrameBox
{
  float planes[6];

  FrameBox()
  {
    std::fill_n(this->planes, 3, std::numeric_limits<float>::infinity());
    std::fill_n(this->planes + 3, 3, -std::numeric_limits<float>::infinity());
  }

  /// Rounding is monotonic: this holds the primitives that the box holds, with the room that each
  /// of them would be given.
  FrameBox(const WideBvhFrame& frame, const Box& box)
    : FrameBox()
  {
    for (int k = 0; k < 3 && !box.empty(); ++k)
    {
      this->planes[k] = roundedDown(box.lower[k], frame.centre[k], frame.scale);
      this->planes[k + 3] = roundedUp(box.upper[k], frame.centre[k], frame.scale);
    }
  }

  void extend(const FrameBox& other)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->planes[k] = std::min(this->planes[k], other.planes[k]);
      this->planes[k + 3] = std::max(this->planes[k + 3], other.planes[k + 3]);
    }
  }

  [[nodiscard]] bool empty() const { return !(this->planes[0] <= this->planes[3]); }
};

/// Where the children of each node are.
struct Firsts
{
  std::vector<std::uint32_t> firstNode; ///< of its children, the first that is a node
  std::vector<std::uint32_t> firstLeaf; ///< and the first that is a leaf

  explicit Firsts(const WideBvhTopology& topology)
  {
    std::uint32_t nodes = 1;
    std::uint32_t leaves = 0;
    for (const WideBvhTopology::Node& node : topology.nodes)
    {
      this->firstNode.push_back(nodes);
      this->firstLeaf.push_back(leaves);
      for (unsigned lane = 0; lane < node.children; ++lane)
      {
        ++((node.leafLanes >> lane & 1u) != 0 ? leaves : nodes);
      }
    }
  }
};

/// Calls visit(lane, isLeaf, index of the leaf or node) for each child.
template <class Visit>
void forEachChild(
  const WideBvhTopology& topology, const Firsts& firsts, std::size_t n, const Visit& visit)
{
  std::uint32_t node = firsts.firstNode[n];
  std::uint32_t leaf = firsts.firstLeaf[n];
  for (unsigned lane = 0; lane < topology.nodes[n].children; ++lane)
  {
    const bool isLeaf = (topology.nodes[n].leafLanes >> lane & 1u) != 0;
    visit(lane, isLeaf, isLeaf ? leaf++ : node++);
  }
}

/// The order with lanes named as they are now, those without a child last.
std::uint32_t renamed(std::uint32_t order, const std::array<int, wideArity>& nameOf, int used)
{
  std::uint32_t result = 0;
  int at = 0;
  for (int i = 0; i < wideArity; ++i, order >>= 4)
  {
    const int name = nameOf[order & 7u];
    if (name >= 0)
    {
      result |= static_cast<std::uint32_t>(name) << (4 * at++);
    }
  }
  for (int lane = used; lane < wideArity; ++lane)
  {
    result |= static_cast<std::uint32_t>(lane) << (4 * at++);
  }
  return result;
}

void putLeaves(const Surface& surface, const BvhLeaves& leaves,
  const std::vector<std::uint32_t>& firstBlock, LeafBlocks& blocks, BuildProgress& progress)
{
  std::vector<std::size_t> first(leaves.sizes.size(), 0);
  for (std::size_t i = 1; i < first.size(); ++i)
  {
    first[i] = first[i - 1] + leaves.sizes[i - 1];
  }
  progress.stage(0.98, leaves.sizes.size());
  std::visit(
    [&](auto& store)
    {
      store.resize(firstBlock.back());
      progress.forEach(leaves.sizes.size(), chunk,
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t i = begin; i < end; ++i)
          {
            store.put(firstBlock[i], surface, leaves.references.data() + first[i], leaves.sizes[i]);
          }
        });
    },
    blocks);
}

} // namespace

WideBvhNodes assembleWideBvh(
  const Surface& surface, WideBvhTopology&& topology, LeafBlocks& blocks, BuildProgress& progress)
{
  WideBvhNodes tree;
  keepHittable(surface, topology.leaves);
  if (topology.leaves.references.empty())
  {
    return tree;
  }
  fitBoxes(surface, topology.leaves, progress);
  tree.frame = frameOf(surface.bounds());
  const std::vector<std::uint32_t>& sizes = topology.leaves.sizes;
  std::vector<FrameBox> leafBoxes(sizes.size());
  std::vector<std::uint32_t> firstBlock(sizes.size() + 1, 0);
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    leafBoxes[i] = FrameBox(tree.frame, topology.leaves.boxes[i]);
    firstBlock[i + 1] = firstBlock[i] + (sizes[i] + blockWidth - 1) / blockWidth;
    if (sizes[i] > WideChild::maxCount)
    {
      tree.largeLeaves.emplace_back(firstBlock[i], sizes[i]);
    }
  }
  requireRoomFor(firstBlock.back());
  putLeaves(surface, topology.leaves, firstBlock, blocks, progress);

  const Firsts firsts(topology);
  std::vector<FrameBox> nodeBoxes(topology.nodes.size());
  for (std::size_t n = topology.nodes.size(); n-- > 0;)
  {
    forEachChild(topology, firsts, n,
      [&](unsigned, bool isLeaf, std::uint32_t child)
      { nodeBoxes[n].extend(isLeaf ? leafBoxes[child] : nodeBoxes[child]); });
  }
  std::vector<std::uint32_t> numberOf(topology.nodes.size(), 0);
  std::uint32_t nodeCount = 0;
  for (std::size_t n = 0; n < topology.nodes.size(); ++n)
  {
    numberOf[n] = nodeCount;
    nodeCount += nodeBoxes[n].empty() ? 0 : 1;
  }

  tree.nodes.reserve(nodeCount);
  tree.firstId.reserve(nodeCount);
  std::uint32_t nextId = 1;
  for (std::size_t n = 0; n < topology.nodes.size(); ++n)
  {
    if (nodeBoxes[n].empty())
    {
      continue;
    }
    WideBvhNode wide = emptyWideNode();
    std::array<int, wideArity> nameOf;
    nameOf.fill(-1);
    int used = 0;
    forEachChild(topology, firsts, n,
      [&](unsigned lane, bool isLeaf, std::uint32_t child)
      {
        const FrameBox& box = isLeaf ? leafBoxes[child] : nodeBoxes[child];
        if (box.empty())
        {
          return;
        }
        for (int k = 0; k < 6; ++k)
        {
          wide.planes[k][used] = box.planes[k];
        }
        wide.child[used] = (isLeaf ? WideChild::leaf(firstBlock[child], sizes[child])
                                   : WideChild::node(numberOf[child]))
                             .bits();
        nameOf[lane] = used++;
      });
    for (int octant = 0; octant < 8; ++octant)
    {
      wide.order[octant] = renamed(topology.nodes[n].order[octant], nameOf, used);
    }
    tree.nodes.push_back(wide);
    tree.firstId.push_back(nextId);
    nextId += static_cast<std::uint32_t>(used);
  }
  return tree;
}

} // namespace lumitree
