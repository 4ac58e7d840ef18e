// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/SphereSource.h"

#include "Radiometry/CapLight.h"
#include "Radiometry/Checks.h"
#include "Radiometry/Constants.h"
#include "Radiometry/Integration/ConeSample.h"

namespace lumitree
{

namespace
{

/// The sphere as a position sees it.
struct Sight
{
  Vec3 towards = { 0.0, 0.0, 1.0 };
  double distance;
  double sine; ///< of its angular radius; 0 where it is not seen, from within

  Sight(const Vec3& position, const Vec3& centre, double radius)
  {
    const Vec3 way = centre - position;
    this->distance = std::hypot(way[0], way[1], way[2]);
    this->sine = this->distance >= radius ? radius / this->distance : 0.0;
    if (this->distance > 0.0)
    {
      this->towards = (1.0 / this->distance) * way;
    }
  }

  /// sin(α/2) from 1 − cosα = sin²α / (1 + cosα)
  [[nodiscard]] double sineOfHalf() const
  {
    const double cosine = std::sqrt((1.0 - this->sine) * (1.0 + this->sine));
    return this->sine / std::sqrt(2.0 * (1.0 + cosine));
  }
};

} // namespace

SphereSource::SphereSource(double radiance, const Vec3& centre, double radius, double metresPerUnit)
  : radiance_(checks::notNegative(radiance, "The radiance of a sphere"))
  , centre_(checks::coordinates(centre, "The centre of a sphere"))
  , radius_(checks::positive(radius, "The radius of a sphere"))
  , metresPerUnit_(checks::positive(metresPerUnit, "The number of metres per unit of length"))
{
}

std::optional<double> SphereSource::flux() const
{
  const double metres = this->radius_ * this->metresPerUnit_;
  return 4.0 * pi * pi * this->radiance_ * metres * metres;
}

std::optional<double> SphereSource::intensity(const Vec3&) const
{
  const double metres = this->radius_ * this->metresPerUnit_;
  return pi * this->radiance_ * metres * metres;
}

double SphereSource::irradiance(const Vec3& position, const Vec3& normal) const
{
  const Sight sight(position, this->centre_, this->radius_);
  return this->radiance_ * capIrradiance(sight.sine, dot(normal, sight.towards));
}

double SphereSource::scalarIrradiance(const Vec3& position) const
{
  return this->radiance_ *
    coneSolidAngle(Sight(position, this->centre_, this->radius_).sineOfHalf());
}

Sightline SphereSource::sightline(const Vec3& position) const
{
  return { this->centre_ - position, false };
}

Vec3 SphereSource::lightVector(const Vec3& position) const
{
  const Sight sight(position, this->centre_, this->radius_);
  return (pi * this->radiance_ * sight.sine * sight.sine) * sight.towards;
}

SourceSample SphereSource::sample(const Vec3& position, double u, double v) const
{
  const Sight sight(position, this->centre_, this->radius_);
  if (sight.sine == 0.0)
  {
    return {};
  }
  const double half = sight.sineOfHalf();
  const Vec3 direction = sampleCone(sight.towards, half, u, v);
  // To the nearer crossing of the sphere, or to where the ray is nearest to it.
  const double along = sight.distance * dot(direction, sight.towards);
  const Vec3 across = sight.distance * cross(direction, sight.towards);
  const double inside = this->radius_ * this->radius_ - dot(across, across);
  const double t = along - std::sqrt(std::fmax(0.0, inside));
  return { { t * direction, false }, this->radiance_, t > 0.0 ? coneSolidAngle(half) : 0.0 };
}

std::optional<double> SphereSource::radiance(const Vec3& position, const Vec3& direction) const
{
  return this->sumOfCrossings(position, direction);
}

void SphereSource::crossings(
  const Vec3& position, const Vec3& direction, std::vector<SourceCrossing>& to) const
{
  const Vec3 unit = checks::unit(direction, "A direction to a sphere");
  const Vec3 way = this->centre_ - position;
  const double along = dot(unit, way);
  const Vec3 beside = way - along * unit;
  const double depth = this->radius_ * this->radius_ - dot(beside, beside);
  // Product of the two roots, without cancellation; below 0 within the sphere.
  const double outside = (length(way) - this->radius_) * (length(way) + this->radius_);
  if (along > 0.0 && depth > 0.0 && outside >= 0.0 && this->radiance_ > 0.0)
  {
    to.push_back({ outside / (along + std::sqrt(depth)) / length(direction), this->radiance_ });
  }
}

std::optional<Box> SphereSource::bounds() const
{
  const Vec3 reach = { this->radius_, this->radius_, this->radius_ };
  Box box;
  box.extend(this->centre_ - reach);
  box.extend(this->centre_ + reach);
  return box;
}

} // namespace lumitree
