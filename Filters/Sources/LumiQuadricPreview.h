// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiQuadricPreview_h
#define LumiQuadricPreview_h

#include "vtkLumiABI.h"
#include "vtkSmartPointer.h"

#include "Accel/Quadric.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace lumitree::filters
{

/// Triangles near a quadric, to look at: the form sampled at resolution + 1 positions an axis of
/// the clip box, its zero contour drawn nearer by its gradient and cut by the cuts and the bound.
/// Point normals (double) are the form's, pointing to where it grows. Empty where nothing can be
/// sampled.
[[nodiscard]] vtkSmartPointer<vtkPolyData> previewOf(const Quadric& quadric, int resolution);

/// The same of where a function is 0 in a box. Functions without a change of sign show nothing.
[[nodiscard]] vtkSmartPointer<vtkPolyData> previewOf(
  const ImplicitFunction& function, const Box& clip, int resolution);

} // namespace lumitree::filters
#endif
