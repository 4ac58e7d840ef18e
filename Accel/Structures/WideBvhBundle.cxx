// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Accel/Structures/WideBvhBundle.cxx"
#include "Accel/Kernel/InstructionSets.h"

#include <hwy/foreach_target.h>

#include "Accel/Kernel/BundleLeaf-inl.h"
#include "Accel/Kernel/LeafTest-inl.h"
#include "Accel/Structures/WideBvhBundle.h"
#include "Accel/Structures/WideStep-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lumitree
{
namespace HWY_NAMESPACE
{

constexpr int bundleSize = RayBundle::capacity;

/// A bundle in the frame of a wide BVH.
struct WideBundle
{
  /// False where the rays are not all of one octant, or floats might not do for one of them.
  HWY_INLINE bool start(const WideBvhFrame& frame, const RayBundle& bundle)
  {
    Ray first;
    first.origin = bundle.origin;
    for (int k = 0; k < 3; ++k)
    {
      first.direction[k] = bundle.direction[k][0];
    }
    first.tMin = *std::min_element(bundle.tMin, bundle.tMin + bundle.count);
    this->hull.start(frame, first);
    if (!this->hull.bounded || !this->hull.forward || !this->scale(bundle))
    {
      return false;
    }
    for (int i = 0; i < bundleSize; ++i)
    {
      this->stop[i] = i < bundle.count ? this->hull.above(bundle.tMax[i])
                                       : -std::numeric_limits<float>::infinity();
    }
    this->findLastStop();
    return true;
  }

  /// Rays whose best hit is nearer now.
  HWY_INLINE void lowerStops(const RayBundle& bundle, std::uint64_t changed)
  {
    for (; changed != 0; changed &= changed - 1)
    {
      const auto i = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(changed));
      this->stop[i] = std::min(this->stop[i], this->hull.above(bundle.high[i]));
    }
    this->findLastStop();
  }

  /// Which of the rays asked for may meet the box of a child, as bits.
  HWY_INLINE std::uint64_t meeting(
    const WideBvhNode& node, unsigned lane, std::uint64_t asked) const
  {
    const Rows& rows = octantRows[this->hull.octant];
    const float* const planes = node.planes[0] + lane;
    Float8 toNear[3];
    Float8 toFar[3];
    for (int k = 0; k < 3; ++k)
    {
      toNear[k] = Float8::all(planes[rows.nearPlane[k]] - this->hull.originNear[k]);
      toFar[k] = Float8::all(planes[rows.farPlane[k]] - this->hull.originFar[k]);
    }
    std::uint64_t met = 0;
    for (int i = 0; i < bundleSize; i += wideArity)
    {
      if ((asked >> i & 0xffu) == 0)
      {
        continue;
      }
      Float8 enter = Float8::all(this->hull.sMin);
      Float8 exit = Float8::load(this->stop + i);
      for (int k = 0; k < 3; ++k)
      {
        enter = raise(toNear[k] * Float8::load(this->nearReciprocal[k] + i), enter);
        exit = lower(toFar[k] * Float8::load(this->farReciprocal[k] + i), exit);
      }
      met |= static_cast<std::uint64_t>((enter <= exit).bits()) << i;
    }
    return met & asked;
  }

  /// What all rays have in common, with the least of their near reciprocals and the greatest of the
  /// far ones: for planes before the origin its s bounds those of all; what is behind is below sMin
  /// for all.
  WideRay hull;
  float lastStop;                                  ///< the greatest
  alignas(32) float nearReciprocal[3][bundleSize]; ///< as in WideRay, with the hull's perT
  alignas(32) float farReciprocal[3][bundleSize];
  alignas(32) float stop[bundleSize]; ///< -infinity: the ray has nothing to find any more

private:
  HWY_INLINE void findLastStop()
  {
    Float8 greatest = Float8::load(this->stop);
    for (int i = wideArity; i < bundleSize; i += wideArity)
    {
      greatest = raise(Float8::load(this->stop + i), greatest);
    }
    this->lastStop = greatestOf(greatest);
  }

  HWY_INLINE static float greatestOf(const Float8& values)
  {
    HWY_ALIGN float stored[wideArity];
    values.store(stored);
    return *std::max_element(stored, stored + wideArity);
  }

  /// As WideRay does it for one ray. There the largest component is scaled into [1, 2): here into
  /// [1/4, 8), or the rays are not taken together; nor where one runs along a plane of the axes.
  HWY_INLINE bool scale(const RayBundle& bundle)
  {
    const Double4 unit = Double4::all(this->hull.unit);
    const float infinity = std::numeric_limits<float>::infinity();
    bool alike = true;
    for (int k = 0; k < 3; ++k)
    {
      const bool negative = (this->hull.octant >> k & 1u) != 0;
      const float sign = negative ? -1.0f : 1.0f;
      HWY_ALIGN float sizes[bundleSize];
      for (int i = 0; i < bundleSize; i += 4)
      {
        toFloat(Double4::load(bundle.direction[k] + i) * unit).store(sizes + i);
      }
      Float8 least = Float8::all(infinity);
      Float8 greatest = Float8::all(-infinity);
      for (int i = 0; i < bundleSize; i += wideArity)
      {
        const Float8 size = Float8::load(sizes + i) * Float8::all(sign);
        least = lower(size, least);
        greatest = raise(size, greatest);
        const Float8 reciprocal = Float8::all(sign) / size;
        (reciprocal * Float8::all(1.0f - WideRay::slabPad)).store(this->nearReciprocal[k] + i);
        (reciprocal * Float8::all(1.0f + WideRay::slabPad)).store(this->farReciprocal[k] + i);
      }
      const float smallest = -greatestOf(Float8::all(0.0f) - least);
      const float largest = greatestOf(greatest);
      alike = alike && smallest > (k == bundle.axis ? 0.25f : 0x1p-100f) && largest < 8.0f;
      this->hull.nearReciprocal[k] = sign / largest * (1.0f - WideRay::slabPad);
      this->hull.farReciprocal[k] = sign / smallest * (1.0f + WideRay::slabPad);
    }
    return alike;
  }
};

/// A ray alone looks at one to three leaves. One leaf for many rays costs as much as three for one;
/// with more of them than this, taking the rays together costs more than it saves.
constexpr int leavesPerRay = 3;

template <class T>
bool travelTogether(const WideBvhNodes& tree, const TriangleBlocks<T>& blocks, RayBundle& bundle)
{
  if (tree.nodes.empty())
  {
    return true;
  }
  WideBundle wide;
  if (!wide.start(tree.frame, bundle))
  {
    return false;
  }
  prepare(bundle);
  // A child's number is that of its place among all nodes' lanes; with it waits who met its parent.
  NumberedStack stack;
  std::uint64_t asked[stackSize];
  stack.start(wide.hull.sMin);
  std::uint64_t rays = ~std::uint64_t{ 0 };
  int leaves = 0;
  while (stack.height > 0)
  {
    const int top = --stack.height;
    if (!(stack.enter[top] <= wide.lastStop))
    {
      continue;
    }
    const WideChild child(stack.child[top]);
    if (child.bits() != WideChild::node(0).bits())
    {
      const std::uint32_t place = stack.number[top];
      rays = wide.meeting(tree.nodes[place / wideArity], place % wideArity, asked[top]);
    }
    if (rays == 0)
    {
      continue;
    }
    if (!child.isLeaf())
    {
      const WideBvhNode& node = tree.nodes[child.nodeIndex()];
      Float8 enter;
      Float8 exit;
      meet(node, wide.hull, wide.lastStop, enter, exit);
      const int before = stack.height;
      push(node, child.nodeIndex() * wideArity, node.order[wide.hull.octant], enter, exit, stack);
      for (int i = before; i < stack.height; ++i)
      {
        asked[i] = rays;
        fetch(tree, blocks, WideChild(stack.child[i]));
      }
      continue;
    }
    if (++leaves > leavesPerRay * bundle.count)
    {
      return false;
    }
    const std::uint64_t changed =
      testLeafTogether(bundle, blocks, Span{ child.firstBlock(), tree.countOf(child), 0.0 }, rays);
    if (changed != 0)
    {
      wide.lowerStops(bundle, changed);
    }
  }
  return true;
}

BundleKernel chooseWideBvhBundleKernel(ArrayView::Scalar scalar)
{
  const auto kernel = [](auto t) -> BundleKernel
  {
    return [](const void* structure, const void* store, RayBundle& bundle) HWY_ATTR
    {
      return travelTogether(*static_cast<const WideBvhNodes*>(structure),
        *static_cast<const TriangleBlocks<decltype(t)>*>(store), bundle);
    };
  };
  return scalar == ArrayView::Scalar::Float ? kernel(float{}) : kernel(double{});
}

} // namespace HWY_NAMESPACE
} // namespace lumitree
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lumitree
{

HWY_EXPORT(chooseWideBvhBundleKernel);

BundleKernel wideBvhBundleKernel(ArrayView::Scalar scalar)
{
  return HWY_DYNAMIC_DISPATCH(chooseWideBvhBundleKernel)(scalar);
}

} // namespace lumitree
#endif
