// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiLightReader.h"

#include "Radiometry/DirectionalSource.h"
#include "Radiometry/IsotropicPointSource.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace lumitree::filters
{

namespace
{

std::string text(vtkPolyData* data, const char* name)
{
  auto* array = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name));
  if (!array || array->GetNumberOfValues() != 1)
  {
    throw std::runtime_error(
      "it needs the field data array \"" + std::string(name) + "\" of one string");
  }
  return array->GetValue(0);
}

vtkDataArray* numbers(vtkPolyData* data, const std::string& name, int components)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfTuples() != 1 || array->GetNumberOfComponents() != components)
  {
    throw std::runtime_error("it needs the field data array \"" + name + "\" of one tuple of " +
      std::to_string(components) + (components == 1 ? " component" : " components"));
  }
  return array;
}

double number(vtkPolyData* data, const std::string& name)
{
  return numbers(data, name, 1)->GetComponent(0, 0);
}

double notNegative(vtkPolyData* data, const std::string& name)
{
  const double value = number(data, name);
  if (!(value >= 0.0) || !std::isfinite(value))
  {
    std::ostringstream message;
    message << "its \"" << name << "\" is " << value << ", but must be finite and not negative";
    throw std::runtime_error(message.str());
  }
  return value;
}

std::unique_ptr<const Source> pointSource(
  vtkPolyData* data, LightSystem system, double metresPerUnit)
{
  const double flux = notNegative(data, arrayName(Quantity::Flux, system));
  if (data->GetNumberOfPoints() != 1)
  {
    throw std::runtime_error(
      "a point light has one point, but it has " + std::to_string(data->GetNumberOfPoints()));
  }
  Vec3 position;
  data->GetPoint(0, position.data());
  if (!isFinite(position))
  {
    throw std::runtime_error("its position is not finite");
  }
  return std::make_unique<IsotropicPointSource>(flux, position, metresPerUnit);
}

std::unique_ptr<const Source> directionalSource(vtkPolyData* data, LightSystem system)
{
  const double irradiance = notNegative(data, arrayName(Quantity::NormalIrradiance, system));
  Vec3 direction;
  numbers(data, "LightDirection", 3)->GetTuple(0, direction.data());
  if (!isFinite(direction) || direction == Vec3{ 0.0, 0.0, 0.0 })
  {
    throw std::runtime_error("its \"LightDirection\" must be finite and not zero");
  }
  return std::make_unique<DirectionalSource>(irradiance, direction);
}

} // namespace

bool mayBeLight(vtkPolyData* data)
{
  vtkFieldData* fields = data->GetFieldData();
  return data->GetNumberOfPoints() > 0 || data->GetNumberOfCells() > 0 ||
    fields->GetAbstractArray("LightType") || fields->GetAbstractArray("LightSchema");
}

Light readLight(vtkPolyData* data, double metresPerUnit)
{
  const double schema = number(data, "LightSchema");
  if (schema != lightSchemaVersion)
  {
    std::ostringstream message;
    message << "its schema is version " << schema << ", but this build reads version "
            << lightSchemaVersion;
    throw std::runtime_error(message.str());
  }
  const std::string type = text(data, "LightType");
  Light light;
  light.name = text(data, "LightName");
  const double system = number(data, "LightSystem");
  if (system != 0.0 && system != 1.0)
  {
    std::ostringstream message;
    message << "its \"LightSystem\" is " << system
            << ", but must be 0 (radiometric) or 1 (photometric)";
    throw std::runtime_error(message.str());
  }
  light.system = static_cast<LightSystem>(static_cast<int>(system));

  if (type == "point")
  {
    light.source = pointSource(data, light.system, metresPerUnit);
  }
  else if (type == "directional")
  {
    light.source = directionalSource(data, light.system);
  }
  else
  {
    throw std::runtime_error(
      "this build does not know its type \"" + type + "\" (it knows point and directional)");
  }
  return light;
}

} // namespace lumitree::filters
