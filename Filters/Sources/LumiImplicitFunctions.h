// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiImplicitFunctions_h
#define LumiImplicitFunctions_h

#include "vtkLumiABI.h"

#include "Accel/Quadric.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkImplicitFunction;
VTK_ABI_NAMESPACE_END

namespace lumitree::filters
{

/// The part of a function's zero surface in a closed box. vtkSphere, vtkPlane, vtkCylinder and
/// vtkQuadric without a transform by their own numbers; vtkBox as its six sides, where a transform
/// does not turn them; vtkCone, and the former under a linear transform, by their values at ten
/// points, to rounding. ParaView's subclasses count as their bases. Throws std::invalid_argument
/// for all others, with the name of the class: such a surface could only be sampled.
[[nodiscard]] std::vector<Quadric> quadricsOf(vtkImplicitFunction* function, const Box& box);

} // namespace lumitree::filters
#endif
