// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Kernel/Settle.h"

#include "Accel/Kernel/Precisions.h"
#include "Accel/Kernel/Queries.h"

namespace lumitree
{
namespace
{

template <class PrecisionPolicy, class Query>
void settleCandidate(RayState& state, const Corners& corners, PrimitiveId primitive)
{
  Candidate c;
  c.primitive = primitive;
  if (!state.skips(primitive) && PrecisionPolicy::settle(state, corners, c))
  {
    Query::template offer<PrecisionPolicy>(state, c);
  }
}

template <class PrecisionPolicy>
SettleFunction forQuery(QueryKind query)
{
  switch (query)
  {
    case QueryKind::Closest:
      return settleCandidate<PrecisionPolicy, ClosestQuery>;
    case QueryKind::Any:
      return settleCandidate<PrecisionPolicy, AnyQuery>;
    default:
      return settleCandidate<PrecisionPolicy, CollectQuery>;
  }
}

} // namespace

SettleFunction settleFunction(Precision precision, QueryKind query)
{
  switch (precision)
  {
    case Precision::Fast:
      return forQuery<FastPrecision>(query);
    case Precision::Watertight:
      return forQuery<WatertightPrecision>(query);
    default:
      return forQuery<ExactPrecision>(query);
  }
}

} // namespace lumitree
