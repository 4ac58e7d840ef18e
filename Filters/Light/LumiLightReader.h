// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiLightReader_h
#define LumiLightReader_h

#include "Radiometry/Quantities.h"
#include "Radiometry/Source.h"
#include "vtkLumiABI.h"

#include <memory>
#include <optional>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace lumitree::filters
{

/// A light as the cores know it.
struct Light
{
  std::string name;
  LightSystem system = LightSystem::Radiometric;
  std::unique_ptr<const Source> source;
};

/// The version of Docs/lights.md that this build reads.
inline constexpr int lightSchemaVersion = 1;

/// Whether a dataset is a light at all: it says what it is, or it has geometry. What has neither is
/// a piece of a light that lives on another rank.
[[nodiscard]] bool mayBeLight(vtkPolyData* data);

/// What a light is measured in. Throws std::runtime_error for a schema that is not known.
[[nodiscard]] LightSystem readLightSystem(vtkPolyData* data);

/// The efficacy [lm/W] by which a light may be converted to the other system, if it has one.
[[nodiscard]] std::optional<double> readLuminousEfficacy(vtkPolyData* data);

/// Reads one light by the schema of Docs/lights.md, as one of the wanted system, converted by its
/// luminous efficacy where it is of the other; without a wish as it is. Throws std::runtime_error
/// that says what is wrong, without naming the light.
[[nodiscard]] Light readLight(
  vtkPolyData* data, double metresPerUnit, std::optional<LightSystem> wanted = std::nullopt);

} // namespace lumitree::filters
#endif
