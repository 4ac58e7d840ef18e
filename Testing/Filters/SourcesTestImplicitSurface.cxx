// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkLumiImplicitSurface: its bodies, as rays and light meet them, alone and beside meshes.
#include "SourcesTools.h"

#include "vtkLumiAccelerationStructure.h"
#include "vtkLumiDirectionalLight.h"
#include "vtkLumiImplicitSurface.h"
#include "vtkLumiIrradiance.h"
#include "vtkLumiRayCast.h"
#include "vtkLumiScene.h"

#include "vtkBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCone.h"
#include "vtkCylinder.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkImplicitBoolean.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlane.h"
#include "vtkPoints.h"
#include "vtkQuadric.h"
#include "vtkSphere.h"
#include "vtkTable.h"
#include "vtkTransform.h"

#include <cmath>
#include <limits>

using namespace sources;

namespace
{

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

vtkSmartPointer<vtkPolyData> rayData(const std::vector<std::array<Vec3, 2>>& rays)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> direction;
  direction->SetName("RayDirection");
  direction->SetNumberOfComponents(3);
  for (const auto& ray : rays)
  {
    points->InsertNextPoint(ray[0].data());
    direction->InsertNextTuple(ray[1].data());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->AddArray(direction);
  return data;
}

/// All hits of rays on a surface.
class Hits
{
public:
  Hits(vtkDataObject* surface, const std::vector<std::array<Vec3, 2>>& rays)
  {
    this->cast_->SetInputDataObject(0, surface);
    this->cast_->SetRaysData(rayData(rays));
    this->cast_->SetQuery(vtkLumiRayCast::All);
    this->cast_->SetPrecision(vtkLumiRayCast::Exact);
    this->cast_->PassSurfaceDataOn();
    this->cast_->Update();
    this->points = vtkPolyData::SafeDownCast(this->cast_->GetOutputDataObject(0));
  }

  [[nodiscard]] vtkIdType count() const { return this->points->GetNumberOfPoints(); }
  [[nodiscard]] double value(const char* name, vtkIdType i, int component = 0) const
  {
    return this->points->GetPointData()->GetArray(name)->GetComponent(i, component);
  }

  vtkPolyData* points = nullptr;

private:
  vtkNew<vtkLumiRayCast> cast_;
};

vtkSmartPointer<vtkPolyData> outputOf(vtkLumiImplicitSurface* source)
{
  source->Update();
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(source->GetOutput());
  return copy;
}

TEST(ImplicitSurface, EachShapeIsHitWhereItIs)
{
  struct Case
  {
    int shape;
    std::array<Vec3, 2> ray;
    std::vector<double> t;
    vtkIdType bodies;
  };
  const std::vector<Case> cases = {
    { vtkLumiImplicitSurface::Sphere, { Vec3{ -2, 0, 0 }, Vec3{ 1, 0, 0 } }, { 1.5, 2.5 }, 1 },
    { vtkLumiImplicitSurface::Ellipsoid, { Vec3{ 0, 0, -2 }, Vec3{ 0, 0, 1 } }, { 1, 3 }, 1 },
    { vtkLumiImplicitSurface::Cylinder, { Vec3{ 0, 0, -2 }, Vec3{ 0, 0, 1 } }, { 1.5, 2.5 }, 3 },
    { vtkLumiImplicitSurface::Cone, { Vec3{ 0.25, 0, -2 }, Vec3{ 0, 0, 1 } }, { 1.5, 2 }, 2 },
    { vtkLumiImplicitSurface::Paraboloid, { Vec3{ 0.25, 0, -2 }, Vec3{ 0, 0, 1 } }, { 2.25 }, 1 },
    { vtkLumiImplicitSurface::Disc, { Vec3{ 0.25, 0.25, -2 }, Vec3{ 0, 0, 1 } }, { 2 }, 1 },
    { vtkLumiImplicitSurface::Plane, { Vec3{ 0.9, -0.9, -2 }, Vec3{ 0, 0, 1 } }, { 2 }, 1 },
    { vtkLumiImplicitSurface::Box, { Vec3{ 0.9, -0.9, -2 }, Vec3{ 0, 0, 1 } }, { 1, 3 }, 6 },
    { vtkLumiImplicitSurface::Quadric, { Vec3{ 0, 0, -2 }, Vec3{ 0, 0, 1 } }, { 1, 3 }, 1 },
  };
  for (const Case& c : cases)
  {
    SCOPED_TRACE(c.shape);
    vtkNew<vtkLumiImplicitSurface> source;
    source->SetShape(c.shape);
    source->SetRadii(0.5, 0.5, 1.0);
    const auto data = outputOf(source);
    EXPECT_EQ(data->GetNumberOfVerts(), c.bodies);
    EXPECT_GT(data->GetNumberOfPolys(), 100);
    EXPECT_EQ(
      data->GetCellData()->GetArray("QuadricId")->GetNumberOfTuples(), data->GetNumberOfCells());
    const Hits hits(data, { c.ray });
    ASSERT_EQ(static_cast<std::size_t>(hits.count()), c.t.size());
    for (vtkIdType i = 0; i < hits.count(); ++i)
    {
      EXPECT_DOUBLE_EQ(hits.value("T", i), c.t[static_cast<std::size_t>(i)]);
      EXPECT_LT(hits.value("CellId", i), c.bodies);
      EXPECT_EQ(hits.value("QuadricId", i), hits.value("CellId", i));
      EXPECT_EQ(hits.value("UV", i), 0.0);
      double norm = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        norm += std::pow(hits.value("Normals", i, k), 2);
      }
      EXPECT_NEAR(norm, 1.0, 1e-14);
    }
    // The polygons that show it are near it, and face where the form grows.
    for (vtkIdType p = c.bodies; p < data->GetNumberOfPoints(); p += 17)
    {
      const Vec3 n = tuple(data->GetPointData()->GetNormals(), p);
      EXPECT_NEAR(length(n), 1.0, 1e-12);
    }
    source->SetPreviewResolution(0);
    EXPECT_EQ(outputOf(source)->GetNumberOfPolys(), 0);
    EXPECT_EQ(Hits(outputOf(source), { c.ray }).count(), hits.count());
  }
}

