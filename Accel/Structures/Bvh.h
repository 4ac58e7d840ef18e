// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_Bvh_h
#define Lumitree_Accel_Structures_Bvh_h

#include "Accel/Accelerator.h"

namespace lumitree
{

class SaveReader;

/// A binary bounding volume hierarchy, built as BuildOptions::bvhBuild says.
[[nodiscard]] std::shared_ptr<const Accelerator> buildBvh(std::shared_ptr<const Surface> surface,
  const BuildOptions& options, JobControl* control = nullptr);

/// From what it saved.
[[nodiscard]] std::shared_ptr<const Accelerator> loadBvh(std::shared_ptr<const Surface> surface,
  const BuildOptions& options, SaveReader& reader, JobControl* control);

} // namespace lumitree

#endif
