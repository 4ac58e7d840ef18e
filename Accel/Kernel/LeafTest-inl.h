// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Included once per instruction set (Highway's scheme), so without an ordinary guard.
#if defined(LUMITREE_LEAF_TEST_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LUMITREE_LEAF_TEST_INL
#undef LUMITREE_LEAF_TEST_INL
#else
#define LUMITREE_LEAF_TEST_INL
#endif

#include "Accel/Kernel/BlockFilter-inl.h"

#include "Accel/Choices.h"
#include "Accel/Kernel/Precisions.h"
#include "Accel/Kernel/Queries.h"

HWY_BEFORE_NAMESPACE();
namespace lumitree
{
namespace HWY_NAMESPACE
{

/// Tests the primitives of a leaf: filter, precision, query.
template <class T, class Precision, class Query>
HWY_INLINE void testLeaf(RayState& state, const TriangleBlocks<T>& blocks, const Span& span)
{
  const std::uint32_t blockCount = (span.count + blockWidth - 1) / blockWidth;
  for (std::uint32_t b = 0; b < blockCount; ++b)
  {
    const TriangleBlock<T>& block = blocks[span.firstBlock + b];
    unsigned candidates = candidateLanes<Precision::certain>(state.filter, block);
    for (; candidates != 0; candidates &= candidates - 1)
    {
      const auto lane = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero32(candidates));
      Candidate c;
      c.primitive = block.id[lane];
      if (c.primitive != noPrimitive && !state.skips(c.primitive) &&
        Precision::settle(state, block.corners(lane), c))
      {
        Query::template offer<Precision>(state, c);
      }
    }
  }
}

/// Calls f(scalar, precision policy, query policy) with types in place of the three choices.
template <class F>
auto withPolicies(ArrayView::Scalar scalar, Precision precision, QueryKind query, F f)
{
  const auto withQuery = [&](auto t, auto p) {
    switch (query)
    {
      case QueryKind::Closest:
        return f(t, p, ClosestQuery{});
      case QueryKind::Any:
        return f(t, p, AnyQuery{});
      default:
        return f(t, p, CollectQuery{});
    }
  };
  const auto withPrecision = [&](auto t) {
    switch (precision)
    {
      case Precision::Fast:
        return withQuery(t, FastPrecision{});
      case Precision::Watertight:
        return withQuery(t, WatertightPrecision{});
      default:
        return withQuery(t, ExactPrecision{});
    }
  };
  return scalar == ArrayView::Scalar::Float ? withPrecision(float{}) : withPrecision(double{});
}

} // namespace HWY_NAMESPACE
} // namespace lumitree
HWY_AFTER_NAMESPACE();

#endif
