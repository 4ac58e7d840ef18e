// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiIrradiance.h"

#include "LumiIllumination.h"
#include "LumiJob.h"
#include "LumiPorts.h"
#include "LumiSettings.h"
#include "LumiUnits.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <exception>
#include <stdexcept>

VTK_ABI_NAMESPACE_BEGIN

namespace filters = lumitree::filters;

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// Of the progress bar, for the structure.
constexpr double buildShare = 0.2;

int Rank(vtkLumiIrradiance* self)
{
  return self->GetController() ? self->GetController()->GetLocalProcessId() : 0;
}

int Ranks(vtkLumiIrradiance* self)
{
  return self->GetController() ? self->GetController()->GetNumberOfProcesses() : 1;
}

/// A dataset to be lit: a shallow copy of the receivers, already in the output.
struct Leaf
{
  vtkSmartPointer<vtkDataSet> Data;
  std::int64_t CompositeIndex = 0;
};

/// Copies the receivers to the output, all but their values, and lists their datasets.
std::vector<Leaf> CopyReceivers(vtkDataObject* input, vtkDataObject* output)
{
  std::vector<Leaf> leaves;
  auto* from = vtkCompositeDataSet::SafeDownCast(input);
  if (!from)
  {
    output->ShallowCopy(input);
    leaves.push_back({ vtkDataSet::SafeDownCast(output), 0 });
    return leaves;
  }
  auto* to = vtkCompositeDataSet::SafeDownCast(output);
  to->CopyStructure(from);
  to->GetFieldData()->PassData(from->GetFieldData());
  const auto iterator = vtk::TakeSmartPointer(from->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkDataObject* object = iterator->GetCurrentDataObject();
    const auto copy = vtk::TakeSmartPointer(object->NewInstance());
    copy->ShallowCopy(object);
    to->SetDataSet(iterator, copy);
    if (auto* data = vtkDataSet::SafeDownCast(copy))
    {
      leaves.push_back({ data, static_cast<std::int64_t>(iterator->GetCurrentFlatIndex()) });
    }
  }
  return leaves;
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
    if (self->Shadows && OccludersAreReceivers(inputs) && pieces > Ranks(self))
    {
      throw std::runtime_error("Receivers that come piece after piece cannot shadow each other. "
                               "Connect the whole scene to input port 1, the occluders.");
    }
    light.lights = filters::readLights(
      inputs[2], filters::metresPerUnit(self->LengthUnit), self->GetController());
    light.location = static_cast<filters::ReceiverLocation>(self->ReceiverLocation);
    light.precision = static_cast<lumitree::Precision>(self->GetPrecision());
    light.perLight = self->PerLightArrays;
    light.threads = filters::threadsFor(self->GetNumberOfThreads());
    if (self->Shadows)
    {
      filters::Job buildJob(self, 0.0, buildShare);
      vtkInformationVector* occluders = OccludersAreReceivers(inputs) ? inputs[0] : inputs[1];
      this->Tree = filters::treeFor(vtkDataObject::GetData(occluders), filters::buildOptions(self),
        self->GetController(), self, filters::GatherArrays::No, buildJob.control());
      light.tree = this->Tree;
      return light.tree != nullptr;
    }
    return true;
  }

  static bool OccludersAreReceivers(vtkInformationVector** inputs)
  {
    return inputs[1]->GetNumberOfInformationObjects() == 0;
  }

  /// Lights every leaf; false when the user stopped it.
  bool Illuminate(vtkLumiIrradiance* self, const filters::Illumination& light,
    const std::vector<Leaf>& leaves, bool shadowsItself)
  {
    const auto count = static_cast<double>(leaves.size());
    std::uint64_t receivers = 0;
    std::uint64_t undefined = 0;
    for (std::size_t i = 0; i < leaves.size(); ++i)
    {
      const auto part = [&](std::size_t done)
      {
        const double share = light.tree ? buildShare : 0.0;
        return share + (1.0 - share) * static_cast<double>(done) / count;
      };
      filters::Job job(self, part(i), part(i + 1));
      const filters::IlluminationReport report = light.addTo(
        leaves[i].Data, leaves[i].CompositeIndex, Rank(self), shadowsItself, job.control());
      if (!report.completed)
      {
        return false;
      }
      filters::writeLengthUnit(leaves[i].Data, self->LengthUnit);
      receivers += report.receivers;
      undefined += report.undefined;
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
  this->SetNumberOfInputPorts(3);
}

vtkLumiIrradiance::~vtkLumiIrradiance() = default;

void vtkLumiIrradiance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ReceiverLocation: " << this->ReceiverLocation << "\n";
  os << indent << "Shadows: " << (this->Shadows ? "on" : "off") << "\n";
  os << indent << "PerLightArrays: " << (this->PerLightArrays ? "on" : "off") << "\n";
  os << indent << "LengthUnit: " << filters::lengthUnitName(this->LengthUnit) << "\n";
}

void vtkLumiIrradiance::SetOccludersConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

void vtkLumiIrradiance::SetOccludersData(vtkDataObject* occluders)
{
  this->SetInputDataObject(1, occluders);
}

void vtkLumiIrradiance::AddLightsConnection(vtkAlgorithmOutput* output)
{
  this->AddInputConnection(2, output);
}

void vtkLumiIrradiance::AddLightsData(vtkDataObject* lights)
{
  this->AddInputDataObject(2, lights);
}

void vtkLumiIrradiance::RemoveAllLights()
{
  this->RemoveAllInputConnections(2);
}

int vtkLumiIrradiance::FillInputPortInformation(int port, vtkInformation* info)
{
  // Composites are named, too: otherwise the pipeline would run this filter block by block, and one
  // block would not shadow another.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 2 ? "vtkPolyData" : "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  // Lights are needed, but their absence is reported here, once, and not by the pipeline at each
  // update.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 0 ? 0 : 1);
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), port == 2 ? 1 : 0);
  return 1;
}

int vtkLumiIrradiance::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return filters::makeOutputLike(
    vtkDataObject::GetData(inputVector[0]), outputVector->GetInformationObject(0));
}

int vtkLumiIrradiance::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (const int port : { 1, 2 })
  {
    for (int i = 0; i < inputVector[port]->GetNumberOfInformationObjects(); ++i)
    {
      filters::requestPiece(inputVector[port]->GetInformationObject(i), Rank(this), Ranks(this));
    }
  }
  return 1;
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
        CopyReceivers(vtkDataObject::GetData(inputVector[0]), output);
      complete =
        this->Impl->Illuminate(this, light, leaves, Internals::OccludersAreReceivers(inputVector));
      filters::writeLengthUnit(output, this->LengthUnit);
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
