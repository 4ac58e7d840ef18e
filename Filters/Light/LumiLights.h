// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiLights_h
#define LumiLights_h

#include "LumiLightReader.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkInformationVector;
class vtkMultiProcessController;
VTK_ABI_NAMESPACE_END

namespace lumitree::filters
{

/// The lights of one computation, at least one, of one system, with unique names.
struct Lights
{
  std::vector<Light> lights;
  LightSystem system = LightSystem::Radiometric;

  [[nodiscard]] std::vector<const Source*> sources() const;
};

/// Every light of a repeatable port (datasets and composites, in order) and of every rank.
/// Collective. Throws std::runtime_error, on every rank, that names the light and says what is
/// wrong with it.
[[nodiscard]] Lights readLights(
  vtkInformationVector* port, double metresPerUnit, vtkMultiProcessController* controller);

} // namespace lumitree::filters
#endif
