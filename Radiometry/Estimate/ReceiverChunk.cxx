// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Estimate/ReceiverChunk.h"

#include "Radiometry/Estimate/EstimateWriter.h"
#include "Radiometry/Estimate/Sobol.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lumitree
{

namespace
{

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Lights to which rays are cast together.
constexpr std::size_t mostQueued = 32;

} // namespace

ReceiverChunk::ReceiverChunk(
  EstimateJob& job, EstimateWorkspace& workspace, std::size_t begin, std::size_t end)
  : job_(job)
  , workspace_(workspace)
  , begin_(begin)
  , size_(end - begin)
  , valid_(end - begin, 1)
  , rays_(end - begin, 0)
  , missed_(end - begin, 0)
{
  for (std::size_t k = 0; k < this->size_; ++k)
  {
    const Vec3 p = job.receivers.positions.triple(begin + k);
    bool good = true;
    for (const double x : p)
    {
      good = good && std::fabs(x) <= coordinateLimit;
    }
    if (!good || (job.sided() && !isFinite(job.receivers.normals.triple(begin + k))))
    {
      this->valid_[k] = 0;
      ++job.invalid;
    }
  }
}

void ReceiverChunk::run()
{
  const EstimateOutputs& out = this->job_.outputs;
  const EstimateWriter writer(this->job_.receivers, out, this->begin_, this->valid_);
  if (this->job_.sided())
  {
    const std::vector<Estimate>& front = this->compute(ReceiverPart::Front, true);
    writer.amounts(out.irradiance, front);
    writer.main(front);
    if (out.back)
    {
      writer.amounts(out.back, this->compute(ReceiverPart::Back, false));
    }
  }
  if (this->job_.wantsFree())
  {
    const std::vector<Estimate>& free = this->compute(ReceiverPart::Free, !this->job_.sided());
    writer.amounts(out.scalar, free);
    writer.free(free);
    if (!this->job_.sided())
    {
      writer.main(free);
    }
  }
  for (std::size_t k = 0; k < this->size_; ++k)
  {
    if (out.rays)
    {
      out.rays[this->begin_ + k] = this->rays_[k];
    }
    this->job_.rays += this->rays_[k];
    this->job_.missed += this->missed_[k];
  }
}

View ReceiverChunk::view(std::size_t k, ReceiverPart part, std::size_t source) const
{
  const Receivers& receivers = this->job_.receivers;
  const std::size_t i = this->begin_ + k;
  View view;
  view.position = receivers.positions.triple(i);
  view.eye = view.position;
  view.sided = part != ReceiverPart::Free;
  view.axis = this->job_.options.axis;
  if (view.sided)
  {
    view.normal = (part == ReceiverPart::Back ? -1.0 : 1.0) * receivers.normals.triple(i);
  }
  else
  {
    view.vector = this->job_.outputs.vector || this->job_.outputs.hemispherical;
    view.cylindrical = this->job_.outputs.cylindrical != nullptr;
  }
  if (this->job_.scene.shadowRays)
  {
    view.clearance =
      this->job_.scene.shadowRays->clearance(view.eye, view.sided ? &view.normal : nullptr);
    view.eye = view.eye + view.clearance * view.normal; // a normal of 0 where there is no side
  }
  view.seed = Sobol::mix(
    Sobol::mix(this->job_.options.seed + i) + 3 * source + static_cast<std::uint64_t>(part));
  if (receivers.skip.offsets)
  {
    const std::size_t set = receivers.skip.setOfRay ? receivers.skip.setOfRay[i] : i;
    view.skip = receivers.skip.primitives + receivers.skip.offsets[set];
    view.skipCount = receivers.skip.offsets[set + 1] - receivers.skip.offsets[set];
  }
  return view;
}

const std::vector<Estimate>& ReceiverChunk::compute(ReceiverPart part, bool main)
{
  // Sources of few rays come first, so that the others know how much light there is beside theirs.
  const std::size_t count = this->job_.sources.size();
  this->perSource_.assign(count * this->size_, {});
  std::size_t extended = 0;
  for (std::size_t s = 0; s < count; ++s)
  {
    if (this->job_.estimators[s])
    {
      ++extended;
    }
    else
    {
      this->sightlines(part, s);
    }
  }
  for (std::size_t k = 0; k < this->size_ && extended > 0; ++k)
  {
    if (!this->valid_[k])
    {
      continue;
    }
    double known = 0.0;
    for (std::size_t s = 0; s < count; ++s)
    {
      known += this->of(s, k).value.main;
    }
    const double tolerance =
      std::max(this->job_.options.absoluteTolerance, this->job_.options.relativeTolerance * known) /
      static_cast<double>(extended);
    for (std::size_t s = 0; s < count; ++s)
    {
      if (this->job_.estimators[s])
      {
        // What rays find comes on top of it, now or later.
        Estimate& estimate = this->of(s, k);
        this->workspace_.result = &estimate;
        estimate.add(this->job_.estimators[s]->estimate(
          this->view(k, part, s), tolerance > 0.0 ? tolerance : 0.0, this->workspace_));
        if (this->workspace_.sampler.size() >= mostQueued)
        {
          this->workspace_.sampler.run(this->job_.scene.sampling());
        }
      }
    }
  }
  this->workspace_.sampler.run(this->job_.scene.sampling());
  this->sum_.assign(this->size_, {});
  for (std::size_t k = 0; k < this->size_; ++k)
  {
    for (std::size_t s = 0; s < count; ++s)
    {
      this->sum_[k].add(this->of(s, k));
      if (main && !this->job_.outputs.perSource.empty() && this->job_.outputs.perSource[s])
      {
        this->job_.outputs.perSource[s][this->begin_ + k] =
          this->valid_[k] ? this->of(s, k).value.main : nan;
      }
    }
    this->rays_[k] += this->sum_[k].rays;
    this->missed_[k] = this->missed_[k] || this->sum_[k].missed ? 1 : 0;
  }
  return this->sum_;
}

void ReceiverChunk::sightlines(ReceiverPart part, std::size_t source)
{
  this->sightlines_.clear();
  for (std::size_t k = 0; k < this->size_; ++k)
  {
    if (this->valid_[k])
    {
      this->sightlines_.add(*this->job_.sources[source], this->view(k, part, source),
        this->job_.scene, this->of(source, k));
    }
  }
  this->sightlines_.cast(this->job_.scene, this->job_.receivers.skip.offsets != nullptr);
}

} // namespace lumitree
