// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Reference_Embree_EmbreeAccelerator_h
#define Lumitree_Accel_Reference_Embree_EmbreeAccelerator_h

#include "Accel/Accelerator.h"

namespace lumitree
{

/// The accelerator behind Structure::Embree; README.md says what it promises.
[[nodiscard]] std::shared_ptr<const Accelerator> buildEmbree(std::shared_ptr<const Surface> surface,
  const BuildOptions& options, JobControl* control = nullptr);

} // namespace lumitree

#endif
