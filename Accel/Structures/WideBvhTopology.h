// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_WideBvhTopology_h
#define Lumitree_Accel_Structures_WideBvhTopology_h

#include "Accel/Kernel/LeafBlocks.h"
#include "Accel/Structures/BvhLeaves.h"
#include "Accel/Structures/WideBvhNodes.h"

#include <array>

namespace lumitree
{

/// A wide hierarchy without its boxes: what is saved, and what stays when points move.
struct WideBvhTopology
{
  struct Node
  {
    std::uint8_t children = 0;            ///< 1 … 8, in lanes 0, 1, …
    std::uint8_t leafLanes = 0;           ///< bit i: the child in lane i is a leaf
    std::array<std::uint32_t, 8> order{}; ///< of WideBvhNode
  };

  /// Node 0 is the root. Children that are nodes, and leaves, are numbered as they are met in the
  /// order of nodes and lanes; so nothing has to say which they are.
  std::vector<Node> nodes;
  BvhLeaves leaves;
};

/// Of a tree; with the boxes of its leaves if these matter.
[[nodiscard]] WideBvhTopology topologyOf(
  const WideBvhNodes& tree, const LeafBlocks& blocks, bool parts);

/// The tree over a surface: boxes around the primitives' coordinates, in a frame of the surface's,
/// rounded outward. Primitives that cannot be hit are left out, and so are nodes that hold nothing
/// then.
[[nodiscard]] WideBvhNodes assembleWideBvh(
  const Surface& surface, WideBvhTopology&& topology, LeafBlocks& blocks, BuildProgress& progress);

void saveTopology(const WideBvhTopology& topology, SaveWriter& writer);

/// Throws SaveError where it is no tree of at most 64 levels over all that can be hit.
[[nodiscard]] WideBvhTopology loadTopology(const Surface& surface, bool parts, SaveReader& reader);

} // namespace lumitree

#endif
