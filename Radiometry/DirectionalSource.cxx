// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/DirectionalSource.h"

#include "Radiometry/Checks.h"

namespace lumitree
{

DirectionalSource::DirectionalSource(double normalIrradiance, const Vec3& direction)
  : normalIrradiance_(
      checks::notNegative(normalIrradiance, "The normal irradiance of a directional source"))
  , towards_(-1.0 * checks::unit(direction, "The direction of a directional source"))
{
}

double DirectionalSource::irradiance(const Vec3&, const Vec3& normal) const
{
  const double cosine = dot(normal, this->towards_);
  return cosine <= 0.0 ? 0.0 : this->normalIrradiance_ * cosine;
}

double DirectionalSource::scalarIrradiance(const Vec3&) const
{
  return this->normalIrradiance_;
}

Sightline DirectionalSource::sightline(const Vec3&) const
{
  return { this->towards_, true };
}

Vec3 DirectionalSource::lightVector(const Vec3&) const
{
  return this->normalIrradiance_ * this->towards_;
}

} // namespace lumitree
