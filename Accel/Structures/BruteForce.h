// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BruteForce_h
#define Lumitree_Accel_Structures_BruteForce_h

#include "Accel/Accelerator.h"

namespace lumitree
{

class SaveReader;

/// Every primitive is tested against every ray: no hierarchy, the oracle for all others.
[[nodiscard]] std::shared_ptr<const Accelerator> buildBruteForce(
  std::shared_ptr<const Surface> surface, const BuildOptions& options,
  JobControl* control = nullptr);

/// From what it saved.
[[nodiscard]] std::shared_ptr<const Accelerator> loadBruteForce(
  std::shared_ptr<const Surface> surface, const BuildOptions& options, SaveReader& reader,
  JobControl* control);

} // namespace lumitree

#endif
