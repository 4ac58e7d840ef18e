// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Kernel/Settle.h"

#include "Accel/Kernel/Precisions.h"
#include "Accel/Kernel/Queries.h"

#include <type_traits>

namespace lumitree
{
namespace
{

template <class PrecisionPolicy, class Query>
void settleCandidate(RayState& state, const Corners& corners, PrimitiveId primitive)
{
  Candidate c;
  c.primitive = primitive;
  if constexpr (std::is_same_v<PrecisionPolicy, ExactPrecision> && std::is_same_v<Query, AnyQuery>)
  {
    // Where is not asked.
    if (surelyHit(state.edges) && surelyBetweenLimits(state.ray, corners) &&
      !state.skips(primitive))
    {
      AnyQuery::offer<ExactPrecision>(state, c);
      return;
    }
  }
  if (!state.skips(primitive) && PrecisionPolicy::settle(state, corners, c))
  {
    Query::template offer<PrecisionPolicy>(state, c);
  }
}

/// The same of a surface with quadrics, whose lanes the filter always keeps.
template <class PrecisionPolicy, class Query>
void settleEither(RayState& state, const Corners& corners, PrimitiveId primitive)
{
  if (!state.surface.isQuadric(primitive))
  {
    return settleCandidate<PrecisionPolicy, Query>(state, corners, primitive);
  }
  if (state.skips(primitive))
  {
    return;
  }
  const QuadricHits hits = quadricHits(state, primitive, PrecisionPolicy::precision);
  const int offered = Query::everyRoot ? hits.count : std::min(hits.count, 1);
  for (int i = 0; i < offered; ++i)
  {
    Query::template offer<PrecisionPolicy>(state, hits.hits[static_cast<std::size_t>(i)]);
  }
}

template <class PrecisionPolicy, class Query>
SettleFunction choose(bool quadrics)
{
  return quadrics ? settleEither<PrecisionPolicy, Query> : settleCandidate<PrecisionPolicy, Query>;
}

template <class PrecisionPolicy>
SettleFunction forQuery(QueryKind query, bool quadrics)
{
  switch (query)
  {
    case QueryKind::Closest:
      return choose<PrecisionPolicy, ClosestQuery>(quadrics);
    case QueryKind::Any:
      return choose<PrecisionPolicy, AnyQuery>(quadrics);
    case QueryKind::Ties:
      return choose<PrecisionPolicy, TiesQuery>(quadrics);
    default:
      return choose<PrecisionPolicy, CollectQuery>(quadrics);
  }
}

} // namespace

SettleFunction settleFunction(Precision precision, QueryKind query, bool quadrics)
{
  if (query == QueryKind::Crossings)
  {
    return settleCandidate<ExactPassage, CollectQuery>;
  }
  switch (precision)
  {
    case Precision::Fast:
      return forQuery<FastPrecision>(query, quadrics);
    case Precision::Watertight:
      return forQuery<WatertightPrecision>(query, quadrics);
    default:
      return forQuery<ExactPrecision>(query, quadrics);
  }
}

} // namespace lumitree
