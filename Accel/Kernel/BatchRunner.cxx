// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Kernel/BatchChunk.h"

#include "Accel/Kernel/Finish.h"
#include "Accel/Kernel/Queries.h"
#include "Accel/Parallel.h"

#include <mutex>

namespace lumitree
{
namespace
{

constexpr std::size_t raysPerChunk = 1024;

/// Rays that start in one point are looked at in larger chunks, which hold several rows of pixels;
/// of a small batch there should be enough chunks for all threads.
constexpr std::size_t raysPerPlan = 16384;
constexpr std::size_t leastPlans = 32;

} // namespace

BatchRunner::BatchRunner(const Surface& surface, const void* structure, StructureWalks walks,
  const void* blocks, std::size_t nodeCount, std::size_t memory)
  : surface_(surface)
  , structure_(structure)
  , walks_(walks)
  , blocks_(blocks)
  , nodeCount_(nodeCount)
  , memory_(memory)
{
}

BatchRunner::Course BatchRunner::courseOf(
  const RayBatch& rays, QueryKind query, const QueryOptions& options) const
{
  const bool inOrder = query == QueryKind::All || query == QueryKind::Ties;
  if (inOrder || options.perRay || options.perNode || options.perPrimitive)
  {
    return Course::AsTheyCome;
  }
  if (this->walks_.bundle && !options.roundedT &&
    (query == QueryKind::Closest || query == QueryKind::Any) && this->surface_.bodyCount() == 0 &&
    BundlePlan::mayPay(rays))
  {
    return Course::Together;
  }
  const std::size_t perThread = rays.size / static_cast<std::size_t>(concurrency(options.threads));
  return perThread >= OriginOrder::leastChunk &&
      OriginOrder::pays(rays, this->surface_.bounds(), this->memory_)
    ? Course::ByOrigin
    : Course::AsTheyCome;
}

std::size_t BatchRunner::chunkSize(
  Course course, const RayBatch& rays, const QueryOptions& options) const
{
  switch (course)
  {
    case Course::Together:
      return std::clamp(rays.size / leastPlans, raysPerChunk, raysPerPlan);
    case Course::ByOrigin:
    {
      const auto threads = static_cast<std::size_t>(concurrency(options.threads));
      return std::clamp(rays.size / (2 * threads), OriginOrder::leastChunk, OriginOrder::mostChunk);
    }
    default:
    {
      // Visits and tests are counted per chunk and then added, so chunks are large where there are
      // many nodes or primitives.
      const std::size_t counted = std::max(options.perNode ? this->nodeCount_ : 0,
        options.perPrimitive ? this->surface_.size() : std::size_t{ 0 });
      return std::max(raysPerChunk, counted / 4);
    }
  }
}

QueryReport BatchRunner::run(const RayBatch& rays, QueryKind query, const QueryOptions& options,
  const Clear& clear, const Body& body) const
{
  if (options.roundedT && options.precision != Precision::Exact)
  {
    throw UnsupportedQuery("t is rounded from its exact value, which precision '" +
      std::string(name(options.precision)) + "' does not know, only '" +
      std::string(name(Precision::Exact)) + "'");
  }
  const Course course = this->courseOf(rays, query, options);
  const std::size_t chunk = this->chunkSize(course, rays, options);
  QueryReport report;
  std::mutex mutex;
  std::vector<std::uint8_t> reached((rays.size + chunk - 1) / chunk, 0);
  report.completed = parallelFor(rays.size, chunk, options.threads, options.control,
    [&](std::size_t begin, std::size_t end)
    {
      reached[begin / chunk] = 1;
      clear(begin, end);
      Chunk work(*this, course, rays, query, options);
      body(begin, end, work);
      const std::lock_guard<std::mutex> lock(mutex);
      work.addTo(report);
    });
  for (std::size_t i = 0; i < reached.size(); ++i)
  {
    if (reached[i] == 0)
    {
      clear(i * chunk, std::min(rays.size, (i + 1) * chunk));
    }
  }
  return report;
}

QueryReport BatchRunner::closest(const RayBatch& rays, Hit* hits, const QueryOptions& options) const
{
  return this->run(
    rays, QueryKind::Closest, options,
    [&](std::size_t begin, std::size_t end) { std::fill(hits + begin, hits + end, Hit{}); },
    [&](std::size_t begin, std::size_t end, Chunk& work)
    {
      work.trace(begin, end, false,
        [&](std::size_t i, RayState& state)
        {
          if (state.best.primitive != noPrimitive)
          {
            hits[i] = finish(state, state.best, options);
            work.countHit(hits[i].primitive);
          }
        });
    });
}

QueryReport BatchRunner::any(
  const RayBatch& rays, std::uint8_t* hit, const QueryOptions& options) const
{
  return this->run(
    rays, QueryKind::Any, options,
    [&](std::size_t begin, std::size_t end)
    { std::fill(hit + begin, hit + end, std::uint8_t{ 0 }); },
    [&](std::size_t begin, std::size_t end, Chunk& work)
    {
      work.trace(begin, end, false,
        [&](std::size_t i, const RayState& state)
        {
          if (state.best.primitive != noPrimitive)
          {
            hit[i] = 1;
            work.countHit(state.best.primitive);
          }
        });
    });
}

QueryReport BatchRunner::count(
  const RayBatch& rays, std::uint32_t* counts, const QueryOptions& options) const
{
  return this->numbers(rays, QueryKind::Count, counts, options);
}

QueryReport BatchRunner::crossings(
  const RayBatch& rays, std::uint32_t* counts, const QueryOptions& options) const
{
  if (options.precision != Precision::Exact)
  {
    throw UnsupportedQuery("the query '" + std::string(name(QueryKind::Crossings)) +
      "' is answered with precision '" + std::string(name(Precision::Exact)) + "' only, not '" +
      std::string(name(options.precision)) + "'");
  }
  if (this->surface_.sampledCount() > 0)
  {
    throw UnsupportedQuery("the query '" + std::string(name(QueryKind::Crossings)) +
      "' counts passages through what is known everywhere; this surface has implicits that are "
      "only sampled: " +
      std::to_string(this->surface_.sampledCount()));
  }
  return this->numbers(rays, QueryKind::Crossings, counts, options);
}

QueryReport BatchRunner::numbers(
  const RayBatch& rays, QueryKind query, std::uint32_t* counts, const QueryOptions& options) const
{
  return this->run(
    rays, query, options,
    [&](std::size_t begin, std::size_t end)
    { std::fill(counts + begin, counts + end, std::uint32_t{ 0 }); },
    [&](std::size_t begin, std::size_t end, Chunk& work)
    {
      work.trace(begin, end, false,
        [&](std::size_t i, RayState& state)
        {
          dropDuplicates(state);
          counts[i] = static_cast<std::uint32_t>(state.found.size());
          for (const Candidate& c : state.found)
          {
            work.countHit(c.primitive);
          }
        });
    });
}

QueryReport BatchRunner::all(const RayBatch& rays, AllHits& out, const QueryOptions& options) const
{
  return this->lists(rays, QueryKind::All, out, options);
}

QueryReport BatchRunner::ties(const RayBatch& rays, AllHits& out, const QueryOptions& options) const
{
  return this->lists(rays, QueryKind::Ties, out, options);
}

QueryReport BatchRunner::lists(
  const RayBatch& rays, QueryKind query, AllHits& out, const QueryOptions& options) const
{
  // Each chunk keeps its hits until every ray's number of hits, and so its place, is known.
  struct Part
  {
    std::size_t firstRay;
    std::vector<Hit> hits;
  };
  std::vector<Part> parts;
  std::mutex mutex;
  out.offsets.assign(rays.size + 1, 0);
  const QueryReport report = this->run(
    rays, query, options, [](std::size_t, std::size_t) {},
    [&](std::size_t begin, std::size_t end, Chunk& work)
    {
      Part part{ begin, {} };
      work.trace(begin, end, true,
        [&](std::size_t i, RayState& state)
        {
          arrange(state, query, options.precision);
          out.offsets[i + 1] = state.found.size();
          const std::size_t before = part.hits.size();
          finish(state, query, options, part.hits);
          for (std::size_t h = before; h < part.hits.size(); ++h)
          {
            work.countHit(part.hits[h].primitive);
          }
        });
      const std::lock_guard<std::mutex> lock(mutex);
      parts.push_back(std::move(part));
    });
  for (std::size_t i = 0; i < rays.size; ++i)
  {
    out.offsets[i + 1] += out.offsets[i];
  }
  out.hits.resize(out.offsets.back());
  parallelFor(parts.size(), 1, options.threads, nullptr,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t p = begin; p < end; ++p)
      {
        std::copy(parts[p].hits.begin(), parts[p].hits.end(),
          out.hits.begin() + static_cast<std::ptrdiff_t>(out.offsets[parts[p].firstRay]));
      }
    });
  return report;
}

} // namespace lumitree
