// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiCache.h"

#include "LumiGather.h"
#include "LumiLeaves.h"
#include "LumiQuadrics.h"
#include "LumiReplicate.h"
#include "LumiReport.h"
#include "LumiSharedSurface.h"
#include "LumiStopwatch.h"

#include "vtkAlgorithm.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <string>

namespace lumitree::filters
{
namespace
{

/// A surface as the cache remembers it. On several ranks the same local geometry can be part of
/// different surfaces, so each gathering has a number, the same on all ranks.
struct Entry
{
  GeometryKey key;
  std::weak_ptr<SharedSurface> surface;
  long long gathering = 0;
};

struct Found
{
  std::shared_ptr<SharedSurface> surface;
  long long gathering = 0;
};

class Cache
{
public:
  static Cache& instance()
  {
    static Cache cache;
    return cache;
  }

  Found find(const GeometryKey& key)
  {
    const std::lock_guard<std::mutex> lock(this->mutex_);
    for (const Entry& entry : this->entries_)
    {
      if (entry.key == key)
      {
        if (std::shared_ptr<SharedSurface> surface = entry.surface.lock())
        {
          return { surface, entry.gathering };
        }
      }
    }
    return {};
  }

  /// Remembers a surface and returns the one to use: with `gathering` 0 one that another thread was
  /// faster with stays, so that there is one; a new gathering takes the place of an older one.
  std::shared_ptr<SharedSurface> remember(
    const GeometryKey& key, std::shared_ptr<SharedSurface> surface, long long gathering)
  {
    const std::lock_guard<std::mutex> lock(this->mutex_);
    std::shared_ptr<SharedSurface> faster;
    const auto obsolete = [&](const Entry& entry)
    {
      if (entry.key == key && gathering == 0)
      {
        faster = entry.surface.lock();
        return !faster;
      }
      return entry.key == key || entry.surface.expired();
    };
    this->entries_.erase(
      std::remove_if(this->entries_.begin(), this->entries_.end(), obsolete), this->entries_.end());
    if (faster)
    {
      return faster;
    }
    this->entries_.push_back({ key, surface, gathering });
    return surface;
  }

