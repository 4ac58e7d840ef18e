// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_OctreeBuilder_h
#define Lumitree_Accel_Structures_OctreeBuilder_h

#include "Accel/BuildOptions.h"
#include "Accel/BuildProgress.h"
#include "Accel/Surface.h"

#include <vector>

namespace lumitree
{

/// A node; octants without primitives are left out, so an interior node has one to eight children.
struct OctreeNode
{
  Box box;                 ///< the octant and a hair around it, inside the surface's bounds
  std::uint32_t first = 0; ///< interior: first child; leaf: first of its primitives in references
  std::uint32_t count = 0; ///< interior: number of children; leaf: number of primitives
  std::uint32_t parent = 0;
  bool leaf = true;
};

/// Nodes level by level: parents before their children.
struct OctreeNodes
{
  std::vector<OctreeNode> nodes;
  std::vector<PrimitiveId> references; ///< ascending within a leaf
};

inline constexpr int octreeDepthLimit = 21;

/// The octree of a surface. The root is a cube on the lower corner of the bounds. A primitive is in
/// every leaf that its surface meets. A node is split when it holds more than leafSize primitives
/// and
///   - lies above the depth limit: the smaller of maxDepth and 21;
///   - its children together hold at most 1.5 times its primitives. A random ray that meets a cube
///   meets a given octant
///     with probability 1/4 (by surface area), so beyond 4 times nothing is gained; measured with
///     leaves of four primitives to a block, 1.5 was fastest of 1.5, 2, 2.5 and 3 (teapot, city),
///     with a tenth of the memory of 3;
///     The root may have twice its primitives below: the planes through the middle of something
///     symmetric often touch a row of triangles each, which must not keep it whole;
///   - the whole tree then holds primitives at most 16 times on average (65536 references are
///   always allowed). Levels
///     are split one after the other, the shallow ones first.
[[nodiscard]] OctreeNodes buildOctreeNodes(
  const Surface& surface, const BuildOptions& options, BuildProgress& progress);

} // namespace lumitree

#endif
