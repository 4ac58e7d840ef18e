// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BvhBuilder_h
#define Lumitree_Accel_Structures_BvhBuilder_h

#include "Accel/BuildOptions.h"
#include "Accel/BuildProgress.h"
#include "Accel/Structures/BvhTree.h"
#include "Accel/Surface.h"

namespace lumitree
{

/// Builds the binary hierarchy that BuildOptions::bvhBuild asks for over a surface that is not
/// empty. The same for any number of threads.
///
/// Leaves hold up to leafSize primitives; of up to four there is always a leaf, as leaf tests go by
/// blocks of four. Where the depth left only just suffices for halving, nodes are halved. At
/// maxDepth a node becomes a leaf whatever it holds.
[[nodiscard]] BvhTree buildBvhTree(
  const Surface& surface, const BuildOptions& options, BuildProgress& progress);

} // namespace lumitree

#endif
