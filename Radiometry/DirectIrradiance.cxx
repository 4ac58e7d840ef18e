// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/DirectIrradiance.h"

#include "Accel/Parallel.h"
#include "Radiometry/ShadowRays.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

namespace lumitree
{

namespace
{

// Large enough for the batches of rays to be worth a call, small enough for its arrays to stay in
// cache.
constexpr std::size_t chunkSize = 4096;

/// Some receivers and one source after the other: unoccluded values, the shadow rays they need, and
/// the values that are left.
class Chunk
{
public:
  Chunk(const Receivers& receivers, const DirectOptions& options,
    const std::optional<ShadowRays>& shadowRays, std::size_t begin, std::size_t end)
    : receivers_(receivers)
    , options_(options)
    , shadowRays_(shadowRays)
    , begin_(begin)
    , values_(end - begin, 0.0)
    , valid_(end - begin, 1)
  {
    for (std::size_t k = 0; k < this->values_.size(); ++k)
    {
      if (!within(receivers.positions.triple(begin + k)) ||
        (receivers.normals && !isFinite(receivers.normals.triple(begin + k))))
      {
        this->valid_[k] = 0;
        this->values_[k] = std::numeric_limits<double>::quiet_NaN();
        ++this->invalid_;
      }
    }
    this->total_ = this->values_;
  }

  /// Irradiance from that source, added to the total.
  const std::vector<double>& evaluate(const Source& source)
  {
    this->unocclude(source);
    this->hide();
    for (std::size_t k = 0; k < this->total_.size(); ++k)
    {
      this->total_[k] += this->values_[k];
    }
    return this->values_;
  }

  [[nodiscard]] const std::vector<double>& total() const { return this->total_; }
  [[nodiscard]] std::uint64_t invalid() const { return this->invalid_; }
  [[nodiscard]] std::uint64_t rays() const { return this->rays_; }

private:
  static bool within(const Vec3& p)
  {
    return std::fabs(p[0]) <= coordinateLimit && std::fabs(p[1]) <= coordinateLimit &&
      std::fabs(p[2]) <= coordinateLimit;
  }

  void unocclude(const Source& source)
  {
    this->clearRays();
    for (std::size_t k = 0; k < this->values_.size(); ++k)
    {
      if (!this->valid_[k])
      {
        continue;
      }
      const Vec3 position = this->receivers_.positions.triple(this->begin_ + k);
      if (this->receivers_.normals)
      {
        const Vec3 normal = this->receivers_.normals.triple(this->begin_ + k);
        this->values_[k] = source.irradiance(position, normal);
        this->addRay(k, source, position, &normal);
      }
      else
      {
        this->values_[k] = source.scalarIrradiance(position);
        this->addRay(k, source, position, nullptr);
      }
    }
  }

  void clearRays()
  {
    this->owners_.clear();
    this->sets_.clear();
    this->origins_.clear();
    this->directions_.clear();
    this->tMins_.clear();
    this->tMaxs_.clear();
  }

  void addRay(std::size_t k, const Source& source, const Vec3& position, const Vec3* normal)
  {
    if (!this->shadowRays_ || !(this->values_[k] > 0.0))
    {
      return;
    }
    const Ray ray = (*this->shadowRays_)(source, position, normal);
    if (!isValid(ray))
    {
      return;
    }
    this->owners_.push_back(static_cast<std::uint32_t>(k));
    this->origins_.insert(this->origins_.end(), ray.origin.begin(), ray.origin.end());
    this->directions_.insert(this->directions_.end(), ray.direction.begin(), ray.direction.end());
    this->tMins_.push_back(ray.tMin);
    this->tMaxs_.push_back(ray.tMax);
    if (this->receivers_.skip.offsets)
    {
      const std::uint32_t* sets = this->receivers_.skip.setOfRay;
      this->sets_.push_back(static_cast<std::uint32_t>(sets ? sets[this->begin_ + k] : k));
    }
  }

