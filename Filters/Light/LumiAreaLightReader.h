// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiAreaLightReader_h
#define LumiAreaLightReader_h

#include "LumiLightFields.h"

#include "Radiometry/Source.h"

#include <memory>

namespace lumitree::filters
{

/// The polygons and strips of an area light (Docs/lights.md). Cells that are not flat become
/// triangles; ghosts are left out.
[[nodiscard]] std::unique_ptr<const Source> readAreaLight(const LightFields& fields, double factor);

} // namespace lumitree::filters
#endif
