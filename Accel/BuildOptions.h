// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_BuildOptions_h
#define Lumitree_Accel_BuildOptions_h

#include "Accel/Choices.h"
#include "Accel/Export.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace lumitree
{

struct JobControl;

/// How an accelerator is built. Two equal sets of options on one surface give the same structure.
struct BuildOptions
{
  Structure structure = Structure::Auto;
  BvhBuild bvhBuild = BvhBuild::BinnedSah;
  KdBuild kdBuild = KdBuild::Sah;
  int leafSize = 4;  ///< trees: split nodes with more primitives than this; 1…1024
  int maxDepth = 64; ///< trees: a node this deep becomes a leaf whatever it holds; 1…64
  /// Grid: cells per primitive when gridResolution is automatic; above 0, at most 1000. Textbooks
  /// advise up to 27; here four primitives of a cell are tested at once, and from 0.25 to 54 on the
  /// teapot and the city 0.25 … 0.5 was fastest.
  double gridDensity = 0.5;
  std::array<int, 3> gridResolution = { 0, 0,
    0 }; ///< grid: cells along x, y, z, each 1…2^20; all 0: automatic
  /// Grid, octree, KD- and BSP-tree: rays remember the primitives they were tested against of late,
  /// and leave out blocks that hold no others. Answers are the same, tests are fewer (by 1 … 50 %).
  /// As four primitives are tested at once, it rarely pays: rays were a fifth quicker in a KD-tree
  /// of the stadium, and 6 … 18 % slower on the torus.
  bool mailboxing = false;
  bool embreeRobust =
    true; ///< Embree: its robust flag, which closes edges; it still leaks at vertices
  /// Auto: rays that will be cast at the structure over its life; 0: not known, ten per primitive
  /// and a million at least are reckoned with. Of no consequence, and not compared, elsewhere.
  double expectedRays = 0.0;
  /// Threads to build with; 0: as many as oneTBB gives. What is built does not depend on it, and
  /// options that differ in it only are equal.
  int threads = 0;

  friend bool operator==(const BuildOptions& a, const BuildOptions& b)
  {
    return a.structure == b.structure && a.bvhBuild == b.bvhBuild && a.kdBuild == b.kdBuild &&
      a.leafSize == b.leafSize && a.maxDepth == b.maxDepth && a.gridDensity == b.gridDensity &&
      a.gridResolution == b.gridResolution && a.embreeRobust == b.embreeRobust &&
      a.mailboxing == b.mailboxing &&
      (a.structure != Structure::Auto || a.expectedRays == b.expectedRays);
  }
};

/// Throws std::invalid_argument for options out of range.
LUMITREE_ACCEL_EXPORT void requireValid(const BuildOptions& options);

/// How an accelerator came about.
enum class Origin : int
{
  Built = 0,
  Refitted = 1, ///< the nodes of another one, with boxes for points that moved
  Loaded = 2    ///< from a file
};

/// "built", "refitted", "loaded".
[[nodiscard]] LUMITREE_ACCEL_EXPORT std::string_view name(Origin origin);

/// What building took and what came of it.
struct BuildStatistics
{
  Origin origin = Origin::Built;
  std::size_t nodes = 0; ///< interior nodes and leaves
  std::size_t leaves = 0;
  int depth = 0; ///< of the deepest leaf; the root has depth 0
  /// Expected cost of a random ray that meets the root and is stopped by nothing, by the
  /// surface-area heuristic: (Σ area(n) c(n)) / area(root), in tests of a block of four primitives.
  /// c is what builders minimise: ⌈primitives / 4⌉ for a leaf; for an interior node 1 in Bvh,
  /// WideBvh and Octree, 2 in a KdTree, in a BspTree 0.75 across an axis and 1 for other planes; of
  /// a Grid 1 for each cell on the way, empty blocks not skipped.
  double sahCost = 0.0;
  /// What sahCost was when the nodes were built, before any refit: how much worse rays fare since.
  double sahCostBuilt = 0.0;
  std::size_t references = 0; ///< primitives counted once per leaf that holds them
  double duplication =
    0.0; ///< references / primitives that can be hit; 1 where nothing is held twice
  std::size_t memory = 0;    ///< bytes of the structure, the surface not included
  double buildSeconds = 0.0; ///< to build, refit or load it
  std::string choice;        ///< why Auto chose the structure; empty where it was asked for by name
};

} // namespace lumitree

#endif
