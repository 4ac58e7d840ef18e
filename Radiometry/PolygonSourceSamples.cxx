// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/LambertPolygon.h"
#include "Radiometry/PolygonSource.h"
#include "Radiometry/SphericalTriangle.h"

#include <algorithm>
#include <cmath>

namespace lumitree
{

namespace
{

// Up to so many triangles each sample weighs them all.
constexpr std::size_t fewTriangles = 32;

} // namespace

double PolygonSource::shownSolidAngle(const Triangle& triangle, const Vec3& position) const
{
  if (PolygonSource::side(this->polygons_[triangle.polygon], position) == 0.0)
  {
    return 0.0;
  }
  const std::array<Vec3, 3> ways = { triangle.corners[0] - position, triangle.corners[1] - position,
    triangle.corners[2] - position };
  return polygonSolidAngle(ways.data(), ways.size());
}

SourceSample PolygonSource::sample(const Vec3& position, double u, double v) const
{
  const std::size_t size = this->triangles_.size();
  if (size == 0)
  {
    return {};
  }
  if (size > fewTriangles)
  {
    const double target = u * this->powerSums_.back();
    const auto found = std::min<std::size_t>(size - 1,
      static_cast<std::size_t>(
        std::upper_bound(this->powerSums_.begin(), this->powerSums_.end(), target) -
        this->powerSums_.begin()));
    const double before = found == 0 ? 0.0 : this->powerSums_[found - 1];
    const double own = this->powerSums_[found] - before;
    return own > 0.0 ? this->sampleIn(this->triangles_[found], own / this->powerSums_.back(), 0.0,
                         position, (target - before) / own, v)
                     : SourceSample{};
  }
  std::array<double, fewTriangles> angles;
  double all = 0.0;
  for (std::size_t i = 0; i < size; ++i)
  {
    angles[i] = this->shownSolidAngle(this->triangles_[i], position);
    all += angles[i] * this->polygons_[this->triangles_[i].polygon].radiance;
  }
  double rest = u * all;
  for (std::size_t i = 0; i < size && all > 0.0; ++i)
  {
    const double own = angles[i] * this->polygons_[this->triangles_[i].polygon].radiance;
    if (own > 0.0 && (rest < own || i + 1 == size))
    {
      return this->sampleIn(
        this->triangles_[i], own / all, angles[i], position, std::min(1.0, rest / own), v);
    }
    rest -= own;
  }
  return {};
}

SourceSample PolygonSource::sampleIn(const Triangle& triangle, double chance, double solidAngle,
  const Vec3& position, double u, double v) const
{
  // Outside of these the sphere's triangle has no digits left; pbrt-v4, section 6.5.4.
  constexpr double smallest = 3e-4;
  constexpr double largest = 6.22;
  const EmittingPolygon& polygon = this->polygons_[triangle.polygon];
  SourceSample result;
  result.radiance = polygon.radiance;
  const double height = dot(polygon.normal, triangle.corners[0] - position);
  if (solidAngle > smallest && solidAngle < largest)
  {
    const Vec3 direction = sampleSphericalTriangle(position, triangle.corners, u, v);
    const double t = height / dot(polygon.normal, direction);
    if (t > 0.0 && std::isfinite(t))
    {
      result.sightline.direction = t * direction;
      result.weight = solidAngle / chance;
      return result;
    }
  }
  const double root = std::sqrt(u);
  result.sightline.direction = (1.0 - root) * (triangle.corners[0] - position) +
    (root * (1.0 - v)) * (triangle.corners[1] - position) +
    (root * v) * (triangle.corners[2] - position);
  const double r = length(result.sightline.direction);
  const double shown = PolygonSource::side(polygon, position) == 0.0 ? 0.0 : std::fabs(height) / r;
  result.weight = shown > 0.0 ? shown * triangle.area / (r * r) / chance : 0.0;
  return result;
}

} // namespace lumitree
