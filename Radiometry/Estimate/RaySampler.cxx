// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Estimate/RaySampler.h"

#include "Radiometry/Constants.h"
#include "Radiometry/Estimate/Sobol.h"

#include <algorithm>
#include <cmath>

namespace lumitree
{

namespace
{

/// Enough for a call of the structure to cost nothing, few enough to stay in the cache.
constexpr std::size_t batchSize = 4096;

/// From so many rays on to one light they are cast one light after the other, for the structure to
/// take neighbours together. Fewer are too far from each other, and lights take turns.
constexpr std::size_t neighbours = 1024;

} // namespace

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

void RaySampler::add(SampledLight light)
{
  this->lights_.push_back({ std::move(light), {}, {}, 0 });
}

void RaySampler::draw(std::size_t first, std::size_t last)
{
  std::size_t most = 0;
  for (std::size_t at = first; at < last; ++at)
  {
    most += this->open_[at]->share.end() - this->open_[at]->share.begin();
  }
  if (this->samples_.size() < most)
  {
    this->points_.resize(most);
    this->samples_.resize(most);
    this->slots_.resize(most);
    this->owners_.resize(most);
    this->origins_.resize(3 * most);
    this->directions_.resize(3 * most);
    this->tMins_.resize(most);
    this->tMaxs_.resize(most);
    this->hit_.resize(most);
  }
  this->firstSample_.assign(1, 0);
  std::size_t count = 0;
  for (std::size_t at = first; at < last; ++at)
  {
    Progress& progress = *this->open_[at];
    VisibleShare& share = progress.share;
    const Sobol sobol(Sobol::mix(progress.light.view.seed));
    for (std::uint32_t i = share.begin(); i < share.end(); ++i)
    {
      this->points_[count] = sobol(i);
      count += share.takeOver(this->points_[count], this->slots_[count]) ? 0 : 1;
    }
    const std::size_t from = this->firstSample_.back();
    progress.light.samples->draw(
      this->points_.data() + from, count - from, this->samples_.data() + from);
    this->firstSample_.push_back(count);
  }
}

void RaySampler::addRay(std::size_t at, std::size_t sample, const RaySamplerOptions& options)
{
  Progress& progress = *this->batch_[at];
  const View& view = progress.light.view;
  const SourceSample& drawn = this->samples_[sample];
  const Vec3& way = drawn.sightline.direction;
  const double size = length(way);
  const double cosine = view.sided ? dot(view.normal, way) / size : 1.0;
  const double light = drawn.radiance * drawn.weight * cosine / progress.light.full.main;
  if (!(light > 0.0) || !(size > 0.0))
  {
    return;
  }
  progress.share.addLight(this->slots_[sample], light);
  const double tMin = view.clearance / size;
  const double tMax = drawn.sightline.endless
    ? std::numeric_limits<double>::infinity()
    : 1.0 - options.shadowRays->clearance(view.eye + way) / size;
  if (tMin > tMax)
  {
    return; // too near to be hidden
  }
  ++progress.rays;
  const std::size_t ray = this->size_++;
  this->owners_[ray] = { static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(sample),
    light };
  for (std::size_t k = 0; k < 3; ++k)
  {
    this->origins_[3 * ray + k] = view.eye[k];
    this->directions_[3 * ray + k] = way[k];
  }
  this->tMins_[ray] = tMin;
  this->tMaxs_[ray] = tMax;
}

void RaySampler::cast(std::size_t first, std::size_t last, const RaySamplerOptions& options)
{
  this->draw(first, last);
  this->size_ = 0;
  this->batch_ = this->open_.data() + first;
  const std::size_t lights = last - first;
  std::size_t most = 0;
  bool skips = false;
  for (std::size_t at = 0; at < lights; ++at)
  {
    most = std::max(most, this->firstSample_[at + 1] - this->firstSample_[at]);
    skips = skips || this->batch_[at]->light.view.skipCount > 0;
  }
  const std::size_t turn = most < neighbours ? 1 : most;
  for (std::size_t begin = 0; begin < most; begin += turn)
  {
    for (std::size_t at = 0; at < lights; ++at)
    {
      const std::size_t sample = this->firstSample_[at] + begin;
      const std::size_t end = std::min(sample + turn, this->firstSample_[at + 1]);
      for (std::size_t k = sample; k < end; ++k)
      {
        this->addRay(at, k, options);
      }
    }
  }

  RayBatch batch;
  batch.size = this->size_;
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
    this->skipOffsets_.assign(1, 0);
    this->skipPrimitives_.clear();
    for (std::size_t at = 0; at < lights; ++at)
    {
      const View& view = this->batch_[at]->light.view;
      this->skipPrimitives_.insert(
        this->skipPrimitives_.end(), view.skip, view.skip + view.skipCount);
      this->skipOffsets_.push_back(this->skipPrimitives_.size());
    }
    this->sets_.clear();
    for (std::size_t ray = 0; ray < batch.size; ++ray)
    {
      this->sets_.push_back(this->owners_[ray].at);
    }
    batch.skip.setOfRay = this->sets_.data();
    batch.skip.offsets = this->skipOffsets_.data();
    batch.skip.primitives = this->skipPrimitives_.data();
  }
  QueryOptions query;
  query.precision = options.precision;
  query.threads = 1; // receivers go side by side
  options.occluders->any(batch, this->hit_.data(), query);
  for (std::size_t ray = 0; ray < batch.size; ++ray)
  {
    if (this->hit_[ray])
    {
      const RayOwner& owner = this->owners_[ray];
      Progress& progress = *this->batch_[owner.at];
      progress.share.hide(this->slots_[owner.sample], owner.light);
      if (progress.light.view.vector || progress.light.view.cylindrical)
      {
        progress.hidden.add(amountsOf(progress.light.view, this->samples_[owner.sample]));
      }
    }
  }
}

