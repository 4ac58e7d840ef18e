// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Accel/Kernel/LeafKernels.cxx"
#include "Accel/Kernel/InstructionSets.h"

#include <hwy/foreach_target.h>

#include "Accel/Kernel/LeafKernels.h"
#include "Accel/Kernel/LeafTest-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lumitree
{
namespace HWY_NAMESPACE
{

LeafKernel chooseLeafKernel(ArrayView::Scalar scalar, Precision precision, QueryKind query)
{
  return withPolicies(scalar, precision, query, [](auto t, auto p, auto q) -> LeafKernel {
    return [](RayState& state, const void* blocks, const Span& span) HWY_ATTR {
      using T = decltype(t);
      testLeaf<T, decltype(p), decltype(q)>(
        state, *static_cast<const TriangleBlocks<T>*>(blocks), span);
    };
  });
}

} // namespace HWY_NAMESPACE
} // namespace lumitree
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lumitree
{

HWY_EXPORT(chooseLeafKernel);

LeafKernel leafKernel(ArrayView::Scalar scalar, Precision precision, QueryKind query)
{
  return HWY_DYNAMIC_DISPATCH(chooseLeafKernel)(scalar, precision, query);
}

} // namespace lumitree
#endif
