// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiSettings.h"

#include "LumiReport.h"

#include "vtkAbstractArray.h"
#include "vtkInformation.h"
#include "vtkPointData.h"

#include <string>

namespace lumitree::filters
{

std::string directionArray(vtkAlgorithm* filter, vtkDataSet* rays)
{
  vtkInformation* chosen = filter->GetInputArrayInformation(0);
  if (const char* name = chosen->Get(vtkDataObject::FIELD_NAME()))
  {
    return name;
  }
  vtkAbstractArray* array = chosen->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE())
    ? rays->GetPointData()->GetAbstractAttribute(chosen->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE()))
    : nullptr;
  return array && array->GetName() ? array->GetName() : "";
}

BuildOptions buildOptions(vtkLumiStructureAlgorithm* filter)
{
  BuildOptions options;
  options.structure = static_cast<Structure>(filter->GetStructure());
  options.bvhBuild = static_cast<BvhBuild>(filter->GetBvhBuild());
  options.kdBuild = static_cast<KdBuild>(filter->GetKdBuild());
  options.leafSize = filter->GetLeafSize();
  options.threads = threadsFor(filter->GetNumberOfThreads());
  options.maxDepth = filter->GetMaxDepth();
  options.gridDensity = filter->GetGridDensity();
  filter->GetGridResolution(options.gridResolution.data());
  options.mailboxing = filter->GetMailboxing();
  return options;
}

TreeSource treeSource(
  vtkLumiStructureAlgorithm* filter, const std::shared_ptr<const Tree>& before, bool withFile)
{
  TreeSource source;
  source.before = before;
  source.refit = filter->GetRefit();
  source.refitLimit = filter->GetRefitLimit();
  source.file = withFile ? filter->GetStructureFile() : "";
  source.fileUse = filter->GetStructureFileUse();
  return source;
}

Precision precisionOf(int precision, const Accelerator* accelerator)
{
  if (precision != vtkLumiStructureAlgorithm::Automatic)
  {
    return static_cast<Precision>(precision);
  }
  return accelerator ? accelerator->bestPrecision() : Precision::Exact;
}

QueryOptions queryOptions(
  vtkLumiStructureAlgorithm* filter, const Accelerator& accelerator, Job& job)
{
  QueryOptions options;
  options.precision = precisionOf(filter->GetPrecision(), &accelerator);
  options.threads = threadsFor(filter->GetNumberOfThreads());
  options.control = job.control();
  return options;
}

bool readRays(vtkLumiRayAlgorithm* filter, vtkDataObject* input, RayInput& rays)
{
  auto* dataset = vtkDataSet::SafeDownCast(input);
  if (!dataset)
  {
    reportError(
      filter, "The rays must be one dataset, not a composite of several: merge its blocks first.");
    return false;
  }
  const std::string directions = directionArray(filter, dataset);
  return readRays(dataset, directions.c_str(), filter->GetTMin(), filter->GetTMax(), rays, filter);
}

void warnOfInvalidRays(vtkLumiRayAlgorithm* filter, const QueryReport& report, const RayInput& rays)
{
  if (report.invalidRays > 0)
  {
    reportWarning(filter,
      std::to_string(report.invalidRays) + " of " + std::to_string(rays.size) +
        " rays cannot be traced and hit nothing (a coordinate that is not finite, direction zero, "
        "or "
        "t_min > t_max).");
  }
}

} // namespace lumitree::filters
