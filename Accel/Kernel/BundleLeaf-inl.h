// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Included once per instruction set (Highway's scheme), so without an ordinary guard.
#if defined(LUMITREE_BUNDLE_LEAF_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LUMITREE_BUNDLE_LEAF_INL
#undef LUMITREE_BUNDLE_LEAF_INL
#else
#define LUMITREE_BUNDLE_LEAF_INL
#endif

#include "Accel/Kernel/BlockFilter-inl.h"

#include "Accel/Kernel/RayBundle.h"

HWY_BEFORE_NAMESPACE();
namespace lumitree
{
namespace HWY_NAMESPACE
{

using Double8 = Pack<double, 8>;
/// So many rays of a bundle are tested at once.
constexpr int bundleStep = 8;

/// What the filter needs of the rays.
HWY_INLINE void prepare(RayBundle& bundle)
{
  for (int i = 0; i < RayBundle::capacity; i += bundleStep)
  {
    const Double8 d[3] = { Double8::load(bundle.direction[0] + i),
      Double8::load(bundle.direction[1] + i), Double8::load(bundle.direction[2] + i) };
    const Double8 oneNorm = absolute(d[0]) + absolute(d[1]) + absolute(d[2]);
    oneNorm.store(bundle.oneNorm + i);
    (Double8::all(0x1p-1020) * (Double8::all(1.0) + oneNorm)).store(bundle.boundFloor + i);
    for (int k = 0; k < 3; ++k)
    {
      (Double8::all(1.0) / d[k]).store(bundle.reciprocal[k] + i);
    }
  }
}

/// What the filter needs of a block of triangles and the point where the rays start: the edge
/// functions are direction · cross[i].
struct SeenBlock
{
  HWY_ALIGN double cross[3][3][blockWidth];
  HWY_ALIGN double along[3][blockWidth]; ///< the vertices less the origin, along the bundle's axis
  HWY_ALIGN double bound[blockWidth];    ///< of an edge function's error, per |direction|_1
};

/// In the order of operations of candidateLanes.
template <class T>
HWY_INLINE void see(const RayBundle& bundle, const TriangleBlock<T>& block, SeenBlock& seen)
{
  SeenEdges edges;
  const Double4 m = edges.from(bundle.origin, block);
  for (int i = 0; i < 3; ++i)
  {
    const Double4* const e = edges.edge[i];
    const Double4* const p = edges.point[SeenEdges::pointOf[i]];
    (e[1] * p[2] - e[2] * p[1]).store(seen.cross[i][0]);
    (e[2] * p[0] - e[0] * p[2]).store(seen.cross[i][1]);
    (e[0] * p[1] - e[1] * p[0]).store(seen.cross[i][2]);
    (loadDoubles(block.v[3 * i + bundle.axis]) - Double4::all(bundle.origin[bundle.axis]))
      .store(seen.along[i]);
  }
  // Four roundings, as there: the last two are the factor |direction|_1 and the floor.
  (Double4::all(2.0 * block.edge) * m * Double4::all(FilterRay::edgeBound / 2)).store(seen.bound);
}

/// A triangle and eight rays of which some may hit it.
struct BundleCandidates
{
  int first; ///< ray of lane 0
  unsigned lanes;
  Double8 f[3];
  Double8 error;
};

/// Whether t, positive, is the key of a hit of a triangle that is certainly met (OrderByKey): it is
/// not before the padded entry of the triangle's own box, by the arithmetic of RayBox.
HWY_INLINE Lanes<Double8> isKey(
  const RayBundle& bundle, const Corners& corners, int first, const Double8& t)
{
  Double8 enter = Double8::all(-std::numeric_limits<double>::infinity());
  for (int k = 0; k < 3; ++k)
  {
    const bool negative = std::signbit(bundle.direction[k][0]);
    const double plane = negative ? std::max(std::max(corners[0][k], corners[1][k]), corners[2][k])
                                  : std::min(std::min(corners[0][k], corners[1][k]), corners[2][k]);
    enter = raise(
      Double8::all(plane - bundle.origin[k]) * Double8::load(bundle.reciprocal[k] + first), enter);
  }
  return enter * Double8::all(1.0 - RayBox::relativePad) - Double8::all(RayBox::absolutePad) <= t;
}

/// The lanes whose rays are to skip the primitive.
inline unsigned skipping(const RayBundle& bundle, const BundleCandidates& c, PrimitiveId id)
{
  unsigned skipped = 0;
  for (unsigned rest = bundle.skip.offsets ? c.lanes : 0; rest != 0; rest &= rest - 1)
  {
    const auto lane = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero32(rest));
    skipped |= bundle.skips(c.first + lane, id) ? 1u << lane : 0u;
  }
  return skipped;
}

/// Decides about the candidates; returns the lanes whose best hit has changed. Where t, u and v are
/// taken from here they are those of the function `crossing`, by the same operations; so is the
/// interval of t, but with twice the pad: it holds that function's t as well as the exact one, and
/// that function's interval. If it is narrow, t is not vague (Finish.cxx).
template <class T>
HWY_NOINLINE unsigned resolve(RayBundle& bundle, const SeenBlock& seen,
  const TriangleBlock<T>& block, int triangle, const BundleCandidates& c)
{
  const auto ofRays = [&](const double* values) HWY_ATTR
  { return Double8::load(values + c.first); };
  const Corners corners = block.corners(triangle);
  const double a[3] = { seen.along[0][triangle], seen.along[1][triangle], seen.along[2][triangle] };
  const double nearest = std::min(std::min(a[0], a[1]), a[2]);
  const double farthest = std::max(std::max(a[0], a[1]), a[2]);
  const double rounding = 0x1p-49 * std::max(std::fabs(nearest), std::fabs(farthest)) + 0x1p-1020;

  const Double8 none = Double8::all(0.0);
  const auto surelyNegative = raise(c.f[0], raise(c.f[1], c.f[2])) < none - c.error;
  const auto surelyPositive = c.error < lower(c.f[0], lower(c.f[1], c.f[2]));
  const Double8 weights[3] = { absolute(c.f[0]), absolute(c.f[1]), absolute(c.f[2]) };
  const Double8 sum = weights[0] + weights[1] + weights[2];
  const Double8 share = Double8::all(1.0) / sum;
  const Double8 u = weights[1] * share;
  const Double8 v = weights[2] * share;
  const Double8 mean = lower(raise((weights[0] * share) * Double8::all(a[0]) +
                                 (u * Double8::all(a[1]) + v * Double8::all(a[2])),
                               Double8::all(nearest)),
    Double8::all(farthest));
  const Double8 relative = c.error * share;
  const Double8 pad =
    relative * Double8::all(8.0 * (farthest - nearest)) + Double8::all(2.0 * rounding);
  const Double8 perAxis = ofRays(bundle.reciprocal[bundle.axis]);
  const Double8 t = mean / ofRays(bundle.direction[bundle.axis]);
  const Double8 one = (mean - pad) * perAxis;
  const Double8 other = (mean + pad) * perAxis;
  Double8 low = lower(one, other);
  Double8 high = raise(one, other);
  low = low - (absolute(low) * Double8::all(0x1p-50) + Double8::all(0x1p-1020));
  high = high + (absolute(high) * Double8::all(0x1p-50) + Double8::all(0x1p-1020));

  const auto certain = (surelyNegative | surelyPositive) & (relative < Double8::all(0x1p-4)) &
    (Double8::all(0x1p-1020) <= sum) & (sum <= Double8::all(std::numeric_limits<double>::max()));
  const auto plain = bundle.exact ? (high - low) < absolute(t) * Double8::all(0x1p-27)
                                  : isKey(bundle, corners, c.first, t);
  const auto between = (ofRays(bundle.tMin) < low) & (high < ofRays(bundle.tMax));
  const auto nearer = high < ofRays(bundle.low);
  const auto beyond = certain & (ofRays(bundle.high) < low);
  const unsigned wanted = c.lanes & ~skipping(bundle, c, block.id[triangle]);
  const unsigned better = (certain & plain & between & nearer).bits() & wanted;
  const unsigned worse = beyond.bits() & wanted;

  unsigned changed = better;
  if (better != 0)
  {
    HWY_ALIGN double values[5][bundleStep];
    low.store(values[0]);
    high.store(values[1]);
    t.store(values[2]);
    u.store(values[3]);
    v.store(values[4]);
    const double nothingMatters = -std::numeric_limits<double>::infinity();
    for (unsigned rest = better; rest != 0; rest &= rest - 1)
    {
      const auto lane = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero32(rest));
      const int ray = c.first + lane;
      bundle.low[ray] = bundle.any ? nothingMatters : values[0][lane];
      bundle.high[ray] = bundle.any ? nothingMatters : values[1][lane];
      bundle.t[ray] = values[2][lane];
      bundle.u[ray] = values[3][lane];
      bundle.v[ray] = values[4][lane];
      bundle.primitive[ray] = block.id[triangle];
    }
    bundle.unsettled &= ~(static_cast<std::uint64_t>(better) << c.first);
  }
  for (unsigned rest = wanted & ~(better | worse); rest != 0; rest &= rest - 1)
  {
    const auto lane = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero32(rest));
    bundle.settle(c.first + lane, corners, block.id[triangle]);
    changed |= 1u << lane;
  }
  return changed;
}

