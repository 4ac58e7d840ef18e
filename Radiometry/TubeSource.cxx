// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/TubeSource.h"

#include "Radiometry/Checks.h"
#include "Radiometry/Constants.h"
#include "Radiometry/Integration/GaussLegendre.h"
#include "Radiometry/Integration/LineLight.h"
#include "Radiometry/Integration/Outline.h"

#include <algorithm>

namespace lumitree
{

/// The tube from a position outside of it: x of the frame points from the axis to the position.
struct TubeSource::Sight
{
  Frame frame;
  Vec3 toBegin;     ///< from the position to the beginning of the axis
  double offset;    ///< of the position from the axis
  double halfAngle; ///< of the part of the circumference that is turned to the position; 0: none is
  double distance;  ///< from the middle of the tube

  Sight(const TubeSource& tube, const Vec3& position)
    : frame(tube.frame_)
    , toBegin(tube.begin_ - position)
  {
    const Vec3 local = tube.frame_.toLocal(-1.0 * this->toBegin);
    this->offset = std::hypot(local[0], local[1]);
    this->halfAngle = this->offset > tube.radius_ ? std::acos(tube.radius_ / this->offset) : 0.0;
    this->distance = std::hypot(this->offset, local[2] - 0.5 * tube.length_);
    if (this->offset > 0.0)
    {
      this->frame.x = (1.0 / this->offset) * (local[0] * tube.frame_.x + local[1] * tube.frame_.y);
      this->frame.y = cross(this->frame.z, this->frame.x);
    }
  }

