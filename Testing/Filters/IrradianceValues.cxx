// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Numbers, names and units of vtkLumiIrradiance on single datasets.
#include "IrradianceFixtures.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace lumitree::testing
{
namespace
{

constexpr char irradiance[] = "Irradiance [W/m^2]";
constexpr char scalarIrradiance[] = "ScalarIrradiance [W/m^2]";
constexpr double overAPlane = 10.1859163578813; // Φ = 1000, h = 2, r = 1.5

/// A point with a vertex cell and a normal, of any length.
vtkSmartPointer<vtkPolyData> sensor(const Point& position, const Point& normal)
{
  auto data = polygons({ position }, {});
  const vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  data->SetVerts(vertices);
  const vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->InsertNextTuple(normal.data());
  data->GetPointData()->SetNormals(normals);
  data->GetCellData()->SetNormals(normals);
  return data;
}

TEST(IrradianceValues, SensorOnAPlane)
{
  for (const int location : { vtkLumiIrradiance::Points, vtkLumiIrradiance::Cells })
  {
    Irradiance filter(sensor({ 0, 0, 0 }, { 0, 0, 7 }), { pointLight({ 1.5, 0, 2 }, 1000.0) });
    filter->SetReceiverLocation(location);
    vtkDataArray* e = filter.run(irradiance);
    ASSERT_TRUE(e) << filter.text;
    EXPECT_EQ(e->GetDataType(), VTK_DOUBLE);
    EXPECT_NEAR(e->GetComponent(0, 0), overAPlane, 1e-12 * overAPlane);
    EXPECT_EQ(filter.errors + filter.warnings, 0) << filter.text;
  }
}

TEST(IrradianceValues, LengthUnitScalesCoordinates)
{
  const double metres[] = { 1.0, 1e-3, 1e-2, 1e3, 0.0254, 0.3048 };
  for (int unit = vtkLumiIrradiance::Metre; unit <= vtkLumiIrradiance::Foot; ++unit)
  {
    Irradiance filter(sensor({ 0, 0, 0 }, { 0, 0, 1 }),
      { pointLight({ 1.5 / metres[unit], 0, 2 / metres[unit] }, 1000.0) });
    filter->SetLengthUnit(unit);
    vtkDataArray* e = filter.run(irradiance);
    ASSERT_TRUE(e);
    EXPECT_NEAR(e->GetComponent(0, 0), overAPlane, 1e-12 * overAPlane) << unit;
    vtkFieldData* fields = filter->GetOutputDataObject(0)->GetFieldData();
    EXPECT_NEAR(fields->GetArray("MetresPerUnit")->GetComponent(0, 0), metres[unit], 1e-15);
    EXPECT_TRUE(vtkStringArray::SafeDownCast(fields->GetAbstractArray("LengthUnit")));
  }
}

TEST(IrradianceValues, ParallelLightIsTheSameInEveryUnit)
{
  Irradiance filter(sensor({ 0, 0, 0 }, { 0, 0, 1 }), { directionalLight({ 0, -3, -4 }, 500.0) });
  filter->SetLengthUnit(vtkLumiIrradiance::Millimetre);
  EXPECT_NEAR(filter.run(irradiance)->GetComponent(0, 0), 400.0, 1e-10);
}

TEST(IrradianceValues, NamesUnitsAndActiveScalars)
{
  for (const bool photometric : { false, true })
  {
    Irradiance filter(floorStrip(0, 1, 3),
      { pointLight({ 0, 0, 2 }, 1000.0, "A", photometric),
        directionalLight({ 0, 0, -1 }, 10.0, "B", photometric) });
    filter->PerLightArraysOn();
    const std::string name = photometric ? "Illuminance [lx]" : irradiance;
    vtkDataArray* e = filter.run(name.c_str());
    ASSERT_TRUE(e) << filter.text;
    vtkCellData* cells = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetCellData();
    EXPECT_EQ(cells->GetScalars(), e);
    EXPECT_EQ(cells->GetNumberOfArrays(), 3);
    for (const char* suffix : { "", " A", " B" })
    {
      vtkDataArray* array = cells->GetArray((name + suffix).c_str());
      ASSERT_TRUE(array) << suffix;
      EXPECT_STREQ(
        array->GetInformation()->Get(vtkDataArray::UNITS_LABEL()), photometric ? "lx" : "W/m^2");
      EXPECT_EQ(array->GetNumberOfComponents(), 1);
    }
  }
}

TEST(IrradianceValues, LightsAddUp)
{
  Irradiance filter(floorStrip(-3, 0.25, 24),
    { pointLight({ 0, 0, 2 }, 1000.0), pointLight({ 1, 1, 3 }, 300.0),
      pointLight({ 9, 1, 3 }, 30.0, "Lamp 2"), directionalLight({ 1, 0, -1 }, 100.0) });
  filter->PerLightArraysOn();
  vtkDataArray* e = filter.run(irradiance);
  ASSERT_TRUE(e) << filter.text;
  vtkCellData* cells = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetCellData();
  std::vector<vtkDataArray*> each;
  for (const char* light : { " Lamp", " Lamp 2", " Lamp 2 2", " Sun" })
  {
    each.push_back(cells->GetArray((std::string(irradiance) + light).c_str()));
    ASSERT_TRUE(each.back()) << light;
  }
  for (vtkIdType i = 0; i < 24; ++i)
  {
    double sum = 0.0;
    for (vtkDataArray* array : each)
    {
      EXPECT_GT(array->GetComponent(i, 0), 0.0);
      sum += array->GetComponent(i, 0);
    }
    EXPECT_EQ(e->GetComponent(i, 0), sum);
  }
}

TEST(IrradianceValues, WindingSaysWhichSideIsLit)
{
  // The same square as quad, polygon, two triangles, and turned over.
  const std::vector<Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
    { 0.5, 1.5, 0 } };
  Irradiance filter(
    polygons(points, { { 0, 1, 2, 3 }, { 0, 1, 2, 4, 3 }, { 0, 1, 2 }, { 3, 2, 1, 0 } }),
    { directionalLight({ 0, 0, -1 }, 10.0) });
  vtkDataArray* e = filter.run(irradiance);
  ASSERT_TRUE(e);
  EXPECT_EQ(e->GetComponent(0, 0), 10.0);
  EXPECT_EQ(e->GetComponent(1, 0), 10.0);
  EXPECT_EQ(e->GetComponent(2, 0), 10.0);
  EXPECT_EQ(e->GetComponent(3, 0), 0.0);
}

TEST(IrradianceValues, StripsFaceOneWay)
{
  auto data = polygons({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 0, 2, 0 } }, {});
  const vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 1, 2, 3, 4 });
  data->SetStrips(strips);
  Irradiance filter(data, { directionalLight({ 0, 0, -1 }, 10.0) });
  EXPECT_EQ(filter.run(irradiance)->GetComponent(0, 0), 10.0);
  filter->SetReceiverLocation(vtkLumiIrradiance::Points);
  vtkDataArray* e = filter.run(irradiance);
  for (vtkIdType i = 0; i < 5; ++i)
  {
    EXPECT_EQ(e->GetComponent(i, 0), 10.0) << i;
  }
}

