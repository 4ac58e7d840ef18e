// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Included once per instruction set (Highway's scheme), so without an ordinary guard.
#if defined(LUMITREE_WIDE_STEP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LUMITREE_WIDE_STEP_INL
#undef LUMITREE_WIDE_STEP_INL
#else
#define LUMITREE_WIDE_STEP_INL
#endif

#include "Accel/Structures/WideRay-inl.h"

#include "Accel/Kernel/TriangleBlock.h"
#include "Accel/Structures/WideBvhNodes.h"

#include <hwy/cache_control.h>

#ifndef LUMITREE_WIDE_BVH_COMPRESSIONS
#define LUMITREE_WIDE_BVH_COMPRESSIONS
namespace lumitree
{

/// For each set of eight lanes the lanes that are in it, first to last. (Highway's own table for
/// AVX2 is copied to the stack each time.)
struct Compressions
{
  constexpr Compressions()
  {
    for (unsigned set = 0; set < 256; ++set)
    {
      int count = 0;
      for (std::uint8_t lane = 0; lane < 8; ++lane)
      {
        if ((set >> lane & 1u) != 0)
        {
          this->lanes[set][count++] = lane;
        }
      }
    }
  }

  std::uint8_t lanes[256][8] = {};
};
inline constexpr Compressions compressions;

} // namespace lumitree
#endif

HWY_BEFORE_NAMESPACE();
namespace lumitree
{
namespace HWY_NAMESPACE
{

// Seven siblings may wait per level of at most 64; a whole node's worth is written each time.
constexpr int stackSize = 7 * 64 + 2 * wideArity;

/// Children that wait, and lower bounds of s inside them.
struct Stack
{
  std::uint32_t child[stackSize]; ///< WideChild::bits
  float enter[stackSize];
  int height;

  void start(float sMin)
  {
    this->child[0] = WideChild::node(0).bits();
    this->enter[0] = sMin;
    this->height = 1;
  }
};

/// The same, and the children's numbers in the hierarchy view.
struct NumberedStack : Stack
{
  std::uint32_t number[stackSize];

