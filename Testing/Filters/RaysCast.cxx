// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkLumiRayCast by the data model: what each query gives, and that it is right.
#include "RaysFixtures.h"

#include "vtkLumiAccelerationStructure.h"
#include "vtkLumiRayCast.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <string>

using namespace lumitree::testing;

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Outputs
{
  vtkPolyData* hits;
  vtkDataSet* rays;
  vtkPointData* hit;
  vtkPointData* ray;
};

Outputs outputs(vtkLumiRayCast* cast)
{
  auto* hits = vtkPolyData::SafeDownCast(cast->GetOutputDataObject(0));
  auto* rays = vtkDataSet::SafeDownCast(cast->GetOutputDataObject(1));
  return { hits, rays, hits->GetPointData(), rays->GetPointData() };
}

/// t of every hit of a ray, by Cramer's rule on each triangle.
std::vector<double> naiveHits(vtkPolyData* surface, const TestRay& ray)
{
  std::vector<double> ts;
  const auto cross = [](const Point& a, const Point& b) -> Point {
    return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
  };
  const auto dot = [](const Point& a, const Point& b)
  { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const auto minus = [](const Point& a, const Point& b) -> Point {
    return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
  };
  for (vtkIdType c = 0; c < surface->GetNumberOfCells(); ++c)
  {
    Point p[3];
    vtkNew<vtkIdList> ids;
    surface->GetCellPoints(c, ids);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      surface->GetPoint(ids->GetId(k), p[k].data());
    }
    const Point a = minus(p[1], p[0]);
    const Point b = minus(p[2], p[0]);
    const Point s = minus(ray.origin, p[0]);
    const double det = dot(cross(ray.direction, b), a);
    const double u = dot(cross(ray.direction, b), s) / det;
    const double v = dot(cross(s, a), ray.direction) / det;
    const double t = dot(cross(s, a), b) / det;
    if (u >= 0 && v >= 0 && u + v <= 1 && t >= 0)
    {
      ts.push_back(t);
    }
  }
  std::sort(ts.begin(), ts.end());
  return ts;
}

class RayCast : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->surface_ = polyData(lumitree::data::sphere(6));
    this->rays_ = raysAtUnitBall(500);
    this->cast_->SetInputData(0, this->surface_);
    this->cast_->SetRaysData(pointRays(this->rays_));
  }

  Outputs run(int query)
  {
    this->cast_->SetQuery(query);
    this->cast_->Update();
    return outputs(this->cast_);
  }

  vtkSmartPointer<vtkPolyData> surface_;
  std::vector<TestRay> rays_;
  vtkNew<vtkLumiRayCast> cast_;
};

} // namespace

TEST_F(RayCast, ClosestArraysAreThoseOfTheDataModel)
{
  const Outputs out = this->run(vtkLumiRayCast::Closest);
  EXPECT_EQ(shape(out.hit, "RayId"), "id 1");
  EXPECT_EQ(shape(out.hit, "T"), "double 1");
  EXPECT_EQ(shape(out.hit, "CellId"), "id 1");
  EXPECT_EQ(shape(out.hit, "CompositeIndex"), "int 1");
  EXPECT_EQ(shape(out.hit, "UV"), "double 2");
  EXPECT_EQ(shape(out.hit, "Normals"), "double 3");
  EXPECT_EQ(out.hit->GetNumberOfArrays(), 6);

  EXPECT_EQ(shape(out.ray, "HitMask"), "unsigned char 1");
  EXPECT_EQ(shape(out.ray, "HitCount"), "id 1");
  EXPECT_EQ(shape(out.ray, "HitOffset"), "id 1");
  EXPECT_EQ(shape(out.ray, "T"), "double 1");
  EXPECT_EQ(shape(out.ray, "CellId"), "id 1");
  EXPECT_EQ(shape(out.ray, "CompositeIndex"), "int 1");
  EXPECT_EQ(out.ray->GetNumberOfArrays(), 7); // and RayDirection, as it came
}

