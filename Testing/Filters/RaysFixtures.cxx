// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RaysFixtures.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <cstring>

namespace lumitree::testing
{

namespace
{

/// SplitMix64 (Steele and others 2014), uniform in [0, 1).
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : state_(seed)
  {
  }
  double operator()()
  {
    this->state_ += 0x9E3779B97F4A7C15u;
    std::uint64_t z = this->state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }

private:
  std::uint64_t state_;
};

Point inBall(Random& random)
{
  Point p;
  double squared = 0.0;
  do
  {
    squared = 0.0;
    for (double& x : p)
    {
      x = 2.0 * random() - 1.0;
      squared += x * x;
    }
  } while (squared > 1.0 || squared < 1e-4);
  return p;
}

vtkSmartPointer<vtkDataArray> triples(
  const std::vector<TestRay>& rays, bool directions, int type, const char* name)
{
  const auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName(name);
  array->SetNumberOfComponents(3);
  for (const TestRay& ray : rays)
  {
    array->InsertNextTuple((directions ? ray.direction : ray.origin).data());
  }
  return array;
}

} // namespace

vtkSmartPointer<vtkPolyData> polyData(const data::Mesh& mesh, int pointType)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(pointType);
  for (std::size_t i = 0; i < mesh.points.size(); i += 3)
  {
    points->InsertNextPoint(&mesh.points[i]);
  }
  vtkNew<vtkCellArray> polygons;
  for (std::int64_t c = 0; c < mesh.numberOfCells(); ++c)
  {
    const auto cell = static_cast<std::size_t>(c);
    const std::vector<vtkIdType> ids(mesh.connectivity.begin() + mesh.offsets[cell],
      mesh.connectivity.begin() + mesh.offsets[cell + 1]);
    polygons->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(polygons);
  return result;
}

vtkSmartPointer<vtkPolyData> triangles(const std::vector<Point>& corners)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const vtkIdType id = points->InsertNextPoint(corners[i].data());
    if (i % 3 == 0)
    {
      cells->InsertNextCell(3);
    }
    cells->InsertCellPoint(id);
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(cells);
  return result;
}

std::vector<TestRay> raysAtUnitBall(int count, double radius, std::uint64_t seed)
{
  Random random(seed);
  std::vector<TestRay> rays;
  for (int i = 0; i < count; ++i)
  {
    const Point from = inBall(random);
    const Point to = inBall(random);
    const double scale =
      radius / std::sqrt(from[0] * from[0] + from[1] * from[1] + from[2] * from[2]);
    const double speed = 0.25 + random();
    TestRay ray;
    for (std::size_t k = 0; k < 3; ++k)
    {
      ray.origin[k] = scale * from[k];
      ray.direction[k] = speed * (1.4 * to[k] - ray.origin[k]);
    }
    rays.push_back(ray);
  }
  return rays;
}

vtkSmartPointer<vtkPolyData> pointRays(
  const std::vector<TestRay>& rays, int pointType, int directionType)
{
  vtkNew<vtkPoints> points;
  points->SetData(triples(rays, false, pointType, "Points"));
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < static_cast<vtkIdType>(rays.size()); ++i)
  {
    vertices->InsertNextCell(1, &i);
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetVerts(vertices);
  result->GetPointData()->AddArray(triples(rays, true, directionType, "RayDirection"));
  return result;
}

vtkSmartPointer<vtkImageData> imageRays(const std::vector<TestRay>& rays, int width)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, static_cast<int>(rays.size()) / width, 1);
  image->GetPointData()->AddArray(triples(rays, false, VTK_DOUBLE, "RayOrigin"));
  image->GetPointData()->AddArray(triples(rays, true, VTK_DOUBLE, "RayDirection"));
  return image;
}

vtkSmartPointer<vtkPolyData> lineRays(const std::vector<TestRay>& rays, double length)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const TestRay& ray : rays)
  {
    Point end;
    for (std::size_t k = 0; k < 3; ++k)
    {
      end[k] = ray.origin[k] + length * ray.direction[k];
    }
    const vtkIdType first = points->InsertNextPoint(ray.origin.data());
    const vtkIdType ids[2] = { first, points->InsertNextPoint(end.data()) };
    lines->InsertNextCell(2, ids);
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetLines(lines);
  return result;
}

struct Messages::Link
{
  vtkSmartPointer<vtkObject> object;
  unsigned long tag;
};

Messages::Messages(vtkAlgorithm* filter)
{
  const vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback(
    [](vtkObject*, unsigned long event, void* self, void* data)
    {
      auto* messages = static_cast<Messages*>(self);
      ++(event == vtkCommand::ErrorEvent ? messages->errors : messages->warnings);
      messages->text = data ? static_cast<const char*>(data) : "";
    });
  for (vtkObject* object :
    { static_cast<vtkObject*>(filter), static_cast<vtkObject*>(filter->GetExecutive()) })
  {
    for (const unsigned long event : { vtkCommand::ErrorEvent, vtkCommand::WarningEvent })
    {
      this->links_.push_back({ object, object->AddObserver(event, command) });
    }
  }
}

Messages::~Messages()
{
  for (const Link& link : this->links_)
  {
    link.object->RemoveObserver(link.tag);
  }
}

bool sameBits(vtkAbstractArray* a, vtkAbstractArray* b)
{
  return a && b &&
    std::string(a->GetName() ? a->GetName() : "") == (b->GetName() ? b->GetName() : "") &&
    a->GetDataType() == b->GetDataType() &&
    a->GetNumberOfComponents() == b->GetNumberOfComponents() &&
    a->GetNumberOfTuples() == b->GetNumberOfTuples() &&
    (a->GetNumberOfValues() == 0 ||
      std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
        static_cast<std::size_t>(a->GetNumberOfValues() * a->GetDataTypeSize())) == 0);
}

bool sameBits(vtkFieldData* a, vtkFieldData* b)
{
  bool same = a->GetNumberOfArrays() == b->GetNumberOfArrays();
  for (int i = 0; same && i < a->GetNumberOfArrays(); ++i)
  {
    same = sameBits(a->GetAbstractArray(i), b->GetAbstractArray(i));
  }
  return same;
}

std::string shape(vtkFieldData* data, const char* name)
{
  vtkAbstractArray* array = data->GetAbstractArray(name);
  if (!array)
  {
    return "";
  }
  const std::string type =
    array->GetDataType() == VTK_ID_TYPE ? "id" : array->GetDataTypeAsString();
  return type + " " + std::to_string(array->GetNumberOfComponents());
}

double value(vtkFieldData* data, const char* name, vtkIdType tuple, int component)
{
  return data->GetArray(name)->GetComponent(tuple, component);
}

} // namespace lumitree::testing
