// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/CosineLobeSource.h"

#include "Radiometry/Checks.h"
#include "Radiometry/Constants.h"

namespace lumitree
{

CosineLobeSource::CosineLobeSource(double axialIntensity, double exponent, const Vec3& position,
  const Vec3& axis, double metresPerUnit)
  : PointLikeSource(position, metresPerUnit)
  , axialIntensity_(checks::notNegative(axialIntensity, "The axial intensity of a lobe"))
  , exponent_(checks::notNegative(exponent, "The exponent of a lobe"))
  , axis_(checks::unit(axis, "The axis of a lobe"))
{
}

double CosineLobeSource::axialIntensityOf(double flux, double exponent)
{
  return flux * (exponent + 1.0) / (2.0 * pi);
}

double CosineLobeSource::fluxWithin(double angle) const
{
  // 1 − cosⁿ⁺¹, without cancellation near the axis.
  const double rest = -std::expm1((this->exponent_ + 1.0) * std::log(std::cos(angle)));
  return 2.0 * pi * this->axialIntensity_ / (this->exponent_ + 1.0) * rest;
}

std::optional<double> CosineLobeSource::flux() const
{
  return 2.0 * pi * this->axialIntensity_ / (this->exponent_ + 1.0);
}

double CosineLobeSource::intensityAlong(const Vec3& direction) const
{
  const double cosine = dot(direction, this->axis_);
  return cosine > 0.0 ? this->axialIntensity_ * std::pow(std::fmin(cosine, 1.0), this->exponent_)
                      : 0.0;
}

} // namespace lumitree
