// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_OctreeSave_h
#define Lumitree_Accel_Structures_OctreeSave_h

#include "Accel/Save/SaveStream.h"
#include "Accel/Structures/OctreeBuilder.h"

namespace lumitree
{

/// Writes which nodes are divided.
void saveOctree(const OctreeNodes& tree, SaveWriter& writer);

/// Divides the surface into the octants that were divided. Throws SaveError where that gives
/// another number of nodes, more than 21 levels below the root, or too many references.
[[nodiscard]] OctreeNodes loadOctree(
  const Surface& surface, BuildProgress& progress, SaveReader& reader);

} // namespace lumitree

#endif
