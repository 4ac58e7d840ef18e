// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiRadiance.h"

#include "LumiCache.h"
#include "LumiJob.h"
#include "LumiLeafCopies.h"
#include "LumiLights.h"
#include "LumiPorts.h"
#include "LumiRayInput.h"
#include "LumiRaysOutput.h"
#include "LumiReceivers.h"
#include "LumiReflectance.h"
#include "LumiSettings.h"
#include "LumiUnits.h"

#include "Radiometry/DirectRadiance.h"
#include "Radiometry/DirectionGrid.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace filters = lumitree::filters;

namespace
{

/// Of the progress bar, for the structure.
constexpr double buildShare = 0.2;

} // namespace

struct vtkLumiRadiance::Internals
{
  std::shared_ptr<const filters::Tree> Tree; ///< kept so that the next execution finds it
  filters::Lights Lights;
  std::vector<const lumitree::Source*> Sources;
  std::vector<double> Reflectances; ///< empty, or one per primitive
  lumitree::RadianceOptions Options;

  /// What the properties and the inputs other than port 0 say. Collective. Throws what is to be
  /// reported; false when it was reported already.
  bool Prepare(vtkLumiRadiance* self, vtkInformationVector** inputs)
  {
    this->Lights = filters::readLights(
      inputs[2], filters::metresPerUnit(self->GetLengthUnit()), self->GetController());
    this->Sources = this->Lights.sources();
    this->Tree = nullptr;
    this->Reflectances.clear();
    lumitree::EstimateOptions& estimate = this->Options.estimate;
    estimate.occluders = nullptr;
    estimate.threads = filters::threadsFor(self->GetNumberOfThreads());
    estimate.relativeTolerance = self->GetRelativeTolerance();
    estimate.maximumRays = static_cast<std::uint32_t>(self->GetMaximumRays());
    this->Options.reflectance = self->Reflection ? self->Reflectance : 0.0;
    this->Options.reflectances = nullptr;
    if (inputs[1]->GetNumberOfInformationObjects() == 0)
    {
      return true;
    }
    filters::Job buildJob(self, 0.0, buildShare);
    this->Tree = filters::treeFor(vtkDataObject::GetData(inputs[1]), filters::buildOptions(self),
      self->GetController(), self,
      self->Reflection ? filters::GatherArrays::Yes : filters::GatherArrays::No, buildJob.control(),
      filters::treeSource(self, this->Tree));
    if (!this->Tree)
    {
      return false;
    }
    estimate.occluders = this->Tree->accelerator.get();
    estimate.precision = filters::precisionOf(self->GetPrecision(), estimate.occluders);
    if (self->Reflection)
    {
      this->Reflectances = filters::readReflectances(*this->Tree->input, self->Reflectance);
      this->Options.reflectances = this->Reflectances.empty() ? nullptr : this->Reflectances.data();
    }
    return true;
  }

  /// The array of that many tuples, made the active scalars.
  [[nodiscard]] double* AddArray(
    vtkDataSetAttributes* to, std::size_t tuples, std::size_t components) const
  {
    const vtkNew<vtkDoubleArray> array;
    const auto quantity = lumitree::describe(lumitree::Quantity::Radiance, this->Lights.system);
    filters::setUnit(array, std::string(quantity.name).c_str(), std::string(quantity.unit).c_str());
    array->SetNumberOfComponents(static_cast<int>(components));
    array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
    to->AddArray(array);
    to->SetActiveScalars(array->GetName());
    return array->GetPointer(0);
  }

  /// Both: false when it was reported, or stopped.
  bool LookAlongRays(vtkLumiRadiance* self, vtkDataObject* input, vtkDataObject* output)
  {
    auto* dataset = vtkDataSet::SafeDownCast(input);
    if (!dataset)
    {
      throw std::runtime_error(
        "The rays must be one dataset, not a composite of several: merge its blocks first.");
    }
    filters::RayInput rays;
    const std::string directions = filters::directionArray(self, dataset);
    if (!filters::readRays(dataset, directions.c_str(), self->TMin, self->TMax, rays, self))
    {
      return false;
    }
    vtkDataSetAttributes* to =
      filters::makeRaysOutput(dataset, rays, vtkDataSet::SafeDownCast(output));
    double* values = this->AddArray(to, rays.batch.size, 1);
    filters::Job job(self, buildShare, 1.0);
    this->Options.estimate.control = job.control();
    const lumitree::RadianceReport report =
      lumitree::directRadiance(rays.batch, this->Sources, values, this->Options);
    filters::writeLengthUnit(output, self->GetLengthUnit());
    Warn(self, report, rays.batch.size);
    return report.completed;
  }

