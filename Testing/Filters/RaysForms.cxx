// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkLumiRayCast: the forms that rays come in, and bad rays.
#include "RaysFixtures.h"

#include "vtkLumiRayCast.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <limits>

using namespace lumitree::testing;

namespace
{

class RayForms : public ::testing::Test
{
protected:
  void SetUp() override { this->cast_->SetInputData(0, polyData(lumitree::data::sphere(6))); }

  vtkDataSet* run(vtkDataObject* rays)
  {
    this->cast_->SetRaysData(rays);
    this->cast_->Update();
    return vtkDataSet::SafeDownCast(this->cast_->GetOutputDataObject(1));
  }

  vtkPolyData* hits() { return vtkPolyData::SafeDownCast(this->cast_->GetOutputDataObject(0)); }

  /// One error, and two empty outputs of the right type.
  void expectOneError(vtkDataObject* rays, const char* word)
  {
    Messages messages(this->cast_);
    this->cast_->SetRaysData(rays);
    this->cast_->Update();
    EXPECT_EQ(messages.errors, 1);
    EXPECT_EQ(messages.warnings, 0);
    EXPECT_NE(messages.text.find(word), std::string::npos) << messages.text;
    EXPECT_EQ(this->hits()->GetNumberOfPoints(), 0);
    vtkDataObject* out = this->cast_->GetOutputDataObject(1);
    EXPECT_STREQ(out->GetClassName(), rays->GetClassName());
    EXPECT_EQ(out->GetNumberOfElements(vtkDataObject::POINT), 0);
  }

  vtkNew<vtkLumiRayCast> cast_;
};

} // namespace

TEST_F(RayForms, AnImageStaysAnImage)
{
  const auto image = imageRays(raysAtUnitBall(48), 8);
  image->SetOrigin(1, 2, 3);
  vtkNew<vtkIntArray> own;
  own->SetName("Own");
  own->SetNumberOfTuples(48);
  own->FillValue(7);
  image->GetPointData()->AddArray(own);
  auto* out = vtkImageData::SafeDownCast(this->run(image));
  ASSERT_TRUE(out);
  EXPECT_EQ(out->GetDimensions()[0], 8);
  EXPECT_EQ(out->GetDimensions()[1], 6);
  EXPECT_EQ(out->GetOrigin()[2], 3);
  EXPECT_TRUE(sameBits(out->GetPointData()->GetArray("Own"), own));
  EXPECT_EQ(shape(out->GetPointData(), "T"), "double 1");
  EXPECT_EQ(image->GetPointData()->GetNumberOfArrays(), 3) << "the input was changed";
}

TEST_F(RayForms, AllFormsGiveTheSameHits)
{
  const std::vector<TestRay> rays = raysAtUnitBall(300);
  vtkNew<vtkPolyData> points;
  this->run(pointRays(rays));
  points->DeepCopy(this->hits());
  this->run(imageRays(rays, 10));
  EXPECT_TRUE(sameBits(points->GetPointData(), this->hits()->GetPointData()));

  this->run(lineRays(rays, 10));
  ASSERT_EQ(this->hits()->GetNumberOfPoints(), points->GetNumberOfPoints());
  for (vtkIdType h = 0; h < points->GetNumberOfPoints(); ++h)
  {
    ASSERT_EQ(
      value(this->hits()->GetPointData(), "CellId", h), value(points->GetPointData(), "CellId", h));
    ASSERT_NEAR(10 * value(this->hits()->GetPointData(), "T", h),
      value(points->GetPointData(), "T", h), 1e-12);
  }
}

TEST_F(RayForms, LinesAnswerInTheirCells)
{
  const auto lines = lineRays(raysAtUnitBall(20), 10);
  vtkDataSet* out = this->run(lines);
  EXPECT_EQ(out->GetNumberOfCells(), 20);
  EXPECT_EQ(shape(out->GetCellData(), "T"), "double 1");
  EXPECT_EQ(shape(out->GetCellData(), "HitOffset"), "id 1");
  EXPECT_EQ(out->GetPointData()->GetNumberOfArrays(), 0);
}

TEST_F(RayForms, ALineEndsAtItsSecondPoint)
{
  const TestRay inward{ { 3, 0.1, 0.2 }, { -1, 0, 0 } };
  EXPECT_EQ(value(this->run(lineRays({ inward }, 1.5))->GetCellData(), "HitMask", 0), 0);
  EXPECT_EQ(value(this->run(lineRays({ inward }, 2.5))->GetCellData(), "HitMask", 0), 1);
}

TEST_F(RayForms, PolylinesBecomeSegmentsWithTheirCellData)
{
  const auto rays = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  for (const double x : { 3.0, 2.0, 0.0, 5.0, 4.0 })
  {
    points->InsertNextPoint(x, 0.1, 0.2);
  }
  rays->SetPoints(points);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  rays->SetVerts(vertices);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1, 2 });
  lines->InsertNextCell({ 3, 4 });
  rays->SetLines(lines);
  vtkNew<vtkIntArray> colour;
  colour->SetName("Colour");
  for (const int c : { 1, 2, 3 })
  {
    colour->InsertNextValue(c);
  }
  rays->GetCellData()->AddArray(colour);

  const auto check = [&](vtkDataSet* out)
  {
    ASSERT_EQ(out->GetNumberOfCells(), 3);
    ASSERT_EQ(out->GetNumberOfPoints(), 5);
    const int colours[3] = { 2, 2, 3 };
    const int masks[3] = { 0, 1, 0 };
    for (vtkIdType c = 0; c < 3; ++c)
    {
      EXPECT_EQ(out->GetCellType(c), VTK_LINE);
      EXPECT_EQ(value(out->GetCellData(), "Colour", c), colours[c]);
      EXPECT_EQ(value(out->GetCellData(), "HitMask", c), masks[c]);
    }
    EXPECT_EQ(value(this->hits()->GetPointData(), "RayId", 0), 1);
  };
  check(this->run(rays));

  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  const vtkIdType ids[] = { 0, 1, 2, 3, 4 };
  grid->InsertNextCell(VTK_VERTEX, 1, ids);
  grid->InsertNextCell(VTK_POLY_LINE, 3, ids);
  grid->InsertNextCell(VTK_LINE, 2, ids + 3);
  grid->GetCellData()->AddArray(colour);
  check(this->run(grid));
}

