// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Estimate/SightlineBatch.h"

#include "Radiometry/Constants.h"

#include <algorithm>
#include <cmath>

namespace lumitree
{

void SightlineBatch::clear()
{
  this->owners_.clear();
  this->origins_.clear();
  this->directions_.clear();
  this->tMins_.clear();
  this->tMaxs_.clear();
  this->skipOffsets_.assign(1, 0);
  this->skipPrimitives_.clear();
}

void SightlineBatch::add(
  const Source& source, const View& view, const EstimateScene& scene, Estimate& estimate)
{
  Amounts& value = estimate.value;
  if (view.sided)
  {
    value.main = source.irradiance(view.position, view.normal);
  }
  else
  {
    value.main = source.scalarIrradiance(view.position);
    if (view.vector)
    {
      value.vector = source.lightVector(view.position);
    }
    if (view.cylindrical)
    {
      const Vec3 way = source.sightline(view.position).direction;
      const double size = std::hypot(way[0], way[1], way[2]);
      const double cosine = dot(view.axis, way) / size;
      value.cylindrical =
        value.main * std::sqrt(std::max(0.0, (1.0 - cosine) * (1.0 + cosine))) / pi;
    }
  }
  estimate.unoccluded = value.main;
  estimate.lower = value.main;
  estimate.upper = value.main;
  if (!(value.main > 0.0))
  {
    return;
  }
  estimate.method = EstimateMethod::Sightline;
  if (!scene.shadowRays)
  {
    return;
  }
  const Ray ray = (*scene.shadowRays)(source, view.position, view.sided ? &view.normal : nullptr);
  if (!isValid(ray))
  {
    return;
  }
  this->owners_.push_back(&estimate);
  this->origins_.insert(this->origins_.end(), ray.origin.begin(), ray.origin.end());
  this->directions_.insert(this->directions_.end(), ray.direction.begin(), ray.direction.end());
  this->tMins_.push_back(ray.tMin);
  this->tMaxs_.push_back(ray.tMax);
  this->skipPrimitives_.insert(this->skipPrimitives_.end(), view.skip, view.skip + view.skipCount);
  this->skipOffsets_.push_back(this->skipPrimitives_.size());
}

void SightlineBatch::cast(const EstimateScene& scene, bool skips)
{
  RayBatch batch;
  batch.size = this->owners_.size();
  if (batch.size == 0)
  {
    return;
  }
  batch.origins = this->origins_.data();
  batch.directions = this->directions_.data();
  batch.tMins = this->tMins_.data();
  batch.tMaxs = this->tMaxs_.data();
  if (skips)
  {
    batch.skip.offsets = this->skipOffsets_.data();
    batch.skip.primitives = this->skipPrimitives_.data();
  }
  QueryOptions query;
  query.precision = scene.options.precision;
  query.threads = 1; // the chunks themselves run side by side
  this->hit_.resize(batch.size);
  scene.occluders->any(batch, this->hit_.data(), query);
  for (std::size_t r = 0; r < batch.size; ++r)
  {
    Estimate& estimate = *this->owners_[r];
    estimate.rays = 1;
    if (this->hit_[r])
    {
      estimate.value = {};
      estimate.lower = 0.0;
      estimate.upper = 0.0;
    }
  }
}

} // namespace lumitree