TEST_F(RayCast, OffsetsHitsAndMissesAgree)
{
  for (const int query : { vtkLumiRayCast::Closest, vtkLumiRayCast::All })
  {
    const Outputs out = this->run(query);
    vtkIdType next = 0;
    vtkIdType misses = 0;
    for (vtkIdType r = 0; r < out.rays->GetNumberOfPoints(); ++r)
    {
      const auto count = static_cast<vtkIdType>(value(out.ray, "HitCount", r));
      ASSERT_EQ(value(out.ray, "HitOffset", r), next);
      ASSERT_EQ(value(out.ray, "HitMask", r), count > 0 ? 1 : 0);
      for (vtkIdType h = next; h < next + count; ++h)
      {
        ASSERT_EQ(value(out.hit, "RayId", h), r);
        ASSERT_TRUE(h == next || value(out.hit, "T", h - 1) <= value(out.hit, "T", h));
      }
      if (count > 0)
      {
        ASSERT_EQ(value(out.ray, "T", r), value(out.hit, "T", next));
        ASSERT_EQ(value(out.ray, "CellId", r), value(out.hit, "CellId", next));
        ASSERT_EQ(value(out.ray, "CompositeIndex", r), 0);
      }
      else
      {
        ++misses;
        ASSERT_EQ(value(out.ray, "T", r), infinity);
        ASSERT_EQ(value(out.ray, "CellId", r), -1);
        ASSERT_EQ(value(out.ray, "CompositeIndex", r), -1);
      }
      next += count;
    }
    EXPECT_EQ(next, out.hits->GetNumberOfPoints());
    EXPECT_EQ(next, out.hits->GetNumberOfVerts());
    EXPECT_GT(misses, 0);
    EXPECT_LT(misses, out.rays->GetNumberOfPoints());
  }
}

TEST_F(RayCast, HitsAreWhereTheyShouldBe)
{
  const Outputs out = this->run(vtkLumiRayCast::All);
  vtkIdType h = 0;
  for (std::size_t r = 0; r < this->rays_.size(); ++r)
  {
    for (const double t : naiveHits(this->surface_, this->rays_[r]))
    {
      ASSERT_LT(h, out.hits->GetNumberOfPoints());
      ASSERT_EQ(value(out.hit, "RayId", h), static_cast<double>(r));
      ASSERT_NEAR(value(out.hit, "T", h), t, 1e-12 * (1 + t));
      ++h;
    }
  }
  EXPECT_EQ(h, out.hits->GetNumberOfPoints());
}

TEST_F(RayCast, PointUvAndNormalBelongToTheTriangle)
{
  const Outputs out = this->run(vtkLumiRayCast::All);
  for (vtkIdType h = 0; h < out.hits->GetNumberOfPoints(); ++h)
  {
    const TestRay& ray = this->rays_[static_cast<std::size_t>(value(out.hit, "RayId", h))];
    const double u = value(out.hit, "UV", h, 0);
    const double v = value(out.hit, "UV", h, 1);
    vtkNew<vtkIdList> ids;
    this->surface_->GetCellPoints(static_cast<vtkIdType>(value(out.hit, "CellId", h)), ids);
    Point p[3];
    for (vtkIdType k = 0; k < 3; ++k)
    {
      this->surface_->GetPoint(ids->GetId(k), p[k].data());
    }
    Point at;
    out.hits->GetPoint(h, at.data());
    double outward = 0.0;
    double squared = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const int c = static_cast<int>(k);
      EXPECT_NEAR(at[k], ray.origin[k] + value(out.hit, "T", h) * ray.direction[k], 1e-13);
      EXPECT_NEAR(at[k], (1 - u - v) * p[0][k] + u * p[1][k] + v * p[2][k], 1e-12);
      outward += value(out.hit, "Normals", h, c) * p[0][k];
      squared += value(out.hit, "Normals", h, c) * value(out.hit, "Normals", h, c);
    }
    EXPECT_GT(outward, 0.9); // the sphere winds outward
    EXPECT_NEAR(squared, 1.0, 1e-14);
  }
}

