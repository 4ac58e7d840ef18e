// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef Lumitree_Accel_Reference_CGAL_CgalAccelerator_h
#define Lumitree_Accel_Reference_CGAL_CgalAccelerator_h

#include "Accel/Accelerator.h"

namespace lumitree
{

/// The accelerators behind Structure::Cgal, CgalEpick and CgalCartesian; README.md says what each
/// promises.
///@{
[[nodiscard]] std::shared_ptr<const Accelerator> buildCgal(std::shared_ptr<const Surface> surface,
  const BuildOptions& options, JobControl* control = nullptr);
[[nodiscard]] std::shared_ptr<const Accelerator> buildCgalEpick(
  std::shared_ptr<const Surface> surface, const BuildOptions& options,
  JobControl* control = nullptr);
[[nodiscard]] std::shared_ptr<const Accelerator> buildCgalCartesian(
  std::shared_ptr<const Surface> surface, const BuildOptions& options,
  JobControl* control = nullptr);
///@}

} // namespace lumitree

#endif
