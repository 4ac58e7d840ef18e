// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiRadiantIntensity.h"

#include "LumiCache.h"
#include "LumiGather.h"
#include "LumiJob.h"
#include "LumiLightReader.h"
#include "LumiPhotometricText.h"
#include "LumiPorts.h"
#include "LumiSettings.h"
#include "LumiUnits.h"

#include "Radiometry/Checks.h"
#include "Radiometry/Constants.h"
#include "Radiometry/EmitterIntensity.h"
#include "Radiometry/PhotometricWeb.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
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

void AddNumber(vtkDataObject* object, const std::string& name, double value)
{
  const vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  array->InsertNextValue(value);
  object->GetFieldData()->AddArray(array);
}

} // namespace

struct vtkLumiRadiantIntensity::Internals
{
  // Kept so that the next execution finds them.
  std::shared_ptr<const filters::Tree> Surface;
  std::shared_ptr<const filters::Tree> Occluders;

  lumitree::PhotometricWeb Web; ///< planes 0 … 360 degrees, both ends the same
  std::vector<Vec3> Directions; ///< as its intensities
  lumitree::LightSystem System = lumitree::LightSystem::Radiometric;
  double EmittedFlux = 0.0;
  double FarField = 0.0; ///< 0: not known

  void SetDirections(vtkLumiRadiantIntensity* self)
  {
    const Vec3 axis = lumitree::checks::unit(ToVec3(self->Axis), "Axis");
    const Vec3 given = lumitree::checks::unit(ToVec3(self->Reference), "Reference");
    const Vec3 across = given - lumitree::dot(given, axis) * axis;
    if (!(lumitree::length(across) > 1e-9))
    {
      throw std::runtime_error("Axis and Reference are parallel.");
    }
    const Vec3 x = lumitree::checks::unit(across, "Reference");
    const Vec3 y = lumitree::cross(-1.0 * axis, x);
    this->Web = {};
    this->Directions.clear();
    for (int c = 0; c <= self->Planes; ++c)
    {
      this->Web.horizontals.push_back(360.0 * c / self->Planes);
      const double turn = 2.0 * lumitree::pi * (c % self->Planes) / self->Planes;
      for (int g = 0; g <= self->Steps; ++g)
      {
        const double gamma = lumitree::pi * g / self->Steps;
        this->Directions.push_back(std::cos(gamma) * axis + (std::sin(gamma) * std::cos(turn)) * x +
          (std::sin(gamma) * std::sin(turn)) * y);
      }
    }
    for (int g = 0; g <= self->Steps; ++g)
    {
      this->Web.verticals.push_back(180.0 * g / self->Steps);
    }
  }

