// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_RayState_h
#define Lumitree_Accel_Kernel_RayState_h

#include "Accel/Kernel/Crossing.h"
#include "Accel/Kernel/RayBox.h"
#include "Accel/Kernel/Span.h"

#include <algorithm>
#include <vector>

namespace lumitree
{

/// A primitive that a ray hits, as far as the precision asked for can tell.
struct Candidate
{
  PrimitiveId primitive = noPrimitive;
  std::uint16_t root = 0; ///< of a quadric: 0 the lower, 1 the upper of two; of an implicit any
  std::uint8_t flags = 0; ///< HitFlag
  double key = std::numeric_limits<double>::infinity(); ///< what Fast and Watertight order by
  double t = 0.0;
  double tLow = 0.0;
  double tHigh = 0.0;
  double u = 0.0;
  double v = 0.0;

  void take(const Crossing& x)
  {
    this->key = x.t;
    this->t = x.t;
    this->tLow = x.tLow;
    this->tHigh = x.tHigh;
    this->u = x.u;
    this->v = x.v;
  }
};

using Corners = std::array<Vec3, 3>;

struct RayState;

/// Decides about one primitive that the filter could not rule out; vertices are a triangle's.
using SettleFunction = void (*)(RayState& state, const Along& vertices, PrimitiveId primitive);

/// All that one ray carries through a structure. Reused from ray to ray, so that found keeps its
/// memory.
struct RayState
{
  explicit RayState(const Surface& s)
    : surface(s)
    , box_(Ray{})
  {
  }

  /// To be called when there is another ray.
  void start()
  {
    this->ray.prepare();
    this->hasBox_ = false;
    this->tStop = this->ray.tMax;
    this->best.primitive = noPrimitive;
    this->best.key = std::numeric_limits<double>::infinity();
    this->found.clear();
  }

  /// Made when it is first asked for: not every walk and precision needs it.
  [[nodiscard]] const RayBox& box()
  {
    if (!this->hasBox_)
    {
      this->box_ = RayBox(this->ray);
      this->hasBox_ = true;
    }
    return this->box_;
  }

  [[nodiscard]] bool skips(PrimitiveId id) const
  {
    return this->skipFirst != this->skipLast &&
      std::binary_search(this->skipFirst, this->skipLast, id);
  }

  /// The set of the ray at index.
  void setSkips(const SkipSets& skip)
  {
    if (skip.offsets)
    {
      this->skipFirst = skip.first(this->index);
      this->skipLast = skip.last(this->index);
    }
  }

  const Surface& surface;
  std::size_t index = 0; ///< of the ray in its batch
  SettleFunction settle = nullptr;
  bool anyHit = false; ///< any hit answers the query, so nearer ones need not come first
  FilterRay ray;
  EdgeValues edges; ///< of the candidate to be settled, with its block's bound
  const PrimitiveId* skipFirst = nullptr;
  const PrimitiveId* skipLast = nullptr;

  double tStop = 0.0;           ///< nothing beyond matters
  Candidate best;               ///< Closest, Any
  std::vector<Candidate> found; ///< All, Count, Crossings, Ties
  /// What the filter could not decide, and t that exact arithmetic rounded, over all rays so far.
  ///@{
  std::uint64_t exactTests = 0;
  std::uint64_t exactParameters = 0;
  ///@}

  /// The ray, if any, along which an order could not be certified.
  std::size_t uncertainOrder = std::numeric_limits<std::size_t>::max();
  /// Implicits whose hits along a ray have been offered: found once, however many leaves hold them.
  ///@{
  std::size_t implicitsRay = std::numeric_limits<std::size_t>::max();
  std::vector<PrimitiveId> implicits;
  ///@}

private:
  RayBox box_;
  bool hasBox_ = false;
};

} // namespace lumitree

#endif
