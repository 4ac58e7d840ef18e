// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/SunDiskSource.h"

#include "Radiometry/CapLight.h"
#include "Radiometry/Checks.h"
#include "Radiometry/Constants.h"
#include "Radiometry/Integration/ConeSample.h"

namespace lumitree
{

SunDiskSource::SunDiskSource(double normalIrradiance, const Vec3& direction, double angularDiameter)
  : normalIrradiance_(checks::notNegative(normalIrradiance, "The normal irradiance of a sun"))
  , towards_(-1.0 * checks::unit(direction, "The direction of a sun"))
  , angularRadius_(0.5 * checks::positive(angularDiameter, "The angular diameter of a sun"))
{
  if (angularDiameter > pi)
  {
    throw std::invalid_argument("The angular diameter of a sun must not be above 180 degrees.");
  }
  const double sine = std::sin(this->angularRadius_);
  this->radiance_ = normalIrradiance / (pi * sine * sine);
}

double SunDiskSource::irradiance(const Vec3&, const Vec3& normal) const
{
  return this->radiance_ *
    capIrradiance(std::sin(this->angularRadius_), dot(normal, this->towards_));
}

double SunDiskSource::scalarIrradiance(const Vec3&) const
{
  return this->radiance_ * coneSolidAngle(std::sin(0.5 * this->angularRadius_));
}

Sightline SunDiskSource::sightline(const Vec3&) const
{
  return { this->towards_, true };
}

Vec3 SunDiskSource::lightVector(const Vec3&) const
{
  return this->normalIrradiance_ * this->towards_;
}

SourceSample SunDiskSource::sample(const Vec3&, double u, double v) const
{
  const double half = std::sin(0.5 * this->angularRadius_);
  return { { sampleCone(this->towards_, half, u, v), true }, this->radiance_,
    coneSolidAngle(half) };
}

std::optional<double> SunDiskSource::radiance(const Vec3&, const Vec3& direction) const
{
  const Vec3 unit = checks::unit(direction, "A direction to a sun");
  const double angle = std::atan2(length(cross(unit, this->towards_)), dot(unit, this->towards_));
  return angle <= this->angularRadius_ ? this->radiance_ : 0.0;
}

} // namespace lumitree