TEST_F(RayCast, QueriesAgreeWithEachOther)
{
  const Outputs all = this->run(vtkLumiRayCast::All);
  vtkNew<vtkPolyData> kept;
  kept->DeepCopy(all.rays);
  vtkPointData* reference = kept->GetPointData();
  for (const int query : { vtkLumiRayCast::Closest, vtkLumiRayCast::Any, vtkLumiRayCast::Count })
  {
    const Outputs out = this->run(query);
    EXPECT_TRUE(sameBits(out.ray->GetArray("HitMask"), reference->GetArray("HitMask")));
    if (query == vtkLumiRayCast::Closest)
    {
      EXPECT_TRUE(sameBits(out.ray->GetArray("T"), reference->GetArray("T")));
      EXPECT_TRUE(sameBits(out.ray->GetArray("CellId"), reference->GetArray("CellId")));
    }
    else
    {
      EXPECT_EQ(out.hits->GetNumberOfPoints(), 0);
      EXPECT_EQ(out.ray->GetNumberOfArrays(), 3); // RayDirection, HitMask, HitCount
    }
    const char* same = query == vtkLumiRayCast::Count ? "HitCount" : "HitMask";
    for (vtkIdType r = 0; r < out.rays->GetNumberOfPoints(); ++r)
    {
      ASSERT_EQ(value(out.ray, "HitCount", r), value(reference, same, r));
    }
  }
}

TEST_F(RayCast, CrossingsTellInsideFromOutside)
{
  // From the centre exactly through vertices, and from far away.
  std::vector<TestRay> rays;
  for (vtkIdType i = 0; i < this->surface_->GetNumberOfPoints(); ++i)
  {
    Point p;
    this->surface_->GetPoint(i, p.data());
    rays.push_back({ { 0, 0, 0 }, p });
    rays.push_back({ { 3, 0, 0 }, { p[0] - 3, p[1], p[2] } });
  }
  this->cast_->SetRaysData(pointRays(rays));
  this->cast_->SetPrecision(vtkLumiRayCast::Exact);
  const Outputs out = this->run(vtkLumiRayCast::Crossings);
  EXPECT_EQ(shape(out.ray, "HitMask"), "unsigned char 1");
  EXPECT_EQ(shape(out.ray, "HitCount"), "id 1");
  EXPECT_EQ(shape(out.ray, "Inside"), "unsigned char 1");
  EXPECT_EQ(out.ray->GetNumberOfArrays(), 4); // and RayDirection
  EXPECT_EQ(out.hits->GetNumberOfPoints(), 0);
  for (vtkIdType r = 0; r < out.rays->GetNumberOfPoints(); ++r)
  {
    ASSERT_EQ(value(out.ray, "Inside", r), r % 2 == 0 ? 1 : 0);
    ASSERT_TRUE(r % 2 == 1 || value(out.ray, "HitCount", r) == 1);
  }

  Messages messages(this->cast_);
  this->cast_->SetPrecision(vtkLumiRayCast::Watertight);
  this->run(vtkLumiRayCast::Crossings);
  EXPECT_EQ(messages.errors, 1);
  EXPECT_NE(messages.text.find("'exact' only"), std::string::npos) << messages.text;
  EXPECT_EQ(outputs(this->cast_).rays->GetNumberOfPoints(), 0);
}