bool RaySampler::finish(Progress& progress, const RaySamplerOptions& options)
{
  const SampledLight& light = progress.light;
  const double value = light.full.main * (1.0 - progress.share.hiddenShare());
  const double half = light.full.main * progress.share.halfWidth();
  const double shade = 0.05 * (light.known + light.full.main);
  const double tolerance =
    std::max(light.tolerance, options.relativeTolerance * std::max(light.known + value, shade));
  const bool missed =
    half > tolerance && std::uint64_t{ progress.share.cast() } * 2 > options.maximumRays;
  if (half > tolerance && !missed)
  {
    const bool more = light.view.vector || light.view.cylindrical;
    progress.share.goOn(more ? 0.0 : tolerance / light.full.main);
    return false;
  }
  const double all = progress.share.all();
  const double scale = all > 0.0 ? 1.0 / all : 0.0;
  Estimate found;
  found.value.main = value;
  found.value.vector = light.full.vector - scale * progress.hidden.vector;
  found.value.cylindrical =
    std::max(0.0, light.full.cylindrical - scale * progress.hidden.cylindrical);
  found.lower = std::max(0.0, value - half);
  found.upper = std::min(light.full.main, value + half);
  found.method = EstimateMethod::Sampling;
  found.rays = progress.rays;
  found.missed = missed;
  light.to->add(found);
  return true;
}

void RaySampler::run(const RaySamplerOptions& options)
{
  this->open_.clear();
  for (Progress& progress : this->lights_)
  {
    const SampledLight& light = progress.light;
    const double widest =
      std::max(light.tolerance, options.relativeTolerance * (light.known + light.full.main));
    progress.share.startWith(widest / light.full.main, options.maximumRays);
    this->open_.push_back(&progress);
  }
  while (!this->open_.empty())
  {
    for (std::size_t first = 0; first < this->open_.size();)
    {
      std::size_t last = first;
      std::size_t samples = 0;
      while (last < this->open_.size() && samples < batchSize)
      {
        samples += this->open_[last]->share.end() - this->open_[last]->share.begin();
        ++last;
      }
      this->cast(first, last, options);
      first = last;
    }
    this->open_.erase(std::remove_if(this->open_.begin(), this->open_.end(),
                        [&](Progress* progress) { return finish(*progress, options); }),
      this->open_.end());
  }
  this->lights_.clear();
}

} // namespace lumitree
