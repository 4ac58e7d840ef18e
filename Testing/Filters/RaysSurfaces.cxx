// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkLumiRayCast: the surfaces that rays meet, their ids, ghosts, and their own arrays.
#include "RaysFixtures.h"

#include "vtkLumiRayCast.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

using namespace lumitree::testing;

namespace
{

/// A large triangle at that height.
vtkSmartPointer<vtkPolyData> wall(double z)
{
  return triangles({ { -9, -9, z }, { 9, -9, z }, { 0, 9, z } });
}

class RaySurfaces : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->cast_->SetQuery(vtkLumiRayCast::All);
    this->cast_->SetRaysData(pointRays({ { { 0.1, 0.2, 0 }, { 0, 0, 1 } } }));
  }

  vtkPointData* run(vtkDataObject* surface)
  {
    this->cast_->SetInputDataObject(0, surface);
    this->cast_->Update();
    return vtkPolyData::SafeDownCast(this->cast_->GetOutputDataObject(0))->GetPointData();
  }

  vtkNew<vtkLumiRayCast> cast_;
};

template <class Array>
vtkSmartPointer<Array> named(const char* name, vtkIdType tuples, int components = 1)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

} // namespace

TEST_F(RaySurfaces, ACompositeIsOneScene)
{
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, wall(3));
  vtkNew<vtkMultiBlockDataSet>
    blocks; // flat indices: wall(1) 1, null 2, inner 3, wall(3) 4, wall(2) 5
  blocks->SetBlock(0, wall(1));
  blocks->SetBlock(1, nullptr);
  blocks->SetBlock(2, inner);
  blocks->SetBlock(3, wall(2));
  vtkPointData* hits = this->run(blocks);
  ASSERT_EQ(hits->GetNumberOfTuples(), 3);
  const int expected[3] = { 1, 5, 4 };
  for (vtkIdType h = 0; h < 3; ++h)
  {
    EXPECT_EQ(value(hits, "T", h), h + 1.0);
    EXPECT_EQ(value(hits, "CellId", h), 0);
    EXPECT_EQ(value(hits, "CompositeIndex", h), expected[h]);
  }
  // One dataset of rays, not a copy for each block.
  EXPECT_TRUE(vtkPolyData::SafeDownCast(this->cast_->GetOutputDataObject(1)));
  this->cast_->SetQuery(vtkLumiRayCast::Closest);
  EXPECT_EQ(this->run(blocks)->GetNumberOfTuples(), 1);
}

TEST_F(RaySurfaces, PartitionedCollections)
{
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartition(0, 0, wall(1));
  collection->SetPartition(1, 0, wall(2));
  collection->SetPartition(1, 1, wall(3));
  vtkPointData* hits = this->run(collection);
  ASSERT_EQ(hits->GetNumberOfTuples(), 3);
  const int expected[3] = { 2, 4, 5 }; // 1 and 3 are the partitioned datasets
  for (vtkIdType h = 0; h < 3; ++h)
  {
    EXPECT_EQ(value(hits, "CompositeIndex", h), expected[h]);
  }
}

TEST_F(RaySurfaces, ATriangulatedPolygonReportsItself)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point& p :
    std::vector<Point>{ { -1, -1, 1 }, { 1, -1, 1 }, { 1, 1, 1 }, { 0, 2, 1 }, { -1, 1, 1 } })
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 2, 3, 4 });
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetVerts(vertices);
  surface->SetPolys(polygons);
  vtkPointData* hits = this->run(surface);
  ASSERT_EQ(hits->GetNumberOfTuples(), 1);
  EXPECT_EQ(value(hits, "CellId", 0), 1); // cell 0 is the vertex
}

TEST_F(RaySurfaces, AVolumeIsMetAtItsOuterCells)
{
  vtkNew<vtkImageData> volume; // cells [0, 1] … [3, 4] along each axis
  volume->SetDimensions(5, 5, 5);
  this->cast_->SetRaysData(pointRays({ { { 0.4, 1.3, -1 }, { 0, 0, 1 } } }));
  vtkPointData* hits = this->run(volume);
  ASSERT_EQ(hits->GetNumberOfTuples(), 2);
  EXPECT_EQ(value(hits, "CellId", 0), 4);
  EXPECT_EQ(value(hits, "CellId", 1), 4 + 3 * 16);
}

TEST_F(RaySurfaces, GhostsAreNotMet)
{
  const auto surface = triangles({ { -9, -9, 1 }, { 9, -9, 1 }, { 0, 9, 1 }, { -9, -9, 2 },
    { 9, -9, 2 }, { 0, 9, 2 }, { -9, -9, 3 }, { 9, -9, 3 }, { 0, 9, 3 } });
  const auto ghosts = named<vtkUnsignedCharArray>(vtkDataSetAttributes::GhostArrayName(), 3);
  ghosts->SetValue(0, vtkDataSetAttributes::HIDDENCELL);
  ghosts->SetValue(1, vtkDataSetAttributes::DUPLICATECELL);
  ghosts->SetValue(2, 0);
  surface->GetCellData()->AddArray(ghosts);
  this->cast_->PassSurfaceDataOn();
  vtkPointData* hits = this->run(surface);
  ASSERT_EQ(hits->GetNumberOfTuples(), 1);
  EXPECT_EQ(value(hits, "CellId", 0), 2);
  EXPECT_FALSE(hits->HasArray(vtkDataSetAttributes::GhostArrayName()));
}