  [[nodiscard]] Vec3 outward(double phi) const
  {
    return std::cos(phi) * this->frame.x + std::sin(phi) * this->frame.y;
  }
};

namespace
{

// From how many sizes the outline of the tube loses digits that an integral over its area keeps;
// and from how many it has none left, so that the horizon's cut is left to that integral, too.
constexpr double areaFrom = 300.0;
constexpr double onlyAreaFrom = 1e6;

} // namespace

TubeSource::TubeSource(
  double radiance, const Vec3& begin, const Vec3& end, double radius, double metresPerUnit)
  : radiance_(checks::notNegative(radiance, "The radiance of a tube"))
  , begin_(checks::coordinates(begin, "The beginning of a tube"))
  , frame_(Frame::around(checks::unit(
      checks::coordinates(end, "The end of a tube") - begin, "The way between the ends of a tube")))
  , length_(std::hypot(end[0] - begin[0], end[1] - begin[1], end[2] - begin[2]))
  , radius_(checks::positive(radius, "The radius of a tube"))
  , metresPerUnit_(checks::positive(metresPerUnit, "The number of metres per unit of length"))
{
}

std::optional<double> TubeSource::flux() const
{
  return 2.0 * pi * pi * this->radiance_ * (this->radius_ * this->metresPerUnit_) *
    (this->length_ * this->metresPerUnit_);
}

std::optional<double> TubeSource::intensity(const Vec3& direction) const
{
  const Vec3 unit = checks::unit(direction, "The direction of an intensity");
  return 2.0 * this->radiance_ * (this->radius_ * this->metresPerUnit_) *
    (this->length_ * this->metresPerUnit_) * lumitree::length(cross(unit, this->frame_.z));
}

double TubeSource::integral(const Sight& sight, const Vec3& normal, bool cut) const
{
  const double size = std::max(this->radius_, this->length_);
  const Vec3 end = this->length_ * this->frame_.z;
  if (sight.distance > onlyAreaFrom * size || (!cut && sight.distance > areaFrom * size))
  {
    return this->radius_ *
      integrate<16>(-sight.halfAngle, sight.halfAngle,
        [&](double phi)
        {
          const Vec3 outward = sight.outward(phi);
          const Vec3 foot = sight.toBegin + this->radius_ * outward;
          return integrate<8>(0.0, this->length_,
            [&](double z)
            {
              const Vec3 way = foot + z * this->frame_.z;
              const double d = std::hypot(way[0], way[1], way[2]);
              const double shown = std::max(0.0, -dot(outward, way) / d);
              const double received = dot(normal, way) / d;
              return shown * (cut ? std::max(0.0, received) : received) / d / d;
            });
        });
  }
  const Vec3 u = this->radius_ * sight.frame.x;
  const Vec3 v = this->radius_ * sight.frame.y;
  const Vec3 left = sight.toBegin + this->radius_ * sight.outward(-sight.halfAngle);
  const Vec3 right = sight.toBegin + this->radius_ * sight.outward(sight.halfAngle);
  Outline outline(normal, cut ? Outline::Horizon::Cuts : Outline::Horizon::Ignored);
  outline.arc(sight.toBegin, u, v, -sight.halfAngle, sight.halfAngle);
  outline.segment(right, right + end);
  outline.arc(sight.toBegin + end, u, v, sight.halfAngle, -sight.halfAngle);
  outline.segment(left + end, left);
  return -outline.integral(); // it turns left as seen from the outside
}

double TubeSource::irradiance(const Vec3& position, const Vec3& normal) const
{
  const Sight sight(*this, position);
  if (sight.halfAngle == 0.0)
  {
    return 0.0;
  }
  // The lowest and the highest point over the receiver's horizon.
  const double begin = dot(normal, sight.toBegin);
  const double end = begin + this->length_ * dot(normal, this->frame_.z);
  const double reach =
    this->radius_ * std::hypot(dot(normal, this->frame_.x), dot(normal, this->frame_.y));
  if (std::max(begin, end) + reach <= 0.0)
  {
    return 0.0;
  }
  const bool cut = std::min(begin, end) - reach < 0.0;
  return this->radiance_ * std::max(0.0, this->integral(sight, normal, cut));
}

Vec3 TubeSource::lightVector(const Vec3& position) const
{
  const Sight sight(*this, position);
  if (sight.halfAngle == 0.0)
  {
    return { 0.0, 0.0, 0.0 };
  }
  // By symmetry there is nothing along y.
  return this->radiance_ *
    (this->integral(sight, sight.frame.x, false) * sight.frame.x +
      this->integral(sight, sight.frame.z, false) * sight.frame.z);
}

double TubeSource::scalarIrradiance(const Vec3& position) const
{
  const Sight sight(*this, position);
  if (sight.halfAngle == 0.0)
  {
    return 0.0;
  }
  const double half = integrateAdaptively<12>(0.0, sight.halfAngle, 1e-13,
    [&](double phi)
    {
      const Vec3 outward = sight.outward(phi);
      const Vec3 from = sight.toBegin + this->radius_ * outward;
      const LineLight line(from, from + this->length_ * this->frame_.z);
      return line.touches() ? 0.0 : std::max(0.0, -dot(outward, line.isotropicVector()));
    });
  return this->radiance_ * 2.0 * this->radius_ * half;
}

Sightline TubeSource::sightline(const Vec3& position) const
{
  return { (this->begin_ - position) + (0.5 * this->length_) * this->frame_.z, false };
}

SourceSample TubeSource::sample(const Vec3& position, double u, double v) const
{
  const Sight sight(*this, position);
  if (sight.halfAngle == 0.0)
  {
    return {};
  }
  const Vec3 outward = sight.outward((2.0 * u - 1.0) * sight.halfAngle);
  const Vec3 way = sight.toBegin + this->radius_ * outward + (v * this->length_) * this->frame_.z;
  const double d = std::hypot(way[0], way[1], way[2]);
  const double shown = std::max(0.0, -dot(outward, way) / d);
  return { { way, false }, this->radiance_,
    shown * (2.0 * sight.halfAngle * this->radius_ / d) * (this->length_ / d) };
}

std::optional<double> TubeSource::radiance(const Vec3& position, const Vec3& direction) const
{
  return this->sumOfCrossings(position, direction);
}

void TubeSource::crossings(
  const Vec3& position, const Vec3& direction, std::vector<SourceCrossing>& to) const
{
  // The nearer crossing of the infinite cylinder, in the tube's own frame.
  const Vec3 o = this->frame_.toLocal(position - this->begin_);
  const Vec3 d = this->frame_.toLocal(checks::unit(direction, "A direction to a tube"));
  const double a = d[0] * d[0] + d[1] * d[1];
  const double b = o[0] * d[0] + o[1] * d[1];
  const double c = o[0] * o[0] + o[1] * o[1] - this->radius_ * this->radius_;
  const double inside = b * b - a * c;
  if (c <= 0.0 || b >= 0.0 || inside <= 0.0)
  {
    return;
  }
  const double t = c / (-b + std::sqrt(inside));
  const double z = o[2] + t * d[2];
  if (z >= 0.0 && z <= this->length_ && this->radiance_ > 0.0)
  {
    to.push_back({ t / lumitree::length(direction), this->radiance_ });
  }
}

std::optional<Box> TubeSource::bounds() const
{
  Box box;
  for (const Vec3& end : { this->begin_, this->begin_ + this->length_ * this->frame_.z })
  {
    for (int k = 0; k < 3; ++k)
    {
      const double reach =
        this->radius_ * std::hypot(this->frame_.x[k], this->frame_.y[k]) * (1.0 + 0x1p-50);
      box.lower[k] = std::min(box.lower[k], end[k] - reach);
      box.upper[k] = std::max(box.upper[k], end[k] + reach);
    }
  }
  return box;
}

} // namespace lumitree
