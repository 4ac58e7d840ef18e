// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiImplicitFunctions_h
#define LumiImplicitFunctions_h

#include "vtkLumiABI.h"

#include "LumiImplicitData.h"

#include "Accel/Quadric.h"

#include <memory>
#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkImplicitFunction;
VTK_ABI_NAMESPACE_END

namespace lumitree::filters
{

/// The surface of a function in a box.
struct FunctionBodies
{
  std::vector<Quadric> quadrics; ///< or
  std::optional<Implicit> implicit;
  std::shared_ptr<const ImplicitTree> tree; ///< of the implicit, unless it is sampled
  Guarantee guarantee = Guarantee::Exact;
};

/// As quadrics where it is made of such, by intervals where it is made of superquadrics as well,
/// else to be sampled at the step (0: 1/256 of the box's diagonal). Throws std::invalid_argument
/// for a boolean of nothing.
[[nodiscard]] FunctionBodies bodiesOf(vtkImplicitFunction* function, const Box& box, double step);

} // namespace lumitree::filters
#endif
