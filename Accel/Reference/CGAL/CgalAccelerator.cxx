// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Accel/Reference/CGAL/CgalAccelerator.h"

#include "Accel/FloatEnvironment.h"
#include "Accel/Parallel.h"
#include "Accel/Reference/CGAL/CgalTree.h"

#include <algorithm>
#include <chrono>
#include <mutex>

namespace lumitree
{
namespace
{

constexpr std::size_t raysPerReport = 64;

/// One for the process: lazy numbers may share constants between trees.
std::mutex& cgalMutex()
{
  static std::mutex mutex;
  return mutex;
}

class CgalAccelerator final : public Accelerator
{
public:
  CgalAccelerator(std::shared_ptr<const Surface> surface, const BuildOptions& options,
    JobControl* control, Precision precision,
    std::unique_ptr<const CgalTree> (*makeTree)(const Surface&, BuildProgress&))
    : Accelerator(std::move(surface), options)
    , precision_(precision)
  {
    refuseBodies(this->surface(), "CGAL");
    const std::lock_guard<std::mutex> lock(cgalMutex());
    const FloatEnvironment environment;
    const auto start = std::chrono::steady_clock::now();
    BuildProgress progress(control, options.threads);
    this->tree_ = makeTree(this->surface(), progress);
    progress.stage(1.0, 0);
    progress.advance(1);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;

    this->statistics_.nodes = 1;
    this->statistics_.leaves = 1;
    this->statistics_.references = this->surface().hittable().size();
    this->statistics_.duplication = 1.0;
    this->statistics_.sahCost = this->hierarchy().nodes.front().cost;
    this->statistics_.memory = this->tree_->memory();
    this->statistics_.buildSeconds = elapsed.count();
  }

  ~CgalAccelerator() override
  {
    const std::lock_guard<std::mutex> lock(cgalMutex());
    this->tree_.reset();
  }

  [[nodiscard]] bool supports(Precision precision) const override
  {
    return precision == this->precision_;
  }

  QueryReport closest(const RayBatch& rays, Hit* hits, const QueryOptions& options) const override
  {
    std::fill_n(hits, rays.size, Hit{});
    return this->run(rays, options,
      [&](std::size_t i, const std::vector<Hit>& found)
      { hits[i] = found.empty() ? Hit{} : found.front(); });
  }

  QueryReport any(
    const RayBatch& rays, std::uint8_t* hit, const QueryOptions& options) const override
  {
    std::fill_n(hit, rays.size, std::uint8_t{ 0 });
    return this->run(rays, options,
      [&](std::size_t i, const std::vector<Hit>& found) { hit[i] = found.empty() ? 0 : 1; });
  }

  QueryReport all(const RayBatch& rays, AllHits& hits, const QueryOptions& options) const override
  {
    return this->lists(rays, hits, options, &CgalTree::all);
  }

  QueryReport ties(const RayBatch& rays, AllHits& hits, const QueryOptions& options) const override
  {
    return this->lists(rays, hits, options, &CgalTree::ties);
  }

  QueryReport count(
    const RayBatch& rays, std::uint32_t* counts, const QueryOptions& options) const override
  {
    std::fill_n(counts, rays.size, std::uint32_t{ 0 });
    return this->run(rays, options,
      [&](std::size_t i, const std::vector<Hit>& found)
      { counts[i] = static_cast<std::uint32_t>(found.size()); });
  }

  [[nodiscard]] HierarchyView hierarchy() const override
  {
    HierarchyView view;
    view.references = this->surface().hittable();
    HierarchyNode root;
    root.box = this->surface().bounds();
    root.leaf = true;
    root.referenceCount = static_cast<std::uint32_t>(view.references.size());
    root.cost = root.box.area() > 0.0 ? root.referenceCount : 0.0;
    view.nodes.push_back(root);
    return view;
  }

private:
  using Search = void (CgalTree::*)(
    const Ray&, const PrimitiveId*, const PrimitiveId*, std::vector<Hit>&) const;

  QueryReport lists(
    const RayBatch& rays, AllHits& hits, const QueryOptions& options, Search search) const
  {
    hits.offsets.assign(rays.size + 1, 0);
    hits.hits.clear();
    // Rays come in order, on one thread.
    const QueryReport report = this->run(
      rays, options,
      [&](std::size_t i, const std::vector<Hit>& found)
      {
        hits.offsets[i + 1] = found.size();
        hits.hits.insert(hits.hits.end(), found.begin(), found.end());
      },
      search);
    for (std::size_t i = 0; i < rays.size; ++i)
    {
      hits.offsets[i + 1] += hits.offsets[i];
    }
    return report;
  }

  template <class Answer>
  QueryReport run(const RayBatch& rays, const QueryOptions& options, const Answer& answer,
    Search search = &CgalTree::all) const
  {
    if (!this->supports(options.precision))
    {
      throw UnsupportedQuery("structure '" + std::string(name(this->options().structure)) +
        "' answers with precision '" + std::string(name(this->precision_)) + "' only, not '" +
        std::string(name(options.precision)) + "'");
    }
    if (options.roundedT && this->precision_ != Precision::Exact)
    {
      throw UnsupportedQuery("structure '" + std::string(name(this->options().structure)) +
        "' does not know t exactly, from which it is to be rounded");
    }
    const std::lock_guard<std::mutex> lock(cgalMutex());
    QueryReport report;
    std::vector<Hit> found;
    report.completed = parallelFor(rays.size, raysPerReport, 1, options.control,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          const Ray ray = rays[i];
          found.clear();
          if (isValid(ray))
          {
            this->trace(rays.skip, i, ray, found, search);
          }
          else
          {
            ++report.invalidRays;
          }
          answer(i, found);
        }
      });
    if (options.perRay)
    {
      std::fill_n(options.perRay, rays.size, RayCounters{});
    }
    return report;
  }

  void trace(const SkipSets& skip, std::size_t i, const Ray& ray, std::vector<Hit>& found,
    Search search) const
  {
    const PrimitiveId* first = nullptr;
    const PrimitiveId* last = nullptr;
    if (skip.offsets)
    {
      const std::size_t set = skip.setOfRay ? skip.setOfRay[i] : i;
      first = skip.primitives + skip.offsets[set];
      last = skip.primitives + skip.offsets[set + 1];
    }
    ((*this->tree_).*search)(ray, first, last, found);
  }

  Precision precision_;
  std::unique_ptr<const CgalTree> tree_;
};

} // namespace

std::shared_ptr<const Accelerator> buildCgal(
  std::shared_ptr<const Surface> surface, const BuildOptions& options, JobControl* control)
{
  return std::make_shared<CgalAccelerator>(
    std::move(surface), options, control, Precision::Exact, makeEpeckTree);
}

std::shared_ptr<const Accelerator> buildCgalEpick(
  std::shared_ptr<const Surface> surface, const BuildOptions& options, JobControl* control)
{
  return std::make_shared<CgalAccelerator>(
    std::move(surface), options, control, Precision::Fast, makeEpickTree);
}

std::shared_ptr<const Accelerator> buildCgalCartesian(
  std::shared_ptr<const Surface> surface, const BuildOptions& options, JobControl* control)
{
  return std::make_shared<CgalAccelerator>(
    std::move(surface), options, control, Precision::Fast, makeCartesianTree);
}

} // namespace lumitree
