// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Structures side by side, and rays on which two back ends differ.
#include "RaysFixtures.h"

#include "vtkLumiRayDisagreement.h"
#include "vtkLumiStructureComparison.h"

#include "LumiDisagreement.h"

#include "Accel/Registry.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <sstream>

using namespace lumitree::testing;

namespace
{

class Comparison : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->filter_->SetInputData(0, polyData(lumitree::data::sphere(6))); // 720 triangles
    this->filter_->SetRaysData(pointRays(raysAtUnitBall(500)));
    this->filter_->SetRepetitions(1);
  }

  vtkTable* table()
  {
    this->filter_->Update();
    return vtkTable::SafeDownCast(this->filter_->GetOutputDataObject(0));
  }

  std::string text(const char* column, vtkIdType row)
  {
    auto* array = vtkStringArray::SafeDownCast(this->table()->GetColumnByName(column));
    return array ? array->GetValue(row) : std::string("no column");
  }

  double number(const char* column, vtkIdType row)
  {
    return value(this->table()->GetRowData(), column, row);
  }

  vtkNew<vtkLumiStructureComparison> filter_;
};

class RayDisagreement : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->filter_->SetInputData(0, polyData(lumitree::data::sphere(6)));
    this->filter_->SetRaysData(pointRays(raysAtUnitBall(500)));
  }

  vtkPolyData* lines()
  {
    this->filter_->Update();
    return vtkPolyData::SafeDownCast(this->filter_->GetOutputDataObject(0));
  }

  double count(const char* column)
  {
    this->filter_->Update();
    auto* table = vtkTable::SafeDownCast(this->filter_->GetOutputDataObject(1));
    return value(table->GetRowData(), column, 0);
  }

  vtkNew<vtkLumiRayDisagreement> filter_;
};

} // namespace

TEST_F(Comparison, ThereIsARowForEachStructure)
{
  this->filter_->IncludeBruteForceOn();
  this->filter_->CountDisagreementsOn();
  this->filter_->SetPrecision(vtkLumiStructureComparison::Exact);
  const std::pair<const char*, const char*> columns[] = { { "Structure", "string 1" },
    { "Parameters", "string 1" }, { "GridCells", "id 1" }, { "CellsPerPrimitive", "double 1" },
    { "LeafSize", "id 1" }, { "BuildSeconds", "double 1" }, { "MemoryBytes", "id 1" },
    { "Nodes", "id 1" }, { "Leaves", "id 1" }, { "Depth", "id 1" },
    { "ReferencesPerPrimitive", "double 1" }, { "SahCost", "double 1" }, { "Rays", "id 1" },
    { "HitRays", "id 1" }, { "NodesPerRay", "double 1" }, { "CellsPerRay", "double 1" },
    { "LeavesPerRay", "double 1" }, { "TestsPerRay", "double 1" }, { "CastSeconds", "double 1" },
    { "RaysPerSecond", "double 1" }, { "Disagreements", "double 1" },
    { "ObservedSahCost", "double 1" }, { "EmptyLeaves", "id 1" }, { "UnvisitedLeaves", "id 1" },
    { "EndPointOverlap", "double 1" } };
  int i = 0;
  for (const auto& [name, type] : columns)
  {
    EXPECT_STREQ(this->table()->GetColumnName(i++), name);
    EXPECT_EQ(shape(this->table()->GetRowData(), name), type);
  }
  EXPECT_EQ(this->table()->GetNumberOfColumns(), i);

  std::size_t own = 0;
  for (const lumitree::Structure structure : lumitree::Registry::instance().structures())
  {
    own += structure < lumitree::Structure::Embree ? 1 : 0;
  }
  ASSERT_EQ(this->table()->GetNumberOfRows(), static_cast<vtkIdType>(own));
  EXPECT_EQ(this->text("Structure", 0), "brute_force");
  EXPECT_EQ(this->number("TestsPerRay", 0), 720);
  for (vtkIdType row = 0; row < this->table()->GetNumberOfRows(); ++row)
  {
    SCOPED_TRACE(this->text("Structure", row));
    EXPECT_EQ(this->number("Disagreements", row), 0);
    EXPECT_EQ(this->number("Rays", row), 500);
    EXPECT_EQ(this->number("HitRays", row), this->number("HitRays", 0));
    EXPECT_GT(this->number("RaysPerSecond", row), 0);
    EXPECT_GE(this->number("ReferencesPerPrimitive", row), 1);
    EXPECT_LE(this->number("TestsPerRay", row), 720);
    EXPECT_GT(this->number("ObservedSahCost", row), 0);
    EXPECT_LE(this->number("ObservedSahCost", row), 1.01 * this->number("SahCost", row));
    EXPECT_LT(this->number("UnvisitedLeaves", row), this->number("Leaves", row));
    EXPECT_TRUE(std::isnan(this->number("EndPointOverlap", row)));
  }
  this->filter_->MeasureOverlapOn();
  for (vtkIdType row = 0; row < this->table()->GetNumberOfRows(); ++row)
  {
    const std::string structure = this->text("Structure", row);
    EXPECT_EQ(
      this->number("EndPointOverlap", row) > 0, structure == "bvh" || structure == "wide_bvh")
      << structure;
  }
}

