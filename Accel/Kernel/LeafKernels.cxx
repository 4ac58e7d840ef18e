// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Kernel/LeafKernels.h"

#include "Accel/Kernel/Precisions.h"
#include "Accel/Kernel/Queries.h"

namespace lumitree
{
namespace
{

template <class T, class PrecisionPolicy, class Query>
void testLeaf(RayState& state, const void* store, const Span& span)
{
  const auto& blocks = *static_cast<const TriangleBlocks<T>*>(store);
  const std::uint32_t blockCount = (span.count + blockWidth - 1) / blockWidth;
  EdgeBlock edges;
  for (std::uint32_t b = 0; b < blockCount; ++b)
  {
    const TriangleBlock<T>& block = blocks[span.firstBlock + b];
    edgeFunctions(state.filter, block, edges);
    for (int lane = 0; lane < blockWidth; ++lane)
    {
      const EdgeValues e = { edges.u[lane], edges.v[lane], edges.w[lane], edges.error[lane] };
      Candidate c;
      c.primitive = block.id[lane];
      if (PrecisionPolicy::mayHit(e) && c.primitive != noPrimitive && !state.skips(c.primitive) &&
        PrecisionPolicy::settle(state, c))
      {
        Query::template offer<PrecisionPolicy>(state, c);
      }
    }
  }
}

template <class T, class PrecisionPolicy>
LeafKernel forQuery(QueryKind query)
{
  switch (query)
  {
    case QueryKind::Closest:
      return testLeaf<T, PrecisionPolicy, ClosestQuery>;
    case QueryKind::Any:
      return testLeaf<T, PrecisionPolicy, AnyQuery>;
    default:
      return testLeaf<T, PrecisionPolicy, CollectQuery>;
  }
}

template <class T>
LeafKernel forPrecision(Precision precision, QueryKind query)
{
  switch (precision)
  {
    case Precision::Fast:
      return forQuery<T, FastPrecision>(query);
    case Precision::Watertight:
      return forQuery<T, WatertightPrecision>(query);
    default:
      return forQuery<T, ExactPrecision>(query);
  }
}

} // namespace

LeafKernel leafKernel(ArrayView::Scalar scalar, Precision precision, QueryKind query)
{
  return scalar == ArrayView::Scalar::Float ? forPrecision<float>(precision, query)
                                            : forPrecision<double>(precision, query);
}

void arrange(RayState& state, Precision precision)
{
  switch (precision)
  {
    case Precision::Fast:
      return arrange<FastPrecision>(state);
    case Precision::Watertight:
      return arrange<WatertightPrecision>(state);
    default:
      return arrange<ExactPrecision>(state);
  }
}

Hit finish(const RayState& state, PrimitiveId primitive, Precision precision)
{
  const auto vertices = state.surface.vertices(primitive);
  const Crossing x = crossing(state.filter, vertices);
  Hit hit;
  hit.primitive = primitive;
  hit.t = x.t;
  hit.u = x.u;
  hit.v = x.v;
  // Half a float ulp is 2^-25 of t at least: a wider interval does not decide the float nearest to t.
  if (precision == Precision::Exact && x.tHigh - x.tLow > 0x1p-26 * std::fabs(x.t))
  {
    hit.t = exact::crossingParameter(state.ray, vertices);
  }
  else
  {
    hit.t = std::min(std::max(hit.t, state.ray.tMin), state.ray.tMax);
  }
  return hit;
}

} // namespace lumitree
