// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkLumiImplicitSurface: functions of VTK that are more than a quadric.
#include "SourcesTools.h"

#include "vtkLumiImplicitSurface.h"
#include "vtkLumiRayCast.h"

#include "vtkBox.h"
#include "vtkCylinder.h"
#include "vtkFieldData.h"
#include "vtkImplicitBoolean.h"
#include "vtkImplicitSum.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPerlinNoise.h"
#include "vtkPlane.h"
#include "vtkPlanes.h"
#include "vtkPoints.h"
#include "vtkSphere.h"
#include "vtkSuperquadric.h"
#include "vtkTransform.h"

#include <cmath>

using namespace sources;

namespace
{

vtkSmartPointer<vtkPolyData> raysAtBox(int count)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> direction;
  direction->SetName("RayDirection");
  direction->SetNumberOfComponents(3);
  for (int i = 0; i < count; ++i)
  {
    const Vec3 from = { 3 * std::sin(i), 3 * std::cos(1.7 * i), 3 * std::sin(0.3 * i + 1) };
    const Vec3 to = { 0.5 * std::sin(2.1 * i), 0.5 * std::cos(i), 0.5 * std::sin(5.0 * i) };
    const Vec3 d = to - from;
    points->InsertNextPoint(from.data());
    direction->InsertNextTuple(d.data());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->AddArray(direction);
  return data;
}

struct Seen
{
  int guarantee = -1;
  vtkSmartPointer<vtkPolyData> surface = vtkSmartPointer<vtkPolyData>::New();
  vtkSmartPointer<vtkPolyData> hits = vtkSmartPointer<vtkPolyData>::New();
};

Seen see(vtkImplicitFunction* function, double step = 0.0)
{
  vtkNew<vtkLumiImplicitSurface> source;
  source->SetShape(vtkLumiImplicitSurface::Function);
  source->SetImplicitFunction(function);
  source->SetStep(step);
  source->Update();
  Seen seen;
  seen.surface->ShallowCopy(source->GetOutput());
  vtkDataArray* const guarantee = seen.surface->GetFieldData()->GetArray("ImplicitGuarantee");
  seen.guarantee = guarantee ? static_cast<int>(guarantee->GetComponent(0, 0)) : -1;
  vtkNew<vtkLumiRayCast> cast;
  cast->SetInputDataObject(0, seen.surface);
  cast->SetRaysData(raysAtBox(60));
  cast->SetQuery(vtkLumiRayCast::All);
  cast->SetPrecision(vtkLumiRayCast::Exact);
  cast->Update();
  seen.hits->ShallowCopy(cast->GetOutputDataObject(0));
  return seen;
}

/// Every sign change that fine samples see is hit, and every hit is a zero.
void expectZeros(vtkImplicitFunction* function, const Seen& seen, double tolerance)
{
  const vtkIdType n = seen.hits->GetNumberOfPoints();
  EXPECT_GT(n, 10);
  for (vtkIdType i = 0; i < n; ++i)
  {
    Vec3 p = point(seen.hits, i);
    EXPECT_NEAR(function->FunctionValue(p.data()), 0.0, tolerance) << i;
  }
  const auto rays = raysAtBox(60);
  vtkDataArray* const directions = rays->GetPointData()->GetArray("RayDirection");
  vtkDataArray* const rayIds = seen.hits->GetPointData()->GetArray("RayId");
  std::vector<int> found(60, 0);
  for (vtkIdType i = 0; i < n; ++i)
  {
    ++found[static_cast<std::size_t>(rayIds->GetComponent(i, 0))];
  }
  for (vtkIdType r = 0; r < 60; ++r)
  {
    const Vec3 o = point(rays, r);
    Vec3 d;
    directions->GetTuple(r, d.data());
    int changes = 0;
    int last = 0;
    for (int i = 0; i <= 4000; ++i)
    {
      Vec3 p = o + (i / 1500.0) * d;
      if (std::max({ std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2]) }) > 1.0)
      {
        last = 0;
        continue;
      }
      const int sign = function->FunctionValue(p.data()) < 0.0 ? -1 : 1;
      changes += last * sign < 0 ? 1 : 0;
      last = sign;
    }
    EXPECT_GE(found[static_cast<std::size_t>(r)], changes) << r;
  }
}

class Functions : public ::testing::Test
{
protected:
  Functions()
  {
    this->sphere->SetRadius(0.8);
    this->hole->SetRadius(0.4);
    this->box->SetBounds(-0.6, 0.6, -0.5, 0.7, -0.6, 0.9);
    this->turn->RotateX(20);
    this->turn->RotateZ(35);
  }

  vtkNew<vtkSphere> sphere;
  vtkNew<vtkCylinder> hole;
  vtkNew<vtkBox> box;
  vtkNew<vtkTransform> turn;
};

TEST_F(Functions, BooleansOfQuadricsAreExact)
{
  for (int operation = 0; operation < 4; ++operation)
  {
    for (const bool turned : { false, true })
    {
      SCOPED_TRACE(operation);
      vtkNew<vtkImplicitBoolean> inner;
      inner->SetOperationTypeToIntersection();
      inner->AddFunction(this->sphere);
      inner->AddFunction(this->box);
      this->box->SetTransform(turned ? this->turn.Get() : nullptr);
      vtkNew<vtkImplicitBoolean> all;
      all->SetOperationType(operation);
      all->AddFunction(inner);
      all->AddFunction(this->hole);
      all->SetTransform(turned ? this->turn.Get() : nullptr);
      const Seen seen = see(all);
      EXPECT_EQ(seen.guarantee, 0);
      EXPECT_GT(seen.surface->GetNumberOfVerts(), 6);
      EXPECT_EQ(seen.hits->GetPointData()->GetArray("HitFlags"), nullptr);
      expectZeros(all, seen, 1e-9);
    }
  }
}

