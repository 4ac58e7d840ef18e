// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiSurfaceReport.h"

#include "LumiCache.h"
#include "LumiGather.h"
#include "LumiJob.h"
#include "LumiPorts.h"
#include "LumiSurfaceReportOutput.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"

#include <exception>

VTK_ABI_NAMESPACE_BEGIN

namespace filters = lumitree::filters;

struct vtkLumiSurfaceReport::Internals
{
  vtkSmartPointer<vtkMultiProcessController> Controller;
  std::shared_ptr<const filters::SurfaceInput> Input; ///< kept so that the next execution finds it
};

vtkStandardNewMacro(vtkLumiSurfaceReport);

vtkLumiSurfaceReport::vtkLumiSurfaceReport()
  : Impl(new Internals)
{
  this->SetNumberOfOutputPorts(3);
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkLumiSurfaceReport::~vtkLumiSurfaceReport() = default;

void vtkLumiSurfaceReport::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MergeCoincidentPoints: " << (this->MergeCoincidentPoints ? "on" : "off") << "\n";
  os << indent << "Controller: " << this->Impl->Controller.Get() << "\n";
}

void vtkLumiSurfaceReport::SetController(vtkMultiProcessController* controller)
{
  if (this->Impl->Controller != controller)
  {
    this->Impl->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkLumiSurfaceReport::GetController()
{
  return this->Impl->Controller;
}

int vtkLumiSurfaceReport::FillInputPortInformation(int, vtkInformation* info)
{
  filters::acceptAnyDataSet(info);
  return 1;
}

int vtkLumiSurfaceReport::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 2 ? "vtkTable" : "vtkPolyData");
  return 1;
}

int vtkLumiSurfaceReport::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  filters::makeOutputLike(vtkNew<vtkPolyData>(), outputs->GetInformationObject(0));
  filters::makeOutputLike(vtkNew<vtkPolyData>(), outputs->GetInformationObject(1));
  filters::makeOutputLike(vtkNew<vtkTable>(), outputs->GetInformationObject(2));
  return 1;
}

int vtkLumiSurfaceReport::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  filters::requestSurface(inputs[0]->GetInformationObject(0), this->Impl->Controller);
  return 1;
}

int vtkLumiSurfaceReport::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkMultiProcessController* controller = this->Impl->Controller;
  this->Impl->Input = filters::surfaceFor(
    vtkDataObject::GetData(inputs[0], 0), controller, this, filters::GatherArrays::No);
  if (!this->Impl->Input ||
    (filters::isDistributed(controller) && controller->GetLocalProcessId() != 0))
  {
    return 1; // an error was reported; returning 0 would make VTK report it a second time
  }
  try
  {
    const lumitree::Surface& surface = *this->Impl->Input->surface;
    if (surface.bodyCount() > 0)
    {
      vtkWarningMacro(<< surface.bodyCount() << " bodies that are no triangles are left out.");
    }
    filters::Job job(this, 0.1, 0.9);
    const filters::SurfaceCheck check = filters::checkSurface(
      surface, this->MergeCoincidentPoints, [&](double done) { return job.report(done); });
    if (!job.aborted())
    {
      filters::makeSurfaceOutput(surface, check, vtkPolyData::GetData(outputs, 0));
      filters::makeEdgesOutput(surface, check, vtkPolyData::GetData(outputs, 1));
      filters::makeReportTable(surface, check, vtkTable::GetData(outputs, 2));
    }
  }
  catch (const std::exception& problem)
  {
    vtkErrorMacro(<< problem.what());
  }
  return 1;
}

VTK_ABI_NAMESPACE_END
