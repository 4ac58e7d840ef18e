// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiStatisticsTable.h"

#include "LumiRow.h"
#include "LumiVisitCosts.h"

#include <cstdint>
#include <limits>
#include <string_view>

namespace lumitree::filters
{

void makeStatisticsTable(const Accelerator& accelerator, const HierarchyView& view,
  const Visits& visits, bool measureOverlap, bool withRow, vtkTable* table)
{
  const Surface& surface = accelerator.surface();
  const BuildOptions& options = accelerator.options();
  const BuildStatistics& built = accelerator.statistics();
  const bool isHierarchyOfBoxes =
    options.structure == Structure::Bvh || options.structure == Structure::WideBvh;

  Row row(table, withRow);
  row.add("Structure", name(options.structure));
  row.add("BvhBuild", isHierarchyOfBoxes ? name(options.bvhBuild) : std::string_view());
  row.add("Primitives", std::uint64_t{ surface.size() });
  row.add("SkippedNonFinite", std::uint64_t{ surface.nonFiniteCount() });
  row.add("SkippedZeroArea", std::uint64_t{ surface.zeroAreaCount() });
  row.add("Nodes", std::uint64_t{ built.nodes });
  row.add("Leaves", std::uint64_t{ built.leaves });
  row.add("Depth", static_cast<std::uint64_t>(built.depth));
  row.add("References", std::uint64_t{ built.references });
  row.add("SahCost", built.sahCost);
  row.add("Duplication", built.duplication);
  row.add("MemoryBytes", std::uint64_t{ built.memory });
  row.add("BuildSeconds", built.buildSeconds);
  row.add("Rays", visits.rays);
  row.add("RayNodesEntered", visits.nodesEntered);
  row.add("RayPrimitivesTested", visits.primitivesTested);
  row.add("ObservedSahCost", observedCost(view, visits.perNode, visits.cellsStepped));
  row.add("EmptyLeaves", emptyLeaves(view));
  constexpr double notMeasured = std::numeric_limits<double>::quiet_NaN();
  row.add(
    "EndPointOverlap", measureOverlap && withRow ? overlapOf(accelerator, view) : notMeasured);
  row.add("Quadrics", std::uint64_t{ surface.quadricCount() });
  row.add("SkippedEmptyQuadrics", std::uint64_t{ surface.emptyQuadricCount() });
  row.add("Choice", std::string_view(built.choice));
  row.add("Origin", name(built.origin));
  row.add("SahCostBuilt", built.sahCostBuilt);
  row.add("UnvisitedLeaves", unvisitedLeaves(view, visits.perNode));
}

void makeCastTable(const Accelerator& accelerator, const Cast& cast, Precision precision,
  const HitTotals& totals, const CastSeconds& seconds, vtkTable* table)
{
  Row row(table, true);
  row.add("Structure", name(accelerator.options().structure));
  row.add("Precision", name(precision));
  row.add("Query", name(cast.query()));
  row.add("Rays", std::uint64_t{ cast.size() });
  row.add("InvalidRays", cast.report().invalidRays);
  row.add("RaysHit", totals.raysHit);
  row.add("Hits", totals.hits);
  row.add("ExactTests", cast.report().exactTests);
  row.add("ExactParameters", cast.report().exactParameters);
  row.add("SurfaceSeconds", seconds.surface);
  row.add("BuildSeconds", seconds.build);
  row.add("ReadSeconds", seconds.rays);
  row.add("CastSeconds", seconds.cast);
  row.add("OutputSeconds", seconds.output);
  const BuildStatistics& built = accelerator.statistics();
  row.add("Origin", name(built.origin));
  row.add("SahCost", built.sahCost);
  row.add("SahCostBuilt", built.sahCostBuilt);
}

} // namespace lumitree::filters
