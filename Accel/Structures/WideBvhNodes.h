// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_WideBvhNodes_h
#define Lumitree_Accel_Structures_WideBvhNodes_h

#include "Accel/LargeMemory.h"
#include "Accel/Vec3.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace lumitree
{

inline constexpr int wideArity = 8;

/// The lanes as they stand, the order in which any hit is looked for: from the last to the first.
inline constexpr std::uint32_t laneOrder = 0x76543210;

/// A child of a wide node in 32 bits: the index of a node, or a leaf's first block and how many
/// primitives it has. What a walk keeps of a child that waits.
class WideChild
{
public:
  static constexpr std::uint32_t maxBlock = (1u << 27) - 1; ///< 28 GB of blocks of floats
  /// A leaf of more is marked, and its size stands in WideBvhNodes::largeLeaves.
  static constexpr std::uint32_t maxCount = 15;

  WideChild() = default;
  explicit WideChild(std::uint32_t bits)
    : bits_(bits)
  {
  }

  static WideChild node(std::uint32_t index) { return WideChild(index); }
  static WideChild leaf(std::uint32_t firstBlock, std::uint32_t count)
  {
    return WideChild(leafBit | (count <= maxCount ? count << 27 : 0u) | firstBlock);
  }

  [[nodiscard]] std::uint32_t bits() const { return this->bits_; }
  [[nodiscard]] bool isLeaf() const { return (this->bits_ & leafBit) != 0; }
  [[nodiscard]] std::uint32_t nodeIndex() const { return this->bits_; }
  [[nodiscard]] std::uint32_t firstBlock() const { return this->bits_ & maxBlock; }
  /// 0: a large leaf.
  [[nodiscard]] std::uint32_t count() const { return (this->bits_ >> 27) & maxCount; }

private:
  static constexpr std::uint32_t leafBit = 1u << 31;
  std::uint32_t bits_ = 0;
};

/// Up to eight children, their boxes side by side in float, relative to the tree's frame and
/// rounded outward. Lanes without a child have a box that no ray meets.
struct alignas(64) WideBvhNode
{
  float planes[6][wideArity];     ///< lower x, y, z, then upper x, y, z
  std::uint32_t child[wideArity]; ///< WideChild::bits
  /// For each octant of directions (bit k: component k is negative) the lanes from far to near, as
  /// the binary splits that the node was made of put them: the i-th is order >> 4 i & 7
  /// (Fuetterling et al. 2017, "Accelerated single ray tracing for wide vector units").
  std::uint32_t order[8];
};

/// Coordinates in the tree are (x - centre) * scale, scale a power of two: of magnitude 1 at most,
/// so that floats neither over- nor underflow whatever the scene's size, and as fine as floats are
/// wherever the scene lies.
struct WideBvhFrame
{
  Vec3 centre = { 0.0, 0.0, 0.0 };
  double scale = 1.0;
};

/// The tree as its walk needs it. Node 0 is the root; there is none over an empty surface.
struct WideBvhNodes
{
  WideBvhFrame frame;
  std::vector<WideBvhNode, LargeMemory<WideBvhNode>> nodes;
  /// Lanes are used from lane 0 on; the child in lane i of node n has number firstId[n] + i in the
  /// hierarchy view.
  std::vector<std::uint32_t> firstId;
  /// First block and primitives of each leaf of more than WideChild::maxCount, ascending.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> largeLeaves;

  [[nodiscard]] std::uint32_t countOf(WideChild leaf) const
  {
    return leaf.count() != 0 ? leaf.count()
                             : std::lower_bound(this->largeLeaves.begin(), this->largeLeaves.end(),
                                 std::pair<std::uint32_t, std::uint32_t>{ leaf.firstBlock(), 0 })
                                 ->second;
  }
};

} // namespace lumitree

#endif
