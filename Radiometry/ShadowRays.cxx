// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/ShadowRays.h"

#include <algorithm>

namespace lumitree
{

ShadowRays::ShadowRays(const Accelerator& occluders, ArrayView::Scalar stored)
  : bounds_(occluders.surface().bounds())
  , coordinateError_(stored == ArrayView::Scalar::Float ? 0x1p-22 : 0x1p-51)
  , arithmeticError_(occluders.options().structure == Structure::Embree ? 0x1p-19 : 0x1p-40)
{
}

double ShadowRays::clearance(const Vec3& position, const Vec3* normal) const
{
  constexpr Vec3 allAxes = { 1.0, 1.0, 1.0 };
  const Vec3& weights = normal ? *normal : allAxes;
  double stored = 0.0;
  double reach = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    stored += std::fabs(weights[k] * position[k]);
    reach = std::max({ reach, std::fabs(position[k] - this->bounds_.lower[k]),
      std::fabs(position[k] - this->bounds_.upper[k]) });
  }
  return this->coordinateError_ * stored + this->arithmeticError_ * reach;
}

Ray ShadowRays::operator()(const Source& source, const Vec3& position, const Vec3* normal) const
{
  const double start = this->clearance(position, normal);
  Ray ray;
  ray.origin = normal ? position + start * *normal : position;

  const Sightline way = source.sightline(ray.origin);
  ray.direction = way.direction;
  const double size = std::hypot(way.direction[0], way.direction[1], way.direction[2]);
  ray.tMin = start / size;
  if (!way.endless)
  {
    ray.tMax = 1.0 - this->clearance(ray.origin + way.direction) / size;
  }
  return ray;
}

} // namespace lumitree
