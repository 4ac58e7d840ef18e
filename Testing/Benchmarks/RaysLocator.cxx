// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RaysLocator.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>

namespace lumitree::benchmarks
{
namespace
{

vtkSmartPointer<vtkFloatArray> triples(const std::vector<float>& values)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size() / 3));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

Vec3 tripleAt(const std::vector<float>& values, std::size_t i)
{
  return ArrayView(values.data()).triple(i);
}

} // namespace

vtkSmartPointer<vtkPolyData> surfaceData(const Scene& scene)
{
  vtkNew<vtkPoints> points;
  points->SetData(triples(scene.points));
  vtkNew<vtkTypeInt64Array> offsets;
  vtkNew<vtkTypeInt64Array> corners;
  const auto count = static_cast<vtkIdType>(scene.triangles.size());
  offsets->SetNumberOfValues(count + 1);
  corners->SetNumberOfValues(3 * count);
  for (vtkIdType t = 0; t <= count; ++t)
  {
    offsets->SetValue(t, 3 * t);
  }
  vtkIdType next = 0;
  for (const Triangle& triangle : scene.triangles)
  {
    for (const std::uint32_t corner : triangle)
    {
      corners->SetValue(next++, corner);
    }
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, corners);
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(cells);
  return surface;
}

vtkSmartPointer<vtkPolyData> rayData(const Rays& rays)
{
  vtkNew<vtkPoints> points;
  points->SetData(triples(rays.origins));
  const vtkSmartPointer<vtkFloatArray> directions = triples(rays.directions);
  directions->SetName("RayDirection");
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->AddArray(directions);
  return data;
}

RawLocator::RawLocator(vtkPolyData* surface)
  : locator_(vtkSmartPointer<vtkStaticCellLocator>::New())
{
  this->locator_->SetDataSet(surface);
  this->locator_->BuildLocator();
  this->reach_ = 10.0 * surface->GetLength();
}

void RawLocator::closest(const Rays& rays, std::size_t begin, std::size_t end, Hit* hits) const
{
  const vtkNew<vtkGenericCell> cell;
  for (std::size_t i = begin; i < end; ++i)
  {
    const Vec3 origin = tripleAt(rays.origins, i);
    const Vec3 direction = tripleAt(rays.directions, i); // of length 1
    const Vec3 far = origin + this->reach_ * direction;
    double t;
    double x[3];
    double uv[3];
    int part;
    vtkIdType id;
    hits[i] = Hit{};
    if (this->locator_->IntersectWithLine(
          origin.data(), far.data(), 0.0, t, x, uv, part, id, cell.Get()))
    {
      hits[i] = { this->reach_ * t, uv[0], uv[1], static_cast<PrimitiveId>(id) };
    }
  }
}

} // namespace lumitree::benchmarks