TEST(ImplicitSurface, StandsBesideMeshes)
{
  vtkNew<vtkLumiScene> mesh; // a sphere of radius 1
  mesh->SetScene(vtkLumiScene::Sphere);
  mesh->SetResolution(5);
  mesh->Update();
  vtkNew<vtkLumiImplicitSurface> ball;
  ball->SetRadius(2.0);
  vtkNew<vtkLumiImplicitSurface> far;
  far->SetCenter(0, 0, 9);
  vtkNew<vtkMultiBlockDataSet> scene;
  scene->SetBlock(0, outputOf(ball));
  scene->SetBlock(1, mesh->GetOutput());
  scene->SetBlock(2, outputOf(far));
  const Hits hits(scene, { { Vec3{ 0.01, 0.02, -5 }, Vec3{ 0, 0, 1 } } });
  ASSERT_EQ(hits.count(), 6);
  const double composite[] = { 1, 2, 2, 1, 3, 3 };
  for (vtkIdType i = 0; i < 6; ++i)
  {
    EXPECT_EQ(hits.value("CompositeIndex", i), composite[i]) << i;
  }
  EXPECT_EQ(hits.value("CellId", 0), 0.0);
  EXPECT_EQ(hits.value("CellId", 5), 0.0);
  EXPECT_GT(hits.value("CellId", 1), 0.0);
}

TEST(ImplicitSurface, AnOutputThatWasChangedIsRefused)
{
  vtkNew<vtkLumiImplicitSurface> source;
  const auto data = outputOf(source);
  const auto refused = [&](vtkPolyData* surface, const char* because)
  {
    vtkNew<vtkLumiRayCast> cast;
    vtkNew<Messages> messages;
    messages->watch(cast);
    cast->SetInputDataObject(0, surface);
    cast->SetRaysData(rayData({ { Vec3{ -2, 0, 0 }, Vec3{ 1, 0, 0 } } }));
    cast->Update();
    EXPECT_EQ(messages->errors, 1);
    EXPECT_NE(messages->last.find(because), std::string::npos) << messages->last;
  };
  vtkNew<vtkPolyData> moved;
  moved->DeepCopy(data);
  moved->GetPoints()->SetPoint(0, 1, 0, 0);
  refused(moved, "not those of their source");
  vtkNew<vtkPolyData> withoutVertices;
  withoutVertices->DeepCopy(data);
  withoutVertices->SetVerts(nullptr);
  refused(withoutVertices, "not those of their source");
  vtkNew<vtkPolyData> joined; // as Append Geometry leaves it: a cell more, no array for it
  joined->DeepCopy(data);
  const vtkIdType corners[] = { 1, 2, 3 };
  joined->GetPolys()->InsertNextCell(3, corners);
  joined->GetCellData()->RemoveArray("QuadricId");
  refused(joined, "not those of their source");
  vtkNew<vtkPolyData> without;
  without->DeepCopy(data);
  without->GetFieldData()->RemoveArray("QuadricCuts");
  refused(without, "QuadricCuts");
  vtkNew<vtkPolyData> later;
  later->DeepCopy(data);
  later->GetFieldData()->GetArray("QuadricSchema")->SetComponent(0, 0, 3);
  refused(later, "schema");
}

