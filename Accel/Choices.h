// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Choices_h
#define Lumitree_Accel_Choices_h

#include "Accel/Export.h"

#include <optional>
#include <string_view>

/// The choices a caller makes by name. The values are part of the data model (they are stored in
/// state files and arrays): they are never renumbered, and a choice that a build lacks is reported,
/// not remapped.
namespace lumitree
{

/// How the surface is organised for rays.
enum class Structure : int
{
  Auto = 0,       ///< the cheapest that the scene needs
  BruteForce = 1, ///< every primitive, every ray: the oracle
  Bvh = 2,        ///< binary bounding volume hierarchy
  WideBvh = 3,    ///< eight-wide bounding volume hierarchy
  Grid = 4,       ///< uniform grid
  Octree = 5,
  KdTree = 6,
  BspTree = 7,
  Embree = 8,     ///< Intel Embree, a reference for speed
  Cgal = 9,       ///< CGAL's AABB tree with exact numbers (EPECK), the ground truth
  CgalEpick = 10, ///< CGAL's AABB tree with exact predicates on rounded rays (EPICK), compared with
  CgalCartesian = 11 ///< CGAL's AABB tree in doubles (Simple_cartesian), compared with
};
inline constexpr int structureCount = 12;

/// What is promised about the primitives hit and their order.
enum class Precision : int
{
  Fast = 0,       ///< floating point as it comes; may leak at edges and vertices
  Watertight = 1, ///< undecided counts as hit: nothing passes through a closed mesh
  Exact = 2       ///< what rational arithmetic on the stored numbers says
};
inline constexpr int precisionCount = 3;

/// How a bounding volume hierarchy is split.
enum class BvhBuild : int
{
  LongestAxisMedian = 0, ///< the textbook's: longest axis, object in the middle
  BinnedSah = 1,         ///< surface-area heuristic over bins (Wald 2007)
  SweepSah = 2,          ///< surface-area heuristic over every division of the sorted centres
  SpatialSplits = 3,     ///< as BinnedSah, and triangles are cut where it pays (Stich et al. 2009)
  Morton = 4 ///< linear: along the Morton curve (Lauterbach et al. 2009), the quickest to build
};
inline constexpr int bvhBuildCount = 5;

/// How a KD-tree is split.
enum class KdBuild : int
{
  SpatialMedian = 0, ///< the textbook's: longest axis of the cell, in the middle
  Sah =
    1 ///< surface-area heuristic over the bounds of what lies in the cell (Wald and Havran 2006)
};
inline constexpr int kdBuildCount = 2;

/// The question asked of each ray.
enum class QueryKind : int
{
  Closest = 0,
  Any = 1,
  All = 2,
  Count = 3,
  Crossings = 4, ///< passages through the surface: odd from inside a closed one
  Ties = 5       ///< every hit at the least t
};
inline constexpr int queryKindCount = 6;

/// Snake-case name ("brute_force"), as used in Python, on command lines and in messages.
///@{
[[nodiscard]] LUMITREE_ACCEL_EXPORT std::string_view name(Structure);
[[nodiscard]] LUMITREE_ACCEL_EXPORT std::string_view name(Precision);
[[nodiscard]] LUMITREE_ACCEL_EXPORT std::string_view name(BvhBuild);
[[nodiscard]] LUMITREE_ACCEL_EXPORT std::string_view name(KdBuild);
[[nodiscard]] LUMITREE_ACCEL_EXPORT std::string_view name(QueryKind);
///@}

/// The choice of that name, or nothing.
///@{
[[nodiscard]] LUMITREE_ACCEL_EXPORT std::optional<Structure> structureFromName(std::string_view);
[[nodiscard]] LUMITREE_ACCEL_EXPORT std::optional<Precision> precisionFromName(std::string_view);
///@}

} // namespace lumitree

#endif
