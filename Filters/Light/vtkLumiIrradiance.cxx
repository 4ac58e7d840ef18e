// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiIrradiance.h"

#include "LumiGather.h"
#include "LumiIllumination.h"
#include "LumiJob.h"
#include "LumiLeafCopies.h"
#include "LumiPorts.h"
#include "LumiSettings.h"
#include "LumiUnits.h"

#include "vtkCommunicator.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <exception>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace filters = lumitree::filters;

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// Of the progress bar, for the structure.
constexpr double buildShare = 0.2;

using Leaf = filters::LeafCopy;

/// A number in the field data.
void AddNumber(vtkFieldData* fields, const std::string& name, double value)
{
  const vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  array->InsertNextValue(value);
  fields->AddArray(array);
}

} // namespace

struct vtkLumiIrradiance::Internals
{
  std::shared_ptr<const filters::Tree> Tree; ///< kept so that the next execution finds it

  /// What the properties and the inputs other than the receivers say. Collective. Throws what is to
  /// be reported; false when it was reported already.
  bool Prepare(vtkLumiIrradiance* self, vtkInformationVector** inputs, int pieces,
    filters::Illumination& light)
  {
    if (self->Shadows && OccludersAreReceivers(inputs) && pieces > self->Ranks())
    {
      throw std::runtime_error("Receivers that come piece after piece cannot shadow each other. "
                               "Connect the whole scene to input port 1, the occluders.");
    }
    light.lights = filters::readLights(
      inputs[2], filters::metresPerUnit(self->GetLengthUnit()), self->GetController());
    light.location = static_cast<filters::ReceiverLocation>(self->ReceiverLocation);
    light.arrays = { self->PerLightArrays, self->TwoSided, self->ScalarIrradiance,
      self->LightVector, self->CylindricalIrradiance, self->HemisphericalIrradiance,
      self->EstimateArrays, self->ShadowMasks };
    light.relativeTolerance = self->GetRelativeTolerance();
    light.absoluteTolerance = self->AbsoluteTolerance;
    light.maximumRays = static_cast<std::uint32_t>(self->GetMaximumRays());
    light.threads = filters::threadsFor(self->GetNumberOfThreads());
    if (self->Shadows)
    {
      filters::Job buildJob(self, 0.0, buildShare);
      vtkInformationVector* occluders = OccludersAreReceivers(inputs) ? inputs[0] : inputs[1];
      this->Tree = filters::treeFor(vtkDataObject::GetData(occluders), filters::buildOptions(self),
        self->GetController(), self, filters::GatherArrays::No, buildJob.control(),
        filters::treeSource(self, this->Tree));
      if (!this->Tree)
      {
        return false;
      }
      light.tree = this->Tree;
      light.precision = filters::precisionOf(self->GetPrecision(), this->Tree->accelerator.get());
    }
    return true;
  }

  static bool OccludersAreReceivers(vtkInformationVector** inputs)
  {
    return inputs[1]->GetNumberOfInformationObjects() == 0;
  }

  /// Writes what holds for all receivers, of all ranks, to the field data. Collective.
  void Summarise(vtkLumiIrradiance* self, const filters::Illumination& light,
    filters::IlluminationStatistics statistics, lumitree::Quantity quantity,
    const std::vector<Leaf>& leaves)
  {
    vtkMultiProcessController* controller = self->GetController();
    if (filters::isDistributed(controller))
    {
      const double sums[2] = { statistics.sum, static_cast<double>(statistics.count) };
      const double ends[2] = { -statistics.minimum, statistics.maximum };
      double allSums[2];
      double allEnds[2];
      controller->AllReduce(sums, allSums, 2, vtkCommunicator::SUM_OP);
      controller->AllReduce(ends, allEnds, 2, vtkCommunicator::MAX_OP);
      statistics = { static_cast<std::uint64_t>(allSums[1]), allSums[0], -allEnds[0], allEnds[1] };
    }
    const lumitree::QuantityName q = lumitree::describe(quantity, light.lights.system);
    const auto name = [&](const std::string& what)
    { return filters::nameWithUnit(what.c_str(), std::string(q.unit).c_str()); };
    const double none = std::numeric_limits<double>::quiet_NaN();
    const bool some = statistics.count > 0;
    const double mean = some ? statistics.sum / static_cast<double>(statistics.count) : none;
    const double outdoor = light.outdoorIrradiance();
    this->Numbers = { { name(std::string(q.name) + "Minimum"), some ? statistics.minimum : none },
      { name(std::string(q.name) + "Mean"), mean },
      { name(std::string(q.name) + "Maximum"), some ? statistics.maximum : none },
      { "Uniformity", mean > 0.0 ? statistics.minimum / mean : none } };
    if (outdoor > 0.0)
    {
      const lumitree::QuantityName e =
        lumitree::describe(lumitree::Quantity::Irradiance, light.lights.system);
      this->Numbers.emplace_back(name("Outdoor" + std::string(e.name)), outdoor);
      this->Numbers.emplace_back("DaylightFactor [%]", 100.0 * mean / outdoor);
    }
    for (const Leaf& leaf : leaves)
    {
      this->WriteNumbers(leaf.data);
    }
  }

