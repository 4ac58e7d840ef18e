// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BspSave_h
#define Lumitree_Accel_Structures_BspSave_h

#include "Accel/BuildProgress.h"
#include "Accel/Kernel/LeafBlocks.h"
#include "Accel/Save/SaveStream.h"
#include "Accel/Structures/BspNodes.h"
#include "Accel/Surface.h"

namespace lumitree
{

/// Writes the tree's planes.
void saveBspTree(
  const Surface& surface, const BspNodes& tree, const LeafBlocks& blocks, SaveWriter& writer);

/// Divides the surface by the planes that were written. Throws SaveError where a plane is none or
/// does not cut its cell, where there are more than 64 levels below the root, or too many
/// references.
[[nodiscard]] BspNodes loadBspTree(
  const Surface& surface, LeafBlocks& blocks, BuildProgress& progress, SaveReader& reader);

} // namespace lumitree

#endif
