// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiComparison.h"

#include "LumiDisagreement.h"
#include "LumiGather.h"
#include "LumiRow.h"
#include "LumiVisitCosts.h"

#include "Accel/Registry.h"

#include "vtkCommunicator.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace lumitree::filters
{
namespace
{

/// Two t are the same up to this part of the larger: a disagreement about primitives is none about
/// rounding.
constexpr double tolerance = 1e-6;

bool isReference(Structure structure)
{
  return structure == Structure::Embree || structure == Structure::Cgal ||
    structure == Structure::CgalEpick || structure == Structure::CgalCartesian;
}

double step(double from, double to, int steps, int i)
{
  return steps == 1 ? from : from * std::pow(to / from, static_cast<double>(i) / (steps - 1));
}

/// What sets a row apart, in words.
std::string ownParameters(const BuildOptions& options, const HierarchyView& view)
{
  switch (options.structure)
  {
    case Structure::Grid:
      return std::to_string(view.gridResolution[0]) + " x " +
        std::to_string(view.gridResolution[1]) + " x " + std::to_string(view.gridResolution[2]);
    case Structure::Bvh:
    case Structure::WideBvh:
      return std::string(name(options.bvhBuild)) + ", leaf size " +
        std::to_string(options.leafSize);
    case Structure::KdTree:
      return std::string(name(options.kdBuild)) + ", leaf size " + std::to_string(options.leafSize);
    case Structure::Octree:
    case Structure::BspTree:
      return "leaf size " + std::to_string(options.leafSize);
    default:
      return {};
  }
}

std::string parameters(const BuildOptions& options, const HierarchyView& view)
{
  const bool remembers = options.mailboxing &&
    (options.structure == Structure::Grid || options.structure == Structure::Octree ||
      options.structure == Structure::KdTree || options.structure == Structure::BspTree);
  return ownParameters(options, view) + (remembers ? ", mailboxing" : "");
}

double perRay(std::uint64_t value, const Trial& trial)
{
  return trial.rays > 0 ? static_cast<double>(value) / static_cast<double>(trial.rays)
                        : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

void Trial::joinRanks(vtkMultiProcessController* controller)
{
  if (!isDistributed(controller))
  {
    return;
  }
  std::uint64_t* const counts[] = { &this->rays, &this->nodes, &this->cells, &this->leaves,
    &this->tests, &this->hitRays, &this->disagreements };
  constexpr vtkIdType n = 7;
  vtkIdType mine[n];
  vtkIdType all[n];
  for (vtkIdType i = 0; i < n; ++i)
  {
    mine[i] = static_cast<vtkIdType>(*counts[i]);
  }
  controller->AllReduce(mine, all, n, vtkCommunicator::SUM_OP);
  for (vtkIdType i = 0; i < n; ++i)
  {
    *counts[i] = static_cast<std::uint64_t>(all[i]);
  }
  vtkNew<vtkIdTypeArray> entered;
  vtkNew<vtkIdTypeArray> sum;
  const auto nodeCount = static_cast<vtkIdType>(this->perNode.size());
  entered->SetNumberOfValues(nodeCount);
  sum->SetNumberOfValues(nodeCount);
  std::copy(this->perNode.begin(), this->perNode.end(), entered->GetPointer(0));
  controller->AllReduce(entered, sum, vtkCommunicator::SUM_OP);
  std::copy_n(sum->GetPointer(0), nodeCount, this->perNode.begin());
  const double seconds[2] = { this->castSeconds, this->buildSeconds };
  double slowest[2];
  controller->AllReduce(seconds, slowest, 2, vtkCommunicator::MAX_OP);
  this->castSeconds = slowest[0];
  this->buildSeconds = slowest[1];
}

std::vector<BuildOptions> gridSweep(const BuildOptions& options, double from, double to, int steps)
{
  BuildOptions grid = options;
  grid.structure = Structure::Grid;
  grid.gridResolution = { 1, 1, 1 };
  std::vector<BuildOptions> rows = { grid };
  grid.gridResolution = { 0, 0, 0 };
  for (int i = 0; i < steps; ++i)
  {
    grid.gridDensity = step(from, to, steps, i);
    rows.push_back(grid);
  }
  return rows;
}

std::vector<BuildOptions> leafSweep(const BuildOptions& options, double from, double to, int steps)
{
  BuildOptions tree = options;
  tree.structure = options.structure == Structure::Auto ? Structure::Bvh : options.structure;
  std::vector<BuildOptions> rows;
  for (int i = 0; i < steps; ++i)
  {
    tree.leafSize = std::max(1, static_cast<int>(std::lround(step(from, to, steps, i))));
    if (rows.empty() || rows.back().leafSize != tree.leafSize)
    {
      rows.push_back(tree);
    }
  }
  return rows;
}

std::vector<BuildOptions> everyStructure(
  const BuildOptions& options, bool bruteForce, bool references)
{
  std::vector<BuildOptions> rows;
  for (const Structure structure : Registry::instance().structures())
  {
    if (structure != Structure::Auto && (bruteForce || structure != Structure::BruteForce) &&
      (references || !isReference(structure)))
    {
      rows.push_back(options);
      rows.back().structure = structure;
    }
  }
  return rows;
}

std::optional<Trial> tryOut(const Accelerator& accelerator, QueryKind query, const RayBatch& rays,
  const QueryOptions& options, int repetitions, const Cast* truth)
{
  Trial trial;
  trial.rays = rays.size;
  trial.buildSeconds = accelerator.statistics().buildSeconds;
  trial.castSeconds = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repetitions; ++i)
  {
    const auto start = std::chrono::steady_clock::now();
    const Cast cast(query, accelerator, rays, options);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    trial.castSeconds = std::min(trial.castSeconds, elapsed.count());
    if (!cast.report().completed)
    {
      return std::nullopt;
    }
  }
  std::vector<RayCounters> counters(rays.size);
  QueryOptions counting = options;
  counting.perRay = counters.data();
  trial.perNode.resize(accelerator.statistics().nodes);
  counting.perNode = trial.perNode.data();
  const Cast cast(query, accelerator, rays, counting);
  if (!cast.report().completed)
  {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < rays.size; ++i)
  {
    trial.nodes += counters[i].nodes;
    trial.cells += counters[i].cells;
    trial.leaves += counters[i].leaves;
    trial.tests += counters[i].primitives;
    trial.hitRays += cast.count(i) > 0 ? 1 : 0;
    if (truth)
    {
      const auto differs = difference(cast, *truth, i, tolerance);
      trial.disagreements += differs && differs->kind != Disagreement::Tie ? 1 : 0;
    }
  }
  return trial;
}

void addComparison(const Accelerator& accelerator, const HierarchyView& view, const Trial& trial,
  const RowChoices& choices, vtkTable* table)
{
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const BuildOptions& options = accelerator.options();
  const BuildStatistics& built = accelerator.statistics();
  std::uint64_t cells = 0;
  if (view.gridResolution[0] > 0)
  {
    cells = 1;
    for (const int slabs : view.gridResolution)
    {
      cells *= static_cast<std::uint64_t>(slabs);
    }
  }
  Row row(table, choices.present);
  row.add("Structure", name(options.structure));
  row.add("Parameters", parameters(options, view));
  row.add("GridCells", cells);
  row.add("CellsPerPrimitive",
    cells > 0 ? static_cast<double>(cells) /
        static_cast<double>(std::max<std::size_t>(1, accelerator.surface().hittable().size()))
              : none);
  row.add("LeafSize", static_cast<std::uint64_t>(options.leafSize));
  row.add("BuildSeconds", trial.buildSeconds);
  row.add("MemoryBytes", std::uint64_t{ built.memory });
  row.add("Nodes", std::uint64_t{ built.nodes });
  row.add("Leaves", std::uint64_t{ built.leaves });
  row.add("Depth", static_cast<std::uint64_t>(built.depth));
  row.add("ReferencesPerPrimitive", built.duplication);
  row.add("SahCost", built.sahCost);
  row.add("Rays", trial.rays);
  row.add("HitRays", trial.hitRays);
  row.add("NodesPerRay", perRay(trial.nodes, trial));
  row.add("CellsPerRay", perRay(trial.cells, trial));
  row.add("LeavesPerRay", perRay(trial.leaves, trial));
  row.add("TestsPerRay", perRay(trial.tests, trial));
  row.add("CastSeconds", trial.castSeconds);
  row.add("RaysPerSecond",
    trial.castSeconds > 0 ? static_cast<double>(trial.rays) / trial.castSeconds : none);
  row.add("Disagreements", choices.compared ? static_cast<double>(trial.disagreements) : none);
  row.add("ObservedSahCost", observedCost(view, trial.perNode, trial.cells));
  row.add("EmptyLeaves", emptyLeaves(view));
  row.add("UnvisitedLeaves", unvisitedLeaves(view, trial.perNode));
  row.add("EndPointOverlap",
    !choices.measureOverlap || !choices.present ? none : overlapOf(accelerator, view));
}

} // namespace lumitree::filters
