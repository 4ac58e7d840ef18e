// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/DiskSource.h"

#include "Radiometry/Checks.h"
#include "Radiometry/Constants.h"
#include "Radiometry/Integration/Elliptic.h"
#include "Radiometry/Integration/GaussLegendre.h"
#include "Radiometry/Integration/Outline.h"

#include <algorithm>
#include <cmath>

namespace lumitree
{

namespace
{

/// Solid angle of a disk of radius R at height h > 0 over its plane and distance r from its axis.
double diskAngle(double radius, double height, double offset)
{
  const double distance = std::hypot(height, offset);
  if (distance > 20.0 * radius)
  {
    // Seven rings of the disk; the closed form would be a difference of like numbers.
    return integrate<7>(0.0, radius,
      [&](double r)
      {
        constexpr int spokes = 12;
        double sum = 0.0;
        for (int i = 0; i < spokes; ++i)
        {
          const double phi = 2.0 * pi * i / spokes;
          const double d = std::hypot(height, offset - r * std::cos(phi), r * std::sin(phi));
          sum += height / (d * d * d);
        }
        return 2.0 * pi / spokes * r * sum;
      });
  }
  const double outer = offset + radius;
  const double slant = std::hypot(height, outer);
  const double gap = (radius - offset) / outer;
  const double nearest = std::hypot(height, radius - offset) / slant;
  const double first = carlsonF(0.0, nearest * nearest, 1.0);
  if (gap == 0.0)
  {
    return pi - 2.0 * height / slant * first;
  }
  const double parameter = 4.0 * offset * radius / (outer * outer);
  const double third = first + parameter / 3.0 * carlsonJ(0.0, nearest * nearest, 1.0, gap * gap);
  const double inside = gap > 0.0 ? 2.0 * pi : 0.0;
  return std::clamp(inside - 2.0 * height / slant * (first + gap * third), 0.0, 2.0 * pi);
}

/// From how many radii the outline of a cut disk loses digits that an integral over its area keeps.
constexpr double areaFrom = 100.0;

} // namespace

DiskSource::DiskSource(double radiance, const Vec3& centre, const Vec3& normal, double radius,
  bool twoSided, double metresPerUnit)
  : radiance_(checks::notNegative(radiance, "The radiance of a disk"))
  , centre_(checks::coordinates(centre, "The centre of a disk"))
  , frame_(Frame::around(checks::unit(normal, "The normal of a disk")))
  , radius_(checks::positive(radius, "The radius of a disk"))
  , twoSided_(twoSided)
  , metresPerUnit_(checks::positive(metresPerUnit, "The number of metres per unit of length"))
{
}

double DiskSource::heightOver(const Vec3& position) const
{
  const double height = dot(this->frame_.z, position - this->centre_);
  return this->twoSided_ ? std::fabs(height) : std::max(0.0, height);
}

std::optional<double> DiskSource::flux() const
{
  const double metres = pi * this->radius_ * this->metresPerUnit_;
  return (this->twoSided_ ? 2.0 : 1.0) * metres * metres * this->radiance_;
}

std::optional<double> DiskSource::intensity(const Vec3& direction) const
{
  const double cosine =
    dot(this->frame_.z, checks::unit(direction, "The direction of an intensity"));
  const double metres = this->radius_ * this->metresPerUnit_;
  return pi * metres * metres * this->radiance_ *
    (this->twoSided_ ? std::fabs(cosine) : std::max(0.0, cosine));
}

Vec3 DiskSource::lightVector(const Vec3& position) const
{
  const double height = this->heightOver(position);
  if (height == 0.0)
  {
    return { 0.0, 0.0, 0.0 };
  }
  const Vec3 from = position - this->centre_;
  const double side = dot(this->frame_.z, from) > 0.0 ? 1.0 : -1.0;
  const Vec3 local = this->frame_.toLocal(from);
  const double offset = std::hypot(local[0], local[1]);
  const double r = this->radius_;
  // The product of the smallest and the largest distance from its edge.
  const double edges = std::hypot(height, offset - r) * std::hypot(height, offset + r);
  const double axialLack = height * height + (offset - r) * (offset + r);
  const double axial = axialLack > 0.0
    ? 2.0 * (r * height / edges) * (r * height / (edges + axialLack))
    : 0.5 * (edges - axialLack) / edges;
  const double all = height * height + offset * offset + r * r;
  const double radial = 2.0 * (height * r / edges) * (offset * r / (edges + all));
  Vec3 inwards = { 0.0, 0.0, 0.0 };
  if (offset > 0.0)
  {
    inwards = (-1.0 / offset) * (local[0] * this->frame_.x + local[1] * this->frame_.y);
  }
  return (pi * this->radiance_) * ((-side * axial) * this->frame_.z + radial * inwards);
}

double DiskSource::irradiance(const Vec3& position, const Vec3& normal) const
{
  const double height = this->heightOver(position);
  if (height == 0.0)
  {
    return 0.0;
  }
  const Vec3 towards = this->centre_ - position;
  const double middle = dot(normal, towards);
  const double reach =
    this->radius_ * std::hypot(dot(normal, this->frame_.x), dot(normal, this->frame_.y));
  if (middle >= reach)
  {
    return std::max(0.0, dot(normal, this->lightVector(position)));
  }
  return middle <= -reach ? 0.0 : this->radiance_ * this->cutIrradiance(towards, normal);
}

double DiskSource::cutIrradiance(const Vec3& towardsCentre, const Vec3& normal) const
{
  const double distance = std::hypot(towardsCentre[0], towardsCentre[1], towardsCentre[2]);
  if (distance < areaFrom * this->radius_)
  {
    Outline outline(normal, Outline::Horizon::Cuts);
    outline.arc(
      towardsCentre, this->radius_ * this->frame_.x, this->radius_ * this->frame_.y, 0.0, 2.0 * pi);
    return std::fabs(outline.integral());
  }
  // Strips of the disk along the horizon: x = R cosψ above it.
  const double across = dot(normal, this->frame_.x);
  const double along = dot(normal, this->frame_.y);
  const double size = std::hypot(across, along);
  const Vec3 x = (1.0 / size) * (across * this->frame_.x + along * this->frame_.y);
  const Vec3 y = cross(this->frame_.z, x);
  const double lowest = std::clamp(-dot(normal, towardsCentre) / (size * this->radius_), -1.0, 1.0);
  return integrate<12>(0.0, std::acos(lowest),
    [&](double psi)
    {
      const double half = this->radius_ * std::sin(psi);
      return half *
        integrate<8>(-half, half,
          [&](double t)
          {
            const Vec3 way = towardsCentre + (this->radius_ * std::cos(psi)) * x + t * y;
            const double d = std::hypot(way[0], way[1], way[2]);
            return std::max(0.0, dot(normal, way) / d) * std::fabs(dot(this->frame_.z, way) / d) /
              d / d;
          });
    });
}

double DiskSource::scalarIrradiance(const Vec3& position) const
{
  const double height = this->heightOver(position);
  const Vec3 local = this->frame_.toLocal(position - this->centre_);
  return height > 0.0
    ? this->radiance_ * diskAngle(this->radius_, height, std::hypot(local[0], local[1]))
    : 0.0;
}

Sightline DiskSource::sightline(const Vec3& position) const
{
  return { this->centre_ - position, false };
}

SourceSample DiskSource::sample(const Vec3& position, double u, double v) const
{
  const double height = this->heightOver(position);
  if (height == 0.0)
  {
    return {};
  }
  // Concentric map (Shirley & Chiu, Journal of Graphics Tools 2, 1997).
  const double a = 2.0 * u - 1.0;
  const double b = 2.0 * v - 1.0;
  const bool wide = std::fabs(a) > std::fabs(b);
  const double r = this->radius_ * (wide ? a : b);
  const double phi = wide ? 0.25 * pi * (b / a) : (b == 0.0 ? 0.0 : 0.5 * pi - 0.25 * pi * (a / b));
  const Vec3 way = (this->centre_ - position) + (r * std::cos(phi)) * this->frame_.x +
    (r * std::sin(phi)) * this->frame_.y;
  const double d = std::hypot(way[0], way[1], way[2]);
  return { { way, false }, this->radiance_,
    pi * (this->radius_ / d) * (this->radius_ / d) * (height / d) };
}

std::optional<double> DiskSource::radiance(const Vec3& position, const Vec3& direction) const
{
  return this->sumOfCrossings(position, direction);
}

void DiskSource::crossings(
  const Vec3& position, const Vec3& direction, std::vector<SourceCrossing>& to) const
{
  const double height = dot(this->frame_.z, position - this->centre_);
  const double towards = dot(this->frame_.z, direction);
  if (this->heightOver(position) == 0.0 || height * towards >= 0.0)
  {
    return;
  }
  const double t = -height / towards;
  const Vec3 local = this->frame_.toLocal(position - this->centre_ + t * direction);
  if (std::hypot(local[0], local[1]) <= this->radius_ && this->radiance_ > 0.0)
  {
    to.push_back({ t, this->radiance_ });
  }
}

std::optional<Box> DiskSource::bounds() const
{
  Box box;
  for (int k = 0; k < 3; ++k)
  {
    const double reach =
      this->radius_ * std::hypot(this->frame_.x[k], this->frame_.y[k]) * (1.0 + 0x1p-50);
    box.lower[k] = this->centre_[k] - reach;
    box.upper[k] = this->centre_[k] + reach;
  }
  return box;
}

} // namespace lumitree
