// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/DirectRadiance.h"

#include "Accel/Parallel.h"
#include "Radiometry/Constants.h"
#include "Radiometry/ShadowRays.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

namespace lumitree
{

namespace
{

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr std::size_t chunkSize = 512;

/// A part of a job that tells how far the whole is.
class PartOfJob
{
public:
  PartOfJob(JobControl* whole, double begin, double end)
  {
    if (whole)
    {
      this->control_.onProgress = [whole, begin, end](double done) {
        return !whole->stop &&
          (!whole->onProgress || whole->onProgress(begin + done * (end - begin)));
      };
    }
  }
  JobControl* operator*() { return &this->control_; }

private:
  JobControl control_;
};

const Accelerator* occludersOf(const RadianceOptions& options)
{
  const Accelerator* occluders = options.estimate.occluders;
  return occluders && !occluders->surface().hittable().empty() ? occluders : nullptr;
}

void check(const RadianceOptions& options)
{
  const auto good = [](double x) { return x >= 0.0 && x <= 1.0; };
  const Accelerator* occluders = options.estimate.occluders;
  bool all = good(options.reflectance);
  if (options.reflectances && occluders)
  {
    all =
      std::all_of(options.reflectances, options.reflectances + occluders->surface().size(), good);
  }
  if (!all)
  {
    throw std::invalid_argument("Reflectances must be 0 to 1.");
  }
  if (occluders && !occluders->supports(options.estimate.precision))
  {
    throw UnsupportedQuery("The structure " + std::string(name(occluders->options().structure)) +
      " does not support the precision " + std::string(name(options.estimate.precision)) + ".");
  }
}

/// The rays of one call.
class RadianceJob
{
public:
  RadianceJob(const RayBatch& rays, const std::vector<const Source*>& sources,
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

  RadianceReport run(double* radiance, JobControl* control)
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

private:
  /// The nearest hits, and the sources before them.
  void look(std::size_t begin, std::size_t end, double* radiance)
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

  [[nodiscard]] double emitted(
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

  /// Adds what the surface that was hit makes of the light that falls on it.
  void reflect(double* radiance, JobControl* control, RadianceReport& report) const
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

  [[nodiscard]] double reflectance(const Hit& hit) const
  {
    return this->options_.reflectances ? this->options_.reflectances[hit.primitive]
                                       : this->options_.reflectance;
  }

  const RayBatch& rays_;
  const std::vector<const Source*>& sources_;
  const RadianceOptions& options_;
  const Accelerator* occluders_; ///< null: nothing is in the way
  ArrayView::Scalar stored_;
  std::optional<ShadowRays> shadowRays_; ///< where there are occluders
  std::vector<Hit> hits_;                ///< empty where nothing reflects
  std::atomic<std::uint64_t> invalid_{ 0 };
};

ArrayView::Scalar coarser(ArrayView::Scalar given, const Accelerator* occluders)
{
  const bool coarse = given == ArrayView::Scalar::Float ||
    (occluders && occluders->surface().scalar() == ArrayView::Scalar::Float);
  return coarse ? ArrayView::Scalar::Float : ArrayView::Scalar::Double;
}

} // namespace

RadianceReport directRadiance(const RayBatch& rays, const std::vector<const Source*>& sources,
  double* radiance, const RadianceOptions& options)
{
  check(options);
  const ArrayView::Scalar stored = coarser(rays.origins.type, occludersOf(options));
  return RadianceJob(rays, sources, stored, options).run(radiance, options.estimate.control);
}

RadianceReport radianceAround(const Receivers& places, const std::vector<Vec3>& directions,
  const std::vector<const Source*>& sources, double* radiance, const RadianceOptions& options)
{
  check(options);
  RadianceReport report;
  const std::size_t count = directions.size();
  if (places.size == 0 || count == 0)
  {
    return report;
  }
  const Accelerator* occluders = occludersOf(options);
  const ArrayView::Scalar stored = coarser(places.stored, occluders);
  std::optional<ShadowRays> shadowRays;
  if (occluders)
  {
    shadowRays.emplace(*occluders, stored);
  }
  // Blocks of places, so that memory does not grow with their number.
  constexpr std::size_t most = std::size_t{ 1 } << 20;
  const std::size_t block = std::clamp(most / count, std::size_t{ 1 }, places.size);
  std::vector<double> origins, ways, tMins;
  std::vector<std::uint32_t> sets;
  std::vector<std::uint8_t> behind;
  for (std::size_t begin = 0; begin < places.size; begin += block)
  {
    const std::size_t end = std::min(places.size, begin + block);
    origins.clear();
    ways.clear();
    tMins.clear();
    sets.clear();
    behind.clear();
    for (std::size_t i = begin; i < end; ++i)
    {
      Vec3 eye = places.positions.triple(i);
      const Vec3 normal = places.normals ? places.normals.triple(i) : Vec3{ nan, nan, nan };
      const bool sided = isFinite(normal);
      const double clearance =
        shadowRays ? shadowRays->clearance(eye, sided ? &normal : nullptr) : 0.0;
      if (sided)
      {
        eye = eye + clearance * normal;
      }
      for (const Vec3& direction : directions)
      {
        origins.insert(origins.end(), eye.begin(), eye.end());
        ways.insert(ways.end(), direction.begin(), direction.end());
        tMins.push_back(clearance > 0.0 ? clearance / length(direction) : 0.0);
        sets.push_back(static_cast<std::uint32_t>(i));
        behind.push_back(sided && !(dot(normal, direction) > 0.0) ? 1 : 0);
      }
    }
    RayBatch batch;
    batch.size = tMins.size();
    batch.origins = origins.data();
    batch.directions = ways.data();
    batch.tMins = tMins.data();
    if (places.skip.offsets)
    {
      batch.skip = places.skip;
      batch.skip.setOfRay = sets.data();
    }
    const auto size = static_cast<double>(places.size);
    PartOfJob part(
      options.estimate.control, static_cast<double>(begin) / size, static_cast<double>(end) / size);
    double* const to = radiance + begin * count;
    const RadianceReport one = RadianceJob(batch, sources, stored, options).run(to, *part);
    for (std::size_t k = 0; k < behind.size(); ++k)
    {
      if (behind[k] && !std::isnan(to[k]))
      {
        to[k] = 0.0;
      }
    }
    report.invalidRays += one.invalidRays;
    report.missedTolerance += one.missedTolerance;
    report.completed = one.completed;
    if (!one.completed)
    {
      break;
    }
  }
  return report;
}

} // namespace lumitree
