// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Rays_LumiHierarchyBlocks_h
#define Lumitree_Filters_Rays_LumiHierarchyBlocks_h

#include "Accel/Hierarchy.h"

#include "vtkMultiBlockDataSet.h"

#include <cstdint>

namespace lumitree::filters
{

/// How nodes become cells.
enum class NodeShape : int
{
  Outlines = 0, ///< the edges: 12 lines of a box
  Cells = 1     ///< the faces: 6 quads of a box, convex polygons of a polyhedron
};

struct HierarchyOptions
{
  NodeShape shape = NodeShape::Outlines;
  int minimumLevel = 0;
  int maximumLevel = 0;
  std::int64_t maximumNodes =
    0;                      ///< levels that would exceed this sum are left out; so are the leaves
  bool leaves = false;      ///< a block with all leaves
  bool occupancy = false;   ///< of a grid, a last block with its cells as an image
  bool drawNothing = false; ///< the same blocks, all empty: rank 0 draws for all
  int threads = 0;
};

/// What was left out because of maximumNodes.
struct HierarchyReport
{
  int firstLevelLeftOut = -1; ///< -1 when none was
  bool leavesLeftOut = false;
};

/// The hierarchy as blocks (Docs/data-model.md): block i holds the nodes of depth i, null below
/// minimumLevel. Nodes with an empty box are not drawn. visits: one per node, or null when no rays
/// were cast.
HierarchyReport makeHierarchyBlocks(const HierarchyView& hierarchy, const std::uint64_t* visits,
  const HierarchyOptions& options, vtkMultiBlockDataSet* blocks);

} // namespace lumitree::filters

#endif
