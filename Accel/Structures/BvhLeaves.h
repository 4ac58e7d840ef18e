// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BvhLeaves_h
#define Lumitree_Accel_Structures_BvhLeaves_h

#include "Accel/BuildProgress.h"
#include "Accel/Save/SaveStream.h"
#include "Accel/Surface.h"

#include <cstdint>
#include <vector>

namespace lumitree
{

/// The leaves of a hierarchy of boxes, in its order: what stays of it when points move, and what is
/// saved. A primitive lies in one leaf, or, where boxes are around parts of primitives, in several.
struct BvhLeaves
{
  std::vector<std::uint32_t> sizes;
  std::vector<PrimitiveId> references; ///< leaf after leaf
  std::vector<Box> boxes;              ///< of the leaves; of saved ones only where there are parts
};

/// Whether every primitive that can be hit is among them.
[[nodiscard]] bool holdAll(const Surface& surface, const std::vector<PrimitiveId>& references);

/// Takes out what cannot be hit. Leaves may become empty.
void keepHittable(const Surface& surface, BvhLeaves& leaves);

/// Makes the boxes those of the primitives' coordinates, exactly; that of an empty leaf is empty.
/// With boxes at hand, a primitive in several leaves extends each by its part in the leaf's box at
/// hand, where these parts are shown to be all of it, and else by all of itself. So whatever boxes
/// were at hand, every point of a primitive lies in the box of a leaf that holds it.
void fitBoxes(const Surface& surface, BvhLeaves& leaves, BuildProgress& progress);

void saveLeaves(const BvhLeaves& leaves, SaveWriter& writer);

/// So many leaves, with the boxes of parts if there are such. Throws SaveError
/// where they do not hold what can be hit, each primitive once unless there are parts.
[[nodiscard]] BvhLeaves loadLeaves(
  const Surface& surface, std::size_t count, bool parts, SaveReader& reader);

} // namespace lumitree

#endif