TEST_F(Comparison, AGridIsBestBetweenOneCellAndFarTooMany)
{
  // The lecture's curve, by what a ray does and not by a clock: cells stepped and triangles tested.
  this->filter_->SetInputData(0, polyData(lumitree::data::randomCloud(4000, 3)));
  this->filter_->SetSweep(vtkLumiStructureComparison::GridCells);
  const vtkIdType rows = this->table()->GetNumberOfRows();
  ASSERT_EQ(rows, 10);
  EXPECT_EQ(this->text("Parameters", 0), "1 x 1 x 1");
  EXPECT_EQ(this->number("GridCells", 0), 1);
  vtkIdType best = 0;
  const auto cost = [this](vtkIdType row)
  { return this->number("CellsPerRay", row) + this->number("TestsPerRay", row); };
  for (vtkIdType row = 1; row < rows; ++row)
  {
    EXPECT_GT(this->number("GridCells", row), this->number("GridCells", row - 1));
    best = cost(row) < cost(best) ? row : best;
  }
  EXPECT_GT(best, 0);
  EXPECT_LT(best, rows - 1);
  EXPECT_GT(cost(0), 10 * cost(best));
  EXPECT_GT(cost(rows - 1), 1.5 * cost(best));
}

TEST_F(Comparison, ATeapotInAStadiumIsBadForAGrid)
{
  // Rays at the teapot, which is a hundredth of the stadium: one cell of the grid holds it.
  const auto scene = polyData(lumitree::data::teapotInStadium(8));
  std::vector<TestRay> rays = raysAtUnitBall(400, 3.0);
  for (TestRay& ray : rays)
  {
    for (int k = 0; k < 3; ++k)
    {
      ray.origin[static_cast<std::size_t>(k)] *= 0.1;
      ray.direction[static_cast<std::size_t>(k)] *= 0.1;
    }
    ray.origin[2] = std::abs(ray.origin[2]) + 0.05;
    ray.direction[2] = -std::abs(ray.direction[2]);
  }
  this->filter_->SetInputData(0, scene);
  this->filter_->SetRaysData(pointRays(rays));
  double grid = 0.0;
  double bvh = 0.0;
  double kdTree = 0.0;
  for (vtkIdType row = 0; row < this->table()->GetNumberOfRows(); ++row)
  {
    const std::string structure = this->text("Structure", row);
    double& tests = structure == "grid" ? grid : structure == "kd_tree" ? kdTree : bvh;
    if (structure == "grid" || structure == "kd_tree" || structure == "bvh")
    {
      tests = this->number("TestsPerRay", row);
    }
  }
  EXPECT_GT(grid, 20 * bvh);
  EXPECT_GT(grid, 20 * kdTree);
}

TEST_F(Comparison, LeafSizesAreTriedOnceEach)
{
  this->filter_->SetSweep(vtkLumiStructureComparison::LeafSizes);
  this->filter_->SetSweepMinimum(1);
  this->filter_->SetSweepMaximum(4);
  ASSERT_EQ(this->table()->GetNumberOfRows(), 4);
  for (vtkIdType row = 0; row < 4; ++row)
  {
    EXPECT_EQ(this->text("Structure", row), "bvh");
    EXPECT_EQ(this->number("LeafSize", row), static_cast<double>(row + 1));
  }
}