TEST_F(RayForms, TheDirectionArrayIsChosen)
{
  const std::vector<TestRay> rays = raysAtUnitBall(50);
  const auto points = pointRays(rays);
  vtkNew<vtkPolyData> expected;
  expected->DeepCopy(this->run(points));
  vtkDataArray* directions = points->GetPointData()->GetArray("RayDirection");
  directions->SetName("Velocity");
  this->cast_->SetInputArrayToProcess(0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Velocity");
  EXPECT_TRUE(sameBits(
    this->run(points)->GetPointData()->GetArray("T"), expected->GetPointData()->GetArray("T")));

  points->GetPointData()->SetActiveVectors("Velocity");
  this->cast_->SetInputArrayToProcess(
    0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::VECTORS);
  EXPECT_TRUE(sameBits(
    this->run(points)->GetPointData()->GetArray("T"), expected->GetPointData()->GetArray("T")));
}

TEST_F(RayForms, AnyMemoryLayoutWillDo)
{
  const std::vector<TestRay> rays = raysAtUnitBall(50);
  const auto points = pointRays(rays);
  vtkNew<vtkPolyData> expected;
  expected->DeepCopy(this->run(points));
  vtkNew<vtkSOADataArrayTemplate<double>> apart;
  apart->SetNumberOfComponents(3);
  apart->DeepCopy(points->GetPointData()->GetArray("RayDirection"));
  apart->SetName("RayDirection");
  points->GetPointData()->AddArray(apart);
  EXPECT_TRUE(sameBits(
    this->run(points)->GetPointData()->GetArray("T"), expected->GetPointData()->GetArray("T")));
}

TEST_F(RayForms, RaysThatCannotBeTracedAreCountedInOneWarning)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto rays = pointRays({ { { 3, 0.1, 0.2 }, { -1, 0, 0 } }, { { nan, 0, 0 }, { 1, 0, 0 } },
    { { 3, 0, 0 }, { 0, 0, 0 } }, { { 3, 0, 0 }, { -1, infinity, 0 } } });
  Messages messages(this->cast_);
  vtkDataSet* out = this->run(rays);
  EXPECT_EQ(messages.errors, 0);
  EXPECT_EQ(messages.warnings, 1);
  EXPECT_NE(messages.text.find("3 of 4 rays"), std::string::npos) << messages.text;
  EXPECT_EQ(value(out->GetPointData(), "HitMask", 0), 1);
  for (vtkIdType r = 1; r < 4; ++r)
  {
    EXPECT_EQ(value(out->GetPointData(), "HitMask", r), 0);
    EXPECT_EQ(value(out->GetPointData(), "HitOffset", r), 1);
  }
}

TEST_F(RayForms, NoRaysIsNoError)
{
  Messages messages(this->cast_);
  for (int query = vtkLumiRayCast::Closest; query <= vtkLumiRayCast::Count; ++query)
  {
    this->cast_->SetQuery(query);
    vtkDataSet* out = this->run(pointRays({}));
    EXPECT_EQ(shape(out->GetPointData(), "HitCount"), "id 1");
    EXPECT_EQ(out->GetPointData()->GetArray("HitCount")->GetNumberOfTuples(), 0);
    EXPECT_EQ(this->hits()->GetNumberOfPoints(), 0);
    this->run(vtkNew<vtkPolyData>());
  }
  EXPECT_EQ(messages.errors + messages.warnings, 0) << messages.text;
}

TEST_F(RayForms, WrongRaysAreOneError)
{
  const std::vector<TestRay> rays = raysAtUnitBall(5);
  const auto none = pointRays(rays);
  none->GetPointData()->RemoveArray("RayDirection");
  this->expectOneError(none, "RayDirection");

  const auto pairs = pointRays(rays);
  vtkNew<vtkDoubleArray> two;
  two->SetName("RayDirection");
  two->SetNumberOfComponents(2);
  two->SetNumberOfTuples(5);
  pairs->GetPointData()->AddArray(two);
  this->expectOneError(pairs, "RayDirection");

  const auto integers = pointRays(rays, VTK_DOUBLE, VTK_INT);
  this->expectOneError(integers, "RayDirection");

  this->cast_->SetInputArrayToProcess(0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Nowhere");
  this->expectOneError(pointRays(rays), "Nowhere");
}

TEST_F(RayForms, CompositeRaysAreOneError)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, pointRays(raysAtUnitBall(5)));
  blocks->SetBlock(1, pointRays(raysAtUnitBall(5)));
  this->expectOneError(blocks, "composite");
}
