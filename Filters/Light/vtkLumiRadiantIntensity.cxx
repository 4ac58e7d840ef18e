// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiRadiantIntensity.h"

#include "LumiCache.h"
#include "LumiGather.h"
#include "LumiIntensityField.h"
#include "LumiJob.h"
#include "LumiLightReader.h"
#include "LumiPhotometricText.h"
#include "LumiPorts.h"
#include "LumiSettings.h"
#include "LumiUnits.h"

#include "Radiometry/Constants.h"
#include "Radiometry/EmitterIntensity.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace filters = lumitree::filters;
using lumitree::Vec3;
using lumitree::operator+;
using lumitree::operator-;
using lumitree::operator*;

namespace
{

Vec3 ToVec3(const double* from)
{
  return { from[0], from[1], from[2] };
}

} // namespace

struct vtkLumiRadiantIntensity::Internals
{
  // Kept so that the next execution finds them.
  std::shared_ptr<const filters::Tree> Surface;
  std::shared_ptr<const filters::Tree> Occluders;

  filters::IntensityField Field;

  void OfLight(vtkLumiRadiantIntensity* self, vtkPolyData* data)
  {
    const filters::Light light =
      filters::readLight(data, filters::metresPerUnit(self->GetLengthUnit()));
    this->Field.system = light.system;
    this->Field.emittedFlux =
      light.source->flux().value_or(std::numeric_limits<double>::quiet_NaN());
    this->Field.farField = 0.0;
    this->Field.web.name = light.name;
    for (const Vec3& direction : this->Field.directions)
    {
      const auto intensity = light.source->intensity(direction);
      if (!intensity)
      {
        throw std::runtime_error(
          "The light \"" + light.name + "\" has no intensity: it is infinitely far.");
      }
      this->Field.web.intensities.push_back(*intensity);
    }
  }

  /// False when stopped.
  bool OfSurface(vtkLumiRadiantIntensity* self)
  {
    if (!(self->Value >= 0.0) || !std::isfinite(self->Value))
    {
      throw std::runtime_error("Value must be finite and not negative.");
    }
    filters::Job job(self, 0.2, 1.0);
    lumitree::Emitter emitter;
    emitter.surface = &this->Surface->accelerator->surface();
    emitter.occluders = (this->Occluders ? this->Occluders : this->Surface)->accelerator.get();
    emitter.precision = filters::precisionOf(self->GetPrecision(), emitter.occluders);
    emitter.radiance = 1.0;
    emitter.twoSided = self->TwoSided;
    emitter.metresPerUnit = filters::metresPerUnit(self->GetLengthUnit());
    emitter.threads = filters::threadsFor(self->GetNumberOfThreads());
    emitter.control = job.control();
    const lumitree::EmitterReport report =
      lumitree::emitterIntensity(emitter, this->Field.directions, this->Field.web.intensities);
    if (!(report.flux > 0.0))
    {
      throw std::runtime_error("There is no surface that could shine on input port 0.");
    }
    const double radiance = self->Emission == TotalFlux ? self->Value / report.flux
      : self->Emission == Exitance                      ? self->Value / lumitree::pi
                                                        : self->Value;
    for (double& intensity : this->Field.web.intensities)
    {
      intensity *= radiance;
    }
    this->Field.system = static_cast<lumitree::LightSystem>(self->System);
    this->Field.emittedFlux = report.flux * radiance;
    this->Field.farField = 5.0 * report.extent;
    return report.completed;
  }
};

vtkStandardNewMacro(vtkLumiRadiantIntensity);

vtkLumiRadiantIntensity::vtkLumiRadiantIntensity()
  : Impl(new Internals)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

vtkLumiRadiantIntensity::~vtkLumiRadiantIntensity() = default;

