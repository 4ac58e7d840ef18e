// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_Grid_h
#define Lumitree_Accel_Structures_Grid_h

#include "Accel/Accelerator.h"

namespace lumitree
{

class SaveReader;

/// A uniform grid over the surface's bounds; BuildOptions::gridDensity and gridResolution say how
/// fine.
[[nodiscard]] std::shared_ptr<const Accelerator> buildGrid(std::shared_ptr<const Surface> surface,
  const BuildOptions& options, JobControl* control = nullptr);

/// From what it saved.
[[nodiscard]] std::shared_ptr<const Accelerator> loadGrid(std::shared_ptr<const Surface> surface,
  const BuildOptions& options, SaveReader& reader, JobControl* control);

} // namespace lumitree

#endif
