// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Reference/Embree/EmbreeFrame.h"

#include <algorithm>
#include <cmath>

namespace lumitree
{
namespace
{

/// Room for rounding between the surface and the ball about it.
constexpr double margin = 1.01;

std::array<float, 3> toFloat(const Vec3& p)
{
  return { static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]) };
}

} // namespace

EmbreeFrame::EmbreeFrame(const Box& bounds)
{
  if (bounds.empty())
  {
    return;
  }
  this->centre_ = bounds.centre();
  Vec3 half = 0.5 * bounds.size();
  this->exponent_ = std::ilogb(std::max({ half[0], half[1], half[2] }));
  for (double& x : half)
  {
    x = std::ldexp(x, -this->exponent_);
  }
  this->radius_ = margin * length(half);
}

Vec3 EmbreeFrame::inside(const Vec3& p) const
{
  Vec3 moved = p - this->centre_;
  for (double& x : moved)
  {
    x = std::ldexp(x, -this->exponent_);
  }
  return moved;
}

std::array<float, 3> EmbreeFrame::point(const Vec3& p) const
{
  return toFloat(this->inside(p));
}

bool EmbreeFrame::cut(const Ray& ray, EmbreeSegment& segment) const
{
  if (this->radius_ < 0.0)
  {
    return false;
  }
  Vec3 direction = ray.direction;
  const int size = std::ilogb(
    std::max({ std::fabs(direction[0]), std::fabs(direction[1]), std::fabs(direction[2]) }));
  for (double& x : direction)
  {
    x = std::ldexp(x, -size);
  }
  const Vec3 origin = this->inside(ray.origin);
  segment.exponent = this->exponent_ - size;

  // Comparisons are written so that NaN, from numbers beyond doubles, is a miss.
  const double length2 = dot(direction, direction);
  const double middle = -dot(origin, direction) / length2;
  const Vec3 nearest = origin + middle * direction;
  const double left = this->radius_ * this->radius_ - dot(nearest, nearest);
  if (!(left >= 0.0))
  {
    return false;
  }
  const double half = std::sqrt(left / length2);
  segment.start = std::max(middle - half, std::ldexp(ray.tMin, -segment.exponent));
  const double end = std::min(middle + half, std::ldexp(ray.tMax, -segment.exponent));
  const Vec3 begin = origin + segment.start * direction;
  if (!(segment.start <= end) || !(dot(begin, begin) <= 4.0 * this->radius_ * this->radius_))
  {
    return false;
  }
  segment.origin = toFloat(begin);
  segment.direction = toFloat(direction);
  segment.tFar = std::nextafter(static_cast<float>(end - segment.start), HUGE_VALF);
  return true;
}

} // namespace lumitree
