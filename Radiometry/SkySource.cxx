// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/SkySource.h"

#include "Radiometry/Checks.h"
#include "Radiometry/Constants.h"
#include "Radiometry/Frame.h"

#include <algorithm>

namespace lumitree
{

SkySource::SkySource(const Vec3& up, double groundRadiance)
  : up_(checks::unit(up, "The direction to the zenith"))
  , groundRadiance_(checks::notNegative(groundRadiance, "The radiance of the ground"))
{
}

double SkySource::radianceFrom(const Vec3& direction) const
{
  return dot(direction, this->up_) >= 0.0 ? this->skyRadiance(direction) : this->groundRadiance_;
}

double SkySource::irradiance(const Vec3&, const Vec3& normal) const
{
  const double cosine = std::clamp(dot(normal, this->up_), -1.0, 1.0);
  return this->skyIrradiance(normal) + 0.5 * pi * this->groundRadiance_ * (1.0 - cosine);
}

double SkySource::scalarIrradiance(const Vec3&) const
{
  return this->skyScalarIrradiance() + 2.0 * pi * this->groundRadiance_;
}

Vec3 SkySource::lightVector(const Vec3&) const
{
  return this->skyVector() - (pi * this->groundRadiance_) * this->up_;
}

Sightline SkySource::sightline(const Vec3&) const
{
  return { this->up_, true };
}

SourceSample SkySource::sample(const Vec3&, double u, double v) const
{
  const bool sphere = this->groundRadiance_ > 0.0;
  const double z = sphere ? 1.0 - 2.0 * u : 1.0 - u;
  const double r = std::sqrt(std::max(0.0, (1.0 - z) * (1.0 + z)));
  const double azimuth = 2.0 * pi * v;
  SourceSample result;
  result.sightline.direction =
    Frame::around(this->up_).toWorld({ r * std::cos(azimuth), r * std::sin(azimuth), z });
  result.sightline.endless = true;
  result.radiance =
    z >= 0.0 ? this->skyRadiance(result.sightline.direction) : this->groundRadiance_;
  result.weight = (sphere ? 4.0 : 2.0) * pi;
  return result;
}

std::optional<double> SkySource::radiance(const Vec3&, const Vec3& direction) const
{
  return this->radianceFrom(checks::unit(direction, "A direction to the sky"));
}

UniformSky::UniformSky(double radiance, const Vec3& up, double groundRadiance)
  : SkySource(up, groundRadiance)
  , radiance_(checks::notNegative(radiance, "The radiance of a sky"))
{
}

double UniformSky::skyRadiance(const Vec3&) const
{
  return this->radiance_;
}

double UniformSky::skyIrradiance(const Vec3& normal) const
{
  return 0.5 * pi * this->radiance_ * (1.0 + std::clamp(dot(normal, this->up()), -1.0, 1.0));
}

double UniformSky::skyScalarIrradiance() const
{
  return 2.0 * pi * this->radiance_;
}

Vec3 UniformSky::skyVector() const
{
  return (pi * this->radiance_) * this->up();
}

} // namespace lumitree
