// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_WideBvh_h
#define Lumitree_Accel_Structures_WideBvh_h

#include "Accel/Accelerator.h"

namespace lumitree
{

class SaveReader;

/// A bounding volume hierarchy of eight children a node, collapsed from a binary one: the structure
/// for production.
[[nodiscard]] std::shared_ptr<const Accelerator> buildWideBvh(
  std::shared_ptr<const Surface> surface, const BuildOptions& options,
  JobControl* control = nullptr);

/// From what it saved.
[[nodiscard]] std::shared_ptr<const Accelerator> loadWideBvh(std::shared_ptr<const Surface> surface,
  const BuildOptions& options, SaveReader& reader, JobControl* control);

} // namespace lumitree

#endif