TEST_F(RaySurfaces, AnEmptySurfaceIsMissed)
{
  Messages messages(this->cast_);
  for (int query = vtkLumiRayCast::Closest; query <= vtkLumiRayCast::Count; ++query)
  {
    this->cast_->SetQuery(query);
    this->run(vtkNew<vtkPolyData>());
    this->run(vtkNew<vtkMultiBlockDataSet>());
    auto* rays = vtkDataSet::SafeDownCast(this->cast_->GetOutputDataObject(1));
    ASSERT_EQ(shape(rays->GetPointData(), "HitMask"), "unsigned char 1");
    EXPECT_EQ(value(rays->GetPointData(), "HitMask", 0), 0);
  }
  EXPECT_EQ(messages.errors + messages.warnings, 0) << messages.text;
}

TEST_F(RaySurfaces, ALinearFieldIsInterpolatedExactly)
{
  const auto surface = polyData(lumitree::data::sphere(8));
  const auto field = named<vtkDoubleArray>("Field", surface->GetNumberOfPoints(), 2);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    field->SetComponent(i, 0, 1 + 2 * p[0] - 3 * p[1] + 5 * p[2]);
    field->SetComponent(i, 1, p[0]);
  }
  surface->GetPointData()->AddArray(field);
  const auto number = named<vtkTypeInt64Array>("Number", surface->GetNumberOfCells());
  vtkNew<vtkStringArray> text;
  text->SetName("Text");
  const vtkTypeInt64 large = (vtkTypeInt64{ 1 } << 62) + 1; // not a double
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    number->SetValue(i, large + i);
    text->InsertNextValue(std::to_string(i));
  }
  surface->GetCellData()->AddArray(number);
  surface->GetCellData()->AddArray(text);
  this->cast_->SetRaysData(pointRays(raysAtUnitBall(1000)));
  EXPECT_EQ(this->run(surface)->GetArray("Field"), nullptr) << "only on request";
  this->cast_->PassSurfaceDataOn();
  vtkPointData* hits = this->run(surface);
  auto* points = vtkPolyData::SafeDownCast(this->cast_->GetOutputDataObject(0));
  EXPECT_EQ(shape(hits, "Field"), "double 2");
  ASSERT_GT(hits->GetNumberOfTuples(), 500);
  for (vtkIdType h = 0; h < hits->GetNumberOfTuples(); ++h)
  {
    double p[3];
    points->GetPoint(h, p);
    ASSERT_NEAR(value(hits, "Field", h, 0), 1 + 2 * p[0] - 3 * p[1] + 5 * p[2], 1e-13);
    ASSERT_NEAR(value(hits, "Field", h, 1), p[0], 1e-14);
    const auto cell = static_cast<vtkIdType>(value(hits, "CellId", h));
    ASSERT_EQ(hits->GetArray("Number")->GetVariantValue(h).ToTypeInt64(), large + cell);
    ASSERT_EQ(vtkStringArray::SafeDownCast(hits->GetAbstractArray("Text"))->GetValue(h),
      std::to_string(cell));
  }
}

TEST_F(RaySurfaces, OnlyArraysThatEveryLeafHasArePassed)
{
  const auto first = wall(1);
  const auto second = wall(2);
  for (vtkPolyData* leaf : { first.Get(), second.Get() })
  {
    const double base = leaf == first ? 0 : 10;
    const auto both = named<vtkDoubleArray>("Both", 3);
    both->FillValue(base);
    leaf->GetPointData()->AddArray(both);
    const auto cell = named<vtkIntArray>("Cell", 1);
    cell->FillValue(static_cast<int>(base) + 1);
    leaf->GetCellData()->AddArray(cell);
    const auto taken = named<vtkDoubleArray>("T", 3);
    taken->FillValue(-1);
    leaf->GetPointData()->AddArray(taken);
    const auto shapes = named<vtkDoubleArray>("Shapes", 3, leaf == first ? 1 : 2);
    shapes->Fill(0);
    leaf->GetPointData()->AddArray(shapes);
  }
  first->GetPointData()->AddArray(named<vtkDoubleArray>("First", 3));
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, vtkNew<vtkPolyData>()); // nothing can hit it: it does not count
  blocks->SetBlock(1, first);
  blocks->SetBlock(2, second);
  this->cast_->PassSurfaceDataOn();
  vtkPointData* hits = this->run(blocks);
  ASSERT_EQ(hits->GetNumberOfTuples(), 2);
  EXPECT_EQ(hits->GetNumberOfArrays(), 8);
  EXPECT_EQ(value(hits, "Both", 0), 0);
  EXPECT_EQ(value(hits, "Both", 1), 10);
  EXPECT_EQ(value(hits, "Cell", 0), 1);
  EXPECT_EQ(value(hits, "Cell", 1), 11);
  EXPECT_EQ(value(hits, "T", 0), 1);
  EXPECT_EQ(value(hits, "T", 1), 2);
}

TEST_F(RaySurfaces, AVolumesArraysArePassed)
{
  vtkNew<vtkImageData> volume;
  volume->SetDimensions(5, 5, 5);
  const auto field = named<vtkDoubleArray>("Field", volume->GetNumberOfPoints());
  for (vtkIdType i = 0; i < volume->GetNumberOfPoints(); ++i)
  {
    double p[3];
    volume->GetPoint(i, p);
    field->SetValue(i, p[0] + 10 * p[1] + 100 * p[2]);
  }
  volume->GetPointData()->AddArray(field);
  this->cast_->SetRaysData(pointRays({ { { 0.4, 1.3, -1 }, { 0, 0, 1 } } }));
  this->cast_->PassSurfaceDataOn();
  vtkPointData* hits = this->run(volume);
  ASSERT_EQ(hits->GetNumberOfTuples(), 2);
  EXPECT_NEAR(value(hits, "Field", 0), 13.4, 1e-12);
  EXPECT_NEAR(value(hits, "Field", 1), 413.4, 1e-12);
}
