// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Hierarchy_h
#define Lumitree_Accel_Hierarchy_h

#include "Accel/Box.h"
#include "Accel/Export.h"
#include "Accel/Hit.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lumitree
{

/// A node as others see it. Nodes are listed so that a parent comes before its children; the root
/// is node 0. Visits (QueryOptions::perNode) use the same numbering.
struct HierarchyNode
{
  Box box;                  ///< the node's cell, or what bounds its polyhedron
  std::int64_t parent = -1; ///< -1 for the root
  std::int32_t depth = 0;
  bool leaf = false;
  std::int32_t splitAxis = -1; ///< 0, 1, 2, or -1 where no axis plane splits the node
  double splitPosition = 0.0;
  std::uint32_t firstReference =
    0; ///< leaves: its primitives are references[first … first + count - 1]
  std::uint32_t referenceCount =
    0;               ///< leaves: primitives held; interior nodes: those of all leaves below
  double cost = 0.0; ///< the node's share of the surface-area cost: area / area(root) times
                     ///< costOf; the sum over all nodes is BuildStatistics::sahCost
};

/// A convex polyhedron; faces are lists of its points, counter-clockwise seen from outside.
struct Polyhedron
{
  std::vector<Vec3> points;
  std::vector<std::vector<std::uint32_t>> faces;
};

/// Any structure, walked as a flat list of nodes.
struct HierarchyView
{
  std::vector<HierarchyNode> nodes;
  std::vector<PrimitiveId> references;
  std::array<int, 3> gridResolution = { 0, 0, 0 }; ///< cells of a grid along x, y, z; else 0
  /// One per node where cells are not boxes (BSP-trees), else none; without faces where there is no
  /// cell. Costs then go by their areas, relative to the root's.
  std::vector<Polyhedron> polyhedra;
  /// What a ray pays for an interior node that a plane across an axis splits, and for any other:
  /// the weights by which the structure's builder decides, in tests of a block of four primitives.
  ///@{
  double axisStepCost = 1.0;
  double stepCost = 1.0;
  ///@}
};

/// What a ray pays for the primitives of a leaf, by the surface-area heuristic of every builder:
/// they are tested in blocks of four, each a unit.
[[nodiscard]] constexpr double leafCost(std::size_t primitives)
{
  return static_cast<double>((primitives + 3) / 4);
}

/// What a ray pays that enters a node of the view: a leaf leafCost, an interior node a step. Of a
/// grid, which has no steps down, the root costs a step for each cell that a random ray goes
/// through, empty ones included: Σ area(cell) / area(root).
[[nodiscard]] LUMITREE_ACCEL_EXPORT double costOf(const HierarchyView& view, std::size_t node);

class Surface;
struct BuildStatistics;

/// Fills in each node's cost and each interior node's number of references from the leaves.
LUMITREE_ACCEL_EXPORT void completeHierarchy(HierarchyView& view);

/// References per primitive that can be hit; 1 where there is none.
[[nodiscard]] double duplicationOf(std::size_t references, const Surface& surface);

/// Nodes, leaves, depth, references, duplication and surface-area cost of a hierarchy over a
/// surface.
[[nodiscard]] BuildStatistics describe(const HierarchyView& view, const Surface& surface);

} // namespace lumitree

#endif
