// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Rays_LumiVisits_h
#define Lumitree_Filters_Rays_LumiVisits_h

#include "Accel/Accelerator.h"

#include "vtkMultiProcessController.h"

#include <cstdint>
#include <vector>

namespace lumitree::filters
{

/// What casting rays over a structure took.
struct Visits
{
  std::vector<std::uint64_t> perNode; ///< rays that entered each node of the hierarchy
  std::uint64_t rays = 0;
  std::uint64_t nodesEntered = 0; ///< nodes of a tree, or cells of a grid
  std::uint64_t cellsStepped = 0; ///< cells of a grid, empty ones included
  std::uint64_t primitivesTested = 0;
  std::uint64_t failures = 0; ///< ranks that could not cast their rays

  explicit Visits(std::size_t nodes)
    : perNode(nodes, 0)
  {
  }

  /// Casts rays and adds what it took. Throws what the accelerator throws.
  QueryReport cast(QueryKind query, const Accelerator& accelerator, const RayBatch& batch,
    const QueryOptions& options);

  /// The sums over all ranks, on every rank. Collective.
  void sumOverRanks(vtkMultiProcessController* controller);
};

} // namespace lumitree::filters

#endif
