// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Kernel/Settle.h"

#include "Accel/Kernel/ImplicitHits.h"
#include "Accel/Kernel/Precisions.h"
#include "Accel/Kernel/Queries.h"

#include <type_traits>

namespace lumitree
{
namespace
{

template <class PrecisionPolicy, class Query>
void settleCandidate(RayState& state, const Along& vertices, PrimitiveId primitive)
{
  Candidate c;
  c.primitive = primitive;
  if constexpr (std::is_same_v<Query, AnyQuery>)
  {
    // Where is not asked.
    if (surelyHit(state.edges) && surelyBetweenLimits(state.ray, vertices) &&
      !state.skips(primitive))
    {
      AnyQuery::offer<PrecisionPolicy>(state, c);
      return;
    }
  }
  if (!state.skips(primitive) && PrecisionPolicy::settle(state, vertices, c))
  {
    Query::template offer<PrecisionPolicy>(state, c);
  }
}

/// The same of a surface with bodies, whose lanes the filter always keeps.
template <class PrecisionPolicy, class Query>
void settleEither(RayState& state, const Along& vertices, PrimitiveId primitive)
{
  if (state.surface.isTriangle(primitive))
  {
    return settleCandidate<PrecisionPolicy, Query>(state, vertices, primitive);
  }
  if (state.skips(primitive))
  {
    return;
  }
  if (state.surface.isImplicit(primitive))
  {
    for (const Candidate& c :
      implicitHits(state, primitive, PrecisionPolicy::precision, Query::everyRoot))
    {
      Query::template offer<PrecisionPolicy>(state, c);
    }
    return;
  }
  const QuadricHits hits = quadricHits(state, primitive, PrecisionPolicy::precision);
  const int offered = Query::everyRoot ? hits.count : std::min(hits.count, 1);
  for (int i = 0; i < offered; ++i)
  {
    Query::template offer<PrecisionPolicy>(state, hits.hits[static_cast<std::size_t>(i)]);
  }
}

/// Passages through whatever the primitive is.
void settlePassages(RayState& state, const Along& vertices, PrimitiveId primitive)
{
  if (state.surface.isTriangle(primitive))
  {
    return settleCandidate<ExactPassage, CollectQuery>(state, vertices, primitive);
  }
  if (state.skips(primitive))
  {
    return;
  }
  if (state.surface.isImplicit(primitive))
  {
    for (const Candidate& c : implicitPassages(state, primitive))
    {
      CollectQuery::offer<ExactPassage>(state, c);
    }
    return;
  }
  const QuadricHits passages = quadricPassages(state, primitive);
  for (int i = 0; i < passages.count; ++i)
  {
    CollectQuery::offer<ExactPassage>(state, passages.hits[static_cast<std::size_t>(i)]);
  }
}

template <class PrecisionPolicy, class Query>
SettleFunction choose(bool bodies)
{
  return bodies ? settleEither<PrecisionPolicy, Query> : settleCandidate<PrecisionPolicy, Query>;
}

template <class PrecisionPolicy>
SettleFunction forQuery(QueryKind query, bool bodies)
{
  switch (query)
  {
    case QueryKind::Closest:
      return choose<PrecisionPolicy, ClosestQuery>(bodies);
    case QueryKind::Any:
      return choose<PrecisionPolicy, AnyQuery>(bodies);
    case QueryKind::Ties:
      return choose<PrecisionPolicy, TiesQuery>(bodies);
    default:
      return choose<PrecisionPolicy, CollectQuery>(bodies);
  }
}

} // namespace

SettleFunction settleFunction(Precision precision, QueryKind query, bool bodies)
{
  if (query == QueryKind::Crossings)
  {
    return bodies ? settlePassages : settleCandidate<ExactPassage, CollectQuery>;
  }
  switch (precision)
  {
    case Precision::Fast:
      return forQuery<FastPrecision>(query, bodies);
    case Precision::Watertight:
      return forQuery<WatertightPrecision>(query, bodies);
    default:
      return forQuery<ExactPrecision>(query, bodies);
  }
}

} // namespace lumitree
