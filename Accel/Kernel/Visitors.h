// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_Visitors_h
#define Lumitree_Accel_Kernel_Visitors_h

#include "Accel/Kernel/LeafKernels.h"
#include "Accel/Kernel/PrimitiveTests.h"
#include "Accel/Query.h"

#include <atomic>

namespace lumitree
{

/// Sends leaves to the leaf kernel and counts nothing; the calls vanish.
class LeafVisitor
{
public:
  LeafVisitor(RayState& state, LeafKernel kernel, const void* blocks)
    : state_(state)
    , kernel_(kernel)
    , blocks_(blocks)
  {
  }

  void node(std::uint32_t) {}
  void cell() {}
  [[nodiscard]] double tStop() const { return this->state_.tStop; }

  double leaf(const Span& span)
  {
    this->kernel_(this->state_, this->blocks_, span);
    return this->state_.tStop;
  }

private:
  RayState& state_;
  LeafKernel kernel_;
  const void* blocks_;
};

/// Where a walk is counted; null where it is not.
struct TraversalCounts
{
  std::uint64_t* perNode = nullptr;
  PrimitiveCounters* perPrimitive = nullptr;
  PrimitiveTests addTests = nullptr;
};

/// The same, and counts per ray, per node and per primitive.
class CountingVisitor
{
public:
  CountingVisitor(RayState& state, LeafKernel kernel, const void* blocks, RayCounters& counters,
    const TraversalCounts& counts)
    : visitor_(state, kernel, blocks)
    , blocks_(blocks)
    , counters_(counters)
    , counts_(counts)
  {
  }

  void node(std::uint32_t i)
  {
    ++this->counters_.nodes;
    if (this->counts_.perNode)
    {
      ++this->counts_.perNode[i];
    }
  }
  void cell() { ++this->counters_.cells; }
  [[nodiscard]] double tStop() const { return this->visitor_.tStop(); }

  double leaf(const Span& span)
  {
    ++this->counters_.leaves;
    this->counters_.primitives += span.count;
    if (this->counts_.perPrimitive)
    {
      this->counts_.addTests(this->blocks_, span, this->counts_.perPrimitive);
    }
    return this->visitor_.leaf(span);
  }

private:
  LeafVisitor visitor_;
  const void* blocks_;
  RayCounters& counters_;
  TraversalCounts counts_;
};

} // namespace lumitree

#endif
