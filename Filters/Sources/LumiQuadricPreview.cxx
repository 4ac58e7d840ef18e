// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiQuadricPreview.h"

#include "vtkCellArray.h"
#include "vtkClipPolyData.h"
#include "vtkDoubleArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lumitree::filters
{
namespace
{

vtkSmartPointer<vtkDoubleArray> newArray(vtkIdType tuples, int components = 1)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

/// The zero contour of a function in a box.
template <class F, class G>
vtkSmartPointer<vtkPolyData> contour(F value, G gradient, const Box& box, int resolution)
{
  const vtkNew<vtkImageData> image;
  const Vec3 size = box.size();
  image->SetDimensions(resolution + 1, resolution + 1, resolution + 1);
  image->SetOrigin(box.lower.data());
  image->SetSpacing(size[0] / resolution, size[1] / resolution, size[2] / resolution);
  const vtkIdType n = image->GetNumberOfPoints();
  const auto values = newArray(n);
  double largest = 0.0;
  for (vtkIdType i = 0; i < n; ++i)
  {
    Vec3 x;
    image->GetPoint(i, x.data());
    const double v = value(x);
    // Nothing is shown where there is no number.
    values->SetValue(i, std::isfinite(v) ? v : std::numeric_limits<float>::max());
    largest = std::max(largest, std::fabs(values->GetValue(i)));
  }
  // The contour filter compares with numbers near 1.
  for (vtkIdType i = 0; largest > 0.0 && i < n; ++i)
  {
    values->SetValue(i, values->GetValue(i) / largest);
  }
  image->GetPointData()->SetScalars(values);
  const vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->SetValue(0, 0.0);
  edges->ComputeNormalsOff();
  edges->ComputeScalarsOff();
  edges->Update();
  auto result = vtkSmartPointer<vtkPolyData>::New();
  const vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkPoints* const found = edges->GetOutput()->GetPoints();
  points->SetNumberOfPoints(found ? found->GetNumberOfPoints() : 0);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    Vec3 x;
    found->GetPoint(i, x.data());
    for (int step = 0; step < 2; ++step)
    {
      const Vec3 g = gradient(x);
      const double square = dot(g, g);
      if (square > 0.0)
      {
        const double reach = length(size) / resolution;
        const double move = value(x) / square;
        // Near an apex the gradient says nothing.
        x = std::fabs(move) * std::sqrt(square) <= reach ? x - move * g : x;
      }
    }
    points->SetPoint(i, x.data());
  }
  result->SetPoints(points);
  result->SetPolys(edges->GetOutput()->GetPolys());
  return result;
}

/// What is left where f(x) <= 0.
template <class F>
vtkSmartPointer<vtkPolyData> clipped(vtkPolyData* data, F f)
{
  const auto values = newArray(data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    Vec3 x;
    data->GetPoint(i, x.data());
    values->SetValue(i, f(x));
  }
  data->GetPointData()->SetScalars(values);
  const vtkNew<vtkClipPolyData> clip;
  clip->SetInputData(data);
  clip->InsideOutOn();
  clip->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  clip->Update();
  vtkSmartPointer<vtkPolyData> result = clip->GetOutput();
  result->GetPointData()->Initialize();
  return result;
}

/// Winds every polygon so that the function grows on the side of its normal.
template <class G>
void turn(G gradient, vtkPolyData* data)
{
  const vtkNew<vtkCellArray> turned;
  const vtkNew<vtkIdList> ids;
  vtkCellArray* const polygons = data->GetPolys();
  for (vtkIdType i = 0; i < polygons->GetNumberOfCells(); ++i)
  {
    polygons->GetCellAtId(i, ids);
    Vec3 corner[3];
    for (int k = 0; k < 3; ++k)
    {
      data->GetPoint(ids->GetId(k), corner[k].data());
    }
    const Vec3 n = cross(corner[1] - corner[0], corner[2] - corner[0]);
    const Vec3 middle = (1.0 / 3) * (corner[0] + corner[1] + corner[2]);
    if (dot(n, gradient(middle)) < 0.0)
    {
      std::reverse(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfIds());
    }
    turned->InsertNextCell(ids);
  }
  data->SetPolys(turned);
}

/// The box to sample; false where there is nothing to show.
bool usableBox(Box& box, int resolution)
{
  bool usable = resolution > 0;
  for (int k = 0; k < 3; ++k)
  {
    usable = usable && box.lower[k] <= box.upper[k] && std::isfinite(box.upper[k] - box.lower[k]);
  }
  if (!usable)
  {
    return false;
  }
  // A flat box has no inside to sample.
  const double least = 1e-6 * box.size()[box.longestAxis()];
  for (int k = 0; k < 3; ++k)
  {
    if (box.upper[k] - box.lower[k] < least)
    {
      box.lower[k] -= least;
      box.upper[k] += least;
    }
  }
  return true;
}

template <class G>
void addNormals(G gradient, vtkPolyData* shown)
{
  const auto normals = newArray(shown->GetNumberOfPoints(), 3);
  normals->SetName("Normals");
  for (vtkIdType i = 0; i < shown->GetNumberOfPoints(); ++i)
  {
    Vec3 x;
    shown->GetPoint(i, x.data());
    Vec3 g = gradient(x);
    const double norm = length(g);
    g = norm > 0.0 ? (1.0 / norm) * g : Vec3{ 0, 0, 0 };
    normals->SetTuple(i, g.data());
  }
  shown->GetPointData()->SetNormals(normals);
}

} // namespace

vtkSmartPointer<vtkPolyData> previewOf(const Quadric& quadric, int resolution)
{
  Box box = quadric.clip;
  if (!usableBox(box, resolution))
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  const auto gradient = [&](const Vec3& x) { return gradientAt(quadric.form, x); };
  vtkSmartPointer<vtkPolyData> shown =
    contour([&](const Vec3& x) { return valueAt(quadric.form, x); }, gradient, box, resolution);
  for (const QuadricCut& cut : quadric.cuts)
  {
    if (cut.normal != Vec3{ 0, 0, 0 })
    {
      shown = clipped(shown, [&](const Vec3& x) { return dot(cut.normal, x - cut.point); });
    }
  }
  const auto& bound = quadric.bound.coefficients;
  if (std::any_of(bound.begin(), bound.end(), [](double x) { return x != 0.0; }))
  {
    shown = clipped(shown, [&](const Vec3& x) { return valueAt(quadric.bound, x); });
  }
  turn(gradient, shown);
  addNormals(gradient, shown);
  return shown;
}

vtkSmartPointer<vtkPolyData> previewOf(
  const ImplicitFunction& function, const Box& clip, int resolution)
{
  Box box = clip;
  if (!usableBox(box, resolution))
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  const auto gradient = [&](const Vec3& x) { return function.gradient(x); };
  auto shown = contour([&](const Vec3& x) { return function.value(x); }, gradient, box, resolution);
  turn(gradient, shown);
  addNormals(gradient, shown);
  return shown;
}

} // namespace lumitree::filters
