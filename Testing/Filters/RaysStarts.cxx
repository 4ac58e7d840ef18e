// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rays that start on the surface they are cast at: they do not hit the cell they leave from.
#include "RaysFixtures.h"

#include "vtkLumiRayCast.h"
#include "vtkLumiSurfaceRays.h"

#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <string>

using namespace lumitree::testing;

namespace
{

/// 20 480 triangles of float points around (offset, offset, offset).
vtkSmartPointer<vtkPolyData> ball(double offset)
{
  auto mesh = lumitree::data::sphere(32);
  for (double& x : mesh.points)
  {
    x = 100.0 * x + offset;
  }
  return polyData(mesh, VTK_FLOAT);
}

struct Start
{
  bool skip = false;
  bool clear = false;
  int points = vtkAlgorithm::DOUBLE_PRECISION;
};

class RayStarts : public ::testing::Test
{
protected:
  /// How many of ten rays a source hit the cell that they leave from (or a cell around the point).
  vtkIdType selfHits(vtkPolyData* surface, int precision, const Start& start)
  {
    vtkNew<vtkLumiSurfaceRays> rays;
    rays->SetInputData(surface);
    rays->SetSourceLocation(this->location_);
    rays->SetRaysPerSource(10);
    rays->SetClearOfRounding(start.clear);
    rays->SetOutputPointsPrecision(start.points);
    vtkNew<vtkLumiRayCast> cast;
    cast->SetInputData(0, surface);
    cast->SetRaysConnection(rays->GetOutputPort());
    cast->SetPrecision(precision);
    cast->SetSkipSource(start.skip);
    cast->Update();
    vtkPointData* all = vtkDataSet::SafeDownCast(cast->GetOutputDataObject(1))->GetPointData();
    vtkNew<vtkIdList> points;
    vtkIdType found = 0;
    this->rays_ = all->GetNumberOfTuples();
    this->hits_ = 0;
    for (vtkIdType i = 0; i < this->rays_; ++i)
    {
      const auto cell = static_cast<vtkIdType>(value(all, "CellId", i));
      if (cell >= 0)
      {
        ++this->hits_;
        surface->GetCellPoints(cell, points);
        const auto point = static_cast<vtkIdType>(value(all, "SourcePointId", i));
        found += value(all, "SourceCellId", i) == cell || points->IsId(point) >= 0 ? 1 : 0;
      }
    }
    return found;
  }

