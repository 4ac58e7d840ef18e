// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Rays_LumiComparison_h
#define Lumitree_Filters_Rays_LumiComparison_h

#include "LumiCast.h"

#include "Accel/Accelerator.h"

#include "vtkMultiProcessController.h"
#include "vtkTable.h"

#include <optional>
#include <vector>

namespace lumitree::filters
{

/// What casting rays at one structure took.
struct Trial
{
  std::uint64_t rays = 0;
  std::uint64_t nodes = 0;
  std::uint64_t cells = 0;
  std::uint64_t leaves = 0;
  std::uint64_t tests = 0;
  std::uint64_t hitRays = 0;
  std::uint64_t disagreements = 0;
  std::vector<std::uint64_t> perNode; ///< rays that entered each node of the hierarchy
  double castSeconds = 0.0;
  double buildSeconds = 0.0;

  /// Sums, and the seconds of the slowest, over all ranks. Collective.
  void joinRanks(vtkMultiProcessController* controller);
};

/// The options of each row of a sweep over the densities of a grid: one cell, then so many steps.
[[nodiscard]] std::vector<BuildOptions> gridSweep(
  const BuildOptions& options, double from, double to, int steps);

/// The options of each row of a sweep over leaf sizes, each once.
[[nodiscard]] std::vector<BuildOptions> leafSweep(
  const BuildOptions& options, double from, double to, int steps);

/// The options of each structure of the registry.
[[nodiscard]] std::vector<BuildOptions> everyStructure(
  const BuildOptions& options, bool bruteForce, bool references);

/// Casts the rays once with counters and then for the time. truth: what the answers are compared
/// with, or null. Nothing when stopped. Throws what the accelerator throws.
[[nodiscard]] std::optional<Trial> tryOut(const Accelerator& accelerator, QueryKind query,
  const RayBatch& rays, const QueryOptions& options, int repetitions, const Cast* truth);

/// What a row tells beside a trial.
struct RowChoices
{
  bool compared = false;       ///< with the truth
  bool measureOverlap = false; ///< of hierarchies of boxes, which takes time
  bool present = true;         ///< else the columns only
};

/// Adds a row of the output of vtkLumiStructureComparison (Docs/data-model.md).
void addComparison(const Accelerator& accelerator, const HierarchyView& view, const Trial& trial,
  const RowChoices& choices, vtkTable* table);

} // namespace lumitree::filters

#endif