  /// The number of the next gathering, agreed upon by all ranks.
  long long nextGathering(vtkMultiProcessController* controller)
  {
    const long long next = largestOfAll(controller, this->lastGathering_.load()) + 1;
    this->lastGathering_.store(next);
    return next;
  }

private:
  std::mutex mutex_;
  std::vector<Entry> entries_;
  std::atomic<long long> lastGathering_{ 0 };
};

std::vector<SurfacePart> convert(const std::vector<InputLeaf>& leaves, int threads)
{
  std::vector<SurfacePart> parts;
  for (const InputLeaf& leaf : leaves)
  {
    parts.emplace_back();
    parts.back().triangles = trianglesOf(leaf.data, threads);
    parts.back().leaf.compositeIndex = leaf.compositeIndex;
  }
  return parts;
}

/// A shared surface, with the current datasets of its leaves where it was not gathered.
struct Located
{
  std::shared_ptr<SharedSurface> surface;
  std::vector<vtkSmartPointer<vtkDataSet>> leaves;
};

/// A surface numbers its quadrics after its triangles, and its implicits last.
std::vector<InputLeaf> sortedLeavesOf(vtkDataObject* input)
{
  std::vector<InputLeaf> leaves = leavesOf(input);
  const auto kind = [](const InputLeaf& leaf)
  { return holdsImplicit(leaf.data) ? 2 : (holdsQuadrics(leaf.data) ? 1 : 0); };
  std::stable_sort(leaves.begin(), leaves.end(),
    [&](const InputLeaf& a, const InputLeaf& b) { return kind(a) < kind(b); });
  return leaves;
}

Located locateHere(vtkDataObject* input, int threads)
{
  const std::vector<InputLeaf> leaves = sortedLeavesOf(input);
  const GeometryKey key = keyOf(leaves);
  Located located;
  located.surface = Cache::instance().find(key).surface;
  if (!located.surface)
  {
    located.surface = Cache::instance().remember(
      key, std::make_shared<SharedSurface>(convert(leaves, threads), false, threads), 0);
  }
  for (const InputLeaf& leaf : leaves)
  {
    const auto copy = vtkSmartPointer<vtkDataSet>::Take(leaf.data->NewInstance());
    copy->ShallowCopy(leaf.data);
    located.leaves.push_back(copy);
  }
  return located;
}

/// Throws on every rank if any rank has something to say, so that none goes on alone.
void agree(vtkMultiProcessController* controller, const std::string& problem)
{
  if (largestOfAll(controller, !problem.empty()) != 0)
  {
    throw std::runtime_error(problem.empty() ? "the input of another rank is bad" : problem);
  }
}

/// Runs a step that is not collective and agrees with the other ranks on how it went.
template <class Step>
void together(vtkMultiProcessController* controller, Step&& step)
{
  std::string problem;
  try
  {
    step();
  }
  catch (const std::exception& error)
  {
    problem = error.what();
  }
  agree(controller, problem);
}

Located locateEverywhere(
  vtkDataObject* input, vtkMultiProcessController* controller, GatherArrays arrays, int threads)
{
  std::vector<InputLeaf> leaves;
  GeometryKey key;
  together(controller,
    [&]
    {
      leaves = sortedLeavesOf(input);
      key = keyOf(leaves);
      key.push_back(reinterpret_cast<std::uintptr_t>(controller));
      if (arrays == GatherArrays::Yes)
      {
        // Gathered arrays are copies: they are as good as the day they were sent.
        for (const InputLeaf& leaf : leaves)
        {
          key.push_back(leaf.data->GetMTime());
        }
      }
      key.push_back(static_cast<std::uint64_t>(arrays));
    });

  // All ranks must have the same gathering at hand; if one has not, all gather anew.
  const Found found = Cache::instance().find(key);
  const long long newest = largestOfAll(controller, found.gathering);
  const long long oldest = -largestOfAll(controller, -found.gathering);
  if (newest == oldest && newest != 0)
  {
    return { found.surface, {} };
  }

  std::vector<vtkSmartPointer<vtkDataObject>> mine;
  together(controller,
    [&]
    {
      for (const InputLeaf& leaf : leaves)
      {
        mine.push_back(pack(trianglesOf(leaf.data, threads), leaf.data, leaf.compositeIndex,
          arrays == GatherArrays::Yes));
      }
    });
  std::vector<SurfacePart> parts;
  const vtkNew<vtkPolyData> prototype;
  const std::vector<GatheredObject> all = gatherObjects(controller, mine, prototype);
  std::shared_ptr<SharedSurface> surface;
  together(controller,
    [&]
    {
      for (const GatheredObject& one : all)
      {
        parts.push_back(unpack(vtkPolyData::SafeDownCast(one.object), one.process));
      }
      const auto kind = [](const SurfacePart& part) {
        return !part.triangles.implicits.empty() ? 2 : (!part.triangles.quadrics.empty() ? 1 : 0);
      };
      std::stable_sort(parts.begin(), parts.end(),
        [&](const SurfacePart& a, const SurfacePart& b) { return kind(a) < kind(b); });
      surface = std::make_shared<SharedSurface>(std::move(parts), true, threads);
    });
  const long long gathering = Cache::instance().nextGathering(controller);
  return { Cache::instance().remember(key, surface, gathering), {} };
}

Located locate(
  vtkDataObject* input, vtkMultiProcessController* controller, GatherArrays arrays, int threads)
{
  return isDistributed(controller) ? locateEverywhere(input, controller, arrays, threads)
                                   : locateHere(input, threads);
}

TreeReuse reuseOf(const TreeSource& source, vtkMultiProcessController* controller)
{
  TreeReuse reuse;
  reuse.refit = source.refit;
  if (source.before)
  {
    reuse.before = source.before->accelerator;
    reuse.beforeAsked = source.before->asked;
    reuse.beforeFile = source.before->file;
  }
  reuse.refitLimit = source.refitLimit;
  reuse.file = source.file;
  reuse.fileUse = static_cast<TreeReuse::File>(source.fileUse);
  reuse.mayWrite = !isDistributed(controller) || controller->GetLocalProcessId() == 0;
  return reuse;
}

/// The accelerator, or null where the build was stopped.
std::shared_ptr<const Accelerator> unlessStopped(
  SharedSurface& surface, const BuildOptions& options, JobControl* control, const TreeReuse& reuse)
{
  try
  {
    return surface.accelerator(options, control, reuse);
  }
  catch (const BuildStopped&)
  {
    return nullptr;
  }
}

} // namespace

std::shared_ptr<const SurfaceInput> surfaceFor(vtkDataObject* input,
  vtkMultiProcessController* controller, vtkAlgorithm* reporter, GatherArrays arrays, int threads)
{
  try
  {
    const Located located = locate(input, controller, arrays, threads);
    return located.surface->input(located.leaves);
  }
  catch (const std::exception& error)
  {
    reportError(reporter, std::string("The surface cannot be used: ") + error.what());
    return nullptr;
  }
}

std::shared_ptr<const Tree> treeFor(vtkDataObject* input, const BuildOptions& options,
  vtkMultiProcessController* controller, vtkAlgorithm* reporter, GatherArrays arrays,
  JobControl* control, const TreeSource& source)
{
  auto tree = std::make_shared<Tree>();
  Stopwatch stopwatch;
  Located located;
  try
  {
    located = locate(input, controller, arrays, options.threads);
    tree->surfaceSeconds = stopwatch.lap();
  }
  catch (const std::exception& error)
  {
    reportError(reporter, std::string("The surface cannot be used: ") + error.what());
    return nullptr;
  }
  try
  {
    tree->asked = options;
    tree->file = source.file;
    const TreeReuse reuse = reuseOf(source, controller);
    const auto make = [&]
    { tree->accelerator = unlessStopped(*located.surface, options, control, reuse); };
    if (isDistributed(controller))
    {
      together(controller, make); // a file may be there for some ranks only
    }
    else
    {
      make();
    }
    // Stopped on one rank, all ranks go without, so that none waits for another.
    const bool stopped = !tree->accelerator;
    if (isDistributed(controller) ? largestOfAll(controller, stopped) != 0 : stopped)
    {
      return nullptr;
    }
    tree->input = located.surface->input(located.leaves);
    tree->buildSeconds = stopwatch.lap();
    return tree;
  }
  catch (const std::exception& error)
  {
    reportError(
      reporter, std::string("The acceleration structure cannot be built: ") + error.what());
    return nullptr;
  }
}

std::uint64_t treeBuilds()
{
  return acceleratorsBuilt();
}

} // namespace lumitree::filters
