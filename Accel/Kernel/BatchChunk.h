// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_BatchChunk_h
#define Lumitree_Accel_Kernel_BatchChunk_h

#include "Accel/Kernel/BatchRunner.h"
#include "Accel/Kernel/BundlePlan.h"
#include "Accel/Kernel/OriginOrder.h"
#include "Accel/Kernel/Settle.h"

namespace lumitree
{

/// What one chunk of rays needs; totals are added to the report when it ends.
class BatchRunner::Chunk
{
public:
  Chunk(const BatchRunner& runner, Course course, const RayBatch& rays, QueryKind query,
    const QueryOptions& options)
    : runner_(runner)
    , course_(course)
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
    if (course == Course::Together)
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
    if (this->course_ == Course::Together)
    {
      BundlePlan plan;
      plan.make(this->rays_, begin, end);
      this->traceTogether(plan, answer);
      this->trace(
        Queue<Answer>{ *this, 0, plan.alone().size(), plan.alone().data(), answer }, inOrder);
    }
    else if (this->course_ == Course::ByOrigin)
    {
      OriginOrder order;
      order.make(this->rays_, this->runner_.surface_.bounds(), begin, end);
      this->trace(
        Queue<Answer>{ *this, 0, order.rays().size(), order.rays().data(), answer }, inOrder);
    }
    else
    {
      this->trace(Queue<Answer>{ *this, begin, end, nullptr, answer }, inOrder);
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
  /// So many rays that are not side by side in memory are read at a time: the processor then waits
  /// for many of them at once.
  static constexpr std::size_t raysAhead = 64;

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
        if (this->listed)
        {
          this->readAhead(i);
          static_cast<Ray&>(state.ray) = this->ahead[i % raysAhead];
        }
        else
        {
          this->chunk.rays_.read(i, state.ray);
        }
        if (this->chunk.start(this->listed ? this->listed[i] : i, state))
        {
          return true;
        }
      }
      return false;
    }

    void readAhead(std::size_t i)
    {
      if (i % raysAhead == 0)
      {
        this->ahead.resize(raysAhead);
        for (std::size_t k = i; k < std::min(this->end, i + raysAhead); ++k)
        {
          this->chunk.rays_.read(this->listed[k], this->ahead[k - i]);
        }
      }
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
    std::vector<Ray> ahead{}; ///< of those listed, from a multiple of raysAhead on
  };

  /// Traces the rays of the queue.
  template <class Answer>
  void trace(Queue<Answer>&& queue, bool inOrder)
  {
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
      queue.answer(state.index, state);
    }
  }

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

  /// Starts the ray in the state; false when it is not valid.
  bool start(std::size_t i, RayState& state)
  {
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
  Course course_;
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

} // namespace lumitree

#endif