  void OfLight(vtkLumiRadiantIntensity* self, vtkPolyData* data)
  {
    const filters::Light light = filters::readLight(data, filters::metresPerUnit(self->LengthUnit));
    this->System = light.system;
    this->EmittedFlux = light.source->flux().value_or(std::numeric_limits<double>::quiet_NaN());
    this->FarField = 0.0;
    this->Web.name = light.name;
    for (const Vec3& direction : this->Directions)
    {
      const auto intensity = light.source->intensity(direction);
      if (!intensity)
      {
        throw std::runtime_error(
          "The light \"" + light.name + "\" has no intensity: it is infinitely far.");
      }
      this->Web.intensities.push_back(*intensity);
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
    emitter.metresPerUnit = filters::metresPerUnit(self->LengthUnit);
    emitter.threads = filters::threadsFor(self->GetNumberOfThreads());
    emitter.control = job.control();
    const lumitree::EmitterReport report =
      lumitree::emitterIntensity(emitter, this->Directions, this->Web.intensities);
    if (!(report.flux > 0.0))
    {
      throw std::runtime_error("There is no surface that could shine on input port 0.");
    }
    const double radiance = self->Emission == TotalFlux ? self->Value / report.flux
      : self->Emission == Exitance                      ? self->Value / lumitree::pi
                                                        : self->Value;
    for (double& intensity : this->Web.intensities)
    {
      intensity *= radiance;
    }
    this->System = static_cast<lumitree::LightSystem>(self->System);
    this->EmittedFlux = report.flux * radiance;
    this->FarField = 5.0 * report.extent;
    return report.completed;
  }

  void AddNumbers(vtkDataObject* object) const
  {
    const std::string unit(lumitree::describe(lumitree::Quantity::Flux, this->System).unit);
    AddNumber(object, "EmittedFlux [" + unit + "]", this->EmittedFlux);
    AddNumber(object, "IntegratedFlux [" + unit + "]", this->Web.flux());
    if (this->FarField > 0.0)
    {
      AddNumber(object, "FarFieldDistance", this->FarField);
    }
  }

  void FillSolid(vtkLumiRadiantIntensity* self, vtkPolyData* solid) const
  {
    const vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    const vtkNew<vtkDoubleArray> values;
    const vtkNew<vtkDoubleArray> planes;
    const vtkNew<vtkDoubleArray> gammas;
    const auto quantity = lumitree::describe(lumitree::Quantity::Intensity, this->System);
    filters::setUnit(
      values, std::string(quantity.name).c_str(), std::string(quantity.unit).c_str());
    planes->SetName("C");
    gammas->SetName("Gamma");
    double greatest = 0.0;
    for (const double intensity : this->Web.intensities)
    {
      greatest = std::max(greatest, intensity);
    }
    const Vec3 centre = ToVec3(self->Centre);
    const auto rows = this->Web.verticals.size();
    for (std::size_t i = 0; i < this->Directions.size(); ++i)
    {
      const double intensity = this->Web.intensities[i];
      const double share = greatest > 0.0 ? intensity / greatest : 0.0;
      const Vec3 p = centre + (self->Radius * share) * this->Directions[i];
      points->InsertNextPoint(p.data());
      values->InsertNextValue(intensity);
      planes->InsertNextValue(this->Web.horizontals[i / rows]);
      gammas->InsertNextValue(this->Web.verticals[i % rows]);
    }
    const vtkNew<vtkCellArray> cells;
    const auto last = static_cast<vtkIdType>(rows) - 1;
    for (vtkIdType c = 0; c < self->Planes; ++c)
    {
      for (vtkIdType g = 0; g < last; ++g)
      {
        const vtkIdType a = c * (last + 1) + g;
        const vtkIdType b = a + last + 1;
        cells->InsertNextCell({ a, b, b + 1, a + 1 });
      }
    }
    solid->SetPoints(points);
    solid->SetPolys(cells);
    solid->GetPointData()->SetScalars(values);
    solid->GetPointData()->AddArray(planes);
    solid->GetPointData()->AddArray(gammas);
  }

  void FillTable(vtkLumiRadiantIntensity* self, vtkTable* table) const
  {
    const vtkNew<vtkDoubleArray> gammas;
    gammas->SetName("Gamma");
    for (const double gamma : this->Web.verticals)
    {
      gammas->InsertNextValue(gamma);
    }
    table->AddColumn(gammas);
    const auto rows = this->Web.verticals.size();
    for (int c = 0; c < self->Planes; ++c)
    {
      const vtkNew<vtkDoubleArray> column;
      char name[32];
      std::snprintf(name, sizeof name, "C %g", this->Web.horizontals[c]);
      column->SetName(name);
      for (std::size_t g = 0; g < rows; ++g)
      {
        column->InsertNextValue(this->Web.intensities[c * rows + g]);
      }
      table->AddColumn(column);
    }
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
  os << indent << "LengthUnit: " << filters::lengthUnitName(this->LengthUnit) << "\n";
}

void vtkLumiRadiantIntensity::SetOccludersConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

void vtkLumiRadiantIntensity::SetOccludersData(vtkDataObject* occluders)
{
  this->SetInputDataObject(1, occluders);
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
  impl.Web = {};
  try
  {
    impl.SetDirections(this);
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
        impl.Web = {};
        return 1; // reported, or stopped
      }
    }
    // In a run over several ranks all know the same: one gives it.
    vtkMultiProcessController* controller = this->GetController();
    if (!filters::isDistributed(controller) || controller->GetLocalProcessId() == 0)
    {
      impl.FillSolid(this, solid);
      impl.FillTable(this, table);
      impl.AddNumbers(solid);
      impl.AddNumbers(table);
    }
  }
  catch (const std::exception& problem)
  {
    impl.Web = {};
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
    if (this->Impl->Web.intensities.empty())
    {
      throw std::runtime_error("There is no table to write.");
    }
    filters::writePhotometricFile(this->Impl->Web, name);
  }
  catch (const std::exception& problem)
  {
    vtkErrorMacro(<< problem.what());
    return false;
  }
  return true;
}

VTK_ABI_NAMESPACE_END
