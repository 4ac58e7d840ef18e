// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Accel/Structures/WideBvhWalk.cxx"
#include "Accel/Kernel/InstructionSets.h"

#include <hwy/foreach_target.h>

#include "Accel/Kernel/LeafTest-inl.h"
#include "Accel/Structures/WideBvhWalk.h"
#include "Accel/Structures/WideRay.h"

#include <hwy/cache_control.h>

#include <utility>

HWY_BEFORE_NAMESPACE();
namespace lumitree
{
namespace HWY_NAMESPACE
{

/// A child that waits, and a lower bound of s inside it.
struct Waiting
{
  std::uint32_t child;
  std::uint32_t count;
  float enter;
  std::uint32_t id;
};

// Seven siblings may wait per level of at most 64.
constexpr int stackSize = 7 * 64 + wideArity;

/// What the slab test needs of a ray, in registers.
struct Planes
{
  explicit Planes(const WideRay& ray)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->originNear[k] = Float8::all(ray.originNear[k]);
      this->originFar[k] = Float8::all(ray.originFar[k]);
      // Where s >= 0 a factor makes it smaller or larger; elsewhere the pad is added later.
      const float pad = ray.forward ? slabPad : 0.0f;
      this->nearReciprocal[k] = Float8::all(ray.reciprocal[k] * (1.0f - pad));
      this->farReciprocal[k] = Float8::all(ray.reciprocal[k] * (1.0f + pad));
      this->nearRow[k] = ray.negative[k] ? k + 3 : k;
      this->farRow[k] = ray.negative[k] ? k : k + 3;
    }
  }

  /// Difference, reciprocal and product round to 2^-24 each, 3.1 · 2^-24 in all, and the padded
  /// reciprocal once more.
  static constexpr float slabPad = 0x1p-21f;

  Float8 originNear[3];
  Float8 originFar[3];
  Float8 nearReciprocal[3];
  Float8 farReciprocal[3];
  int nearRow[3]; ///< of WideBvhNode::planes
  int farRow[3];
};

/// Raises enter to the near planes' s and lowers exit to the far planes', lane by lane; NaN changes
/// nothing.
HWY_INLINE void clip(const WideBvhNode& node, const Planes& planes, Float8& enter, Float8& exit)
{
  for (int k = 0; k < 3; ++k)
  {
    const Float8 nearPlane = Float8::load(node.planes[planes.nearRow[k]]);
    const Float8 farPlane = Float8::load(node.planes[planes.farRow[k]]);
    enter = raise((nearPlane - planes.originNear[k]) * planes.nearReciprocal[k], enter);
    exit = lower((farPlane - planes.originFar[k]) * planes.farReciprocal[k], exit);
  }
}

/// The lanes whose boxes the segment [sMin, stop] may meet, as bits, and lower bounds of s inside
/// them. The slab test of RayBox in float; boxes and origin interval are rounded outward before.
HWY_INLINE unsigned meets(
  const WideBvhNode& node, const WideRay& ray, const Planes& planes, float stop, float* enters)
{
  if (ray.forward)
  {
    // A negative s, however it is padded, stays below sMin. Underflow loses less than the boxes'
    // own absolute pad.
    Float8 enter = Float8::all(ray.sMin);
    Float8 exit = Float8::all(stop);
    clip(node, planes, enter, exit);
    enter.store(enters);
    return (enter <= exit).bits();
  }
  Float8 enter = Float8::all(-std::numeric_limits<float>::infinity());
  Float8 exit = Float8::all(std::numeric_limits<float>::infinity());
  clip(node, planes, enter, exit);
  const Float8 relative = Float8::all(Planes::slabPad);
  const Float8 absolutePad = Float8::all(0x1p-120f);
  enter = enter - (absolute(enter) * relative + absolutePad);
  exit = exit + (absolute(exit) * relative + absolutePad);
  const Float8 from = raise(enter, Float8::all(ray.sMin));
  from.store(enters);
  // An enter of NaN is an infinite one on its way out of the box: no comparison with it holds.
  return ((enter <= exit) & (from <= exit) & (from <= Float8::all(stop))).bits();
}

