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

LeafKernel chooseLeafKernel(ArrayView::Scalar scalar)
{
  return withScalar(scalar,
    [](auto t) -> LeafKernel
    {
      return [](RayState& state, const void* store, const Span& span) HWY_ATTR
      {
        using T = decltype(t);
        const auto& blocks = *static_cast<const TriangleBlocks<T>*>(store);
        testLeaf(state, blocks, span);
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

LeafKernel leafKernel(ArrayView::Scalar scalar)
{
  return HWY_DYNAMIC_DISPATCH(chooseLeafKernel)(scalar);
}

} // namespace lumitree
#endif
