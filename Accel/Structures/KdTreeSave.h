// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_KdTreeSave_h
#define Lumitree_Accel_Structures_KdTreeSave_h

#include "Accel/BuildProgress.h"
#include "Accel/Kernel/LeafBlocks.h"
#include "Accel/Save/SaveStream.h"
#include "Accel/Structures/KdTreeNodes.h"
#include "Accel/Surface.h"

namespace lumitree
{

/// Writes the tree's planes.
void saveKdTree(
  const Surface& surface, const KdTreeNodes& tree, const LeafBlocks& blocks, SaveWriter& writer);

/// Divides the surface by the planes that were written. Throws SaveError where a plane lies outside
/// its cell, where there are more than 64 levels below the root, or too many references.
[[nodiscard]] KdTreeNodes loadKdTree(
  const Surface& surface, LeafBlocks& blocks, BuildProgress& progress, SaveReader& reader);

} // namespace lumitree

#endif
