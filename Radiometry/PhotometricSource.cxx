// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/PhotometricSource.h"

#include "Radiometry/Checks.h"
#include "Radiometry/Constants.h"

#include <algorithm>

namespace lumitree
{

namespace
{

const PhotometricWeb& checkedWeb(const std::shared_ptr<const PhotometricWeb>& web)
{
  if (!web)
  {
    throw std::invalid_argument("A photometric source needs a web.");
  }
  web->check();
  return *web;
}

} // namespace

PhotometricSource::PhotometricSource(std::shared_ptr<const PhotometricWeb> web,
  const Vec3& position, const Vec3& axis, const Vec3& reference, double scale, double metresPerUnit)
  : PointLikeSource(position, metresPerUnit)
  , web_(std::move(web))
  , scale_(checks::notNegative(scale, "The scale of a photometric source"))
  , flux_(scale * checkedWeb(this->web_).flux())
{
  this->frame_.z = -1.0 * checks::unit(axis, "The axis of a photometric source");
  const Vec3 given = checks::unit(reference, "The reference direction of a photometric source");
  const Vec3 across = given - dot(given, this->frame_.z) * this->frame_.z;
  if (length(across) < 1e-6)
  {
    throw std::invalid_argument(
      "The axis and the reference direction of a photometric source must not be parallel.");
  }
  this->frame_.x = checks::unit(across, "The reference direction of a photometric source");
  this->frame_.y = cross(this->frame_.z, this->frame_.x);
}

double PhotometricSource::intensityAlong(const Vec3& direction) const
{
  constexpr double degrees = 180.0 / pi;
  const Vec3 local = this->frame_.toLocal(direction);
  if (this->web_->type == PhotometricWeb::Type::C)
  {
    const double gamma = std::atan2(std::hypot(local[0], local[1]), -local[2]) * degrees;
    return this->scale_ * this->web_->intensity(std::atan2(local[1], local[0]) * degrees, gamma);
  }
  const double horizontal = std::atan2(local[0], std::hypot(local[1], local[2])) * degrees;
  const double vertical = std::atan2(local[1], -local[2]) * degrees;
  return this->scale_ * this->web_->intensity(horizontal, vertical);
}

} // namespace lumitree
