// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiTriangulate.h"

#include "vtkPoints.h"

#include <algorithm>

namespace lumitree::filters
{
namespace
{

Triangle triangleOf(vtkIdType a, vtkIdType b, vtkIdType c)
{
  return { static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
    static_cast<std::uint32_t>(c) };
}

bool usable(const Vec3& p)
{
  // Written so that NaN is not usable.
  return std::fabs(p[0]) <= coordinateLimit && std::fabs(p[1]) <= coordinateLimit &&
    std::fabs(p[2]) <= coordinateLimit;
}

/// How far the worse of the two triangles of a diagonal keeps to the side of the normal: positive
/// when the diagonal lies inside. From a to c, with b and d on either side.
double inside(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& normal)
{
  return std::min(dot(cross(b - a, c - a), normal), dot(cross(c - a, d - a), normal));
}

} // namespace

bool Triangulator::notFinite(
  vtkIdType n, const vtkIdType* ids, std::vector<Triangle>& triangles) const
{
  for (vtkIdType i = 0; i < n; ++i)
  {
    if (!usable(this->points_.values.triple(static_cast<std::size_t>(ids[i]))))
    {
      triangles.push_back(triangleOf(ids[i], ids[(i + 1) % n], ids[(i + 2) % n]));
      return true;
    }
  }
  return false;
}

void Triangulator::quad(const vtkIdType* ids, std::vector<Triangle>& triangles) const
{
  Vec3 p[4];
  for (int k = 0; k < 4; ++k)
  {
    p[k] = this->points_.values.triple(static_cast<std::size_t>(ids[k]));
  }
  const Vec3 d02 = p[2] - p[0];
  const Vec3 d13 = p[3] - p[1];
  const Vec3 normal = cross(d02, d13);
  const double inside02 = inside(p[0], p[1], p[2], p[3], normal);
  const double inside13 = inside(p[1], p[2], p[3], p[0], normal);
  const bool shorter02 = dot(d02, d02) <= dot(d13, d13);
  const bool cut02 =
    shorter02 ? inside02 > 0.0 || inside02 >= inside13 : !(inside13 > 0.0) && inside02 > inside13;
  if (cut02)
  {
    triangles.push_back(triangleOf(ids[0], ids[1], ids[2]));
    triangles.push_back(triangleOf(ids[0], ids[2], ids[3]));
  }
  else
  {
    triangles.push_back(triangleOf(ids[0], ids[1], ids[3]));
    triangles.push_back(triangleOf(ids[1], ids[2], ids[3]));
  }
}

bool Triangulator::cutEars(vtkIdType n, const vtkIdType* ids)
{
  // Relative to the first point: far from the origin the areas that the ear cutter compares would
  // otherwise be noise.
  const Vec3 first = this->points_.values.triple(static_cast<std::size_t>(ids[0]));
  this->polygon_->Points->SetDataTypeToDouble();
  this->polygon_->Points->SetNumberOfPoints(n);
  this->polygon_->PointIds->SetNumberOfIds(n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    const Vec3 p = this->points_.values.triple(static_cast<std::size_t>(ids[i])) - first;
    this->polygon_->Points->SetPoint(i, p.data());
    this->polygon_->PointIds->SetId(i, i);
  }
  this->polygon_->Points->Modified(); // else the bounds of the last polygon are taken
  return this->polygon_->EarCutTriangulation(this->ears_.Get()) != 0 &&
    this->ears_->GetNumberOfIds() == 3 * (n - 2);
}

void Triangulator::polygon(vtkIdType n, const vtkIdType* ids, std::vector<Triangle>& triangles)
{
  if (n == 3)
  {
    triangles.push_back(triangleOf(ids[0], ids[1], ids[2]));
  }
  else if (this->notFinite(n, ids, triangles))
  {
    return;
  }
  else if (n == 4)
  {
    this->quad(ids, triangles);
  }
  else if (this->cutEars(n, ids))
  {
    for (vtkIdType i = 0; i < 3 * (n - 2); i += 3)
    {
      triangles.push_back(triangleOf(ids[this->ears_->GetId(i)], ids[this->ears_->GetId(i + 1)],
        ids[this->ears_->GetId(i + 2)]));
    }
  }
  else
  {
    for (vtkIdType i = 2; i < n; ++i)
    {
      triangles.push_back(triangleOf(ids[0], ids[i - 1], ids[i]));
    }
  }
}

void Triangulator::strip(vtkIdType n, const vtkIdType* ids, std::vector<Triangle>& triangles) const
{
  if (this->notFinite(n, ids, triangles))
  {
    return;
  }
  for (vtkIdType i = 2; i < n; ++i)
  {
    const bool reversed = i % 2 != 0;
    triangles.push_back(
      triangleOf(ids[i - 2], ids[reversed ? i : i - 1], ids[reversed ? i - 1 : i]));
  }
}

} // namespace lumitree::filters