/// Tests a leaf against the rays whose bits are set; returns those whose best hit has changed.
template <class T>
HWY_INLINE std::uint64_t testLeafTogether(
  RayBundle& bundle, const TriangleBlocks<T>& blocks, const Span& span, std::uint64_t rays)
{
  std::uint64_t changed = 0;
  const std::uint32_t blockCount = (span.count + blockWidth - 1) / blockWidth;
  for (std::uint32_t b = 0; b < blockCount; ++b)
  {
    const TriangleBlock<T>& block = blocks[span.firstBlock + b];
    SeenBlock seen;
    see(bundle, block, seen);
    for (int triangle = 0; triangle < blockWidth && block.id[triangle] != noPrimitive; ++triangle)
    {
      for (int first = 0; first < RayBundle::capacity; first += bundleStep)
      {
        const auto asked = static_cast<unsigned>(rays >> first) & ((1u << bundleStep) - 1);
        if (asked == 0)
        {
          continue;
        }
        BundleCandidates c;
        const Double8 d[3] = { Double8::load(bundle.direction[0] + first),
          Double8::load(bundle.direction[1] + first), Double8::load(bundle.direction[2] + first) };
        for (int i = 0; i < 3; ++i)
        {
          c.f[i] = (d[0] * Double8::all(seen.cross[i][0][triangle]) +
                     d[1] * Double8::all(seen.cross[i][1][triangle])) +
            d[2] * Double8::all(seen.cross[i][2][triangle]);
        }
        c.error = Double8::all(seen.bound[triangle]) * Double8::load(bundle.oneNorm + first) +
          Double8::load(bundle.boundFloor + first);
        const Double8 below = Double8::all(0.0) - c.error;
        const auto negative = lower(c.f[0], lower(c.f[1], c.f[2])) < below;
        const auto positive = c.error < raise(c.f[0], raise(c.f[1], c.f[2]));
        c.first = first;
        c.lanes = ~(negative & positive).bits() & asked;
        if (c.lanes != 0)
        {
          changed |= static_cast<std::uint64_t>(resolve(bundle, seen, block, triangle, c)) << first;
        }
      }
    }
  }
  return changed;
}

} // namespace HWY_NAMESPACE
} // namespace lumitree
HWY_AFTER_NAMESPACE();

#endif
