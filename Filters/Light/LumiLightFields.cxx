// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiLightFields.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include "Radiometry/Constants.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace lumitree::filters
{

namespace
{

vtkDataArray* tuple(vtkPolyData* data, const std::string& name, int components)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfTuples() != 1 || array->GetNumberOfComponents() != components)
  {
    throw std::runtime_error("it needs the field data array \"" + name + "\" of one tuple of " +
      std::to_string(components) + (components == 1 ? " component" : " components"));
  }
  return array;
}

} // namespace

std::string intensityPerMetreName(LightSystem system)
{
  return system == LightSystem::Photometric ? "LuminousIntensityPerMetre [cd/m]"
                                            : "RadiantIntensityPerMetre [W/(sr m)]";
}

std::string zenithRadianceName(LightSystem system)
{
  return system == LightSystem::Photometric ? "ZenithLuminance [cd/m^2]"
                                            : "ZenithRadiance [W/(m^2 sr)]";
}

std::string groundRadianceName(LightSystem system)
{
  return system == LightSystem::Photometric ? "GroundLuminance [cd/m^2]"
                                            : "GroundRadiance [W/(m^2 sr)]";
}

std::string diffuseIrradianceName(LightSystem system)
{
  return system == LightSystem::Photometric ? "DiffuseHorizontalIlluminance [lx]"
                                            : "DiffuseHorizontalIrradiance [W/m^2]";
}

bool LightFields::has(const std::string& name) const
{
  return this->data_->GetFieldData()->GetAbstractArray(name.c_str()) != nullptr;
}

std::string LightFields::text(vtkPolyData* data, const char* name)
{
  auto* array = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name));
  if (!array || array->GetNumberOfValues() != 1)
  {
    throw std::runtime_error(
      "it needs the field data array \"" + std::string(name) + "\" of one string");
  }
  return array->GetValue(0);
}

double LightFields::number(vtkPolyData* data, const std::string& name)
{
  return tuple(data, name, 1)->GetComponent(0, 0);
}

std::vector<double> LightFields::numbers(const std::string& name) const
{
  vtkDataArray* array = this->data_->GetFieldData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfComponents() != 1)
  {
    throw std::runtime_error("it needs the field data array \"" + name + "\" of one component");
  }
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}

Vec3 LightFields::vector(const std::string& name) const
{
  Vec3 value;
  tuple(this->data_, name, 3)->GetTuple(0, value.data());
  return value;
}

Vec3 LightFields::direction(const std::string& name) const
{
  const Vec3 value = this->vector(name);
  if (!isFinite(value) || value == Vec3{ 0.0, 0.0, 0.0 })
  {
    throw std::runtime_error("its \"" + name + "\" must be finite and not zero");
  }
  return value;
}

bool LightFields::flag(const std::string& name) const
{
  return this->has(name) && this->number(name) != 0.0;
}

double LightFields::amount(const std::string& name) const
{
  const double value = this->number(name);
  if (!(value >= 0.0) || !std::isfinite(value))
  {
    std::ostringstream message;
    message << "its \"" << name << "\" is " << value << ", but must be finite and not negative";
    throw std::runtime_error(message.str());
  }
  return value * this->factor_;
}

double LightFields::amount(Quantity quantity) const
{
  return this->amount(arrayName(quantity, this->system_));
}

bool LightFields::has(Quantity quantity) const
{
  return this->has(arrayName(quantity, this->system_));
}

double LightFields::radiance(double area) const
{
  if (this->has(Quantity::Exitance))
  {
    return this->amount(Quantity::Exitance) / pi;
  }
  if (this->has(Quantity::Flux))
  {
    if (!(area > 0.0))
    {
      throw std::runtime_error("it has a flux but no area");
    }
    return this->amount(Quantity::Flux) / (pi * area);
  }
  return this->amount(Quantity::Radiance);
}

Vec3 LightFields::position() const
{
  if (this->data_->GetNumberOfPoints() < 1)
  {
    throw std::runtime_error("its position is its first point, but it has none");
  }
  Vec3 position;
  this->data_->GetPoint(0, position.data());
  if (!isFinite(position))
  {
    throw std::runtime_error("its position is not finite");
  }
  return position;
}

} // namespace lumitree::filters