TEST_F(Comparison, WrongSweepsAreOneErrorAndWhatCannotBeBuiltIsOneWarning)
{
  this->filter_->SetSweep(vtkLumiStructureComparison::GridCells);
  const Messages messages(this->filter_);
  for (const double maximum : { 0.0, 0.001, 1e6, std::nan("") })
  {
    this->filter_->SetSweepMaximum(maximum);
    EXPECT_EQ(this->table()->GetNumberOfColumns(), 0);
  }
  EXPECT_EQ(messages.errors, 4);
  this->filter_->SetSweep(vtkLumiStructureComparison::AllStructures);
  this->filter_->SetGridResolution(1 << 20, 1 << 20, 1 << 20);
  EXPECT_GT(this->table()->GetNumberOfRows(), 1);
  EXPECT_EQ(messages.errors, 4);
  EXPECT_EQ(messages.warnings, 1);
}

TEST_F(Comparison, NothingOrNoRaysIsNoError)
{
  const Messages messages(this->filter_);
  this->filter_->SetInputData(0, vtkNew<vtkPolyData>());
  EXPECT_GT(this->table()->GetNumberOfRows(), 1);
  EXPECT_EQ(this->number("HitRays", 0), 0);
  this->filter_->SetRaysData(pointRays({}));
  EXPECT_GT(this->table()->GetNumberOfRows(), 1);
  EXPECT_EQ(messages.errors, 0) << messages.text;
}

TEST_F(Comparison, PrintsItself)
{
  std::ostringstream text;
  this->filter_->Print(text);
  EXPECT_NE(text.str().find("SweepMaximum: "), std::string::npos);
}

TEST_F(RayDisagreement, ExactStructuresAgree)
{
  this->filter_->SetStructure(vtkLumiRayDisagreement::WideBvh);
  this->filter_->SetPrecision(vtkLumiRayDisagreement::Exact);
  EXPECT_EQ(this->lines()->GetNumberOfCells(), 0);
  EXPECT_EQ(this->count("Rays"), 500);
  EXPECT_EQ(this->count("Agree"), 500);
  this->filter_->SetQuery(vtkLumiRayDisagreement::All);
  EXPECT_EQ(this->count("Agree"), 500);
  this->filter_->SetQuery(vtkLumiRayDisagreement::Count);
  EXPECT_EQ(this->count("Agree"), 500);
}

TEST_F(RayDisagreement, FastDiffersAtVerticesFromExact)
{
  // Rays through the vertices of a sphere far from the origin: floating point is not sure of them.
  lumitree::data::Mesh mesh = lumitree::data::sphere(6);
  for (double& x : mesh.points)
  {
    x += 1e6;
  }
  const auto sphere = polyData(mesh, VTK_FLOAT);
  std::vector<TestRay> rays;
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    Point vertex;
    sphere->GetPoint(i, vertex.data());
    const Point from{ 1e6 + 5.1, 1e6 - 3.3, 1e6 + 2.7 };
    rays.push_back({ from, { vertex[0] - from[0], vertex[1] - from[1], vertex[2] - from[2] } });
  }
  this->filter_->SetInputData(0, sphere);
  this->filter_->SetRaysData(pointRays(rays));
  double all = this->count("Agree");
  for (const char* kind : { "Missed", "Phantom", "OtherPrimitive", "Far", "Tie" })
  {
    all += this->count(kind);
  }
  EXPECT_EQ(all, static_cast<double>(rays.size()));
  EXPECT_LT(this->count("Agree"), static_cast<double>(rays.size()));
  EXPECT_EQ(this->lines()->GetNumberOfCells(), rays.size() - this->count("Agree"));

  vtkCellData* data = this->lines()->GetCellData();
  for (const char* name : { "RayId", "CellId", "OtherCellId", "HitCount", "OtherHitCount" })
  {
    EXPECT_EQ(shape(data, name), "id 1") << name;
  }
  for (const char* name : { "Kind", "CompositeIndex", "OtherCompositeIndex" })
  {
    EXPECT_EQ(shape(data, name), "int 1") << name;
  }
  EXPECT_EQ(shape(data, "T"), "double 1");
  EXPECT_EQ(shape(data, "OtherT"), "double 1");
  EXPECT_STREQ(data->GetScalars()->GetName(), "Kind");
  double first[3];
  this->lines()->GetPoint(0, first);
  EXPECT_EQ(first[0], 1e6 + 5.1);
}