TEST(ImplicitSurface, FunctionsOfVtk)
{
  vtkNew<vtkSphere> sphere;
  sphere->SetRadius(0.7);
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1, 2, 3);
  vtkNew<vtkCylinder> cylinder;
  cylinder->SetRadius(0.3);
  vtkNew<vtkCone> cone;
  cone->SetAngle(30);
  vtkNew<vtkQuadric> quadric;
  quadric->SetCoefficients(1, 2, 3, 0.5, -0.25, 0.125, 0.1, 0.2, -0.3, -0.5);
  vtkNew<vtkBox> box;
  box->SetBounds(-0.5, 0.25, -0.5, 0.75, -0.5, 3);
  vtkNew<vtkTransform> transform;
  transform->RotateX(20);
  transform->Scale(1.5, 0.75, 1);
  transform->Translate(0.1, 0, 0.2);
  for (vtkImplicitFunction* function :
    std::initializer_list<vtkImplicitFunction*>{ sphere, plane, cylinder, cone, quadric, box })
  {
    for (const bool transformed : { false, true })
    {
      SCOPED_TRACE(function->GetClassName() + std::string(transformed ? ", transformed" : ""));
      function->SetTransform(transformed ? transform.Get() : nullptr);
      vtkNew<vtkLumiImplicitSurface> source;
      source->SetShape(vtkLumiImplicitSurface::Function);
      source->SetImplicitFunction(function);
      std::vector<std::array<Vec3, 2>> rays;
      for (int i = 0; i < 60; ++i)
      {
        const Vec3 from = { std::sin(i), std::cos(1.7 * i), std::sin(0.3 * i + 1) };
        const Vec3 to = { 0.5 * std::sin(2.1 * i), 0.5 * std::cos(i), 0.5 * std::sin(5.0 * i) };
        rays.push_back({ 3.0 * from, to - 3.0 * from });
      }
      const Hits hits(outputOf(source), rays);
      EXPECT_GT(hits.count(), 10);
      for (vtkIdType i = 0; i < hits.count(); ++i)
      {
        Vec3 p = point(hits.points, i);
        EXPECT_NEAR(function->FunctionValue(p.data()), 0.0, 1e-12);
        for (int k = 0; k < 3; ++k)
        {
          EXPECT_LE(std::fabs(p[k]), 1.0 + 1e-12);
        }
      }
    }
  }
}

TEST(ImplicitSurface, WhatItCannotMakeIsOneError)
{
  vtkNew<vtkLumiImplicitSurface> source;
  vtkNew<Messages> messages;
  messages->watch(source);
  const auto fails = [&](const char* because)
  {
    messages->errors = 0;
    source->Modified();
    source->Update();
    EXPECT_EQ(messages->errors, 1);
    EXPECT_NE(messages->last.find(because), std::string::npos) << messages->last;
    EXPECT_EQ(source->GetOutput()->GetNumberOfCells(), 0);
  };
  source->SetShape(vtkLumiImplicitSurface::Function);
  fails("needs an ImplicitFunction");
  vtkNew<vtkImplicitBoolean> nothing;
  source->SetImplicitFunction(nothing);
  fails("has no functions");

  vtkNew<vtkPolyData> points;
  source->SetInputData(points);
  fails("cannot be put at points");
  source->SetShape(vtkLumiImplicitSurface::Sphere);
  source->SetRadiusArray("Nowhere");
  fails("no point array Nowhere of 1 component");
}

