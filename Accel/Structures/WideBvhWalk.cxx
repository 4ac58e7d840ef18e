// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Accel/Structures/WideBvhWalk.cxx"
#include "Accel/Kernel/InstructionSets.h"

#include <hwy/foreach_target.h>

#include "Accel/Kernel/LeafTest-inl.h"
#include "Accel/Structures/WideBvhWalk.h"
#include "Accel/Structures/WideStep-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lumitree
{
namespace HWY_NAMESPACE
{

/// A ray on its way through the tree.
template <class StackType>
struct Traveller
{
  /// Takes the ray in the state to the root.
  void start(const WideBvhNodes& tree, RayState& rayState)
  {
    this->state = &rayState;
    this->ray.start(tree.frame, rayState.ray);
    this->stop = this->ray.above(rayState.tStop);
    this->stack.start(this->ray.sMin);
  }

  /// The same in two steps.
  ///@{
  void await(RayState& rayState)
  {
    this->state = &rayState;
    this->stack.height = -1;
  }
  HWY_INLINE void startIfAwaited(const WideBvhNodes& tree)
  {
    if (this->stack.height < 0)
    {
      this->start(tree, *this->state);
    }
  }
  ///@}

  /// Takes the nearest child that matters from the stack, which then has it above its top; false
  /// when there is none.
  HWY_INLINE bool pop()
  {
    while (this->stack.height > 0)
    {
      --this->stack.height;
      if (this->stack.enter[this->stack.height] <= this->stop)
      {
        return true;
      }
    }
    return false;
  }

  /// Goes through the child taken: into a node, or leaf(span) as the contract of Span.h says.
  template <class Leaf>
  HWY_INLINE void step(const WideBvhNodes& tree, Leaf testLeafAt)
  {
    const WideChild child(this->stack.child[this->stack.height]);
    if (!child.isLeaf())
    {
      const WideBvhNode& node = tree.nodes[child.nodeIndex()];
      Float8 enter;
      Float8 exit;
      meet(node, this->ray, this->stop, enter, exit);
      const std::uint32_t order = this->state->anyHit ? laneOrder : node.order[this->ray.octant];
      push(node, tree.firstId[child.nodeIndex()], order, enter, exit, this->stack);
      return;
    }
    const double tStop = this->state->tStop;
    testLeafAt(*this->state, Span{ child.firstBlock(), tree.countOf(child), 0.0 });
    if (this->state->tStop < tStop)
    {
      this->stop = this->ray.above(this->state->tStop);
      this->stack.height = this->state->tStop < this->state->ray.tMin ? 0 : this->stack.height;
    }
  }

  RayState* state = nullptr;
  WideRay ray;
  float stop = 0.0f;
  StackType stack;
};

/// Has what a ray will look at when its turn comes again fetched meanwhile.
template <class T>
HWY_INLINE void fetchNext(
  const WideBvhNodes& tree, const TriangleBlocks<T>& blocks, const Stack& stack)
{
  if (stack.height > 0)
  {
    fetch(tree, blocks, WideChild(stack.child[stack.height - 1]));
  }
}

template <class T>
void travel(const WideBvhNodes& tree, const TriangleBlocks<T>& blocks, RayState* states, int count,
  const RayFeed& feed)
{
  if (tree.nodes.empty())
  {
    while (feed.next(feed.owner, *states))
    {
      feed.done(feed.owner, *states);
    }
    return;
  }
  // A small tree is in the inner caches anyway.
  const bool large = tree.nodes.size() > 1024;
  Traveller<Stack> travellers[mostTravellers];
  Traveller<Stack>* onTheWay[mostTravellers];
  int active = 0;
  for (int i = 0; i < std::min(count, mostTravellers) && feed.next(feed.owner, states[i]); ++i)
  {
    onTheWay[active++] = &travellers[i];
    travellers[i].await(states[i]);
  }
  while (active > 0)
  {
    for (int i = 0; i < active;)
    {
      Traveller<Stack>& traveller = *onTheWay[i];
      traveller.startIfAwaited(tree);
      if (traveller.pop())
      {
        traveller.step(
          tree, [&](RayState& state, const Span& span) HWY_ATTR { testLeaf(state, blocks, span); });
        if (large)
        {
          fetchNext(tree, blocks, traveller.stack);
        }
        ++i;
        continue;
      }
      feed.done(feed.owner, *traveller.state);
      if (feed.next(feed.owner, *traveller.state))
      {
        // It starts when its turn comes again: a ray read in wider pieces than it was just written
        // in would have to wait for the memory.
        traveller.await(*traveller.state);
        ++i;
      }
      else
      {
        onTheWay[i] = onTheWay[--active];
      }
    }
  }
}

RayKernel chooseWideBvhKernel(ArrayView::Scalar scalar)
{
  return withScalar(scalar,
    [](auto t) -> RayKernel
    {
      return [](const void* structure, const void* store, RayState* states, int count,
               const RayFeed& feed) HWY_ATTR
      {
        using T = decltype(t);
        travel(*static_cast<const WideBvhNodes*>(structure),
          *static_cast<const TriangleBlocks<T>*>(store), states, count, feed);
      };
    });
}

void countingWalk(const WideBvhNodes& tree, RayState& state, CountingVisitor& visitor)
{
  if (tree.nodes.empty())
  {
    return;
  }
  Traveller<NumberedStack> traveller;
  traveller.start(tree, state);
  while (traveller.pop())
  {
    visitor.node(traveller.stack.number[traveller.stack.height]);
    traveller.step(tree, [&](RayState&, const Span& span) { visitor.leaf(span); });
  }
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

RayKernel wideBvhKernel(ArrayView::Scalar scalar)
{
  return HWY_DYNAMIC_DISPATCH(chooseWideBvhKernel)(scalar);
}

WideBvhCountingWalk wideBvhCountingWalk()
{
  return HWY_DYNAMIC_DISPATCH(chooseCountingWalk)();
}

} // namespace lumitree
#endif
