// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_Visitors_h
#define Lumitree_Accel_Kernel_Visitors_h

#include "Accel/Kernel/LeafKernels.h"
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

/// The same, and counts per ray and per node.
class CountingVisitor
{
public:
  CountingVisitor(RayState& state, LeafKernel kernel, const void* blocks, RayCounters& counters,
    std::uint64_t* perNode)
    : visitor_(state, kernel, blocks)
    , counters_(counters)
    , perNode_(perNode)
  {
  }

  void node(std::uint32_t i)
  {
    ++this->counters_.nodes;
    if (this->perNode_)
    {
      ++this->perNode_[i];
    }
  }
  void cell() { ++this->counters_.cells; }
  [[nodiscard]] double tStop() const { return this->visitor_.tStop(); }

  double leaf(const Span& span)
  {
    ++this->counters_.leaves;
    this->counters_.primitives += span.count;
    return this->visitor_.leaf(span);
  }

private:
  LeafVisitor visitor_;
  RayCounters& counters_;
  std::uint64_t* perNode_;
};

} // namespace lumitree

#endif