TEST_F(Functions, TurnedBoxesAndPlanesAreExact)
{
  this->box->SetTransform(this->turn);
  const Seen seen = see(this->box);
  EXPECT_EQ(seen.guarantee, 0);
  EXPECT_EQ(seen.surface->GetNumberOfVerts(), 6);
  expectZeros(this->box, seen, 1e-12);
  vtkNew<vtkPlanes> planes;
  planes->SetBounds(-0.5, 0.5, -0.6, 0.6, -0.7, 0.7);
  const Seen cut = see(planes);
  EXPECT_EQ(cut.guarantee, 0);
  expectZeros(planes, cut, 1e-12);
}

TEST_F(Functions, SuperquadricsGoByIntervals)
{
  vtkNew<vtkSuperquadric> body;
  body->SetSize(0.8);
  body->SetScale(1.0, 0.7, 0.9);
  for (const bool toroidal : { false, true })
  {
    for (const double roundness : { 0.3, 1.0, 1.8 })
    {
      SCOPED_TRACE(roundness);
      body->SetToroidal(toroidal);
      body->SetPhiRoundness(roundness);
      body->SetThetaRoundness(0.8);
      body->SetTransform(toroidal ? this->turn.Get() : nullptr);
      const Seen seen = see(body);
      EXPECT_EQ(seen.guarantee, 1);
      expectZeros(body, seen, 1e-9);
      vtkDataArray* const flags = seen.hits->GetPointData()->GetArray("HitFlags");
      ASSERT_NE(flags, nullptr);
      EXPECT_EQ(flags->GetRange()[0], 0.0);
    }
  }
  vtkNew<vtkImplicitBoolean> bitten;
  bitten->SetOperationTypeToDifference();
  bitten->AddFunction(body);
  bitten->AddFunction(this->hole);
  EXPECT_EQ(see(bitten).guarantee, 1);
}

TEST_F(Functions, OthersAreSampled)
{
  vtkNew<vtkPerlinNoise> noise;
  noise->SetFrequency(2, 2, 2);
  const Seen seen = see(noise);
  EXPECT_EQ(seen.guarantee, 2);
  expectZeros(noise, seen, 1e-9);
  EXPECT_EQ(seen.hits->GetPointData()->GetArray("HitFlags")->GetRange()[0], 2.0);
  vtkNew<vtkImplicitSum> sum;
  sum->AddFunction(this->sphere, 1.0);
  sum->AddFunction(this->hole, 0.5);
  EXPECT_EQ(see(sum).guarantee, 2);

  // What cannot be counted, and what the data does not hold, is one error.
  const auto fails = [&](vtkPolyData* surface, int query, const char* because)
  {
    vtkNew<vtkLumiRayCast> cast;
    vtkNew<Messages> messages;
    messages->watch(cast);
    cast->SetInputDataObject(0, surface);
    cast->SetRaysData(raysAtBox(3));
    cast->SetPrecision(vtkLumiRayCast::Exact);
    cast->SetQuery(query);
    cast->Update();
    EXPECT_EQ(messages->errors, 1);
    EXPECT_NE(messages->last.find(because), std::string::npos) << messages->last;
  };
  fails(seen.surface, vtkLumiRayCast::Crossings, "only sampled");
  // As a file would give it back: the numbers alone.
  vtkDataArray* const definition = seen.surface->GetFieldData()->GetArray("ImplicitBox");
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("ImplicitBox");
  numbers->SetNumberOfComponents(7);
  numbers->InsertNextTuple(definition->GetTuple(0));
  vtkNew<vtkPolyData> read;
  read->DeepCopy(seen.surface);
  read->GetFieldData()->AddArray(numbers);
  fails(read, vtkLumiRayCast::Closest, "does not outlive its process");

  vtkNew<vtkLumiImplicitSurface> source;
  source->SetShape(vtkLumiImplicitSurface::Function);
  source->SetImplicitFunction(noise);
  source->SetStep(-1.0);
  source->Update();
  fails(source->GetOutput(), vtkLumiRayCast::Closest, "the step of an implicit");
}

TEST_F(Functions, InsideOfABoolean)
{
  vtkNew<vtkImplicitBoolean> all;
  all->SetOperationTypeToDifference();
  all->AddFunction(this->sphere);
  all->AddFunction(this->box);
  const Seen seen = see(all);
  vtkNew<vtkLumiRayCast> cast;
  cast->SetInputDataObject(0, seen.surface);
  const auto rays = raysAtBox(60);
  for (vtkIdType i = 0; i < 60; ++i)
  {
    Vec3 p = 0.3 * point(rays, i);
    rays->GetPoints()->SetPoint(i, p.data());
  }
  cast->SetRaysData(rays);
  cast->SetQuery(vtkLumiRayCast::Crossings);
  cast->SetPrecision(vtkLumiRayCast::Exact);
  cast->Update();
  auto* const out = vtkDataSet::SafeDownCast(cast->GetOutputDataObject(1));
  vtkDataArray* const inside = out->GetPointData()->GetArray("Inside");
  ASSERT_NE(inside, nullptr);
  for (vtkIdType i = 0; i < 60; ++i)
  {
    Vec3 p;
    rays->GetPoint(i, p.data());
    EXPECT_EQ(inside->GetComponent(i, 0), all->FunctionValue(p.data()) < 0.0 ? 1.0 : 0.0) << i;
  }
}

}
