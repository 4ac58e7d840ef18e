// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Rays_LumiDisagreement_h
#define Lumitree_Filters_Rays_LumiDisagreement_h

#include "LumiCast.h"
#include "LumitreeFiltersRaysModule.h"

#include <optional>

namespace lumitree::filters
{

/// How one answer differs from another. The values are those of the array Kind
/// (Docs/data-model.md).
enum class Disagreement : int
{
  Missed = 0,         ///< fewer hits than the other
  Phantom = 1,        ///< more hits than the other
  OtherPrimitive = 2, ///< another primitive, at another t
  Far = 3,            ///< the same primitive, at another t
  Tie = 4             ///< another primitive, at the same t
};
inline constexpr int disagreementKinds = 5;

[[nodiscard]] const char* name(Disagreement kind);

/// A disagreement, and the first hit that shows it, or none where only numbers are known.
struct Difference
{
  Disagreement kind = Disagreement::Missed;
  const Hit* hit = nullptr;   ///< of the first; null where it has none
  const Hit* other = nullptr; ///< of the other
};

/// How the answers of two casts of the same rays differ for one ray; nothing where they agree. t is
/// the same up to tolerance · max(|t|, |other t|).
[[nodiscard]] LUMITREEFILTERSRAYS_EXPORT std::optional<Difference> difference(
  const Cast& cast, const Cast& other, std::size_t ray, double tolerance);

} // namespace lumitree::filters

#endif
