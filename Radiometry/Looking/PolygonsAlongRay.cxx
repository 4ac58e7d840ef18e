// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Looking/PolygonsAlongRay.h"

#include "Radiometry/Frame.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace lumitree
{

PolygonsAlongRay::PolygonsAlongRay(
  const std::vector<EmittingPolygon>& polygons, const std::vector<Triangle>& triangles)
{
  std::vector<double> points;
  std::vector<lumitree::Triangle> corners;
  for (const Triangle& triangle : triangles)
  {
    const auto first = static_cast<std::uint32_t>(points.size() / 3);
    const EmittingPolygon& polygon = polygons[triangle.polygon];
    for (const Vec3& corner : triangle.corners)
    {
      points.insert(points.end(), corner.begin(), corner.end());
      this->unevenness_ =
        std::max(this->unevenness_, std::fabs(dot(polygon.normal, corner - polygon.corners[0])));
    }
    corners.push_back({ first, first + 1, first + 2 });
    this->polygonOf_.push_back(triangle.polygon);
  }
  BuildOptions options;
  options.structure = Structure::WideBvh;
  options.threads = 1; // others may wait for this one
  this->accelerator_ = build(
    std::make_shared<Surface>(PointArray::from(std::move(points)), std::move(corners)), options);
}

void PolygonsAlongRay::find(
  const Vec3& position, const Vec3& direction, std::vector<std::size_t>& polygons) const
{
  thread_local ConvexRegion region;
  thread_local std::vector<PrimitiveId> found;
  const double size = length(direction);
  const Frame frame = Frame::around((1.0 / size) * direction);
  const Box& bounds = this->accelerator_->surface().bounds();
  double reach = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    reach +=
      std::max(std::fabs(bounds.lower[k]), std::fabs(bounds.upper[k])) + std::fabs(position[k]);
  }
  // What lies in a plane of the dropped axis is farther from the triangle by up to √3.
  const double margin = 4.0 * this->unevenness_ + 0x1p-45 * reach;
  region.clear();
  for (const Vec3& across : { frame.x, frame.y })
  {
    const double at = dot(across, position);
    region.push_back({ across, at + margin });
    region.push_back({ -1.0 * across, -at + margin });
  }
  region.push_back({ -1.0 * frame.z, -dot(frame.z, position) + margin });
  this->accelerator_->overlap(region, found);
  polygons.clear();
  for (const PrimitiveId id : found)
  {
    polygons.push_back(this->polygonOf_[id]);
  }
  // Triangles of one polygon stand side by side.
  polygons.erase(std::unique(polygons.begin(), polygons.end()), polygons.end());
}

} // namespace lumitree
