// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef Lumitree_Accel_Reference_CGAL_CgalAccelerator_h
#define Lumitree_Accel_Reference_CGAL_CgalAccelerator_h

#include "Accel/Accelerator.h"

namespace lumitree
{

/// The accelerator behind Structure::Cgal; README.md says what it promises.
[[nodiscard]] std::shared_ptr<const Accelerator> buildCgal(std::shared_ptr<const Surface> surface,
  const BuildOptions& options, JobControl* control = nullptr);

} // namespace lumitree

#endif
