// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BspTree_h
#define Lumitree_Accel_Structures_BspTree_h

#include "Accel/Accelerator.h"

namespace lumitree
{

class SaveReader;

/// A binary space partition by general planes, chosen by the surface-area heuristic among planes
/// across an axis and planes of triangles: convex cells, triangles in every leaf they reach into.
[[nodiscard]] std::shared_ptr<const Accelerator> buildBspTree(
  std::shared_ptr<const Surface> surface, const BuildOptions& options,
  JobControl* control = nullptr);

/// From what it saved.
[[nodiscard]] std::shared_ptr<const Accelerator> loadBspTree(std::shared_ptr<const Surface> surface,
  const BuildOptions& options, SaveReader& reader, JobControl* control);

} // namespace lumitree

#endif
