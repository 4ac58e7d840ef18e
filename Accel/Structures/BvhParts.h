// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BvhParts_h
#define Lumitree_Accel_Structures_BvhParts_h

#include "Accel/Structures/BvhLeaves.h"

namespace lumitree
{

/// For each reference of leaves with boxes of parts the box of what that leaf has of the primitive:
/// all of it where it lies in one leaf only, and where the boxes of its leaves together are not
/// shown to cover it. leaf i begins at firsts[i].
[[nodiscard]] std::vector<Box> boxesOfParts(const Surface& surface, const BvhLeaves& leaves,
  const std::vector<std::size_t>& firsts, BuildProgress& progress);

/// Whether closed boxes certainly hold every point of a primitive between them. False also where
/// that takes more than a few hundred steps to find out.
[[nodiscard]] bool cover(
  const Surface& surface, PrimitiveId primitive, const std::vector<Box>& boxes);

} // namespace lumitree

#endif