TEST_F(RayCast, TiesAreHitsAtOneT)
{
  const auto walls = triangles({ { -9, -9, 4 }, { 9, -9, 4 }, { 0, 9, 4 }, { -9, -9, 5 },
    { 9, -9, 5 }, { 0, 9, 5 }, { -9, -9, 4 }, { 9, -9, 4 }, { 0, 8, 4 } });
  this->cast_->SetInputData(0, walls);
  this->cast_->SetRaysData(
    pointRays({ { { 0, 0, 0 }, { 0, 0, 2 } }, { { 0, 0, 9 }, { 0, 0, 1 } } }));
  for (const int precision : { vtkLumiRayCast::Fast, vtkLumiRayCast::Exact })
  {
    this->cast_->SetPrecision(precision);
    const Outputs out = this->run(vtkLumiRayCast::Ties);
    ASSERT_EQ(out.hits->GetNumberOfPoints(), 2);
    EXPECT_EQ(value(out.hit, "CellId", 0), 0);
    EXPECT_EQ(value(out.hit, "CellId", 1), 2);
    EXPECT_EQ(value(out.hit, "T", 1), 2.0);
    EXPECT_EQ(value(out.ray, "T", 0), 2.0);
    EXPECT_EQ(value(out.ray, "HitCount", 0), 2);
    EXPECT_EQ(value(out.ray, "HitCount", 1), 0);
    EXPECT_EQ(value(out.ray, "HitOffset", 1), 2);
  }
}

TEST_F(RayCast, StatisticsAreOneRow)
{
  this->cast_->SetPrecision(vtkLumiRayCast::Exact);
  this->cast_->RoundedParameterOn();
  const Outputs out = this->run(vtkLumiRayCast::All);
  auto* table = vtkTable::SafeDownCast(this->cast_->GetOutputDataObject(3));
  ASSERT_EQ(table->GetNumberOfRows(), 1);
  vtkDataSetAttributes* row = table->GetRowData();
  EXPECT_EQ(table->GetValueByName(0, "Structure").ToString(), "wide_bvh");
  EXPECT_EQ(table->GetValueByName(0, "Precision").ToString(), "exact");
  EXPECT_EQ(table->GetValueByName(0, "Query").ToString(), "all");
  EXPECT_EQ(value(row, "Rays", 0), 500);
  EXPECT_EQ(value(row, "InvalidRays", 0), 0);
  EXPECT_EQ(value(row, "Hits", 0), static_cast<double>(out.hits->GetNumberOfPoints()));
  EXPECT_EQ(value(row, "ExactParameters", 0), value(row, "Hits", 0));
  EXPECT_EQ(shape(row, "ExactTests"), "id 1");
  EXPECT_LE(2 * value(row, "RaysHit", 0), value(row, "Hits", 0));

  for (const char* part :
    { "SurfaceSeconds", "BuildSeconds", "ReadSeconds", "CastSeconds", "OutputSeconds" })
  {
    EXPECT_EQ(shape(row, part), "double 1");
    EXPECT_GE(value(row, part, 0), 0.0);
  }

  // Of the other precisions it is ignored.
  this->cast_->SetPrecision(vtkLumiRayCast::Fast);
  Messages messages(this->cast_);
  this->run(vtkLumiRayCast::Closest);
  EXPECT_EQ(messages.errors, 0);
  EXPECT_EQ(table->GetValueByName(0, "Origin").ToString(), "built");
  EXPECT_EQ(shape(row, "SahCost"), "double 1");
  EXPECT_EQ(value(row, "SahCostBuilt", 0), value(row, "SahCost", 0));
  EXPECT_EQ(table->GetNumberOfColumns(), 17);
}

TEST_F(RayCast, LimitsAreClosedAndInUnitsOfTheDirection)
{
  const auto wall = triangles({ { -9, -9, 4 }, { 9, -9, 4 }, { 0, 9, 4 } });
  this->cast_->SetInputData(0, wall);
  this->cast_->SetRaysData(pointRays({ { { 0, 0, 0 }, { 0, 0, 2 } } }));
  EXPECT_EQ(value(this->run(vtkLumiRayCast::Closest).ray, "T", 0), 2.0);
  const auto hitsWithin = [&](double tMin, double tMax)
  {
    this->cast_->SetTMin(tMin);
    this->cast_->SetTMax(tMax);
    return this->run(vtkLumiRayCast::Count).ray->GetArray("HitCount")->GetTuple1(0);
  };
  EXPECT_EQ(hitsWithin(0, 2), 1);
  EXPECT_EQ(hitsWithin(2, 9), 1);
  EXPECT_EQ(hitsWithin(2, 2), 1);
  EXPECT_EQ(hitsWithin(0, std::nextafter(2.0, 0.0)), 0);
  EXPECT_EQ(hitsWithin(std::nextafter(2.0, 3.0), infinity), 0);
}

