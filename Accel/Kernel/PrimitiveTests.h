// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_PrimitiveTests_h
#define Lumitree_Accel_Kernel_PrimitiveTests_h

#include "Accel/Kernel/Span.h"
#include "Accel/Kernel/TriangleBlock.h"
#include "Accel/Query.h"

namespace lumitree
{

/// Adds one test to each primitive of a leaf. The function for the surface's scalar type is chosen
/// once, as the leaf kernel is.
using PrimitiveTests = void (*)(const void* blocks, const Span& span, PrimitiveCounters* counters);

template <class T>
void addPrimitiveTests(const void* blocks, const Span& span, PrimitiveCounters* counters)
{
  const auto& store = *static_cast<const TriangleBlocks<T>*>(blocks);
  for (std::uint32_t i = 0; i < span.count; ++i)
  {
    ++counters[store[span.firstBlock + i / blockWidth].id[i % blockWidth]].tested;
  }
}

inline PrimitiveTests primitiveTests(ArrayView::Scalar scalar)
{
  return scalar == ArrayView::Scalar::Float ? &addPrimitiveTests<float>
                                            : &addPrimitiveTests<double>;
}

} // namespace lumitree

#endif
