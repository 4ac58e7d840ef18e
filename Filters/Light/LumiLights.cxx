// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiLights.h"

#include "LumiGather.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <optional>
#include <set>
#include <stdexcept>

namespace lumitree::filters
{

namespace
{

using Objects = std::vector<vtkSmartPointer<vtkDataObject>>;

Objects leavesOf(vtkInformationVector* port)
{
  Objects leaves;
  for (int i = 0; i < port->GetNumberOfInformationObjects(); ++i)
  {
    vtkDataObject* object = vtkDataObject::GetData(port, i);
    if (auto* composite = vtkCompositeDataSet::SafeDownCast(object))
    {
      auto iterator = vtk::TakeSmartPointer(composite->NewIterator());
      for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
      {
        leaves.push_back(iterator->GetCurrentDataObject());
      }
    }
    else if (object)
    {
      leaves.push_back(object);
    }
  }
  return leaves;
}

/// "Light 2 ("Lamp")", counted from 1 in the order of the port.
std::string title(std::size_t index, vtkPolyData* light)
{
  std::string result = "Light " + std::to_string(index + 1);
  auto* name = vtkStringArray::SafeDownCast(light->GetFieldData()->GetAbstractArray("LightName"));
  if (name && name->GetNumberOfValues() > 0)
  {
    result += " (\"" + name->GetValue(0) + "\")";
  }
  return result;
}

void makeUnique(std::vector<Light>& lights)
{
  std::set<std::string> taken;
  for (Light& light : lights)
  {
    const std::string name = light.name;
    for (int n = 2; !taken.insert(light.name).second; ++n)
    {
      light.name = name + " " + std::to_string(n);
    }
  }
}

/// The system of those that have no luminous efficacy, which cannot be converted; that of the first
/// one where all have.
LightSystem commonSystem(const Objects& objects)
{
  std::optional<LightSystem> common;
  std::optional<LightSystem> first;
  for (std::size_t i = 0; i < objects.size(); ++i)
  {
    auto* data = vtkPolyData::SafeDownCast(objects[i]);
    try
    {
      const LightSystem own = readLightSystem(data);
      first = first.value_or(own);
      if (readLuminousEfficacy(data))
      {
        continue;
      }
      if (common && *common != own)
      {
        throw std::runtime_error("it is " + std::string(name(own)) + ", but those before it are " +
          std::string(name(*common)) +
          "; lights of both are added only where those of one system have a luminous efficacy");
      }
      common = own;
    }
    catch (const std::exception& error)
    {
      throw std::runtime_error(title(i, data) + ": " + error.what() + ".");
    }
  }
  return common.value_or(first.value_or(LightSystem::Radiometric));
}

/// The leaves of this rank that are lights; throws, on every rank, when a rank has a leaf that
/// cannot be one.
Objects lightsOf(const Objects& leaves, vtkMultiProcessController* controller)
{
  Objects mine;
  std::string wrong;
  for (const auto& leaf : leaves)
  {
    auto* data = vtkPolyData::SafeDownCast(leaf);
    if (!data)
    {
      wrong = std::string("A light is a vtkPolyData, but one is a ") + leaf->GetClassName() + ".";
    }
    else if (mayBeLight(data))
    {
      mine.push_back(leaf);
    }
  }
  if (largestOfAll(controller, wrong.empty() ? 0 : 1) > 0)
  {
    throw std::runtime_error(
      wrong.empty() ? "A light of another rank is not a vtkPolyData." : wrong);
  }
  return mine;
}

} // namespace

std::vector<const Source*> Lights::sources() const
{
  std::vector<const Source*> result;
  for (const Light& light : this->lights)
  {
    result.push_back(light.source.get());
  }
  return result;
}

Lights readLights(
  vtkInformationVector* port, double metresPerUnit, vtkMultiProcessController* controller)
{
  Objects objects = lightsOf(leavesOf(port), controller);
  if (isDistributed(controller))
  {
    const vtkNew<vtkPolyData> prototype;
    const std::vector<GatheredObject> gathered = gatherObjects(controller, objects, prototype);
    objects.clear();
    for (const GatheredObject& light : gathered)
    {
      objects.push_back(light.object);
    }
  }
  if (objects.empty())
  {
    throw std::runtime_error("There are no lights on input port 2.");
  }

  Lights result;
  result.system = commonSystem(objects);
  for (std::size_t i = 0; i < objects.size(); ++i)
  {
    auto* data = vtkPolyData::SafeDownCast(objects[i]);
    try
    {
      result.lights.push_back(readLight(data, metresPerUnit, result.system));
    }
    catch (const std::exception& error)
    {
      throw std::runtime_error(title(i, data) + ": " + error.what() + ".");
    }
  }
  makeUnique(result.lights);
  return result;
}

} // namespace lumitree::filters
