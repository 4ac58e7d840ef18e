// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/WideBvhFill.h"

#include "Accel/Structures/WideBvhCollapse.h"

#include <algorithm>

namespace lumitree
{
namespace
{

WideBvhFrame frameOf(const Box& bounds)
{
  WideBvhFrame frame;
  frame.centre = bounds.centre();
  const Vec3 size = bounds.size();
  int exponent = 0;
  std::frexp(std::max({ size[0], size[1], size[2] }), &exponent);
  frame.scale = std::ldexp(1.0, std::clamp(1 - exponent, -1000, 1000));
  return frame;
}

/// In the frame, rounded outward: the subtraction rounds to 2^-53 of the result, the conversion to
/// 2^-24.
///@{
float roundedDown(double x, double centre, double scale)
{
  const double v = (x - centre) * scale;
  return static_cast<float>(v - (std::fabs(v) * 0x1p-23 + 0x1p-120));
}

float roundedUp(double x, double centre, double scale)
{
  const double v = (x - centre) * scale;
  return static_cast<float>(v + (std::fabs(v) * 0x1p-23 + 0x1p-120));
}
///@}

WideBvhNode emptyNode()
{
  WideBvhNode node{};
  for (int k = 0; k < 3; ++k)
  {
    std::fill_n(node.planes[k], wideArity, std::numeric_limits<float>::infinity());
    std::fill_n(node.planes[k + 3], wideArity, -std::numeric_limits<float>::infinity());
  }
  return node;
}

/// A stretch of a tree's references.
struct Range
{
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// The references below each binary node: those of its leaves, which lie side by side.
std::vector<Range> rangesOf(const BvhNodes& bvh)
{
  std::vector<Range> ranges(bvh.nodes.size());
  for (std::size_t i = bvh.nodes.size(); i-- > 0;)
  {
    const BvhNode& node = bvh.nodes[i];
    ranges[i] = node.leaf
      ? Range{ node.first, node.count }
      : Range{ ranges[node.first].first, ranges[node.first].count + ranges[node.first + 1].count };
  }
  return ranges;
}

template <class T>
std::uint32_t appendLeaf(
  const Surface& surface, const BvhNodes& bvh, const Range& range, TriangleBlocks<T>& store)
{
  // Ascending, so that a leaf does not depend on how its node came about.
  std::vector<PrimitiveId> ids(
    bvh.references.begin() + range.first, bvh.references.begin() + range.first + range.count);
  std::sort(ids.begin(), ids.end());
  return store.append(surface, ids.data(), ids.size());
}

} // namespace

WideBvhNodes fillWideBvh(const Surface& surface, const BvhNodes& binary, int leafSize,
  LeafBlocks& blocks, BuildProgress& progress)
{
  const std::vector<CollapsedNode> kept = collapse(binary, leafSize);
  const std::vector<Range> ranges = rangesOf(binary);
  progress.stage(0.99, binary.references.size());
  std::vector<std::uint32_t> nodeOf(kept.size());
  std::uint32_t nodeCount = 0;
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    nodeOf[i] = kept[i].leaf ? 0 : nodeCount++;
  }

  WideBvhNodes tree;
  tree.frame = frameOf(surface.bounds());
  tree.nodes.reserve(nodeCount);
  tree.firstId.reserve(nodeCount);
  for (const CollapsedNode& node : kept)
  {
    if (node.leaf)
    {
      continue;
    }
    WideBvhNode wide = emptyNode();
    for (std::uint32_t lane = 0; lane < node.childCount; ++lane)
    {
      const CollapsedNode& child = kept[node.firstChild + lane];
      const Box& box = binary.nodes[child.binary].box;
      for (int k = 0; k < 3; ++k)
      {
        wide.planes[k][lane] = roundedDown(box.lower[k], tree.frame.centre[k], tree.frame.scale);
        wide.planes[k + 3][lane] = roundedUp(box.upper[k], tree.frame.centre[k], tree.frame.scale);
      }
      wide.child[lane] = nodeOf[node.firstChild + lane];
      if (child.leaf)
      {
        const Range& range = ranges[child.binary];
        wide.count[lane] = range.count;
        progress.advance(range.count);
        wide.child[lane] = std::visit(
          [&](auto& store) { return appendLeaf(surface, binary, range, store); }, blocks);
      }
    }
    tree.nodes.push_back(wide);
    tree.firstId.push_back(node.firstChild);
  }
  return tree;
}

} // namespace lumitree
