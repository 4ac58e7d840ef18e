// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiAccelerationStructure.h"

#include "LumiCache.h"
#include "LumiGather.h"
#include "LumiHierarchyBlocks.h"
#include "LumiSettings.h"
#include "LumiStatisticsTable.h"
#include "LumiVisits.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <exception>

VTK_ABI_NAMESPACE_BEGIN

namespace filters = lumitree::filters;

struct vtkLumiAccelerationStructure::Internals
{
  std::shared_ptr<const filters::Tree> Tree; ///< kept so that the next execution finds it

  /// Casts this rank's rays; false after one vtkErrorMacro.
  static bool Cast(
    vtkLumiAccelerationStructure* self, vtkDataObject* raysInput, filters::Visits& visits);

  /// Draws the hierarchy, and warns of what exceeds MaximumNodes.
  static void Draw(vtkLumiAccelerationStructure* self, const lumitree::HierarchyView& hierarchy,
    const std::uint64_t* visits, bool drawNothing, vtkMultiBlockDataSet* blocks);
};

vtkStandardNewMacro(vtkLumiAccelerationStructure);

vtkLumiAccelerationStructure::vtkLumiAccelerationStructure()
  : Impl(new Internals)
{
}

vtkLumiAccelerationStructure::~vtkLumiAccelerationStructure() = default;

void vtkLumiAccelerationStructure::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Representation: " << this->Representation << "\n";
  os << indent << "MinimumLevel: " << this->MinimumLevel << "\n";
  os << indent << "MaximumLevel: " << this->MaximumLevel << "\n";
  os << indent << "MaximumNodes: " << this->MaximumNodes << "\n";
  os << indent << "ShowLeaves: " << (this->ShowLeaves ? "on" : "off") << "\n";
  os << indent << "ShowOccupancy: " << (this->ShowOccupancy ? "on" : "off") << "\n";
  os << indent << "MeasureOverlap: " << (this->MeasureOverlap ? "on" : "off") << "\n";
}

int vtkLumiAccelerationStructure::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

int vtkLumiAccelerationStructure::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkMultiBlockDataSet" : "vtkTable");
  return 1;
}

int vtkLumiAccelerationStructure::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  if (!vtkMultiBlockDataSet::GetData(outputs, 0))
  {
    outputs->GetInformationObject(0)->Set(
      vtkDataObject::DATA_OBJECT(), vtkNew<vtkMultiBlockDataSet>());
  }
  if (!vtkTable::GetData(outputs, 1))
  {
    outputs->GetInformationObject(1)->Set(vtkDataObject::DATA_OBJECT(), vtkNew<vtkTable>());
  }
  return 1;
}

int vtkLumiAccelerationStructure::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkMultiProcessController* controller = this->GetController();
  filters::Job buildJob(this, 0.0, 0.5);
  this->Impl->Tree = filters::treeFor(vtkDataObject::GetData(inputs[0], 0),
    filters::buildOptions(this), controller, this, filters::GatherArrays::No, buildJob.control(),
    filters::treeSource(this, this->Impl->Tree));
  if (!this->Impl->Tree)
  {
    return 1; // reported, or stopped; returning 0 would make VTK report it a second time
  }
  try
  {
    const lumitree::Accelerator& accelerator = *this->Impl->Tree->accelerator;
    const lumitree::HierarchyView hierarchy = accelerator.hierarchy();
    filters::Visits visits(hierarchy.nodes.size());
    const bool hasRays = this->GetNumberOfInputConnections(1) > 0;
    if (hasRays)
    {
      visits.failures = Internals::Cast(this, vtkDataObject::GetData(inputs[1], 0), visits) ? 0 : 1;
      visits.sumOverRanks(controller);
      if (visits.failures > 0)
      {
        return 1;
      }
    }
    const bool isFirst =
      !filters::isDistributed(controller) || controller->GetLocalProcessId() == 0;
    Internals::Draw(this, hierarchy, hasRays ? visits.perNode.data() : nullptr, !isFirst,
      vtkMultiBlockDataSet::GetData(outputs, 0));
    filters::makeStatisticsTable(
      accelerator, hierarchy, visits, this->MeasureOverlap, isFirst, vtkTable::GetData(outputs, 1));
  }
  catch (const std::exception& problem)
  {
    vtkErrorMacro(<< problem.what());
  }
  return 1;
}

bool vtkLumiAccelerationStructure::Internals::Cast(
  vtkLumiAccelerationStructure* self, vtkDataObject* raysInput, filters::Visits& visits)
{
  filters::RayInput rays;
  if (!filters::readRays(self, raysInput, rays))
  {
    return false;
  }
  try
  {
    filters::Job job(self, 0.5, 0.9);
    const lumitree::Accelerator& accelerator = *self->Impl->Tree->accelerator;
    const lumitree::QueryReport report =
      visits.cast(static_cast<lumitree::QueryKind>(self->GetQuery()), accelerator, rays.batch,
        filters::queryOptions(self, accelerator, job));
    filters::warnOfInvalidRays(self, report, rays);
    return true;
  }
  catch (const std::exception& problem)
  {
    vtkErrorWithObjectMacro(self, << problem.what());
    return false;
  }
}

void vtkLumiAccelerationStructure::Internals::Draw(vtkLumiAccelerationStructure* self,
  const lumitree::HierarchyView& hierarchy, const std::uint64_t* visits, bool drawNothing,
  vtkMultiBlockDataSet* blocks)
{
  filters::HierarchyOptions options;
  options.shape = static_cast<filters::NodeShape>(self->Representation);
  options.minimumLevel = self->MinimumLevel;
  options.maximumLevel = self->MaximumLevel;
  options.maximumNodes = self->MaximumNodes;
  options.leaves = self->ShowLeaves;
  options.occupancy = self->ShowOccupancy;
  options.drawNothing = drawNothing;
  options.threads = filters::threadsFor(self->GetNumberOfThreads());
  const filters::HierarchyReport report =
    filters::makeHierarchyBlocks(hierarchy, visits, options, blocks);
  if (report.firstLevelLeftOut >= 0 || report.leavesLeftOut)
  {
    const std::string levels = report.firstLevelLeftOut >= 0
      ? " levels from " + std::to_string(report.firstLevelLeftOut) + " on"
      : std::string();
    const std::string leaves = report.leavesLeftOut ? " the block of leaves" : "";
    vtkWarningWithObjectMacro(self,
      "Left out:" << levels << (levels.empty() || leaves.empty() ? "" : " and") << leaves
                  << ", which would exceed MaximumNodes (" << self->MaximumNodes << ").");
  }
}

VTK_ABI_NAMESPACE_END
