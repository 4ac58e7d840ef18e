// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiReplicate_h
#define LumiReplicate_h

#include "LumiSharedSurface.h"

#include "vtkPolyData.h"

namespace lumitree::filters
{

/// A leaf's triangles as a dataset that can be sent to other ranks: the points in use, with the
/// original ids, and on request the leaf's point and cell arrays (a triangle has its cell's tuple).
[[nodiscard]] vtkSmartPointer<vtkPolyData> pack(
  const LeafTriangles& triangles, vtkDataSet* leaf, std::int64_t compositeIndex, bool arrays);

/// What another rank packed. Throws std::runtime_error when something was lost on the way.
[[nodiscard]] SurfacePart unpack(vtkPolyData* packed, int process);

} // namespace lumitree::filters
#endif