/// Sorts the children met behind the nearest of them, which is returned: the farther ones wait on
/// the stack, nearer on top, equal ones in the order of their lanes. Memory that the walk will need
/// soon is fetched ahead.
template <class Fetch>
HWY_INLINE Waiting nearest(const WideBvhNode& node, unsigned lanes, const float* enters,
  std::uint32_t firstId, Waiting* stack, int& height, Fetch fetch)
{
  const auto take = [&]
  {
    const auto lane = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero32(lanes));
    lanes &= lanes - 1;
    const Waiting w = { node.child[lane], node.count[lane], enters[lane],
      firstId + static_cast<std::uint32_t>(lane) };
    fetch(w);
    return w;
  };
  Waiting best = take();
  if (lanes == 0)
  {
    return best;
  }
  const int first = height;
  do
  {
    Waiting w = take();
    if (w.enter < best.enter)
    {
      std::swap(w, best);
    }
    int at = height++;
    for (; at > first && stack[at - 1].enter <= w.enter; --at)
    {
      stack[at] = stack[at - 1];
    }
    stack[at] = w;
  } while (lanes != 0);
  return best;
}

/// The walk: node(id) and leaf(span) are called as the contract of Span.h says; block(i) is the
/// address of block i.
template <class Node, class Leaf, class Block>
HWY_INLINE void walk(
  const WideBvhNodes& tree, RayState& state, Node enterNode, Leaf testLeafAt, Block blockAt)
{
  if (tree.nodes.empty())
  {
    return;
  }
  const WideRay ray(tree.frame, state.ray);
  const Planes planes(ray);
  const WideBvhNode* const nodes = tree.nodes.data();
  const auto fetch = [&](const Waiting& w)
  {
    const char* const memory = w.count > 0 ? static_cast<const char*>(blockAt(w.child))
                                           : reinterpret_cast<const char*>(nodes + w.child);
    for (int line = 0; line < 4; ++line)
    {
      hwy::Prefetch(memory + 64 * line);
    }
  };
  Waiting stack[stackSize];
  int height = 0;
  Waiting next = { 0, 0, ray.sMin, 0 };
  double tStop = state.tStop;
  float stop = ray.above(tStop);
  HWY_ALIGN float enters[wideArity];
  while (true)
  {
    enterNode(next.id);
    if (next.count > 0)
    {
      testLeafAt({ next.child, next.count, 0.0 });
      if (state.tStop < tStop)
      {
        tStop = state.tStop;
        stop = ray.above(tStop);
        if (tStop < state.ray.tMin)
        {
          return;
        }
      }
    }
    else
    {
      const WideBvhNode& node = nodes[next.child];
      const unsigned lanes = meets(node, ray, planes, stop, enters);
      if (lanes != 0)
      {
        next = nearest(node, lanes, enters, tree.firstId[next.child], stack, height, fetch);
        continue;
      }
    }
    do
    {
      if (height == 0)
      {
        return;
      }
      next = stack[--height];
    } while (next.enter > stop);
  }
}

RayKernel chooseWideBvhKernel(ArrayView::Scalar scalar, bool certain)
{
  return withChoices(scalar, certain,
    [](auto t, auto isCertain) -> RayKernel
    {
      return [](const void* structure, const void* store, RayState& state) HWY_ATTR
      {
        using T = decltype(t);
        const auto& blocks = *static_cast<const TriangleBlocks<T>*>(store);
        walk(
          *static_cast<const WideBvhNodes*>(structure), state, [](std::uint32_t) {},
          [&](const Span& span) HWY_ATTR
          { testLeaf<decltype(isCertain)::value>(state, blocks, span); },
          [&](std::uint32_t i) -> const void* { return &blocks[i]; });
      };
    });
}

void countingWalk(const WideBvhNodes& tree, RayState& state, CountingVisitor& visitor)
{
  walk(
    tree, state, [&](std::uint32_t id) { visitor.node(id); },
    [&](const Span& span) { visitor.leaf(span); },
    [&](std::uint32_t) -> const void* { return tree.nodes.data(); });
}

WideBvhCountingWalk chooseCountingWalk()
{
  return countingWalk;
}

} // namespace HWY_NAMESPACE
} // namespace lumitree
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lumitree
{

HWY_EXPORT(chooseWideBvhKernel);
HWY_EXPORT(chooseCountingWalk);

RayKernel wideBvhKernel(ArrayView::Scalar scalar, bool certain)
{
  return HWY_DYNAMIC_DISPATCH(chooseWideBvhKernel)(scalar, certain);
}

WideBvhCountingWalk wideBvhCountingWalk()
{
  return HWY_DYNAMIC_DISPATCH(chooseCountingWalk)();
}

} // namespace lumitree
#endif
