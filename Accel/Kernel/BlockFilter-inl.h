// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Included once per instruction set (Highway's scheme), so without an ordinary guard.
#if defined(LUMITREE_BLOCK_FILTER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LUMITREE_BLOCK_FILTER_INL
#undef LUMITREE_BLOCK_FILTER_INL
#else
#define LUMITREE_BLOCK_FILTER_INL
#endif

#include "Accel/Kernel/Simd-inl.h"

#include "Accel/Kernel/EdgeFilter.h"

HWY_BEFORE_NAMESPACE();
namespace lumitree
{
namespace HWY_NAMESPACE
{

/// d · (e x p), in the order of operations of the scalar edgeFunction.
HWY_INLINE Double4 edgeFunctions(const Double4 d[3], const Double4 e[3], const Double4 p[3])
{
  return (d[0] * (e[1] * p[2] - e[2] * p[1]) + d[1] * (e[2] * p[0] - e[0] * p[2])) +
    d[2] * (e[0] * p[1] - e[1] * p[0]);
}

/// The edge functions of a block and the bounds of their errors.
struct BlockEdges
{
  Double4 f[3];
  Double4 error;

  /// As the scalar edgeValues gives them, but for the bound.
  void store(int lane, EdgeValues& e) const
  {
    e.u = this->at(this->f[0], lane);
    e.v = this->at(this->f[1], lane);
    e.w = this->at(this->f[2], lane);
    e.error = this->at(this->error, lane);
  }

private:
  static double at(const Double4& values, int lane)
  {
    HWY_ALIGN double stored[blockWidth];
    values.store(stored);
    return stored[lane];
  }
};

/// A block's edges and the points that its edge functions take, seen from an origin.
struct SeenEdges
{
  /// The edge opposite to vertex i ends in vertex pointOf[i].
  static constexpr int pointOf[3] = { 1, 0, 0 };

  /// Returns the largest of the points' components.
  template <class T>
  HWY_INLINE Double4 from(const Vec3& origin, const TriangleBlock<T>& block)
  {
    Double4 largest = Double4::all(0.0);
    for (int k = 0; k < 3; ++k)
    {
      Double4 vertex[3];
      for (int i = 0; i < 3; ++i)
      {
        vertex[i] = loadDoubles(block.v[3 * i + k]);
      }
      for (int i = 0; i < 3; ++i)
      {
        this->edge[i][k] = vertex[(i + 2) % 3] - vertex[(i + 1) % 3];
      }
      for (int i = 0; i < 2; ++i)
      {
        this->point[i][k] = vertex[i] - Double4::all(origin[k]);
        largest = raise(absolute(this->point[i][k]), largest);
      }
    }
    return largest;
  }

  Double4 edge[3][3];
  Double4 point[2][3];
};

/// The lanes of a block that a precision may count as hit, as bits: lanes whose edge functions
/// certainly have both signs are out.
template <class T>
HWY_INLINE unsigned candidateLanes(
  const FilterRay& ray, const TriangleBlock<T>& block, BlockEdges& edges)
{
  Double4 d[3];
  for (int k = 0; k < 3; ++k)
  {
    d[k] = Double4::all(ray.direction[k]);
  }
  SeenEdges seen;
  const Double4 m = seen.from(ray.origin, block);
  auto& f = edges.f;
  for (int i = 0; i < 3; ++i)
  {
    f[i] = edgeFunctions(d, seen.edge[i], seen.point[SeenEdges::pointOf[i]]);
  }
  auto& error = edges.error;
  error = Double4::all(2.0 * block.edge) * m * Double4::all(ray.oneNorm) *
      Double4::all(FilterRay::edgeBound / 2) +
    Double4::all(ray.boundFloor);
  const Double4 below = Double4::all(0.0) - error;
  const auto negative = lower(f[0], lower(f[1], f[2])) < below;
  const auto positive = error < raise(f[0], raise(f[1], f[2]));
  return ~(negative & positive).bits() & ((1u << blockWidth) - 1u);
}

} // namespace HWY_NAMESPACE
} // namespace lumitree
HWY_AFTER_NAMESPACE();

#endif