  bool LookAround(vtkLumiRadiance* self, vtkDataObject* input, vtkDataObject* output)
  {
    const auto triple = [](const double* v) { return lumitree::Vec3{ v[0], v[1], v[2] }; };
    const lumitree::DirectionGrid grid = lumitree::makeDirectionGrid(
      triple(self->Axis), triple(self->Reference), self->Rings, self->Sectors);
    const auto leaves = filters::copyLeaves(input, output);
    const auto location = static_cast<filters::ReceiverLocation>(self->ReceiverLocation);
    lumitree::RadianceReport all;
    std::size_t rays = 0;
    for (std::size_t i = 0; i < leaves.size(); ++i)
    {
      vtkDataSet* data = leaves[i].data;
      const filters::ReceiverInput read =
        filters::readReceivers(data, location, this->Options.estimate.threads);
      lumitree::Receivers places;
      places.size = read.size();
      places.positions = read.positions.data();
      places.normals = read.normals.data();
      places.stored = read.stored;
      vtkDataSetAttributes* to = data->GetPointData();
      if (location == filters::ReceiverLocation::Cells)
      {
        to = data->GetCellData();
      }
      const auto part = [&](std::size_t done)
      {
        return buildShare +
          (1.0 - buildShare) * static_cast<double>(done) / static_cast<double>(leaves.size());
      };
      filters::Job job(self, part(i), part(i + 1));
      this->Options.estimate.control = job.control();
      const lumitree::RadianceReport report = lumitree::radianceAround(places, grid.directions,
        this->Sources, this->AddArray(to, read.size(), grid.directions.size()), this->Options);
      AddGrid(data, grid);
      filters::writeLengthUnit(data, self->GetLengthUnit());
      all.invalidRays += report.invalidRays;
      all.missedTolerance += report.missedTolerance;
      rays += read.size() * grid.directions.size();
      if (!report.completed)
      {
        return false;
      }
    }
    AddGrid(output, grid);
    filters::writeLengthUnit(output, self->GetLengthUnit());
    Warn(self, all, rays);
    return true;
  }

  static void AddGrid(vtkDataObject* object, const lumitree::DirectionGrid& grid)
  {
    const vtkNew<vtkDoubleArray> directions;
    directions->SetName("RadianceDirections");
    directions->SetNumberOfComponents(3);
    const vtkNew<vtkDoubleArray> solidAngles;
    filters::setUnit(solidAngles, "RadianceSolidAngles", "sr");
    for (std::size_t d = 0; d < grid.directions.size(); ++d)
    {
      directions->InsertNextTuple(grid.directions[d].data());
      solidAngles->InsertNextValue(grid.solidAngles[d]);
    }
    object->GetFieldData()->AddArray(directions);
    object->GetFieldData()->AddArray(solidAngles);
  }

  static void Warn(vtkLumiRadiance* self, const lumitree::RadianceReport& report, std::size_t rays)
  {
    if (report.invalidRays > 0)
    {
      vtkWarningWithObjectMacro(self,
        << report.invalidRays << " of " << rays
        << " rays cannot be traced and have no radiance (NaN): a coordinate is not finite, the "
           "direction is zero, or t_min > t_max.");
    }
    if (report.missedTolerance > 0)
    {
      vtkWarningWithObjectMacro(
        self, << "What " << report.missedTolerance << " of " << rays
              << " rays meet did not reach the tolerance with " << self->GetMaximumRays()
              << " rays to a light. Allow more rays, or a larger tolerance.");
    }
  }
};

vtkStandardNewMacro(vtkLumiRadiance);

vtkLumiRadiance::vtkLumiRadiance()
  : TMax(std::numeric_limits<double>::infinity())
  , Impl(new Internals)
{
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "RayDirection");
}

vtkLumiRadiance::~vtkLumiRadiance() = default;

void vtkLumiRadiance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto triple = [&](const char* name, const double* v)
  { os << indent << name << ": (" << v[0] << ", " << v[1] << ", " << v[2] << ")\n"; };
  os << indent << "Look: " << (this->Look == AlongRays ? "AlongRays" : "ByDirection") << "\n";
  os << indent << "TMin: " << this->TMin << "\n";
  os << indent << "TMax: " << this->TMax << "\n";
  os << indent << "Rings: " << this->Rings << "\n";
  os << indent << "Sectors: " << this->Sectors << "\n";
  triple("Axis", this->Axis);
  triple("Reference", this->Reference);
  os << indent << "Reflection: " << (this->Reflection ? "on" : "off") << "\n";
  os << indent << "Reflectance: " << this->Reflectance << "\n";
}

int vtkLumiRadiance::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  bool complete = false;
  try
  {
    if (this->Impl->Prepare(this, inputVector))
    {
      vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
      complete = this->Look == AlongRays ? this->Impl->LookAlongRays(this, input, output)
                                         : this->Impl->LookAround(this, input, output);
    }
  }
  catch (const std::exception& problem)
  {
    vtkErrorMacro(<< problem.what());
  }
  if (!complete)
  {
    output->Initialize();
  }
  return 1; // what is wrong was reported; returning 0 would make VTK report it a second time
}

VTK_ABI_NAMESPACE_END