TEST_F(RayCast, LimitArraysComeBeforeTheProperties)
{
  const auto wall = triangles({ { -9, -9, 4 }, { 9, -9, 4 }, { 0, 9, 4 } });
  const TestRay ray{ { 0, 0, 0 }, { 0, 0, 1 } };
  const auto rays = pointRays({ ray, ray, ray });
  for (const char* name : { "RayTMin", "RayTMax" })
  {
    vtkNew<vtkDoubleArray> limits;
    limits->SetName(name);
    const double values[3] = { name == std::string("RayTMin") ? 5.0 : 9.0,
      name == std::string("RayTMin") ? 1.0 : 9.0, name == std::string("RayTMin") ? 1.0 : 3.0 };
    for (const double limit : values)
    {
      limits->InsertNextValue(limit);
    }
    rays->GetPointData()->AddArray(limits);
  }
  this->cast_->SetInputData(0, wall);
  this->cast_->SetRaysData(rays);
  this->cast_->SetTMax(0.5);
  const Outputs out = this->run(vtkLumiRayCast::Any);
  EXPECT_EQ(value(out.ray, "HitMask", 0), 0);
  EXPECT_EQ(value(out.ray, "HitMask", 1), 1);
  EXPECT_EQ(value(out.ray, "HitMask", 2), 0);
}

TEST_F(RayCast, PointsAreDoubleWhenAnInputIs)
{
  const auto typeOf = [&](int surface, int rays)
  {
    this->cast_->SetInputData(0, polyData(lumitree::data::sphere(6), surface));
    this->cast_->SetRaysData(pointRays(this->rays_, rays, VTK_FLOAT));
    return this->run(vtkLumiRayCast::Closest).hits->GetPoints()->GetDataType();
  };
  EXPECT_EQ(typeOf(VTK_FLOAT, VTK_FLOAT), VTK_FLOAT);
  EXPECT_EQ(typeOf(VTK_FLOAT, VTK_DOUBLE), VTK_DOUBLE);
  EXPECT_EQ(typeOf(VTK_DOUBLE, VTK_FLOAT), VTK_DOUBLE);
  this->cast_->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  EXPECT_EQ(typeOf(VTK_DOUBLE, VTK_DOUBLE), VTK_FLOAT);
  this->cast_->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  EXPECT_EQ(typeOf(VTK_FLOAT, VTK_FLOAT), VTK_DOUBLE);
}

TEST_F(RayCast, ThreadsChangeNoBit)
{
  this->cast_->SetRaysData(pointRays(raysAtUnitBall(40000)));
  this->cast_->PassSurfaceDataOn();
  this->cast_->CountTraversalOn();
  vtkNew<vtkDoubleArray> height;
  height->SetName("Height");
  for (vtkIdType i = 0; i < this->surface_->GetNumberOfPoints(); ++i)
  {
    height->InsertNextValue(this->surface_->GetPoint(i)[2]);
  }
  this->surface_->GetPointData()->AddArray(height);
  for (int query = vtkLumiRayCast::Closest; query <= vtkLumiRayCast::Count; ++query)
  {
    this->cast_->SetNumberOfThreads(1);
    const Outputs one = this->run(query);
    vtkNew<vtkPolyData> hits;
    hits->DeepCopy(one.hits);
    vtkNew<vtkPolyData> rays;
    rays->DeepCopy(one.rays);
    for (const int threads : { 2, 5 })
    {
      this->cast_->SetNumberOfThreads(threads);
      const Outputs many = this->run(query);
      EXPECT_TRUE(sameBits(hits->GetPointData(), many.hit)) << query;
      EXPECT_TRUE(sameBits(rays->GetPointData(), many.ray)) << query;
      if (hits->GetNumberOfPoints() > 0)
      {
        EXPECT_TRUE(sameBits(hits->GetPoints()->GetData(), many.hits->GetPoints()->GetData()));
      }
    }
  }
}

