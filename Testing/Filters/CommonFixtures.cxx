// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CommonFixtures.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

Reporter::Reporter()
{
  this->algorithm_->AddObserver(vtkCommand::ErrorEvent, this, &Reporter::remember);
  this->algorithm_->AddObserver(vtkCommand::WarningEvent, this, &Reporter::remember);
}

Reporter::~Reporter()
{
  this->algorithm_->RemoveAllObservers();
}

void Reporter::remember(vtkObject*, unsigned long event, void* message)
{
  this->errors += event == vtkCommand::ErrorEvent;
  this->text += static_cast<const char*>(message);
}

vtkSmartPointer<vtkPolyData> polygons(
  const std::vector<lumitree::Vec3>& points, const std::vector<Cell>& cells, int type)
{
  vtkNew<vtkPoints> vtkPts;
  vtkPts->SetDataType(type);
  for (const lumitree::Vec3& p : points)
  {
    vtkPts->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> polys;
  for (const Cell& cell : cells)
  {
    polys->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtkPts);
  data->SetPolys(polys);
  return data;
}

vtkSmartPointer<vtkPolyData> squares(int n, double height, int type)
{
  std::vector<lumitree::Vec3> points;
  std::vector<Cell> cells;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      points.push_back({ static_cast<double>(i), static_cast<double>(j), height });
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const vtkIdType p = j * (n + 1) + i;
      cells.push_back({ p, p + 1, p + n + 2, p + n + 1 });
    }
  }
  return polygons(points, cells, type);
}

vtkSmartPointer<vtkImageData> voxels(int nx, int ny, int nz)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(nx + 1, ny + 1, nz + 1);
  return image;
}

void setGhosts(vtkDataSet* data, const std::vector<int>& values)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (const int value : values)
  {
    ghosts->InsertNextValue(static_cast<unsigned char>(value));
  }
  data->GetCellData()->AddArray(ghosts);
}

std::vector<std::int64_t> cellsOf(const lumitree::filters::SurfaceInput& input)
{
  std::vector<std::int64_t> cells;
  for (lumitree::PrimitiveId i = 0; i < input.surface->size(); ++i)
  {
    cells.push_back(input.surface->source(i).cell);
  }
  return cells;
}

lumitree::Vec3 areaVector(const lumitree::Surface& surface, lumitree::PrimitiveId primitive)
{
  using namespace lumitree; // Vec3 is a std::array: its operators are not found by themselves
  const auto v = surface.vertices(primitive);
  return cross(v[1] - v[0], v[2] - v[0]);
}

double surfaceArea(const lumitree::filters::SurfaceInput& input)
{
  double sum = 0.0;
  for (lumitree::PrimitiveId i = 0; i < input.surface->size(); ++i)
  {
    sum += 0.5 * lumitree::length(areaVector(*input.surface, i));
  }
  return sum;
}

void expectMapsBack(const lumitree::filters::SurfaceInput& input)
{
  for (lumitree::PrimitiveId i = 0; i < input.surface->size(); ++i)
  {
    vtkDataSet* leaf = input.leaves[input.leafOf(i)].data;
    const auto ids = input.leafPointIds(i);
    vtkNew<vtkIdList> ofCell;
    leaf->GetCellPoints(input.leafCellId(i), ofCell);
    for (std::size_t k = 0; k < 3; ++k)
    {
      lumitree::Vec3 p;
      leaf->GetPoint(ids[k], p.data());
      EXPECT_EQ(input.surface->vertices(i)[k], p) << "primitive " << i;
      EXPECT_GE(ofCell->IsId(ids[k]), 0) << "primitive " << i;
    }
  }
}

std::shared_ptr<const lumitree::filters::SurfaceInput> surfaceOf(vtkDataObject* data)
{
  Reporter reporter;
  auto input = lumitree::filters::surfaceFor(data, nullptr, reporter.algorithm());
  EXPECT_EQ(reporter.errors, 0) << reporter.text;
  EXPECT_TRUE(input);
  return input;
}
