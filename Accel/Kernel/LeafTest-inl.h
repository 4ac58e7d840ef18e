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
#include "Accel/Kernel/RayState.h"

HWY_BEFORE_NAMESPACE();
namespace lumitree
{
namespace HWY_NAMESPACE
{

/// Filters the primitives of a leaf and has the candidates settled.
template <class T>
HWY_INLINE void testLeaf(RayState& state, const TriangleBlocks<T>& blocks, const Span& span)
{
  const std::uint32_t blockCount = (span.count + blockWidth - 1) / blockWidth;
  for (std::uint32_t b = 0; b < blockCount; ++b)
  {
    const TriangleBlock<T>& block = blocks[span.firstBlock + b];
    BlockEdges edges;
    unsigned candidates = candidateLanes(state.ray, block, edges);
    for (; candidates != 0; candidates &= candidates - 1)
    {
      const auto lane = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero32(candidates));
      if (block.id[lane] != noPrimitive)
      {
        edges.store(lane, state.edges);
        state.settle(state, block.along(state.ray.axis, lane), block.id[lane]);
      }
    }
  }
}

/// Calls f(T) with a type in place of the choice.
template <class F>
auto withScalar(ArrayView::Scalar scalar, F f)
{
  return scalar == ArrayView::Scalar::Float ? f(float{}) : f(double{});
}

} // namespace HWY_NAMESPACE
} // namespace lumitree
HWY_AFTER_NAMESPACE();

#endif
