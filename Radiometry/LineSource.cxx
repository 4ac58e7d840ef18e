// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/LineSource.h"

#include "Radiometry/Checks.h"
#include "Radiometry/Constants.h"
#include "Radiometry/Integration/LineLight.h"

#include <algorithm>
#include <limits>

namespace lumitree
{

namespace
{

double sizeOf(const Vec3& v)
{
  return std::hypot(v[0], v[1], v[2]);
}

/// θ / sinθ − 1, 0 ≤ θ < π
double beyondItsSine(double angle)
{
  const double squared = angle * angle;
  return angle < 0.02 ? squared / 6.0 * (1.0 + squared * 7.0 / 60.0)
                      : angle / std::sin(angle) - 1.0;
}

} // namespace

LineSource::LineSource(double intensityPerMetre, const Vec3& begin, const Vec3& end,
  Distribution distribution, double metresPerUnit)
  : intensityPerMetre_(checks::notNegative(intensityPerMetre, "The intensity per metre of a line"))
  , begin_(checks::coordinates(begin, "The beginning of a line"))
  , end_(checks::coordinates(end, "The end of a line"))
  , axis_(checks::unit(end - begin, "The way between the ends of a line"))
  , length_(sizeOf(end - begin))
  , distribution_(distribution)
  , metresPerUnit_(checks::positive(metresPerUnit, "The number of metres per unit of length"))
{
}

std::optional<double> LineSource::flux() const
{
  return (this->distribution_ == Distribution::Lambertian ? pi * pi : 4.0 * pi) *
    this->intensityPerMetre_ * this->length_ * this->metresPerUnit_;
}

std::optional<double> LineSource::intensity(const Vec3& direction) const
{
  const Vec3 unit = checks::unit(direction, "The direction of an intensity");
  const double share =
    this->distribution_ == Distribution::Lambertian ? length(cross(unit, this->axis_)) : 1.0;
  return this->intensityPerMetre_ * this->length_ * this->metresPerUnit_ * share;
}

Vec3 LineSource::vectorOf(const Vec3& toBegin, const Vec3& toEnd) const
{
  const LineLight line(toBegin, toEnd);
  if (this->distribution_ == Distribution::Isotropic)
  {
    return line.isotropicVector();
  }
  // e the unit vector to the nearest point of the whole line, m to the middle of the angle seen:
  // V = l / (2 r₁ r₂) (e (Δβ / sinΔβ − 1) + 2 (e·m) m). All terms of it point to the line.
  const Vec3 foot = toBegin - dot(toBegin, this->axis_) * this->axis_;
  const double height = sizeOf(foot);
  if (height == 0.0)
  {
    return { 0.0, 0.0, 0.0 };
  }
  const Vec3 nearest = (1.0 / height) * foot;
  return (0.5 * line.scale()) *
    (beyondItsSine(line.angle()) * nearest + (2.0 * dot(nearest, line.middle())) * line.middle());
}

double LineSource::irradiance(const Vec3& position, const Vec3& normal) const
{
  Vec3 from = this->begin_ - position;
  Vec3 to = this->end_ - position;
  const double a = dot(normal, from);
  const double b = dot(normal, to);
  if (LineLight(from, to).touches())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (a <= 0.0 && b <= 0.0)
  {
    return 0.0;
  }
  const Vec3 way = to - from;
  if (a < 0.0)
  {
    from = from + (a / (a - b)) * way;
  }
  else if (b < 0.0)
  {
    to = from + (a / (a - b)) * way;
  }
  return this->intensityPerMetre_ / this->metresPerUnit_ *
    std::max(0.0, dot(normal, this->vectorOf(from, to)));
}

double LineSource::scalarIrradiance(const Vec3& position) const
{
  const Vec3 from = this->begin_ - position;
  const Vec3 to = this->end_ - position;
  const LineLight line(from, to);
  if (line.touches())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double perMetre = this->intensityPerMetre_ / this->metresPerUnit_;
  if (this->distribution_ == Distribution::Isotropic)
  {
    return perMetre * line.scale() * (1.0 + beyondItsSine(line.angle())); // Δβ / h
  }
  const Vec3 foot = from - dot(from, this->axis_) * this->axis_;
  const double height = sizeOf(foot);
  // (sinβ₂ − sinβ₁) / h = l / (r₁ r₂) × cos of the middle angle / cos of half the angle seen
  return height > 0.0
    ? perMetre * line.scale() * (dot(foot, line.middle()) / height) / line.cosineOfHalf()
    : 0.0;
}

Sightline LineSource::sightline(const Vec3& position) const
{
  return { 0.5 * ((this->begin_ - position) + (this->end_ - position)), false };
}

Vec3 LineSource::lightVector(const Vec3& position) const
{
  const Vec3 from = this->begin_ - position;
  const Vec3 to = this->end_ - position;
  if (LineLight(from, to).touches())
  {
    constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
    return { undefined, undefined, undefined };
  }
  return (this->intensityPerMetre_ / this->metresPerUnit_) * this->vectorOf(from, to);
}

SourceSample LineSource::sample(const Vec3& position, double u, double) const
{
  const Vec3 way = (1.0 - u) * (this->begin_ - position) + u * (this->end_ - position);
  const double r = sizeOf(way);
  if (r == 0.0)
  {
    return {};
  }
  const double share = this->distribution_ == Distribution::Lambertian
    ? length(cross((1.0 / r) * way, this->axis_))
    : 1.0;
  return { { way, false }, this->intensityPerMetre_,
    share * (this->length_ / r) / (r * this->metresPerUnit_) };
}

std::optional<Box> LineSource::bounds() const
{
  Box box;
  box.extend(this->begin_);
  box.extend(this->end_);
  return box;
}

} // namespace lumitree
