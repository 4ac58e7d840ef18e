// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiReflectance_h
#define LumiReflectance_h

#include "LumiSurfaceInput.h"

#include <vector>

namespace lumitree::filters
{

/// The cell array `Reflectance` of a surface, a number for each primitive; `otherwise` where a
/// dataset has no such array. Empty where none has. Throws std::runtime_error for one that is not a
/// number between 0 and 1 for each cell.
[[nodiscard]] std::vector<double> readReflectances(const SurfaceInput& surface, double otherwise);

} // namespace lumitree::filters
#endif
