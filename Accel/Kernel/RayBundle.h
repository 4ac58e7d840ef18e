// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_RayBundle_h
#define Lumitree_Accel_Kernel_RayBundle_h

#include "Accel/Kernel/RayState.h"

namespace lumitree
{

/// Valid rays that start in one point and go nearly the same way, side by side, with the answers of
/// Closest or Any: what depends on the origin and a triangle alone is computed once for all of
/// them, and a box that their hull does not meet is left by all.
///
/// Answers are those of a ray alone, to the last bit. A candidate that is certainly hit, certainly
/// between the limits and certainly nearer than all before needs no more than its t, u and v; every
/// other that is not certainly farther is settled as always.
struct RayBundle
{
  static constexpr int capacity = 64;

  /// Starts anew with these rays of the batch, capacity of them at most, which start in one point
  /// and whose directions are largest along this axis. What kernels compute is left to them.
  void take(const RayBatch& rays, const std::size_t* members, int size, int along);

  /// Whether ray i is to skip the primitive.
  [[nodiscard]] bool skips(int i, PrimitiveId id) const
  {
    return this->skip.offsets && this->skip.skips(this->index[i], id);
  }

  /// Has ray i's candidate settled by the state's function, after what the ray knows so far.
  void settle(int i, const Corners& corners, PrimitiveId id);

  /// Puts ray i and its answer in the state, as a walk of this ray alone would have left it; false
  /// where that walk must be made.
  [[nodiscard]] bool finish(int i);

  RayState* state = nullptr; ///< for what rays do one by one
  bool exact = false;        ///< the precision is Exact
  bool any = false;          ///< the query is Any
  int axis = 0;
  int count = 0;
  Vec3 origin{};
  SkipSets skip;               ///< the batch's
  std::size_t index[capacity]; ///< of the rays in their batch
  alignas(64) double direction[3][capacity];
  alignas(64) double tMin[capacity];
  alignas(64) double tMax[capacity];
  /// For kernels: 1 / direction, and what FilterRay knows.
  ///@{
  alignas(64) double reciprocal[3][capacity];
  alignas(64) double oneNorm[capacity];
  alignas(64) double boundFloor[capacity];
  ///@}
  /// The best hit so far. Its t, as floating point and as exact arithmetic see it, is in
  /// [low, high]; both are infinite where there is none, and -infinity where nothing more matters.
  ///@{
  alignas(64) double low[capacity];
  alignas(64) double high[capacity];
  double t[capacity];
  double u[capacity];
  double v[capacity];
  PrimitiveId primitive[capacity];
  ///@}
  std::uint64_t unsettled = 0; ///< bit i: ray i's t, u, v are to be had by settling the primitive
  std::uint64_t failed = 0;    ///< bit i: what was taken for ray i's best hit is none

private:
  void load(int i);
  bool settleBest(int i);
};

} // namespace lumitree

#endif
