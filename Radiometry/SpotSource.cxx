// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/SpotSource.h"

#include "Radiometry/Checks.h"
#include "Radiometry/Constants.h"

#include <algorithm>

namespace lumitree
{

namespace
{

/// 1 − cos, also of small angles.
double versine(double angle)
{
  const double sine = std::sin(0.5 * angle);
  return 2.0 * sine * sine;
}

/// Flux of a spot of intensity 1.
double unitFlux(double coneAngle, double cutoffAngle)
{
  return pi * (versine(coneAngle) + versine(cutoffAngle));
}

} // namespace

SpotSource::SpotSource(double axialIntensity, double coneAngle, double cutoffAngle,
  const Vec3& position, const Vec3& axis, double metresPerUnit)
  : PointLikeSource(position, metresPerUnit)
  , axialIntensity_(checks::notNegative(axialIntensity, "The axial intensity of a spot"))
  , coneAngle_(coneAngle)
  , cutoffAngle_(cutoffAngle)
  , axis_(checks::unit(axis, "The axis of a spot"))
{
  if (!(coneAngle >= 0.0 && coneAngle <= cutoffAngle && cutoffAngle > 0.0 && cutoffAngle <= pi))
  {
    throw std::invalid_argument(
      "The angles of a spot must be 0 <= cone <= cutoff <= 180 degrees, and the cutoff not 0.");
  }
}

double SpotSource::axialIntensityOf(double flux, double coneAngle, double cutoffAngle)
{
  return flux / unitFlux(coneAngle, cutoffAngle);
}

std::optional<double> SpotSource::flux() const
{
  return this->axialIntensity_ * unitFlux(this->coneAngle_, this->cutoffAngle_);
}

double SpotSource::intensityAlong(const Vec3& direction) const
{
  // Angles by atan2: their cosines lose narrow cones.
  const double angle =
    std::atan2(length(cross(direction, this->axis_)), dot(direction, this->axis_));
  if (angle <= this->coneAngle_)
  {
    return this->axialIntensity_;
  }
  if (angle >= this->cutoffAngle_)
  {
    return 0.0;
  }
  const double cutoff = versine(this->cutoffAngle_);
  const double x =
    std::clamp((cutoff - versine(angle)) / (cutoff - versine(this->coneAngle_)), 0.0, 1.0);
  return this->axialIntensity_ * x * x * (3.0 - 2.0 * x);
}

} // namespace lumitree
