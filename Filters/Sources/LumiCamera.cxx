// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiCamera.h"

#include "LumiDirections.h"

#include <algorithm>
#include <cmath>

namespace
{

using namespace lumitree;

double tangentOfHalf(double degrees)
{
  return std::tan(degrees * (3.14159265358979324 / 360.0));
}

/// Unit vector to the right of the view direction; zero when up is along it.
Vec3 rightOf(const Vec3& forward, const Vec3& viewUp)
{
  using lumitree::filters::unit;
  // Parallel vectors seldom give exactly zero, hence the threshold.
  const Vec3 right = cross(forward, unit(viewUp));
  return length(right) > 1e-12 ? unit(right) : Vec3{ 0.0, 0.0, 0.0 };
}

}

namespace lumitree::filters
{

std::string Camera::problem() const
{
  if (!isFinite(this->position) || !isFinite(this->focalPoint) || !isFinite(this->viewUp))
  {
    return "Position, FocalPoint and ViewUp must be finite.";
  }
  if (this->resolution[0] < 1 || this->resolution[1] < 1)
  {
    return "Resolution must be at least 1 x 1.";
  }
  const Vec3 forward = unit(this->focalPoint - this->position);
  if (isZero(forward))
  {
    return "Position and FocalPoint must differ.";
  }
  if (isZero(rightOf(forward, this->viewUp)))
  {
    return "ViewUp must not be zero, nor along the view direction.";
  }
  if (!this->parallel && !(this->viewAngle > 0.0 && this->viewAngle < 180.0))
  {
    return "ViewAngle must be above 0 and below 180 degrees.";
  }
  if (this->parallel && !(std::isfinite(this->parallelScale) && this->parallelScale > 0.0))
  {
    return "ParallelScale must be finite and above 0.";
  }
  return {};
}

void Camera::lookAt(const Box& box)
{
  const Vec3 centre = box.centre();
  // One point has no extent of its own: any distance shows it.
  const double half = 0.5 * length(box.size());
  const double radius = half > 0.0 ? half : 1.0;

  const Vec3 forward = unit(this->focalPoint - this->position);
  const double aspect = static_cast<double>(this->resolution[0]) / this->resolution[1];
  // The narrower way across the image decides; r / sin is where its two edges touch the sphere.
  const double tangent = tangentOfHalf(this->viewAngle) * std::min(1.0, aspect);
  const double distance = this->parallel ? 2.0 * radius : radius * std::hypot(1.0, 1.0 / tangent);
  this->focalPoint = centre;
  this->position = centre - distance * forward;
  this->parallelScale = radius / std::min(1.0, aspect);
}

CameraRays::CameraRays(const Camera& camera)
  : parallel_(camera.parallel)
  , position_(camera.position)
  , forward_(unit(camera.focalPoint - camera.position))
  , width_(camera.resolution[0])
  , height_(camera.resolution[1])
{
  const double height = camera.parallel ? camera.parallelScale : tangentOfHalf(camera.viewAngle);
  const double width = height * (static_cast<double>(camera.resolution[0]) / camera.resolution[1]);
  const Vec3 right = rightOf(this->forward_, camera.viewUp);
  this->right_ = width * right;
  this->up_ = height * cross(right, this->forward_);
}

RayLine CameraRays::operator()(int i, int j) const
{
  // The subtraction is exact, so the middle pixel of an odd resolution looks straight at
  // FocalPoint.
  const double x = (2.0 * i + 1.0 - this->width_) / this->width_;
  const double y = (2.0 * j + 1.0 - this->height_) / this->height_;
  const Vec3 inPlane = x * this->right_ + y * this->up_;
  if (this->parallel_)
  {
    return { this->position_ + inPlane, this->forward_ };
  }
  return { this->position_, unit(this->forward_ + inPlane) };
}

}
