// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiSolidAngle.h"

#include "LumiCache.h"
#include "LumiJob.h"
#include "LumiLeafCopies.h"
#include "LumiPorts.h"
#include "LumiSettings.h"
#include "LumiUnits.h"

#include "Radiometry/EmitterIntensity.h"
#include "Radiometry/LightEstimate.h"
#include "Radiometry/PolygonSource.h"

#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <exception>
#include <stdexcept>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace filters = lumitree::filters;

struct vtkLumiSolidAngle::Internals
{
  // Kept so that the next execution finds them.
  std::shared_ptr<const filters::Tree> Surface;
  std::shared_ptr<const filters::Tree> Occluders;

  /// Arrays of one dataset; false when stopped.
  bool Measure(vtkLumiSolidAngle* self, vtkDataSet* data, const lumitree::Source* shining,
    lumitree::JobControl* control) const
  {
    const auto count = static_cast<std::size_t>(data->GetNumberOfPoints());
    std::vector<double> positions(3 * count);
    for (std::size_t i = 0; i < count; ++i)
    {
      data->GetPoint(static_cast<vtkIdType>(i), positions.data() + 3 * i);
    }
    const int threads = filters::threadsFor(self->GetNumberOfThreads());
    const auto array = [&](const char* name)
    {
      const vtkNew<vtkDoubleArray> made;
      filters::setUnit(made, name, "sr");
      made->SetNumberOfValues(static_cast<vtkIdType>(count));
      data->GetPointData()->AddArray(made);
      data->GetPointData()->SetActiveScalars(made->GetName());
      return made->GetPointer(0);
    };
    const lumitree::Surface& surface = this->Surface->accelerator->surface();
    if (!lumitree::surfaceSolidAngles(
          surface, positions.data(), count, array("SolidAngle"), threads, control))
    {
      return false;
    }
    if (!shining)
    {
      return true;
    }
    lumitree::Receivers receivers;
    receivers.size = count;
    receivers.positions = positions.data();
    lumitree::EstimateOutputs outputs;
    outputs.scalar = array("VisibleSolidAngle");
    lumitree::EstimateOptions options;
    options.occluders = (this->Occluders ? this->Occluders : this->Surface)->accelerator.get();
    options.precision = filters::precisionOf(self->GetPrecision(), options.occluders);
    options.relativeTolerance = self->RelativeTolerance;
    options.threads = threads;
    options.control = control;
    return lumitree::estimateLight(receivers, { shining }, outputs, options).completed;
  }

  /// Its triangles, shining on both sides with radiance 1: scalar irradiance is the solid angle.
  static std::unique_ptr<const lumitree::Source> Shining(const lumitree::Surface& surface)
  {
    std::vector<lumitree::EmittingPolygon> polygons;
    for (const lumitree::PrimitiveId id : surface.hittable())
    {
      if (!surface.isTriangle(id))
      {
        continue;
      }
      const auto corners = surface.vertices(id);
      lumitree::EmittingPolygon polygon;
      polygon.corners.assign(corners.begin(), corners.end());
      polygon.radiance = 1.0;
      polygon.twoSided = true;
      polygons.push_back(std::move(polygon));
    }
    return std::make_unique<lumitree::PolygonSource>(std::move(polygons));
  }
};

vtkStandardNewMacro(vtkLumiSolidAngle);

vtkLumiSolidAngle::vtkLumiSolidAngle()
  : Impl(new Internals)
{
  this->SetNumberOfInputPorts(3);
}

vtkLumiSolidAngle::~vtkLumiSolidAngle() = default;

void vtkLumiSolidAngle::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VisiblePart: " << (this->VisiblePart ? "on" : "off") << "\n";
  os << indent << "RelativeTolerance: " << this->RelativeTolerance << "\n";
}

void vtkLumiSolidAngle::SetSurfaceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

void vtkLumiSolidAngle::SetSurfaceData(vtkDataObject* surface)
{
  this->SetInputDataObject(1, surface);
}

void vtkLumiSolidAngle::SetOccludersConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(2, output);
}

void vtkLumiSolidAngle::SetOccludersData(vtkDataObject* occluders)
{
  this->SetInputDataObject(2, occluders);
}

int vtkLumiSolidAngle::FillInputPortInformation(int port, vtkInformation* info)
{
  filters::acceptAnyDataSet(info);
  // The surface is needed, but its absence is reported here, once.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 0 ? 0 : 1);
  return 1;
}

int vtkLumiSolidAngle::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return filters::makeOutputLike(
    vtkDataObject::GetData(inputVector[0]), outputVector->GetInformationObject(0));
}

int vtkLumiSolidAngle::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (const int port : { 1, 2 })
  {
    if (inputVector[port]->GetNumberOfInformationObjects() > 0)
    {
      filters::requestSurface(inputVector[port]->GetInformationObject(0), this->GetController());
    }
  }
  return 1;
}

int vtkLumiSolidAngle::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  bool complete = false;
  try
  {
    if (inputVector[1]->GetNumberOfInformationObjects() == 0)
    {
      throw std::runtime_error("There is no surface on input port 1.");
    }
    filters::Job buildJob(this, 0.0, 0.2);
    const auto tree = [&](int port, const std::shared_ptr<const filters::Tree>& before)
    {
      return filters::treeFor(vtkDataObject::GetData(inputVector[port]),
        filters::buildOptions(this), this->GetController(), this, filters::GatherArrays::No,
        buildJob.control(), filters::treeSource(this, before, port == 1));
    };
    const bool others = this->VisiblePart && inputVector[2]->GetNumberOfInformationObjects() > 0;
    this->Impl->Surface = tree(1, this->Impl->Surface);
    this->Impl->Occluders =
      others && this->Impl->Surface ? tree(2, this->Impl->Occluders) : nullptr;
    if (this->Impl->Surface && (!others || this->Impl->Occluders))
    {
      std::unique_ptr<const lumitree::Source> shining;
      if (this->VisiblePart)
      {
        shining = Internals::Shining(this->Impl->Surface->accelerator->surface());
      }
      const auto leaves = filters::copyLeaves(vtkDataObject::GetData(inputVector[0]), output);
      complete = true;
      for (std::size_t i = 0; i < leaves.size() && complete; ++i)
      {
        const double size = static_cast<double>(leaves.size());
        filters::Job job(this, 0.2 + 0.8 * static_cast<double>(i) / size,
          0.2 + 0.8 * static_cast<double>(i + 1) / size);
        complete = this->Impl->Measure(this, leaves[i].data, shining.get(), job.control());
      }
    }
  }
  catch (const std::exception& problem)
  {
    complete = false;
    vtkErrorMacro(<< problem.what());
  }
  if (!complete)
  {
    output->Initialize();
  }
  return 1; // what is wrong was reported; returning 0 would make VTK report it a second time
}

VTK_ABI_NAMESPACE_END
