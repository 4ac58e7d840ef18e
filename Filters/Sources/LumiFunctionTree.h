// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiFunctionTree_h
#define LumiFunctionTree_h

#include "vtkLumiABI.h"

#include "Accel/ImplicitTree.h"

#include <memory>

VTK_ABI_NAMESPACE_BEGIN
class vtkImplicitFunction;
VTK_ABI_NAMESPACE_END

namespace lumitree::filters
{

/// A function as a tree that has its zeros and its signs in the box: vtkSphere, vtkPlane,
/// vtkCylinder, vtkCone, vtkQuadric, vtkBox, vtkPlanes, vtkSuperquadric, and vtkImplicitBoolean of
/// such, all under linear transforms. Null for all others, and where the signs in 216 points of the
/// box are not those of the function.
[[nodiscard]] std::shared_ptr<const ImplicitTree> treeOf(
  vtkImplicitFunction* function, const Box& box);

} // namespace lumitree::filters
#endif
