// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/PolygonSource.h"

#include "Radiometry/Checks.h"
#include "Radiometry/Constants.h"
#include "Radiometry/LambertPolygon.h"
#include "Radiometry/Looking/PolygonsAlongRay.h"
#include "Radiometry/PolygonTriangles.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace lumitree
{

namespace
{

/// Corners as a position sees them, until the next call on the same thread.
const std::vector<Vec3>& seenFrom(const Vec3& position, const std::vector<Vec3>& corners)
{
  thread_local std::vector<Vec3> ways;
  ways.clear();
  for (const Vec3& corner : corners)
  {
    ways.push_back(corner - position);
  }
  return ways;
}

} // namespace

/// Made when it is first asked for.
struct PolygonSource::Finder
{
  std::once_flag once;
  std::optional<PolygonsAlongRay> polygons;
};

PolygonSource::PolygonSource(std::vector<EmittingPolygon> polygons, double metresPerUnit)
  : polygons_(std::move(polygons))
  , middle_({ 0.0, 0.0, 0.0 })
  , metresPerUnit_(checks::positive(metresPerUnit, "The number of metres per unit of length"))
  , finder_(std::make_shared<Finder>())
{
  double powers = 0.0;
  double areas = 0.0;
  for (std::size_t p = 0; p < this->polygons_.size(); ++p)
  {
    EmittingPolygon& polygon = this->polygons_[p];
    checks::notNegative(polygon.radiance, "The radiance of a polygon");
    if (polygon.corners.size() < 3)
    {
      throw std::invalid_argument("A polygon that shines must have at least 3 corners.");
    }
    for (const Vec3& corner : polygon.corners)
    {
      this->bounds_.extend(checks::coordinates(corner, "A corner of a polygon that shines"));
    }
    const Vec3 areaVector = polygonAreaVector(polygon.corners);
    const double area = length(areaVector);
    if (!(area > 0.0) || !std::isfinite(area))
    {
      continue;
    }
    polygon.normal = (1.0 / area) * areaVector;
    for (const std::array<std::size_t, 3>& t : triangulatePolygon(polygon.corners))
    {
      Triangle triangle{ p, { polygon.corners[t[0]], polygon.corners[t[1]], polygon.corners[t[2]] },
        0.0 };
      triangle.area = 0.5 *
        length(cross(
          triangle.corners[1] - triangle.corners[0], triangle.corners[2] - triangle.corners[0]));
      powers += triangle.area * polygon.radiance;
      areas += triangle.area;
      this->triangles_.push_back(triangle);
      this->powerSums_.push_back(powers);
      for (const Vec3& corner : triangle.corners)
      {
        this->middle_ = this->middle_ + (triangle.area / 3.0) * corner;
      }
    }
    const double sides = polygon.twoSided ? 2.0 : 1.0;
    this->flux_ += sides * pi * polygon.radiance * area * metresPerUnit * metresPerUnit;
  }
  if (areas > 0.0)
  {
    this->middle_ = (1.0 / areas) * this->middle_;
  }
}

double PolygonSource::side(const EmittingPolygon& polygon, const Vec3& position)
{
  const double height = dot(polygon.normal, position - polygon.corners[0]);
  return height > 0.0 ? 1.0 : (polygon.twoSided && height < 0.0 ? -1.0 : 0.0);
}

std::optional<double> PolygonSource::intensity(const Vec3& direction) const
{
  const Vec3 unit = checks::unit(direction, "The direction of an intensity");
  double sum = 0.0;
  for (const EmittingPolygon& polygon : this->polygons_)
  {
    const double shown = dot(polygonAreaVector(polygon.corners), unit);
    sum += polygon.radiance * (polygon.twoSided ? std::fabs(shown) : std::max(0.0, shown));
  }
  return sum * this->metresPerUnit_ * this->metresPerUnit_;
}

double PolygonSource::irradiance(const Vec3& position, const Vec3& normal) const
{
  double sum = 0.0;
  for (const EmittingPolygon& polygon : this->polygons_)
  {
    if (PolygonSource::side(polygon, position) != 0.0 && polygon.radiance > 0.0)
    {
      const std::vector<Vec3>& ways = seenFrom(position, polygon.corners);
      sum += polygon.radiance * polygonIrradiance(ways.data(), ways.size(), normal);
    }
  }
  return sum;
}

double PolygonSource::scalarIrradiance(const Vec3& position) const
{
  double sum = 0.0;
  for (const EmittingPolygon& polygon : this->polygons_)
  {
    if (PolygonSource::side(polygon, position) != 0.0 && polygon.radiance > 0.0)
    {
      const std::vector<Vec3>& ways = seenFrom(position, polygon.corners);
      sum += polygon.radiance * polygonSolidAngle(ways.data(), ways.size());
    }
  }
  return sum;
}

Vec3 PolygonSource::lightVector(const Vec3& position) const
{
  Vec3 sum = { 0.0, 0.0, 0.0 };
  for (const EmittingPolygon& polygon : this->polygons_)
  {
    if (PolygonSource::side(polygon, position) != 0.0)
    {
      const std::vector<Vec3>& ways = seenFrom(position, polygon.corners);
      sum = sum + polygon.radiance * polygonLightVector(ways.data(), ways.size());
    }
  }
  return sum;
}

Sightline PolygonSource::sightline(const Vec3& position) const
{
  return { this->middle_ - position, false };
}

std::optional<double> PolygonSource::radiance(const Vec3& position, const Vec3& direction) const
{
  return this->sumOfCrossings(position, direction);
}

void PolygonSource::crossing(const EmittingPolygon& polygon, const Vec3& position,
  const Vec3& direction, std::vector<SourceCrossing>& to)
{
  const double way = PolygonSource::side(polygon, position);
  const double towards = dot(polygon.normal, direction);
  if (way * towards >= 0.0)
  {
    return;
  }
  const double t = dot(polygon.normal, polygon.corners[0] - position) / towards;
  const Vec3 point = position + t * direction;
  // Crossings of the outline by a line in the plane of the polygon, along its two larger axes.
  const Vec3 size = { std::fabs(polygon.normal[0]), std::fabs(polygon.normal[1]),
    std::fabs(polygon.normal[2]) };
  const int drop = size[0] > size[1] ? (size[0] > size[2] ? 0 : 2) : (size[1] > size[2] ? 1 : 2);
  const int x = (drop + 1) % 3;
  const int y = (drop + 2) % 3;
  bool inside = false;
  const std::size_t corners = polygon.corners.size();
  for (std::size_t i = 0; i < corners; ++i)
  {
    const Vec3& a = polygon.corners[i];
    const Vec3& b = polygon.corners[(i + 1) % corners];
    if ((a[y] > point[y]) != (b[y] > point[y]) &&
      point[x] < a[x] + (point[y] - a[y]) / (b[y] - a[y]) * (b[x] - a[x]))
    {
      inside = !inside;
    }
  }
  if (inside && polygon.radiance > 0.0)
  {
    to.push_back({ t, polygon.radiance });
  }
}

void PolygonSource::crossings(
  const Vec3& position, const Vec3& direction, std::vector<SourceCrossing>& to) const
{
  constexpr std::size_t fewPolygons = 32;
  if (this->polygons_.size() <= fewPolygons || this->triangles_.empty())
  {
    for (const EmittingPolygon& polygon : this->polygons_)
    {
      PolygonSource::crossing(polygon, position, direction, to);
    }
    return;
  }
  std::call_once(this->finder_->once,
    [&]
    {
      std::vector<PolygonsAlongRay::Triangle> triangles;
      for (const Triangle& triangle : this->triangles_)
      {
        triangles.push_back({ triangle.polygon, triangle.corners });
      }
      this->finder_->polygons.emplace(this->polygons_, triangles);
    });
  thread_local std::vector<std::size_t> candidates;
  this->finder_->polygons->find(position, direction, candidates);
  for (const std::size_t p : candidates)
  {
    PolygonSource::crossing(this->polygons_[p], position, direction, to);
  }
}

} // namespace lumitree