TEST(IrradianceValues, PointsTakeTheAreaWeightedMeanOfTheirCells)
{
  // A floor of area 2 and a wall of area 1 meet in the edge x = 0.
  Irradiance filter(
    polygons({ { 0, 0, 0 }, { 0, 1, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 0, 0, 1 }, { 0, 1, 1 } },
      { { 0, 2, 3, 1 }, { 0, 1, 5, 4 } }),
    { directionalLight({ 0, 0, -1 }, 1.0) });
  filter->SetReceiverLocation(vtkLumiIrradiance::Points);
  vtkDataArray* e = filter.run(irradiance);
  ASSERT_TRUE(e);
  EXPECT_NEAR(e->GetComponent(0, 0), 2.0 / std::sqrt(5.0), 1e-15);
  EXPECT_NEAR(e->GetComponent(2, 0), 1.0, 1e-15);
  EXPECT_NEAR(e->GetComponent(4, 0), 0.0, 1e-15);
}

TEST(IrradianceValues, CellsOfThreeDimensionsGetScalarIrradiance)
{
  const vtkNew<vtkImageData> image;
  image->SetDimensions(3, 2, 2);
  image->SetSpacing(2, 2, 2);
  image->SetOrigin(-1, -1, -1); // centres (0, 0, 0) and (2, 0, 0)
  Irradiance filter(image, { pointLight({ 0, 0, 3 }, 1000.0) });
  filter->ShadowsOff();
  vtkDataArray* e = filter.run(scalarIrradiance);
  ASSERT_TRUE(e) << filter.text;
  EXPECT_NEAR(e->GetComponent(0, 0), 8.841941282883074, 1e-12 * 8.84);
  EXPECT_NEAR(e->GetComponent(1, 0), 1000.0 / (4.0 * 3.14159265358979323846 * 13.0), 1e-12);
  vtkCellData* cells = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetCellData();
  EXPECT_FALSE(cells->GetArray(irradiance));
  EXPECT_EQ(cells->GetScalars(), e);

  filter->SetReceiverLocation(vtkLumiIrradiance::Points);
  e = filter.run(scalarIrradiance);
  ASSERT_TRUE(e);
  EXPECT_NEAR(e->GetComponent(0, 0), 1000.0 / (4.0 * 3.14159265358979323846 * 18.0), 1e-12);
  EXPECT_EQ(filter.errors + filter.warnings, 0) << filter.text;
}

