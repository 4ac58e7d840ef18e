// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Looking/RadianceJob.h"

#include "Accel/Parallel.h"
#include "Radiometry/Constants.h"
#include "Radiometry/Looking/PartOfJob.h"

#include <algorithm>
#include <limits>

namespace lumitree
{

namespace
{

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr std::size_t chunkSize = 512;

} // namespace

const Accelerator* occludersOf(const RadianceOptions& options)
{
  const Accelerator* occluders = options.estimate.occluders;
  return occluders && !occluders->surface().hittable().empty() ? occluders : nullptr;
}

RadianceJob::RadianceJob(const RayBatch& rays, const std::vector<const Source*>& sources,
  ArrayView::Scalar stored, const RadianceOptions& options)
  : rays_(rays)
  , sources_(sources)
  , options_(options)
  , occluders_(occludersOf(options))
  , stored_(stored)
{
  if (this->occluders_)
  {
    this->shadowRays_.emplace(*this->occluders_, stored);
    if (options.reflectance > 0.0 || options.reflectances)
    {
      this->hits_.resize(rays.size);
    }
  }
}

RadianceReport RadianceJob::run(double* radiance, JobControl* control)
{
  RadianceReport report;
  const bool reflects = !this->hits_.empty();
  {
    PartOfJob part(control, 0.0, reflects ? 0.3 : 1.0);
    report.completed = parallelFor(this->rays_.size, chunkSize, this->options_.estimate.threads,
      *part, [&](std::size_t begin, std::size_t end) { this->look(begin, end, radiance); });
  }
  if (reflects && report.completed)
  {
    PartOfJob part(control, 0.3, 1.0);
    this->reflect(radiance, *part, report);
  }
  report.invalidRays = this->invalid_;
  return report;
}

void RadianceJob::look(std::size_t begin, std::size_t end, double* radiance)
{
  const std::size_t size = end - begin;
  std::vector<double> origins(3 * size), directions(3 * size), tMins(size), tMaxs(size);
  std::vector<std::uint32_t> sets(size);
  for (std::size_t k = 0; k < size; ++k)
  {
    const Ray ray = this->rays_[begin + k];
    std::copy(ray.origin.begin(), ray.origin.end(), origins.begin() + 3 * k);
    std::copy(ray.direction.begin(), ray.direction.end(), directions.begin() + 3 * k);
    tMins[k] = ray.tMin < 0.0 ? 0.0 : ray.tMin;
    tMaxs[k] = ray.tMax;
    const std::uint32_t* set = this->rays_.skip.setOfRay;
    sets[k] = set ? set[begin + k] : static_cast<std::uint32_t>(begin + k);
  }
  RayBatch batch;
  batch.size = size;
  batch.origins = origins.data();
  batch.directions = directions.data();
  batch.tMins = tMins.data();
  batch.tMaxs = tMaxs.data();
  if (this->rays_.skip.offsets)
  {
    batch.skip = this->rays_.skip;
    batch.skip.setOfRay = sets.data();
  }
  std::vector<Hit> hits(size);
  if (this->occluders_)
  {
    QueryOptions query;
    query.precision = this->options_.estimate.precision;
    query.threads = 1; // the chunks themselves run side by side
    this->occluders_->closest(batch, hits.data(), query);
  }
  std::vector<SourceCrossing> crossings;
  for (std::size_t k = 0; k < size; ++k)
  {
    const Ray ray = batch[k];
    if (!isValid(ray))
    {
      radiance[begin + k] = nan;
      ++this->invalid_;
      continue;
    }
    radiance[begin + k] = this->emitted(ray, hits[k], crossings);
    if (!this->hits_.empty())
    {
      this->hits_[begin + k] = hits[k];
    }
  }
}

double RadianceJob::emitted(
  const Ray& ray, const Hit& hit, std::vector<SourceCrossing>& crossings) const
{
  crossings.clear();
  for (const Source* source : this->sources_)
  {
    source->crossings(ray.origin, ray.direction, crossings);
  }
  double sum = 0.0;
  for (const SourceCrossing& crossing : crossings)
  {
    const bool endless = crossing.t == infinity;
    if (crossing.t < ray.tMin || (endless ? ray.tMax < endlessRay : crossing.t > ray.tMax))
    {
      continue;
    }
    double reach = crossing.t;
    if (hit.primitive != noPrimitive && !endless)
    {
      reach -= this->shadowRays_->clearance(ray.origin + crossing.t * ray.direction) /
        length(ray.direction);
    }
    if (hit.primitive == noPrimitive || hit.t >= reach)
    {
      sum += crossing.radiance;
    }
  }
  return sum;
}

void RadianceJob::reflect(double* radiance, JobControl* control, RadianceReport& report) const
{
  const Surface& surface = this->occluders_->surface();
  std::vector<std::size_t> owners;
  std::vector<double> positions, normals;
  std::vector<std::uint64_t> offsets = { 0 };
  std::vector<PrimitiveId> primitives;
  for (std::size_t i = 0; i < this->hits_.size(); ++i)
  {
    const Hit& hit = this->hits_[i];
    if (hit.primitive == noPrimitive || !(this->reflectance(hit) > 0.0))
    {
      continue;
    }
    const Ray ray = this->rays_[i];
    const Vec3 point = ray.origin + hit.t * ray.direction;
    Vec3 normal = surface.normal(hit.primitive, point);
    if (dot(normal, ray.direction) > 0.0)
    {
      normal = -1.0 * normal;
    }
    owners.push_back(i);
    positions.insert(positions.end(), point.begin(), point.end());
    normals.insert(normals.end(), normal.begin(), normal.end());
    primitives.push_back(hit.primitive);
    offsets.push_back(primitives.size());
  }
  Receivers receivers;
  receivers.size = owners.size();
  receivers.positions = positions.data();
  receivers.normals = normals.data();
  receivers.stored = this->stored_;
  receivers.skip.offsets = offsets.data();
  receivers.skip.primitives = primitives.data();
  std::vector<double> irradiance(owners.size());
  EstimateOutputs outputs;
  outputs.irradiance = irradiance.data();
  EstimateOptions options = this->options_.estimate;
  options.control = control;
  const EstimateReport estimate = estimateLight(receivers, this->sources_, outputs, options);
  report.completed = estimate.completed;
  report.missedTolerance = estimate.missedTolerance;
  for (std::size_t k = 0; k < owners.size(); ++k)
  {
    radiance[owners[k]] += this->reflectance(this->hits_[owners[k]]) * irradiance[k] / pi;
  }
}

} // namespace lumitree
