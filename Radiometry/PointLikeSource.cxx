// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/PointLikeSource.h"

#include "Radiometry/Checks.h"

#include <algorithm>
#include <limits>

namespace lumitree
{

namespace
{

/// A difference of positions, scaled to components of at most 1: no square of it over- or
/// underflows.
struct Separation
{
  Vec3 way;       ///< towards the source, divided by scale
  double scale;   ///< 0 where the positions are the same
  double squared; ///< |way|²: 1 … 3

  Separation(const Vec3& from, const Vec3& to)
    : way(to - from)
    , scale(std::max({ std::fabs(way[0]), std::fabs(way[1]), std::fabs(way[2]) }))
  {
    for (double& component : this->way)
    {
      component /= this->scale;
    }
    this->squared = dot(this->way, this->way);
  }

  [[nodiscard]] Vec3 away() const { return (-1.0 / std::sqrt(this->squared)) * this->way; }
};

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

} // namespace

PointLikeSource::PointLikeSource(const Vec3& position, double metresPerUnit)
  : position_(checks::coordinates(position, "The position of a point source"))
  , metresPerUnit_(checks::positive(metresPerUnit, "The number of metres per unit of length"))
{
}

std::optional<double> PointLikeSource::intensity(const Vec3& direction) const
{
  return this->intensityAlong(checks::unit(direction, "The direction of an intensity"));
}

double PointLikeSource::irradiance(const Vec3& position, const Vec3& normal) const
{
  const Separation s(position, this->position_);
  if (s.scale == 0.0)
  {
    return undefined;
  }
  const double cosine = dot(normal, s.way) / std::sqrt(s.squared);
  if (!(cosine > 0.0))
  {
    return cosine <= 0.0 ? 0.0 : undefined;
  }
  const double metres = s.scale * this->metresPerUnit_;
  return this->intensityAlong(s.away()) * cosine / s.squared / metres / metres;
}

double PointLikeSource::scalarIrradiance(const Vec3& position) const
{
  const Separation s(position, this->position_);
  const double metres = s.scale * this->metresPerUnit_;
  return s.scale == 0.0 ? undefined : this->intensityAlong(s.away()) / s.squared / metres / metres;
}

Sightline PointLikeSource::sightline(const Vec3& position) const
{
  return { this->position_ - position, false };
}

Vec3 PointLikeSource::lightVector(const Vec3& position) const
{
  const Separation s(position, this->position_);
  return -this->scalarIrradiance(position) * s.away();
}

} // namespace lumitree