TEST(ImplicitSurface, ABodyAtEachPoint)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(3, 0, 0);
  points->InsertNextPoint(6, 0, 0);
  points->InsertNextPoint(9, 0, 0);
  vtkNew<vtkDoubleArray> size;
  size->SetName("Size");
  for (const double s : { 1.0, 2.0, -1.0, nan })
  {
    size->InsertNextValue(s);
  }
  vtkNew<vtkPolyData> input;
  input->SetPoints(points);
  input->GetPointData()->AddArray(size);
  vtkNew<vtkLumiImplicitSurface> source;
  source->SetInputData(input);
  source->SetRadiusArray("Size");
  const auto data = outputOf(source);
  EXPECT_EQ(data->GetNumberOfVerts(), 4);
  const Hits hits(data, { { Vec3{ -2, 0, 0 }, Vec3{ 1, 0, 0 } } });
  ASSERT_EQ(hits.count(), 4);
  EXPECT_DOUBLE_EQ(hits.value("T", 0), 1.5);
  EXPECT_DOUBLE_EQ(hits.value("T", 2), 4.0);
  EXPECT_DOUBLE_EQ(hits.value("T", 3), 6.0);
  EXPECT_EQ(hits.value("Size", 0), 1.0);
  EXPECT_EQ(hits.value("Size", 3), 2.0);

  for (const int shape : { vtkLumiImplicitSurface::Ellipsoid, vtkLumiImplicitSurface::Cylinder,
         vtkLumiImplicitSurface::Cone, vtkLumiImplicitSurface::Paraboloid,
         vtkLumiImplicitSurface::Disc })
  {
    source->SetShape(shape);
    const Hits others(outputOf(source), { { Vec3{ -2, 0.01, 0.02 }, Vec3{ 1, 0, 0 } } });
    EXPECT_EQ(others.count(), shape == vtkLumiImplicitSurface::Disc ? 0 : 4) << shape;
  }

  vtkNew<vtkLumiAccelerationStructure> structure;
  structure->SetInputData(0, data);
  structure->Update();
  auto* table = vtkTable::SafeDownCast(structure->GetOutputDataObject(1));
  EXPECT_EQ(table->GetValueByName(0, "Primitives").ToInt(), 4);
  EXPECT_EQ(table->GetValueByName(0, "Quadrics").ToInt(), 4);
  EXPECT_EQ(table->GetValueByName(0, "SkippedEmptyQuadrics").ToInt(), 2);
  EXPECT_EQ(table->GetValueByName(0, "SkippedNonFinite").ToInt(), 0);
}

TEST(ImplicitSurface, LightFallsOnItsPolygons)
{
  // The polygons of a ball are its receivers, the ball itself the occluder; it does not shadow
  // itself, and a disc above does.
  vtkNew<vtkLumiImplicitSurface> ball;
  vtkNew<vtkLumiImplicitSurface> disc;
  disc->SetShape(vtkLumiImplicitSurface::Disc);
  disc->SetRadius(0.2);
  disc->SetCenter(0, 0, 2);
  vtkNew<vtkMultiBlockDataSet> scene;
  scene->SetBlock(0, outputOf(ball));
  scene->SetBlock(1, outputOf(disc));
  vtkNew<vtkLumiDirectionalLight> sun;
  sun->SetDirection(0, 0, -1);
  sun->Update();
  for (const int location : { vtkLumiIrradiance::Points, vtkLumiIrradiance::Cells })
  {
    vtkNew<vtkLumiIrradiance> light;
    light->SetInputData(0, scene);
    light->SetInputConnection(2, sun->GetOutputPort());
    light->SetReceiverLocation(location);
    light->Update();
    auto* lit = vtkDataSet::SafeDownCast(
      vtkMultiBlockDataSet::SafeDownCast(light->GetOutputDataObject(0))->GetBlock(0));
    vtkDataSetAttributes* attributes = location == vtkLumiIrradiance::Points
      ? static_cast<vtkDataSetAttributes*>(lit->GetPointData())
      : lit->GetCellData();
    vtkDataArray* irradiance = attributes->GetArray("Irradiance [W/m^2]");
    ASSERT_TRUE(irradiance);
    double largest = 0.0;
    for (vtkIdType i = 1; i < irradiance->GetNumberOfTuples(); ++i)
    {
      largest = std::max(largest, irradiance->GetComponent(i, 0));
    }
    ASSERT_GT(largest, 0.0);
    if (location == vtkLumiIrradiance::Points)
    {
      const double full = largest / std::sqrt(0.75);
      for (vtkIdType i = 1; i < lit->GetNumberOfPoints(); ++i)
      {
        const Vec3 p = point(lit, i);
        const double away = std::hypot(p[0], p[1]);
        if (std::fabs(away - 0.2) > 0.01 && p[2] > 0.0)
        {
          const double cosine = tuple(lit->GetPointData()->GetNormals(), i)[2];
          EXPECT_NEAR(irradiance->GetComponent(i, 0), away < 0.2 ? 0.0 : full * cosine, 0.2 * full);
          EXPECT_EQ(irradiance->GetComponent(i, 0) > 0.0, away > 0.2);
        }
      }
    }
  }
}

} // namespace
