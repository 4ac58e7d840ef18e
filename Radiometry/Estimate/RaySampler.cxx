// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Estimate/RaySampler.h"

#include "Radiometry/Constants.h"
#include "Radiometry/Estimate/Sobol.h"

#include <algorithm>
#include <cmath>

namespace lumitree
{

Amounts amountsOf(const View& view, const SourceSample& sample)
{
  Amounts result;
  const double light = sample.radiance * sample.weight;
  const double size = length(sample.sightline.direction);
  if (!(light > 0.0) || !(size > 0.0))
  {
    return result;
  }
  const Vec3 direction = (1.0 / size) * sample.sightline.direction;
  if (view.sided)
  {
    result.main = light * std::max(0.0, dot(view.normal, direction));
    return result;
  }
  result.main = light;
  if (view.vector)
  {
    result.vector = light * direction;
  }
  if (view.cylindrical)
  {
    const double cosine = dot(view.axis, direction);
    result.cylindrical = light * std::sqrt(std::max(0.0, 1.0 - cosine * cosine)) / pi;
  }
  return result;
}

void RaySampler::gather(const View& view, const Direction& direction, std::uint32_t begin,
  std::uint32_t end, const RaySamplerOptions& options)
{
  this->lights_.clear();
  this->owners_.clear();
  this->origins_.clear();
  this->directions_.clear();
  this->tMins_.clear();
  this->tMaxs_.clear();
  for (std::uint32_t r = 0; r < randomisations; ++r)
  {
    const Sobol sobol(Sobol::mix(view.seed) + 3 * std::uint64_t{ r });
    for (std::uint32_t i = begin; i < end; ++i)
    {
      const auto [u, v] = sobol(i);
      const SourceSample sample = direction(u, v);
      const Amounts light = amountsOf(view, sample);
      if (!(light.main > 0.0))
      {
        continue;
      }
      this->sums_[r].all += light.main;
      this->all_ += light.main;
      const Vec3& way = sample.sightline.direction;
      const double size = length(way);
      double tMax = std::numeric_limits<double>::infinity();
      if (!sample.sightline.endless)
      {
        tMax = 1.0 - options.shadowRays->clearance(view.eye + way) / size;
      }
      const double tMin = view.clearance / size;
      if (tMin > tMax)
      {
        continue; // too near to be hidden
      }
      this->lights_.push_back(light);
      this->owners_.push_back(r);
      this->origins_.insert(this->origins_.end(), view.eye.begin(), view.eye.end());
      this->directions_.insert(this->directions_.end(), way.begin(), way.end());
      this->tMins_.push_back(tMin);
      this->tMaxs_.push_back(tMax);
    }
  }
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
  const std::uint64_t offsets[2] = { 0, view.skipCount };
  if (view.skipCount > 0)
  {
    this->sets_.assign(batch.size, 0);
    batch.skip.setOfRay = this->sets_.data();
    batch.skip.offsets = offsets;
    batch.skip.primitives = view.skip;
  }
  QueryOptions query;
  query.precision = options.precision;
  query.threads = 1;
  this->hit_.resize(batch.size);
  options.occluders->any(batch, this->hit_.data(), query);
  this->rays_ += static_cast<std::uint32_t>(batch.size);
  for (std::size_t i = 0; i < batch.size; ++i)
  {
    if (this->hit_[i])
    {
      this->sums_[this->owners_[i]].hidden += this->lights_[i].main;
      this->hidden_.add(this->lights_[i]);
    }
  }
}

RaySample RaySampler::run(const View& view, const Amounts& full, double known,
  const Direction& direction, const RaySamplerOptions& options)
{
  // Student's 97.5 % point for 7 degrees of freedom.
  constexpr double student = 2.3646;
  this->sums_.assign(randomisations, {});
  this->hidden_ = {};
  this->all_ = 0.0;
  this->rays_ = 0;
  const double shade = 0.05 * (known + full.main);
  RaySample result;
  std::uint32_t begin = 0;
  std::uint32_t end = 8;
  while (true)
  {
    this->gather(view, direction, begin, end, options);
    const double share = this->all_ > 0.0 ? this->hidden_.main / this->all_ : 0.0;
    double variance = 0.0;
    std::uint32_t counted = 0;
    for (const Sums& sums : this->sums_)
    {
      if (sums.all > 0.0)
      {
        const double off = sums.hidden / sums.all - share;
        variance += off * off;
        ++counted;
      }
    }
    variance /= std::max(1u, counted - 1) * static_cast<double>(std::max(1u, counted));
    // Randomisations that agree say nothing about what is smaller than the gaps between all rays.
    const double gap = 1.0 / (static_cast<double>(end) * randomisations);
    const double half = full.main * std::sqrt(student * student * variance + gap * gap);
    result.value.main = full.main * (1.0 - share);
    result.halfWidth = half;
    const double tolerance = std::max(options.absoluteTolerance,
      options.relativeTolerance * std::max(known + result.value.main, shade));
    if (half <= tolerance)
    {
      break;
    }
    if (std::uint64_t{ end } * 2 * randomisations > options.maximumRays)
    {
      result.missed = true;
      break;
    }
    begin = end;
    end *= 2;
  }
  const double scale = this->all_ > 0.0 ? full.main / this->all_ : 0.0;
  result.value.vector = full.vector - scale * this->hidden_.vector;
  result.value.cylindrical = std::max(0.0, full.cylindrical - scale * this->hidden_.cylindrical);
  result.rays = this->rays_;
  return result;
}

} // namespace lumitree
