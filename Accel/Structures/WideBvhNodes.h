// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_WideBvhNodes_h
#define Lumitree_Accel_Structures_WideBvhNodes_h

#include "Accel/Vec3.h"

#include <cstdint>
#include <vector>

namespace lumitree
{

inline constexpr int wideArity = 8;

/// Up to eight children, their boxes side by side in float, relative to the tree's frame and
/// rounded outward. A child with count 0 is the node child; one with primitives is the leaf whose
/// first block is child. Lanes without a child have a box that no ray meets.
struct alignas(64) WideBvhNode
{
  float planes[6][wideArity]; ///< lower x, y, z, then upper x, y, z
  std::uint32_t child[wideArity];
  std::uint32_t count[wideArity];
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
  std::vector<WideBvhNode> nodes;
  /// Lanes are used from lane 0 on; the child in lane i of node n has number firstId[n] + i in the
  /// hierarchy view.
  std::vector<std::uint32_t> firstId;
};

} // namespace lumitree

#endif
