// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiCells.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <array>
#include <limits>
#include <vector>

namespace lumitree::filters
{

namespace
{

std::array<int, VTK_NUMBER_OF_CELL_TYPES> allDimensions()
{
  std::array<int, VTK_NUMBER_OF_CELL_TYPES> dimensions;
  for (int type = 0; type < VTK_NUMBER_OF_CELL_TYPES; ++type)
  {
    const auto cell = vtk::TakeSmartPointer(vtkGenericCell::InstantiateCell(type));
    dimensions[type] = cell && type != VTK_EMPTY_CELL ? cell->GetCellDimension() : -1;
  }
  return dimensions;
}

/// Half the sum of two edges' cross product: the area vector of a triangle.
Vec3 triangleArea(const Vec3& a, const Vec3& b, const Vec3& c)
{
  return 0.5 * cross(b - a, c - a);
}

} // namespace

int cellDimension(int cellType)
{
  static const auto dimensions = allDimensions();
  return cellType >= 0 && cellType < VTK_NUMBER_OF_CELL_TYPES ? dimensions[cellType] : -1;
}

void prepareCells(vtkDataSet* data)
{
  if (data->GetNumberOfCells() > 0)
  {
    const vtkNew<vtkGenericCell> cell;
    data->GetCellType(0);
    data->GetCell(0, cell);
  }
}

Cells::Cells(vtkDataSet* data)
  : data_(data)
{
}

vtkIdList* Cells::points(vtkIdType cell)
{
  this->data_->GetCellPoints(cell, this->ids_);
  return this->ids_;
}

Vec3 Cells::point(vtkIdType id) const
{
  Vec3 p;
  this->data_->GetPoint(id, p.data());
  return p;
}

Vec3 Cells::centre(vtkIdType cell)
{
  Vec3 centre;
  switch (this->data_->GetCellType(cell))
  {
    case VTK_VERTEX:
    case VTK_LINE:
    case VTK_TRIANGLE:
    case VTK_QUAD:
    case VTK_PIXEL:
    case VTK_TETRA:
    case VTK_VOXEL:
    case VTK_HEXAHEDRON:
    {
      // The parametric centre of these is the mean of their points.
      this->points(cell);
      const vtkIdType n = this->ids_->GetNumberOfIds();
      centre = { 0.0, 0.0, 0.0 };
      for (vtkIdType i = 0; i < n; ++i)
      {
        centre = centre + this->point(this->ids_->GetId(i));
      }
      return { centre[0] / n, centre[1] / n, centre[2] / n };
    }
    case VTK_EMPTY_CELL:
      centre.fill(std::numeric_limits<double>::quiet_NaN());
      return centre;
    default:
    {
      this->data_->GetCell(cell, this->cell_);
      double parametric[3];
      int subId = this->cell_->GetParametricCenter(parametric);
      std::vector<double> weights(this->cell_->GetNumberOfPoints());
      this->cell_->EvaluateLocation(subId, parametric, centre.data(), weights.data());
      return centre;
    }
  }
}

Vec3 Cells::polygonArea(const int* order, int corners) const
{
  const auto corner = [&](int i) { return this->point(this->ids_->GetId(order ? order[i] : i)); };
  // From the first corner, so that coordinates far from the origin cancel at once.
  Vec3 area = { 0.0, 0.0, 0.0 };
  if (corners >= 3)
  {
    const Vec3 first = corner(0);
    Vec3 previous = corner(1);
    for (int i = 2; i < corners; ++i)
    {
      const Vec3 next = corner(i);
      area = area + triangleArea(first, previous, next);
      previous = next;
    }
  }
  return area;
}

Vec3 Cells::areaVector(vtkIdType cell)
{
  const int type = this->data_->GetCellType(cell);
  switch (type)
  {
    case VTK_TRIANGLE:
    case VTK_QUAD:
    case VTK_POLYGON:
      this->points(cell);
      return this->polygonArea(nullptr, static_cast<int>(this->ids_->GetNumberOfIds()));
    case VTK_PIXEL:
    {
      constexpr int order[4] = { 0, 1, 3, 2 };
      this->points(cell);
      return this->polygonArea(order, 4);
    }
    case VTK_TRIANGLE_STRIP:
    {
      this->points(cell);
      Vec3 area = { 0.0, 0.0, 0.0 };
      for (vtkIdType i = 2; i < this->ids_->GetNumberOfIds(); ++i)
      {
        const Vec3 one = triangleArea(this->point(this->ids_->GetId(i - 2)),
          this->point(this->ids_->GetId(i - 1)), this->point(this->ids_->GetId(i)));
        area = area + (i % 2 == 0 ? 1.0 : -1.0) * one;
      }
      return area;
    }
    default:
    {
      // Nonlinear cells, by the triangles that VTK makes of them.
      this->data_->GetCell(cell, this->cell_);
      const vtkNew<vtkPoints> corners;
      this->cell_->Triangulate(0, this->ids_, corners);
      Vec3 area = { 0.0, 0.0, 0.0 };
      for (vtkIdType i = 0; i + 2 < corners->GetNumberOfPoints(); i += 3)
      {
        std::array<Vec3, 3> p;
        for (int k = 0; k < 3; ++k)
        {
          corners->GetPoint(i + k, p[k].data());
        }
        area = area + triangleArea(p[0], p[1], p[2]);
      }
      return area;
    }
  }
}

} // namespace lumitree::filters
