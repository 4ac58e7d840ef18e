// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Kernel/BatchRunner.h"

#include "Accel/Kernel/BundlePlan.h"
#include "Accel/Kernel/Finish.h"
#include "Accel/Kernel/Queries.h"
#include "Accel/Kernel/Settle.h"
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

/// What one chunk of rays needs; totals are added to the report when it ends.
class BatchRunner::Chunk
{
public:
  Chunk(
    const BatchRunner& runner, const RayBatch& rays, QueryKind query, const QueryOptions& options)
    : runner_(runner)
    , rays_(rays)
    , query_(query)
    , options_(options)
    , states_(mostTravellers, RayState(runner.surface_))
  {
    const ArrayView::Scalar scalar = runner.surface_.scalar();
    for (RayState& state : this->states_)
    {
      state.settle = settleFunction(options.precision, query, runner.surface_.bodyCount() > 0);
      state.anyHit = query == QueryKind::Any;
    }
    this->leafKernel_ = leafKernel(scalar);
    if (runner.walks_.kernel)
    {
      this->rayKernel_ = runner.walks_.kernel(scalar);
    }
    if (runner.goTogether(rays, query, options))
    {
      this->bundleKernel_ = runner.walks_.bundle(scalar);
    }
    if (options.perNode)
    {
      this->visits_.resize(runner.nodeCount_);
      this->counts_.perNode = this->visits_.data();
    }
    if (options.perPrimitive)
    {
      this->tests_.resize(runner.surface_.size());
      this->counts_.perPrimitive = this->tests_.data();
      this->counts_.addTests = primitiveTests(scalar);
    }
  }

  /// Traces rays [begin, end) and calls answer(i, state) for each that is valid, in this order if
  /// it matters.
  template <class Answer>
  void trace(std::size_t begin, std::size_t end, bool inOrder, Answer answer)
  {
    if (this->bundleKernel_)
    {
      BundlePlan plan;
      plan.make(this->rays_, begin, end);
      this->traceTogether(plan, answer);
      Queue<Answer> queue{ *this, 0, plan.alone().size(), plan.alone().data(), answer };
      this->rayKernel_(this->runner_.structure_, this->runner_.blocks_, this->states_.data(),
        mostTravellers, queue.feed());
      return;
    }
    Queue<Answer> queue{ *this, begin, end, nullptr, answer };
    const bool counting =
      this->options_.perRay || this->options_.perNode || this->options_.perPrimitive;
    if (this->rayKernel_ && !counting)
    {
      this->rayKernel_(this->runner_.structure_, this->runner_.blocks_, this->states_.data(),
        inOrder ? 1 : mostTravellers, queue.feed());
      return;
    }
    RayState& state = this->states_.front();
    while (queue.next(state))
    {
      if (counting)
      {
        RayCounters counters;
        CountingVisitor visitor(
          state, this->leafKernel_, this->runner_.blocks_, counters, this->counts_);
        this->runner_.walks_.counting(this->runner_.structure_, state, visitor);
        if (this->options_.perRay)
        {
          this->options_.perRay[state.index] = counters;
        }
      }
      else
      {
        LeafVisitor visitor(state, this->leafKernel_, this->runner_.blocks_);
        this->runner_.walks_.plain(this->runner_.structure_, state, visitor);
      }
      answer(state.index, state);
    }
  }

  /// Counts a hit that is part of the answer.
  void countHit(PrimitiveId primitive)
  {
    if (!this->tests_.empty())
    {
      ++this->tests_[primitive].hit;
    }
  }

  void addTo(QueryReport& report) const
  {
    report.invalidRays += this->invalid_;
    for (const RayState& state : this->states_)
    {
      report.exactTests += state.exactTests;
      report.exactParameters += state.exactParameters;
    }
    for (std::size_t n = 0; n < this->visits_.size(); ++n)
    {
      this->options_.perNode[n] += this->visits_[n];
    }
    for (std::size_t p = 0; p < this->tests_.size(); ++p)
    {
      this->options_.perPrimitive[p].tested += this->tests_[p].tested;
      this->options_.perPrimitive[p].hit += this->tests_[p].hit;
    }
  }

private:
  /// The chunk's rays that are still to be traced.
  template <class Answer>
  struct Queue
  {
    /// Starts the next valid ray; false when there are no more.
    bool next(RayState& state)
    {
      while (this->first < this->end)
      {
        const std::size_t i = this->first++;
        if (this->chunk.start(this->listed ? this->listed[i] : i, state))
        {
          return true;
        }
      }
      return false;
    }