TEST_F(RayCast, CountsTheTraversal)
{
  this->cast_->SetStructure(vtkLumiRayCast::BruteForce);
  this->cast_->CountTraversalOn();
  const Outputs out = this->run(vtkLumiRayCast::All);
  for (const char* name : { "NodesEntered", "CellsStepped", "LeavesVisited", "PrimitivesTested" })
  {
    EXPECT_EQ(shape(out.ray, name), "int 1") << name;
  }
  for (vtkIdType r = 0; r < out.rays->GetNumberOfPoints(); ++r)
  {
    ASSERT_EQ(value(out.ray, "PrimitivesTested", r),
      static_cast<double>(this->surface_->GetNumberOfCells()));
  }
}

TEST_F(RayCast, TheSurfaceTellsWhatItsCellsCost)
{
  const auto surfaceCells = [this]
  { return vtkDataSet::SafeDownCast(this->cast_->GetOutputDataObject(2))->GetCellData(); };
  this->run(vtkLumiRayCast::Closest);
  EXPECT_EQ(surfaceCells()->GetArray("RayTests"), nullptr);
  this->cast_->CountTraversalOn();
  for (const int structure : { vtkLumiRayCast::BruteForce, vtkLumiRayCast::Bvh,
         vtkLumiRayCast::WideBvh, vtkLumiRayCast::Grid, vtkLumiRayCast::Octree,
         vtkLumiRayCast::KdTree, vtkLumiRayCast::BspTree })
  {
    this->cast_->SetStructure(structure);
    const Outputs out = this->run(vtkLumiRayCast::Closest);
    double tests = 0.0;
    double hits = 0.0;
    double references = 0.0;
    for (const char* name : { "RayTests", "RayHits", "LeafReferences" })
    {
      ASSERT_EQ(shape(surfaceCells(), name), "id 1");
    }
    EXPECT_STREQ(surfaceCells()->GetScalars()->GetName(), "RayTests");
    for (vtkIdType cell = 0; cell < this->surface_->GetNumberOfCells(); ++cell)
    {
      tests += value(surfaceCells(), "RayTests", cell);
      hits += value(surfaceCells(), "RayHits", cell);
      ASSERT_GE(value(surfaceCells(), "LeafReferences", cell), 1);
      references += value(surfaceCells(), "LeafReferences", cell);
    }
    // As many as all leaves hold.
    vtkNew<vtkLumiAccelerationStructure> tree;
    tree->SetInputData(0, this->surface_);
    tree->SetStructure(structure);
    tree->Update();
    EXPECT_EQ(references,
      value(vtkTable::SafeDownCast(tree->GetOutputDataObject(1))->GetRowData(), "References", 0))
      << structure;
    double tested = 0.0;
    double hit = 0.0;
    for (vtkIdType r = 0; r < out.rays->GetNumberOfPoints(); ++r)
    {
      tested += value(out.ray, "PrimitivesTested", r);
      hit += value(out.ray, "HitCount", r);
    }
    EXPECT_EQ(tests, tested) << structure;
    EXPECT_EQ(hits, hit) << structure;
  }
}

TEST_F(RayCast, PrintsItself)
{
  std::ostringstream text;
  this->cast_->Print(text);
  for (const char* name :
    { "Query", "RoundedParameter", "Structure", "Precision", "BvhBuild", "KdBuild", "LeafSize",
      "MaxDepth", "GridDensity", "GridResolution", "Mailboxing", "TMin", "TMax", "PassSurfaceData",
      "CountTraversal", "NumberOfThreads", "OutputPointsPrecision", "Controller" })
  {
    EXPECT_NE(text.str().find(std::string(name) + ": "), std::string::npos) << name;
  }
}
