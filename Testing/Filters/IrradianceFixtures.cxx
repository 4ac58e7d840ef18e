// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "IrradianceFixtures.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"

namespace lumitree::testing
{

void setField(vtkDataObject* object, const char* name, const std::vector<double>& tuple)
{
  const vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(tuple.size()));
  array->InsertNextTuple(tuple.data());
  object->GetFieldData()->AddArray(array);
}

void setText(vtkDataObject* object, const char* name, const std::string& text)
{
  const vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(text);
  object->GetFieldData()->AddArray(array);
}

namespace
{

vtkSmartPointer<vtkPolyData> light(
  const std::string& type, const std::string& name, bool photometric)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  setField(result, "LightSchema", { 1.0 });
  setText(result, "LightType", type);
  setText(result, "LightName", name);
  setField(result, "LightSystem", { photometric ? 1.0 : 0.0 });
  return result;
}

} // namespace

vtkSmartPointer<vtkPolyData> pointLight(
  const Point& position, double flux, const std::string& name, bool photometric)
{
  auto result = light("point", name, photometric);
  setField(result, photometric ? "LuminousFlux [lm]" : "RadiantFlux [W]", { flux });
  const vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(position.data());
  result->SetPoints(points);
  const vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  result->SetVerts(vertices);
  return result;
}

vtkSmartPointer<vtkPolyData> directionalLight(
  const Point& direction, double normalIrradiance, const std::string& name, bool photometric)
{
  auto result = light("directional", name, photometric);
  setField(result, "LightDirection", { direction[0], direction[1], direction[2] });
  setField(result, photometric ? "NormalIlluminance [lx]" : "NormalIrradiance [W/m^2]",
    { normalIrradiance });
  return result;
}

vtkSmartPointer<vtkPolyData> polygons(
  const std::vector<Point>& points, const std::vector<std::vector<vtkIdType>>& cells)
{
  const vtkNew<vtkPoints> coordinates;
  coordinates->SetDataTypeToDouble();
  for (const Point& p : points)
  {
    coordinates->InsertNextPoint(p.data());
  }
  const vtkNew<vtkCellArray> polys;
  for (const std::vector<vtkIdType>& cell : cells)
  {
    polys->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(coordinates);
  result->SetPolys(polys);
  return result;
}

vtkSmartPointer<vtkPolyData> floorStrip(double from, double size, int count)
{
  std::vector<Point> points;
  std::vector<std::vector<vtkIdType>> cells;
  for (int i = 0; i <= count; ++i)
  {
    points.push_back({ from + i * size, -0.5 * size, 0.0 });
    points.push_back({ from + i * size, 0.5 * size, 0.0 });
    if (i > 0)
    {
      const vtkIdType k = 2 * i;
      cells.push_back({ k - 2, k, k + 1, k - 1 });
    }
  }
  return polygons(points, cells);
}

vtkSmartPointer<vtkPolyData> wall()
{
  return polygons({ { 1, -10, 0 }, { 1, 10, 0 }, { 1, 10, 2 }, { 1, -10, 2 } }, { { 0, 1, 2, 3 } });
}

Irradiance::Irradiance(
  vtkDataObject* receivers, const std::vector<vtkSmartPointer<vtkPolyData>>& lights)
  : filter_(vtkSmartPointer<vtkLumiIrradiance>::New())
{
  if (receivers)
  {
    this->filter_->SetInputDataObject(0, receivers);
  }
  for (const auto& one : lights)
  {
    this->filter_->AddLightsData(one);
  }
  const vtkNew<vtkCallbackCommand> heard;
  heard->SetClientData(this);
  heard->SetCallback(
    [](vtkObject*, unsigned long event, void* self, void* message)
    {
      auto* me = static_cast<Irradiance*>(self);
      (event == vtkCommand::ErrorEvent ? me->errors : me->warnings) += 1;
      me->text = static_cast<const char*>(message);
    });
  for (vtkObject* speaker : { static_cast<vtkObject*>(this->filter_),
         static_cast<vtkObject*>(this->filter_->GetExecutive()) })
  {
    speaker->AddObserver(vtkCommand::ErrorEvent, heard);
    speaker->AddObserver(vtkCommand::WarningEvent, heard);
  }
}

Irradiance::~Irradiance()
{
  this->filter_->RemoveAllObservers();
  this->filter_->GetExecutive()->RemoveAllObservers();
}

vtkDataObject* Irradiance::run()
{
  this->filter_->Update();
  return this->filter_->GetOutputDataObject(0);
}

vtkDataArray* Irradiance::run(const char* arrayName)
{
  auto* output = vtkDataSet::SafeDownCast(this->run());
  if (!output)
  {
    return nullptr;
  }
  const bool points = this->filter_->GetReceiverLocation() == vtkLumiIrradiance::Points;
  return points ? output->GetPointData()->GetArray(arrayName)
                : output->GetCellData()->GetArray(arrayName);
}

} // namespace lumitree::testing