  void WriteNumbers(vtkDataObject* object) const
  {
    for (const auto& [name, value] : this->Numbers)
    {
      AddNumber(object->GetFieldData(), name, value);
    }
  }

  std::vector<std::pair<std::string, double>> Numbers; ///< of the field data

  /// Lights every leaf; false when the user stopped it.
  bool Illuminate(vtkLumiIrradiance* self, const filters::Illumination& light,
    const std::vector<Leaf>& leaves, bool shadowsItself)
  {
    const auto count = static_cast<double>(leaves.size());
    std::uint64_t receivers = 0;
    std::uint64_t undefined = 0;
    std::uint64_t missed = 0;
    bool complete = true;
    filters::IlluminationStatistics statistics;
    lumitree::Quantity quantity = lumitree::Quantity::Irradiance;
    for (std::size_t i = 0; i < leaves.size(); ++i)
    {
      const auto part = [&](std::size_t done)
      {
        const double share = light.tree ? buildShare : 0.0;
        return share + (1.0 - share) * static_cast<double>(done) / count;
      };
      filters::Job job(self, part(i), part(i + 1));
      const filters::IlluminationReport report = light.addTo(
        leaves[i].data, leaves[i].compositeIndex, self->Rank(), shadowsItself, job.control());
      if (!report.completed)
      {
        complete = false;
        break;
      }
      filters::writeLengthUnit(leaves[i].data, self->GetLengthUnit());
      receivers += report.receivers;
      undefined += report.undefined;
      missed += report.missed;
      statistics.add(report.statistics);
      quantity = report.quantity;
    }
    // Also when stopped: the other ranks wait for this one.
    this->Summarise(self, light, statistics, quantity, leaves);
    if (!complete)
    {
      return false;
    }
    if (missed > 0)
    {
      vtkWarningWithObjectMacro(self,
        << missed << " of " << receivers << " receivers did not reach the tolerance with "
        << self->GetMaximumRays() << " rays to a light. Allow more rays, or a larger tolerance.");
    }
    if (undefined > 0)
    {
      vtkWarningWithObjectMacro(self,
        << undefined << " of " << receivers
        << " receivers have no value (NaN): their normal is not defined, their coordinates are not "
           "finite, or a point light is where they are.");
    }
    return true;
  }
};

vtkStandardNewMacro(vtkLumiIrradiance);

vtkLumiIrradiance::vtkLumiIrradiance()
  : Impl(new Internals)
{
  this->ReceiverLocation = Cells;
}

vtkLumiIrradiance::~vtkLumiIrradiance() = default;

void vtkLumiIrradiance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shadows: " << (this->Shadows ? "on" : "off") << "\n";
  os << indent << "PerLightArrays: " << (this->PerLightArrays ? "on" : "off") << "\n";
  os << indent << "TwoSided: " << (this->TwoSided ? "on" : "off") << "\n";
  os << indent << "ScalarIrradiance: " << (this->ScalarIrradiance ? "on" : "off") << "\n";
  os << indent << "LightVector: " << (this->LightVector ? "on" : "off") << "\n";
  os << indent << "CylindricalIrradiance: " << (this->CylindricalIrradiance ? "on" : "off") << "\n";
  os << indent << "HemisphericalIrradiance: " << (this->HemisphericalIrradiance ? "on" : "off")
     << "\n";
  os << indent << "EstimateArrays: " << (this->EstimateArrays ? "on" : "off") << "\n";
  os << indent << "ShadowMasks: " << (this->ShadowMasks ? "on" : "off") << "\n";
  os << indent << "AbsoluteTolerance: " << this->AbsoluteTolerance << "\n";
}

int vtkLumiIrradiance::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  const int pieces =
    outputVector->GetInformationObject(0)->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()); // 0: not said
  bool complete = false;
  try
  {
    filters::Illumination light;
    if (this->Impl->Prepare(this, inputVector, pieces, light))
    {
      const std::vector<Leaf> leaves =
        filters::copyLeaves(vtkDataObject::GetData(inputVector[0]), output);
      complete =
        this->Impl->Illuminate(this, light, leaves, Internals::OccludersAreReceivers(inputVector));
      filters::writeLengthUnit(output, this->GetLengthUnit());
      if (complete)
      {
        this->Impl->WriteNumbers(output);
      }
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
