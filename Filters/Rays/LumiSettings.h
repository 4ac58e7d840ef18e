// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Rays_LumiSettings_h
#define Lumitree_Filters_Rays_LumiSettings_h

#include "LumiCache.h"
#include "LumiJob.h"
#include "LumiRayInput.h"
#include "vtkLumiRayAlgorithm.h"

#include "Accel/BuildOptions.h"
#include "Accel/Query.h"

#include "vtkDataSet.h"

#include <string>

namespace lumitree::filters
{

/// What the filter's properties ask of the cores.
///@{
[[nodiscard]] LUMITREEFILTERSRAYS_EXPORT BuildOptions buildOptions(
  vtkLumiStructureAlgorithm* filter);
[[nodiscard]] LUMITREEFILTERSRAYS_EXPORT QueryOptions queryOptions(
  vtkLumiStructureAlgorithm* filter, const Accelerator& accelerator, Job& job);
/// precision: one of vtkLumiStructureAlgorithm::Precisions. accelerator: null where no rays are
/// cast.
[[nodiscard]] LUMITREEFILTERSRAYS_EXPORT Precision precisionOf(
  int precision, const Accelerator* accelerator);
/// before: what the filter had; withFile: whether its StructureFile is of this structure.
[[nodiscard]] LUMITREEFILTERSRAYS_EXPORT TreeSource treeSource(vtkLumiStructureAlgorithm* filter,
  const std::shared_ptr<const Tree>& before, bool withFile = true);
///@}

/// The name of the array chosen with SetInputArrayToProcess(0, …), by name or as an attribute (the
/// vectors, say) of the rays; "" when none is.
[[nodiscard]] LUMITREEFILTERSRAYS_EXPORT std::string directionArray(
  vtkAlgorithm* filter, vtkDataSet* rays);

/// Reads the rays of the filter's input port 1. False after one vtkErrorMacro.
bool readRays(vtkLumiRayAlgorithm* filter, vtkDataObject* input, RayInput& rays);

/// One warning when some rays could not be traced.
void warnOfInvalidRays(
  vtkLumiRayAlgorithm* filter, const QueryReport& report, const RayInput& rays);

} // namespace lumitree::filters

#endif
