// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_Octree_h
#define Lumitree_Accel_Structures_Octree_h

#include "Accel/Accelerator.h"

namespace lumitree
{

class SaveReader;

/// A cube around the surface's bounds, halved along all three axes for as long as OctreeBuilder.h
/// says.
[[nodiscard]] std::shared_ptr<const Accelerator> buildOctree(std::shared_ptr<const Surface> surface,
  const BuildOptions& options, JobControl* control = nullptr);

/// From what it saved.
[[nodiscard]] std::shared_ptr<const Accelerator> loadOctree(std::shared_ptr<const Surface> surface,
  const BuildOptions& options, SaveReader& reader, JobControl* control);

} // namespace lumitree

#endif
