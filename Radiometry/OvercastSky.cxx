// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/GeneralSky.h"

#include "Radiometry/Checks.h"
#include "Radiometry/Constants.h"

#include <algorithm>
#include <cmath>

namespace lumitree
{

double checkedLevel(const SkyLevel& level)
{
  return checks::notNegative(level.value,
    level.kind == SkyLevel::Kind::ZenithRadiance ? "The zenith radiance of a sky"
                                                 : "The horizontal irradiance of a sky");
}

double uniformRadiance(const SkyLevel& level)
{
  const double value = checkedLevel(level);
  return level.kind == SkyLevel::Kind::ZenithRadiance ? value : value / pi;
}

OvercastSky::OvercastSky(const SkyLevel& level, const Vec3& up, double groundRadiance)
  : SkySource(up, groundRadiance)
  , zenithRadiance_(level.kind == SkyLevel::Kind::ZenithRadiance
        ? checkedLevel(level)
        : checkedLevel(level) * 9.0 / (7.0 * pi))
{
}

double OvercastSky::skyRadiance(const Vec3& direction) const
{
  return this->zenithRadiance_ * (1.0 + 2.0 * std::clamp(dot(direction, this->up()), 0.0, 1.0)) /
    3.0;
}

double OvercastSky::skyIrradiance(const Vec3& normal) const
{
  const double cosine = dot(normal, this->up());
  const double sine = length(cross(normal, this->up()));
  const double tilt = std::atan2(sine, cosine);
  return this->zenithRadiance_ *
    std::max(0.0, pi * (1.0 + cosine) / 6.0 + 4.0 / 9.0 * (sine + (pi - tilt) * cosine));
}

double OvercastSky::skyScalarIrradiance() const
{
  return 4.0 * pi / 3.0 * this->zenithRadiance_;
}

Vec3 OvercastSky::skyVector() const
{
  return (7.0 * pi / 9.0 * this->zenithRadiance_) * this->up();
}

} // namespace lumitree
