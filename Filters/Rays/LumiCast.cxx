// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiCast.h"

namespace lumitree::filters
{

Cast::Cast(QueryKind query, const Accelerator& accelerator, const RayBatch& rays,
  const QueryOptions& options)
  : query_(query)
  , size_(rays.size)
  , nearest_(query == QueryKind::Closest ? rays.size : 0)
  , any_(query == QueryKind::Any ? rays.size : 0)
  , counts_(query == QueryKind::Count || query == QueryKind::Crossings ? rays.size : 0)
{
  switch (query)
  {
    case QueryKind::Closest:
      this->report_ = accelerator.closest(rays, this->nearest_.data(), options);
      break;
    case QueryKind::Any:
      this->report_ = accelerator.any(rays, this->any_.data(), options);
      break;
    case QueryKind::All:
      this->report_ = accelerator.all(rays, this->all_, options);
      break;
    case QueryKind::Count:
      this->report_ = accelerator.count(rays, this->counts_.data(), options);
      break;
    case QueryKind::Crossings:
      this->report_ = accelerator.crossings(rays, this->counts_.data(), options);
      break;
    case QueryKind::Ties:
      this->report_ = accelerator.ties(rays, this->all_, options);
      break;
  }
}

vtkIdType Cast::count(std::size_t ray) const
{
  vtkIdType result = 0;
  this->withCounts([&](auto countOf) { result = countOf(ray); });
  return result;
}

} // namespace lumitree::filters