  int location_ = vtkLumiSurfaceRays::Cells;
  vtkIdType rays_ = 0;
  vtkIdType hits_ = 0;
};

TEST_F(RayStarts, CellsAreNotHitByTheirOwnRays)
{
  for (const double offset : { 0.0, 1e4, 1e6 })
  {
    SCOPED_TRACE(offset);
    const auto surface = ball(offset);
    // Without either measure rounding decides.
    EXPECT_GT(this->selfHits(surface, vtkLumiRayCast::Exact, {}), 10000);
    EXPECT_GT(this->rays_, 200000);
    EXPECT_EQ(this->selfHits(surface, vtkLumiRayCast::Exact, { true, false }), 0);
    for (const int points : { vtkAlgorithm::SINGLE_PRECISION, vtkAlgorithm::DOUBLE_PRECISION })
    {
      for (const int precision : { vtkLumiRayCast::Fast, vtkLumiRayCast::Exact })
      {
        EXPECT_EQ(this->selfHits(surface, precision, { false, true, points }), 0);
      }
    }
    EXPECT_EQ(this->selfHits(surface, vtkLumiRayCast::Watertight,
                { true, true, vtkAlgorithm::SINGLE_PRECISION }),
      0);
  }
}

TEST_F(RayStarts, CellsAroundAPointAreNotHitByItsRays)
{
  this->location_ = vtkLumiSurfaceRays::Points;
  for (const double offset : { 0.0, 1e4, 1e6 })
  {
    SCOPED_TRACE(offset);
    const auto surface = ball(offset);
    const vtkIdType atOnce = this->selfHits(surface, vtkLumiRayCast::Exact, {});
    EXPECT_EQ(atOnce, this->rays_); // at t = 0
    EXPECT_EQ(this->selfHits(surface, vtkLumiRayCast::Exact, { true, false }), 0);
    if (offset < 1e5) // where rounding leaves the ball convex
    {
      EXPECT_EQ(this->selfHits(surface, vtkLumiRayCast::Exact, { false, true }), 0);
      EXPECT_EQ(this->hits_, 0);
    }
  }
}

TEST_F(RayStarts, TheSourceIsThatOfTheLeaf)
{
  // Two equal walls, one behind the other; rays of the second leave towards the first.
  const auto near = triangles({ { -9, -9, 4 }, { 9, -9, 4 }, { 0, 9, 4 } });
  const auto far = triangles({ { -9, -9, 5 }, { 0, 9, 5 }, { 9, -9, 5 } });
  vtkNew<vtkMultiBlockDataSet> walls;
  walls->SetBlock(0, near);
  walls->SetBlock(1, far);
  vtkNew<vtkLumiSurfaceRays> rays;
  rays->SetInputData(walls);
  rays->SetSourceLocation(vtkLumiSurfaceRays::Cells);
  rays->SetDistribution(vtkLumiSurfaceRays::Normal);
  vtkNew<vtkLumiRayCast> cast;
  cast->SetInputData(0, walls);
  cast->SetRaysConnection(rays->GetOutputPort());
  cast->SkipSourceOn();
  cast->Update();
  vtkPointData* all = vtkDataSet::SafeDownCast(cast->GetOutputDataObject(1))->GetPointData();
  ASSERT_EQ(all->GetNumberOfTuples(), 2);
  for (const vtkIdType i : { 0, 1 })
  {
    EXPECT_EQ(value(all, "T", i), 1.0);
    EXPECT_EQ(value(all, "CompositeIndex", i), 3 - value(all, "SourceCompositeIndex", i));
  }
}

TEST_F(RayStarts, IdsThatAreMissingOrNoneOfTheSurface)
{
  const auto wall = triangles({ { -9, -9, 4 }, { 9, -9, 4 }, { 0, 9, 4 } });
  const auto rays = pointRays({ { { 0, 0, 0 }, { 0, 0, 1 } }, { { 0, 0, 0 }, { 0, 0, 1 } } });
  vtkNew<vtkLumiRayCast> cast;
  Messages messages(cast);
  cast->SetInputData(0, wall);
  cast->SetRaysData(rays);
  cast->SkipSourceOn();
  cast->Update();
  EXPECT_EQ(messages.errors, 1);
  EXPECT_NE(messages.text.find("SourceCellId"), std::string::npos) << messages.text;
  EXPECT_EQ(vtkPolyData::SafeDownCast(cast->GetOutputDataObject(0))->GetNumberOfPoints(), 0);

  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("SourceCellId");
  ids->InsertNextValue(77);
  ids->InsertNextValue(-1);
  rays->GetPointData()->AddArray(ids);
  rays->Modified();
  cast->Update();
  EXPECT_EQ(messages.errors, 1);
  EXPECT_EQ(vtkPolyData::SafeDownCast(cast->GetOutputDataObject(0))->GetNumberOfPoints(), 2);

  vtkNew<vtkIdTypeArray> pairs;
  pairs->SetName("SourceCellId");
  pairs->SetNumberOfComponents(2);
  pairs->SetNumberOfTuples(2);
  rays->GetPointData()->AddArray(pairs);
  rays->Modified();
  cast->Update();
  EXPECT_EQ(messages.errors, 2);
  EXPECT_NE(messages.text.find("one component"), std::string::npos) << messages.text;
}

TEST_F(RayStarts, TheMoveIsSmallAndAwayFromTheCell)
{
  vtkNew<vtkLumiSurfaceRays> rays;
  rays->SetDistribution(vtkLumiSurfaceRays::Normal);
  rays->SetSourceLocation(vtkLumiSurfaceRays::Cells);
  for (const double height : { 0.0, 1.0, 1e6, 1e-6 })
  {
    rays->SetInputData(triangles({ { -1, -1, height }, { 1, -1, height }, { 0, 1, height } }));
    rays->ClearOfRoundingOff();
    rays->Update();
    const double before = rays->GetOutput()->GetPoint(0)[2];
    rays->ClearOfRoundingOn();
    rays->Update();
    const double after = rays->GetOutput()->GetPoint(0)[2];
    EXPECT_GT(after, height);
    EXPECT_LT(after - before, 3e-14 * (1.0 + height));
  }
}

} // namespace
