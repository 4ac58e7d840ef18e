// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_KdTree_h
#define Lumitree_Accel_Structures_KdTree_h

#include "Accel/Accelerator.h"

namespace lumitree
{

class SaveReader;

/// A KD-tree, built as BuildOptions::kdBuild says: cells that do not overlap, triangles in every
/// leaf they reach into. With the spatial median, cells of up to leafSize triangles are leaves; the
/// surface-area heuristic stops where splitting no longer pays.
[[nodiscard]] std::shared_ptr<const Accelerator> buildKdTree(std::shared_ptr<const Surface> surface,
  const BuildOptions& options, JobControl* control = nullptr);

/// From what it saved.
[[nodiscard]] std::shared_ptr<const Accelerator> loadKdTree(std::shared_ptr<const Surface> surface,
  const BuildOptions& options, SaveReader& reader, JobControl* control);

} // namespace lumitree

#endif
