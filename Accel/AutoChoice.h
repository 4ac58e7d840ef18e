// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_AutoChoice_h
#define Lumitree_Accel_AutoChoice_h

#include "Accel/BuildOptions.h"
#include "Accel/Export.h"
#include "Accel/Surface.h"

#include <string>
#include <vector>

namespace lumitree
{

/// What a scene is like, as far as the choice of a structure goes by it.
struct SceneMeasures
{
  std::size_t primitives = 0; ///< that can be hit
  /// Primitives whose boxes a random ray through the scene's box is expected to meet: the sum of
  /// the boxes' areas over that of the scene's.
  double depth = 0.0;
  /// The share of that sum which belongs to boxes more than a hundred times as large as the median
  /// box and nearly empty (the area of the box more than four times the triangle's).
  double largeEmpty = 0.0;
  double fill = 0.0;   ///< of 32³ cells, the share that holds a primitive's centre
  double aspect = 1.0; ///< longest over shortest side of the scene's box; infinity where it is flat
};

/// One way to answer and what it is expected to take on one thread.
struct AutoEstimate
{
  Structure structure = Structure::BruteForce;
  BvhBuild bvhBuild = BvhBuild::BinnedSah; ///< of hierarchies of boxes
  double buildSeconds = 0.0;
  double raySeconds = 0.0; ///< for all the rays
};

/// What Auto builds, and why.
struct AutoReport
{
  BuildOptions choice; ///< what was asked for, with structure and bvhBuild set
  SceneMeasures measures;
  double rays = 0.0;                   ///< that were reckoned with
  std::vector<AutoEstimate> estimates; ///< every alternative, the cheapest first
  std::string reason;                  ///< one line for people
};

/// What build does for Structure::Auto: of all structures of this process's own, the one that is
/// expected to cost the least, build and rays together, by a model calibrated once on the scenes of
/// Docs/benchmarks.md. Does not depend on the machine or on the number of threads.
[[nodiscard]] LUMITREE_ACCEL_EXPORT AutoReport chooseStructure(
  const Surface& surface, const BuildOptions& options = {});

} // namespace lumitree

#endif