TEST_F(RayDisagreement, KindsAreWhatTheySay)
{
  using namespace lumitree;
  // A square of two triangles and a second one behind it; the first asked with another limit.
  const auto surface = std::make_shared<const Surface>(
    PointArray::from(std::vector<double>{ 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1 }),
    std::vector<Triangle>{ { 0, 1, 2 }, { 3, 4, 5 }, { 0, 1, 2 } });
  const auto accelerator = build(surface, {});
  const double origin[] = { 0.2, 0.2, -1 };
  const double direction[] = { 0, 0, 1 };
  RayBatch rays;
  rays.size = 1;
  rays.origins = origin;
  rays.directions = direction;
  const filters::Cast near(QueryKind::Closest, *accelerator, rays, {});
  rays.tMin = 1.5;
  const filters::Cast far(QueryKind::Closest, *accelerator, rays, {});
  rays.tMin = 3;
  const filters::Cast none(QueryKind::Closest, *accelerator, rays, {});
  const auto kind = [](const filters::Cast& a, const filters::Cast& b, double tolerance)
  { return filters::difference(a, b, 0, tolerance)->kind; };
  EXPECT_FALSE(filters::difference(near, near, 0, 0.0));
  EXPECT_FALSE(filters::difference(none, none, 0, 0.0));
  EXPECT_EQ(kind(near, far, 1e-6), filters::Disagreement::OtherPrimitive);
  EXPECT_EQ(kind(near, far, 0.6), filters::Disagreement::Tie);
  EXPECT_EQ(kind(none, near, 1e-6), filters::Disagreement::Missed);
  EXPECT_EQ(kind(near, none, 1e-6), filters::Disagreement::Phantom);
  EXPECT_EQ(filters::difference(near, none, 0, 0.0)->hit->t, 1.0);
  EXPECT_EQ(filters::difference(near, none, 0, 0.0)->other, nullptr);
  const double back[] = { 0.2, 0.2, -2 };
  rays.tMin = 0;
  rays.origins = back;
  const filters::Cast farther(QueryKind::Closest, *accelerator, rays, {});
  EXPECT_EQ(kind(near, farther, 1e-6), filters::Disagreement::Far);
}

TEST_F(RayDisagreement, CountsHaveNoHitsButARayIsDrawn)
{
  // Two structures that agree cannot show it; the same with another surface would. Any of an empty
  // set of rays gives an empty output.
  this->filter_->SetQuery(vtkLumiRayDisagreement::Any);
  EXPECT_EQ(this->count("Agree"), 500);
  this->filter_->SetRaysData(pointRays({}));
  EXPECT_EQ(this->count("Rays"), 0);
  EXPECT_EQ(this->lines()->GetNumberOfCells(), 0);
}

TEST_F(RayDisagreement, WhatIsNotThereIsOneError)
{
  const Messages messages(this->filter_);
  this->filter_->SetOtherStructure(vtkLumiRayDisagreement::CgalCartesian); // not loaded here
  EXPECT_EQ(this->lines()->GetNumberOfCells(), 0);
  EXPECT_EQ(messages.errors, 1);
  this->filter_->SetOtherStructure(vtkLumiRayDisagreement::BruteForce);
  vtkNew<vtkPolyData> noDirections;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  noDirections->SetPoints(points);
  this->filter_->SetRaysData(noDirections);
  EXPECT_EQ(this->lines()->GetNumberOfCells(), 0);
  EXPECT_EQ(messages.errors, 2);
}

TEST_F(RayDisagreement, PrintsItself)
{
  std::ostringstream text;
  this->filter_->Print(text);
  EXPECT_NE(text.str().find("OtherPrecision: "), std::string::npos);
}