  void start(float sMin)
  {
    this->Stack::start(sMin);
    this->number[0] = 0;
  }
};

/// Where the planes of a node lie, for each octant of directions: the offsets of the near ones
/// along x, y, z and of the far ones.
struct Rows
{
  std::uint32_t nearPlane[3];
  std::uint32_t farPlane[3];
};
constexpr Rows rowsOf(unsigned octant)
{
  Rows rows{};
  for (unsigned k = 0; k < 3; ++k)
  {
    const bool negative = (octant >> k & 1u) != 0;
    rows.nearPlane[k] = wideArity * (negative ? k + 3 : k);
    rows.farPlane[k] = wideArity * (negative ? k : k + 3);
  }
  return rows;
}
constexpr Rows octantRows[8] = { rowsOf(0), rowsOf(1), rowsOf(2), rowsOf(3), rowsOf(4), rowsOf(5),
  rowsOf(6), rowsOf(7) };

/// Raises enter to the near planes' s and lowers exit to the far planes', lane by lane; NaN changes
/// nothing.
HWY_INLINE void clip(const WideBvhNode& node, const WideRay& ray, Float8& enter, Float8& exit)
{
  const Rows& rows = octantRows[ray.octant];
  const float* const planes = node.planes[0];
  const auto near = [&](int k) HWY_ATTR
  {
    return (Float8::load(planes + rows.nearPlane[k]) - Float8::all(ray.originNear[k])) *
      Float8::all(ray.nearReciprocal[k]);
  };
  const auto far = [&](int k) HWY_ATTR
  {
    return (Float8::load(planes + rows.farPlane[k]) - Float8::all(ray.originFar[k])) *
      Float8::all(ray.farReciprocal[k]);
  };
  enter = raise(near(0), raise(near(1), raise(near(2), enter)));
  exit = lower(far(0), lower(far(1), lower(far(2), exit)));
}

/// Lower bounds of s inside the boxes that the segment [sMin, stop] may meet, in enter; a lane that
/// it does not meet has enter > exit, or one of them is NaN. The slab test of RayBox in float;
/// boxes and origin interval are rounded outward before.
HWY_INLINE void meet(
  const WideBvhNode& node, const WideRay& ray, float stop, Float8& enter, Float8& exit)
{
  if (ray.forward)
  {
    // A negative s, however it is padded, stays below sMin. Underflow loses less than the boxes'
    // own absolute pad.
    enter = Float8::all(ray.sMin);
    exit = Float8::all(stop);
    clip(node, ray, enter, exit);
    return;
  }
  enter = Float8::all(-std::numeric_limits<float>::infinity());
  exit = Float8::all(std::numeric_limits<float>::infinity());
  clip(node, ray, enter, exit);
  const Float8 relative = Float8::all(WideRay::slabPad);
  const Float8 absolutePad = Float8::all(0x1p-120f);
  enter = enter - (absolute(enter) * relative + absolutePad);
  exit = exit + (absolute(exit) * relative + absolutePad);
  HWY_ALIGN float enters[wideArity];
  HWY_ALIGN float exits[wideArity];
  enter.store(enters);
  exit.store(exits);
  for (int lane = 0; lane < wideArity; ++lane)
  {
    // An enter of NaN is an infinite one on its way out of the box: the box is not met.
    exits[lane] = enters[lane] <= exits[lane] ? std::min(exits[lane], stop)
                                              : std::numeric_limits<float>::quiet_NaN();
    enters[lane] = std::max(enters[lane], ray.sMin);
  }
  enter = Float8::load(enters);
  exit = Float8::load(exits);
}

/// Puts the children met on the stack, the nearest on top: in the order of the ray's octant, which
/// costs no comparison and no branch.
///@{
template <class Record>
HWY_INLINE void pushLaneByLane(const WideBvhNode& node, std::uint32_t order, const Float8& enter,
  const Float8& exit, Stack& stack, Record record)
{
  HWY_ALIGN float enters[wideArity];
  enter.store(enters);
  const unsigned met = (enter <= exit).bits();
  for (int i = 0; i < wideArity; ++i, order >>= 4)
  {
    const unsigned lane = order & 7u;
    stack.child[stack.height] = node.child[lane];
    stack.enter[stack.height] = enters[lane];
    record(stack.height, lane);
    stack.height += static_cast<int>(met >> lane & 1u);
  }
}

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
/// The lanes that are set come first, in their order; what follows means nothing.
template <class V, class M>
HWY_INLINE V compress(V v, M mask, unsigned bits)
{
#if HWY_TARGET == HWY_AVX3
  (void)bits;
  return hn::Compress(v, mask);
#else
  (void)mask;
  const hn::CappedTag<std::uint32_t, wideArity> du;
  const hn::Rebind<std::uint8_t, decltype(du)> bytes;
  const auto lanes = hn::PromoteTo(du, hn::LoadU(bytes, compressions.lanes[bits]));
  return hn::TableLookupLanes(v, hn::IndicesFromVec(du, lanes));
#endif
}
#endif

HWY_INLINE void push(const WideBvhNode& node, std::uint32_t, std::uint32_t order,
  const Float8& enter, const Float8& exit, Stack& stack)
{
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
  const hn::CappedTag<std::uint32_t, wideArity> du;
  const hn::CappedTag<float, wideArity> df;
  const auto shifts = hn::ShiftLeft<2>(hn::Iota(du, 0));
  const auto nibbles = hn::And(hn::Shr(hn::Set(du, order), shifts), hn::Set(du, 7));
  const auto lanes = hn::IndicesFromVec(du, nibbles);
  const auto ordered = [&](auto v) HWY_ATTR
  { return hn::TableLookupLanes(hn::BitCast(du, v), lanes); };
  const auto first = ordered(enter.part[0]);
  const auto met = hn::Le(hn::BitCast(df, first), hn::BitCast(df, ordered(exit.part[0])));
  const unsigned bits = Lanes<Float8>{ { met } }.bits();
  const auto waiting = hn::RebindMask(du, met);
  hn::StoreU(hn::BitCast(df, compress(first, waiting, bits)), df, stack.enter + stack.height);
  hn::StoreU(
    compress(ordered(hn::LoadU(du, node.child)), waiting, bits), du, stack.child + stack.height);
  stack.height += static_cast<int>(hwy::PopCount(bits));
#else
  pushLaneByLane(node, order, enter, exit, stack, [](int, unsigned) {});
#endif
}

HWY_INLINE void push(const WideBvhNode& node, std::uint32_t firstId, std::uint32_t order,
  const Float8& enter, const Float8& exit, NumberedStack& stack)
{
  pushLaneByLane(node, order, enter, exit, stack,
    [&](int at, unsigned lane) { stack.number[at] = firstId + lane; });
}
///@}

/// Has a child's memory fetched.
template <class T>
HWY_INLINE void fetch(const WideBvhNodes& tree, const TriangleBlocks<T>& blocks, WideChild child)
{
  const char* const memory = child.isLeaf()
    ? reinterpret_cast<const char*>(&blocks[child.firstBlock()])
    : reinterpret_cast<const char*>(&tree.nodes[child.nodeIndex()]);
  for (int line = 0; line < 4; ++line)
  {
    hwy::Prefetch(memory + 64 * line);
  }
}

} // namespace HWY_NAMESPACE
} // namespace lumitree
HWY_AFTER_NAMESPACE();

#endif