TEST(IrradianceValues, OwnFacesDoNotShadowACell)
{
  // Three cubes in a row, lit from above: all have a face to the light.
  const vtkNew<vtkImageData> image;
  image->SetDimensions(4, 2, 2);
  Irradiance filter(image, { directionalLight({ 0.1, 0.2, -1 }, 10.0) });
  vtkDataArray* e = filter.run(scalarIrradiance);
  ASSERT_TRUE(e) << filter.text;
  for (vtkIdType i = 0; i < 3; ++i)
  {
    EXPECT_EQ(e->GetComponent(i, 0), 10.0) << i;
  }
}

TEST(IrradianceValues, CellsOfBothKinds)
{
  const vtkNew<vtkUnstructuredGrid> grid;
  const vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point& p : { Point{ 0, 0, 0 }, Point{ 1, 0, 0 }, Point{ 0, 1, 0 }, Point{ 0, 0, 1 } })
  {
    points->InsertNextPoint(p.data());
  }
  grid->SetPoints(points);
  const vtkIdType ids[] = { 0, 1, 2, 3 };
  grid->InsertNextCell(VTK_TETRA, 4, ids);
  grid->InsertNextCell(VTK_TRIANGLE, 3, ids);
  grid->InsertNextCell(VTK_LINE, 2, ids);
  Irradiance filter(grid, { directionalLight({ 0, 0, -1 }, 10.0) });
  filter->ShadowsOff();
  vtkDataArray* e = filter.run(irradiance);
  vtkDataArray* scalar = filter.run(scalarIrradiance);
  ASSERT_TRUE(e && scalar);
  EXPECT_TRUE(std::isnan(e->GetComponent(0, 0)));
  EXPECT_EQ(e->GetComponent(1, 0), 10.0);
  EXPECT_EQ(scalar->GetComponent(0, 0), 10.0);
  EXPECT_TRUE(std::isnan(scalar->GetComponent(1, 0)));
  EXPECT_EQ(
    vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetCellData()->GetScalars(), e);
  EXPECT_TRUE(std::isnan(e->GetComponent(2, 0)));
  EXPECT_EQ(filter.warnings, 1);
}

TEST(IrradianceValues, FlatImageIsAPlaneOfSensors)
{
  const vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 1);
  image->SetOrigin(-1, -1, 0);
  for (const int location : { vtkLumiIrradiance::Points, vtkLumiIrradiance::Cells })
  {
    Irradiance filter(image, { pointLight({ 0, 0, 2 }, 1000.0) });
    filter->SetReceiverLocation(location);
    vtkDataArray* e = filter.run(irradiance);
    ASSERT_TRUE(e) << filter.text;
    EXPECT_TRUE(vtkImageData::SafeDownCast(filter->GetOutputDataObject(0)));
    for (vtkIdType i = 0; i < e->GetNumberOfTuples(); ++i)
    {
      EXPECT_GT(e->GetComponent(i, 0), 0.0);
    }
  }
}

TEST(IrradianceValues, TheInputIsLeftAlone)
{
  auto floor = floorStrip(-3, 0.25, 24);
  Irradiance filter(floor, { pointLight({ 0, 0, 2 }, 1000.0) });
  ASSERT_TRUE(filter.run(irradiance));
  EXPECT_EQ(floor->GetCellData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(floor->GetFieldData()->GetNumberOfArrays(), 0);
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_TRUE(output);
  EXPECT_EQ(output->GetPoints(), floor->GetPoints());
}

TEST(IrradianceValues, SameBitsForAnyNumberOfThreads)
{
  auto floor = floorStrip(-30, 0.003, 20000);
  std::vector<double> reference;
  for (int threads = 1; threads <= 4; ++threads)
  {
    Irradiance filter(floor, { pointLight({ 0, 0, 2 }, 1000.0), pointLight({ 2, 0.1, 1 }, 100.0) });
    filter->SetOccludersData(wall());
    filter->SetReceiverLocation(vtkLumiIrradiance::Points);
    filter->SetNumberOfThreads(threads);
    auto* e = vtkDoubleArray::SafeDownCast(filter.run(irradiance));
    ASSERT_TRUE(e);
    const std::vector<double> values(e->GetPointer(0), e->GetPointer(0) + e->GetNumberOfValues());
    reference = threads == 1 ? values : reference;
    EXPECT_EQ(std::memcmp(values.data(), reference.data(), values.size() * sizeof(double)), 0);
  }
}

} // namespace
} // namespace lumitree::testing
