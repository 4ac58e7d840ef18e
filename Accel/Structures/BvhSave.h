// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BvhSave_h
#define Lumitree_Accel_Structures_BvhSave_h

#include "Accel/Save/SaveStream.h"
#include "Accel/Structures/BvhNodes.h"

namespace lumitree
{

/// Writes which nodes there are and what the leaves hold; with parts also the leaves' boxes.
void saveBvh(const BvhNodes& bvh, bool parts, SaveWriter& writer);

/// The nodes that were written, with boxes of the surface's coordinates. Throws SaveError where
/// they are no binary tree of at most 64 levels below the root over all that can be hit.
[[nodiscard]] BvhNodes loadBvh(
  const Surface& surface, bool parts, SaveReader& reader, BuildProgress& progress);

/// The same nodes over a surface whose points have moved; what can no longer be hit is taken out.
[[nodiscard]] BvhNodes refitBvh(
  const Surface& surface, const BvhNodes& before, BuildProgress& progress);

} // namespace lumitree

#endif