    [[nodiscard]] RayFeed feed()
    {
      return { this,
        [](void* owner, RayState& state) { return static_cast<Queue*>(owner)->next(state); },
        [](void* owner, RayState& state)
        { static_cast<Queue*>(owner)->answer(state.index, state); } };
    }

    Chunk& chunk;
    std::size_t first;
    std::size_t end;
    const std::size_t* listed; ///< rays listed[first] … listed[end - 1]; null: first … end - 1
    Answer& answer;
  };

  /// Traces the plan's bundles and leaves to go alone what cannot go together.
  template <class Answer>
  void traceTogether(BundlePlan& plan, Answer answer)
  {
    RayBundle bundle;
    bundle.state = &this->states_.front();
    bundle.exact = this->options_.precision == Precision::Exact;
    bundle.any = this->query_ == QueryKind::Any;
    // Where one tile of directions was too wide, those as wide will be.
    float tooWide = std::numeric_limits<float>::infinity();
    for (const BundlePlan::Bundle& members : plan.bundles())
    {
      bool done = false;
      if (members.spread < tooWide)
      {
        bundle.take(
          this->rays_, plan.members(members), static_cast<int>(members.count), members.axis);
        done = this->bundleKernel_(this->runner_.structure_, this->runner_.blocks_, bundle);
        tooWide = done ? tooWide : members.spread;
      }
      if (!done)
      {
        plan.separate(members);
        continue;
      }
      for (int i = 0; i < bundle.count; ++i)
      {
        if (bundle.finish(i))
        {
          answer(bundle.index[i], *bundle.state);
        }
        else
        {
          plan.separate(bundle.index[i]);
        }
      }
    }
  }

  /// False when the ray is not valid.
  bool start(std::size_t i, RayState& state)
  {
    this->rays_.read(i, state.ray);
    if (!isValid(state.ray))
    {
      ++this->invalid_;
      if (this->options_.perRay)
      {
        this->options_.perRay[i] = RayCounters{};
      }
      return false;
    }
    state.start();
    state.index = i;
    state.setSkips(this->rays_.skip);
    return true;
  }

  const BatchRunner& runner_;
  const RayBatch& rays_;
  QueryKind query_;
  const QueryOptions& options_;
  std::vector<RayState> states_;
  LeafKernel leafKernel_ = nullptr;
  RayKernel rayKernel_ = nullptr;
  BundleKernel bundleKernel_ = nullptr;
  std::uint64_t invalid_ = 0;
  std::vector<std::uint64_t> visits_;
  std::vector<PrimitiveCounters> tests_;
  TraversalCounts counts_;
};

BatchRunner::BatchRunner(const Surface& surface, const void* structure, StructureWalks walks,
  const void* blocks, std::size_t nodeCount)
  : surface_(surface)
  , structure_(structure)
  , walks_(walks)
  , blocks_(blocks)
  , nodeCount_(nodeCount)
{
}

bool BatchRunner::goTogether(
  const RayBatch& rays, QueryKind query, const QueryOptions& options) const
{
  const bool counting = options.perRay || options.perNode || options.perPrimitive;
  return this->walks_.bundle && !counting && !options.roundedT &&
    (query == QueryKind::Closest || query == QueryKind::Any) && this->surface_.bodyCount() == 0 &&
    BundlePlan::mayPay(rays);
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
  // Visits and tests are counted per chunk and then added, so chunks are large where there are many
  // nodes or primitives.
  const std::size_t counted = std::max(options.perNode ? this->nodeCount_ : 0,
    options.perPrimitive ? this->surface_.size() : std::size_t{ 0 });
  const std::size_t chunk = this->goTogether(rays, query, options)
    ? std::clamp(rays.size / leastPlans, raysPerChunk, raysPerPlan)
    : std::max(raysPerChunk, counted / 4);
  QueryReport report;
  std::mutex mutex;
  std::vector<std::uint8_t> reached((rays.size + chunk - 1) / chunk, 0);
  report.completed = parallelFor(rays.size, chunk, options.threads, options.control,
    [&](std::size_t begin, std::size_t end)
    {
      reached[begin / chunk] = 1;
      clear(begin, end);
      Chunk work(*this, rays, query, options);
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