void vtkLumiRadiantIntensity::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto triple = [&](const char* name, const double* v)
  { os << indent << name << ": (" << v[0] << ", " << v[1] << ", " << v[2] << ")\n"; };
  os << indent << "Emission: " << this->Emission << "\n";
  os << indent << "Value: " << this->Value << "\n";
  os << indent << "System: " << this->System << "\n";
  os << indent << "TwoSided: " << (this->TwoSided ? "on" : "off") << "\n";
  triple("Axis", this->Axis);
  triple("Reference", this->Reference);
  os << indent << "Planes: " << this->Planes << "\n";
  os << indent << "Steps: " << this->Steps << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  triple("Centre", this->Centre);
}

int vtkLumiRadiantIntensity::FillInputPortInformation(int port, vtkInformation* info)
{
  filters::acceptAnyDataSet(info);
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  return 1;
}

int vtkLumiRadiantIntensity::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

int vtkLumiRadiantIntensity::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!vtkPolyData::GetData(outputVector, 0))
  {
    outputVector->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), vtkNew<vtkPolyData>());
  }
  if (!vtkTable::GetData(outputVector, 1))
  {
    outputVector->GetInformationObject(1)->Set(vtkDataObject::DATA_OBJECT(), vtkNew<vtkTable>());
  }
  return 1;
}

int vtkLumiRadiantIntensity::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (const int port : { 0, 1 })
  {
    if (inputVector[port]->GetNumberOfInformationObjects() > 0)
    {
      filters::requestSurface(inputVector[port]->GetInformationObject(0), this->GetController());
    }
  }
  return 1;
}

int vtkLumiRadiantIntensity::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  Internals& impl = *this->Impl;
  vtkPolyData* solid = vtkPolyData::GetData(outputVector, 0);
  vtkTable* table = vtkTable::GetData(outputVector, 1);
  impl.Field.web = {};
  try
  {
    impl.Field.setDirections(
      ToVec3(this->Axis), ToVec3(this->Reference), this->Planes, this->Steps);
    vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
    auto* light = vtkPolyData::SafeDownCast(input);
    if (light && light->GetFieldData()->GetAbstractArray("LightType"))
    {
      impl.OfLight(this, light);
    }
    else
    {
      filters::Job buildJob(this, 0.0, 0.2);
      const auto tree = [&](int port, const std::shared_ptr<const filters::Tree>& before)
      {
        return filters::treeFor(vtkDataObject::GetData(inputVector[port]),
          filters::buildOptions(this), this->GetController(), this, filters::GatherArrays::No,
          buildJob.control(), filters::treeSource(this, before, port == 0));
      };
      const bool others = inputVector[1]->GetNumberOfInformationObjects() > 0;
      impl.Surface = tree(0, impl.Surface);
      impl.Occluders = others && impl.Surface ? tree(1, impl.Occluders) : nullptr;
      if (!impl.Surface || (others && !impl.Occluders) || !impl.OfSurface(this))
      {
        impl.Field.web = {};
        return 1; // reported, or stopped
      }
    }
    // In a run over several ranks all know the same: one gives it.
    vtkMultiProcessController* controller = this->GetController();
    if (!filters::isDistributed(controller) || controller->GetLocalProcessId() == 0)
    {
      impl.Field.fillSolid(ToVec3(this->Centre), this->Radius, solid);
      impl.Field.fillTable(table);
      impl.Field.addNumbers(solid);
      impl.Field.addNumbers(table);
    }
  }
  catch (const std::exception& problem)
  {
    impl.Field.web = {};
    solid->Initialize();
    table->Initialize();
    vtkErrorMacro(<< problem.what());
  }
  return 1; // what is wrong was reported; returning 0 would make VTK report it a second time
}

bool vtkLumiRadiantIntensity::WritePhotometricFile(const char* fileName)
{
  this->Update();
  const std::string name = fileName ? fileName : "";
  try
  {
    if (this->Impl->Field.web.intensities.empty())
    {
      throw std::runtime_error("There is no table to write.");
    }
    filters::writePhotometricFile(this->Impl->Field.web, name);
  }
  catch (const std::exception& problem)
  {
    vtkErrorMacro(<< problem.what());
    return false;
  }
  return true;
}

VTK_ABI_NAMESPACE_END