  void hide()
  {
    if (this->owners_.empty())
    {
      return;
    }
    RayBatch batch;
    batch.size = this->owners_.size();
    batch.origins = this->origins_.data();
    batch.directions = this->directions_.data();
    batch.tMins = this->tMins_.data();
    batch.tMaxs = this->tMaxs_.data();
    const SkipSets& skip = this->receivers_.skip;
    if (skip.offsets)
    {
      // Without names of sets, receiver i has set i: those of the chunk begin at its own offset.
      batch.skip.offsets = skip.setOfRay ? skip.offsets : skip.offsets + this->begin_;
      batch.skip.primitives = skip.primitives;
      batch.skip.setOfRay = this->sets_.data();
    }
    QueryOptions query;
    query.precision = this->options_.precision;
    query.threads = 1; // the chunks themselves run side by side
    this->hit_.resize(batch.size);
    this->options_.occluders->any(batch, this->hit_.data(), query);
    for (std::size_t r = 0; r < batch.size; ++r)
    {
      if (this->hit_[r])
      {
        this->values_[this->owners_[r]] = 0.0;
      }
    }
    this->rays_ += batch.size;
  }

  const Receivers& receivers_;
  const DirectOptions& options_;
  const std::optional<ShadowRays>& shadowRays_;
  std::size_t begin_;
  std::vector<double> values_; // of the source evaluated last
  std::vector<std::uint8_t> valid_;
  std::vector<double> total_;
  std::vector<std::uint32_t> owners_; // of the rays: index within the chunk
  std::vector<std::uint32_t> sets_;
  std::vector<double> origins_;
  std::vector<double> directions_;
  std::vector<double> tMins_;
  std::vector<double> tMaxs_;
  std::vector<std::uint8_t> hit_;
  std::uint64_t invalid_ = 0;
  std::uint64_t rays_ = 0;
};

} // namespace

DirectReport directIrradiance(const Receivers& receivers, const std::vector<const Source*>& sources,
  double* total, const std::vector<double*>& perSource, const DirectOptions& options)
{
  if (!perSource.empty() && perSource.size() != sources.size())
  {
    throw std::invalid_argument("directIrradiance: one output per source is needed, or none.");
  }
  if (options.occluders &&
    std::any_of(
      sources.begin(), sources.end(), [](const Source* source) { return source->extended(); }))
  {
    throw std::invalid_argument("directIrradiance casts one ray to a source; the shadows of an "
                                "extended one need estimation.");
  }
  std::optional<ShadowRays> shadowRays;
  if (options.occluders && !options.occluders->surface().hittable().empty())
  {
    if (!options.occluders->supports(options.precision))
    {
      throw UnsupportedQuery("The structure " +
        std::string(name(options.occluders->options().structure)) +
        " does not support the precision " + std::string(name(options.precision)) + ".");
    }
    const bool coarse = receivers.stored == ArrayView::Scalar::Float ||
      options.occluders->surface().scalar() == ArrayView::Scalar::Float;
    shadowRays.emplace(
      *options.occluders, coarse ? ArrayView::Scalar::Float : ArrayView::Scalar::Double);
  }

  std::atomic<std::uint64_t> invalid{ 0 };
  std::atomic<std::uint64_t> rays{ 0 };
  DirectReport report;
  report.completed = parallelFor(receivers.size, chunkSize, options.threads, options.control,
    [&](std::size_t begin, std::size_t end)
    {
      Chunk chunk(receivers, options, shadowRays, begin, end);
      for (std::size_t s = 0; s < sources.size(); ++s)
      {
        const std::vector<double>& values = chunk.evaluate(*sources[s]);
        if (!perSource.empty() && perSource[s])
        {
          std::copy(values.begin(), values.end(), perSource[s] + begin);
        }
      }
      std::copy(chunk.total().begin(), chunk.total().end(), total + begin);
      invalid += chunk.invalid();
      rays += chunk.rays();
    });
  report.invalidReceivers = invalid;
  report.shadowRays = rays;
  return report;
}

} // namespace lumitree
