// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/IsotropicPointSource.h"

#include "Radiometry/Checks.h"
#include "Radiometry/Constants.h"

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
};

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

} // namespace

IsotropicPointSource::IsotropicPointSource(double flux, const Vec3& position, double metresPerUnit)
  : flux_(checks::notNegative(flux, "The flux of a point source"))
  , intensity_(flux / (4.0 * pi))
  , position_(checks::coordinates(position, "The position of a point source"))
  , metresPerUnit_(checks::positive(metresPerUnit, "The number of metres per unit of length"))
{
}

std::optional<double> IsotropicPointSource::intensity(const Vec3&) const
{
  return this->intensity_;
}

double IsotropicPointSource::irradiance(const Vec3& position, const Vec3& normal) const
{
  const Separation s(position, this->position_);
  if (s.scale == 0.0)
  {
    return undefined;
  }
  const double cosine = dot(normal, s.way) / std::sqrt(s.squared);
  const double metres = s.scale * this->metresPerUnit_;
  return cosine > 0.0 ? this->intensity_ * cosine / s.squared / metres / metres
                      : (cosine <= 0.0 ? 0.0 : undefined);
}

double IsotropicPointSource::scalarIrradiance(const Vec3& position) const
{
  const Separation s(position, this->position_);
  const double metres = s.scale * this->metresPerUnit_;
  return s.scale == 0.0 ? undefined : this->intensity_ / s.squared / metres / metres;
}

Sightline IsotropicPointSource::sightline(const Vec3& position) const
{
  return { this->position_ - position, false };
}

} // namespace lumitree
