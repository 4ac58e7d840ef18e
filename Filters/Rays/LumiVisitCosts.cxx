// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiVisitCosts.h"

#include "Accel/EndPointOverlap.h"

#include <limits>

namespace lumitree::filters
{

double observedCost(
  const HierarchyView& view, const std::vector<std::uint64_t>& perNode, std::uint64_t cellsStepped)
{
  if (view.nodes.empty() || perNode[0] == 0)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const bool isGrid = view.gridResolution[0] > 0;
  double paid = isGrid ? view.stepCost * static_cast<double>(cellsStepped) : 0.0;
  for (std::size_t i = 0; i < view.nodes.size(); ++i)
  {
    if (view.nodes[i].leaf || !isGrid)
    {
      paid += static_cast<double>(perNode[i]) * costOf(view, i);
    }
  }
  return paid / static_cast<double>(perNode[0]);
}

std::uint64_t emptyLeaves(const HierarchyView& view)
{
  std::uint64_t empty = 0;
  std::uint64_t occupied = 0;
  for (const HierarchyNode& node : view.nodes)
  {
    occupied += node.leaf && node.referenceCount > 0 ? 1 : 0;
    empty += node.leaf && node.referenceCount == 0 ? 1 : 0;
  }
  const auto& cells = view.gridResolution; // a grid's view has no nodes for its empty cells
  const std::uint64_t all =
    std::uint64_t(cells[0]) * std::uint64_t(cells[1]) * std::uint64_t(cells[2]);
  return all > 0 ? all - occupied : empty;
}

std::uint64_t unvisitedLeaves(const HierarchyView& view, const std::vector<std::uint64_t>& perNode)
{
  std::uint64_t unvisited = 0;
  for (std::size_t i = 0; i < view.nodes.size() && perNode[0] > 0; ++i)
  {
    const HierarchyNode& node = view.nodes[i];
    unvisited += node.leaf && node.referenceCount > 0 && perNode[i] == 0 ? 1 : 0;
  }
  return unvisited;
}

double overlapOf(const Accelerator& accelerator, const HierarchyView& view)
{
  const Structure structure = accelerator.options().structure;
  return structure == Structure::Bvh || structure == Structure::WideBvh
    ? endPointOverlap(view, accelerator.surface())
    : 0.0;
}

} // namespace lumitree::filters
