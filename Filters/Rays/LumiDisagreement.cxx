// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiDisagreement.h"

#include <algorithm>
#include <cmath>

namespace lumitree::filters
{

const char* name(Disagreement kind)
{
  constexpr const char* names[disagreementKinds] = { "Missed", "Phantom", "OtherPrimitive", "Far",
    "Tie" };
  return names[static_cast<int>(kind)];
}

std::optional<Difference> difference(
  const Cast& cast, const Cast& other, std::size_t ray, double tolerance)
{
  const vtkIdType count = cast.count(ray);
  const vtkIdType otherCount = other.count(ray);
  const Hit* hits = cast.givesHits() ? cast.hits(ray) : nullptr;
  const Hit* otherHits = other.givesHits() ? other.hits(ray) : nullptr;
  std::optional<Difference> found;
  for (vtkIdType i = 0; hits && otherHits && i < std::min(count, otherCount) && !found; ++i)
  {
    const Hit& a = hits[i];
    const Hit& b = otherHits[i];
    const bool same = std::abs(a.t - b.t) <= tolerance * std::max(std::abs(a.t), std::abs(b.t));
    if (a.primitive != b.primitive)
    {
      found = Difference{ same ? Disagreement::Tie : Disagreement::OtherPrimitive, &a, &b };
    }
    else if (!same)
    {
      found = Difference{ Disagreement::Far, &a, &b };
    }
  }
  if (count != otherCount)
  {
    // What both have comes first only where it tells of the missing one: else the end of the list.
    const vtkIdType last = std::min(count, otherCount);
    Difference more{ count < otherCount ? Disagreement::Missed : Disagreement::Phantom, nullptr,
      nullptr };
    if (found)
    {
      more.hit = found->hit;
      more.other = found->other;
    }
    else
    {
      more.hit = hits && count > last ? hits + last : nullptr;
      more.other = otherHits && otherCount > last ? otherHits + last : nullptr;
    }
    return more;
  }
  return found;
}

} // namespace lumitree::filters
