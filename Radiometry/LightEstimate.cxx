// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/LightEstimate.h"

#include "Accel/Parallel.h"
#include "Radiometry/Constants.h"
#include "Radiometry/Estimate/Sobol.h"
#include "Radiometry/Estimate/SourceEstimator.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>

namespace lumitree
{

namespace
{

// Enough for a batch of rays to be worth a call, few enough to share receivers that take long
// evenly among threads.
constexpr std::size_t chunkSize = 128;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// All that the chunks share.
struct Job
{
  const Receivers& receivers;
  const std::vector<const Source*>& sources;
  const EstimateOutputs& outputs;
  const EstimateOptions& options;
  EstimateScene scene;
  std::vector<std::unique_ptr<const SourceEstimator>> estimators; ///< null: one sightline
  std::atomic<std::uint64_t> invalid{ 0 };
  std::atomic<std::uint64_t> missed{ 0 };
  std::atomic<std::uint64_t> rays{ 0 };
  std::mutex mutex;
  std::vector<std::unique_ptr<EstimateWorkspace>> workspaces; ///< not in use

  [[nodiscard]] bool sided() const { return static_cast<bool>(this->receivers.normals); }
  [[nodiscard]] bool wantsFree() const
  {
    return this->outputs.scalar || this->outputs.vector || this->outputs.cylindrical ||
      this->outputs.hemispherical || !this->sided();
  }
};

enum class Part
{
  Front,
  Back,
  Free
};

/// Some receivers, one part of the light after the other, in it one source after the other.
class Chunk
{
public:
  Chunk(Job& job, EstimateWorkspace& workspace, std::size_t begin, std::size_t end)
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

  void run()
  {
    const EstimateOutputs& out = this->job_.outputs;
    if (this->job_.sided())
    {
      const std::vector<Estimate>& front = this->compute(Part::Front, true);
      this->write(out.irradiance, front);
      this->writeMain(front);
      if (out.back)
      {
        this->write(out.back, this->compute(Part::Back, false));
      }
    }
    if (this->job_.wantsFree())
    {
      const std::vector<Estimate>& free = this->compute(Part::Free, !this->job_.sided());
      this->write(out.scalar, free);
      this->writeFree(free);
      if (!this->job_.sided())
      {
        this->writeMain(free);
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

private:
  [[nodiscard]] View view(std::size_t k, Part part, std::size_t source) const
  {
    const Receivers& receivers = this->job_.receivers;
    const std::size_t i = this->begin_ + k;
    View view;
    view.position = receivers.positions.triple(i);
    view.eye = view.position;
    view.sided = part != Part::Free;
    view.axis = this->job_.options.axis;
    if (view.sided)
    {
      view.normal = (part == Part::Back ? -1.0 : 1.0) * receivers.normals.triple(i);
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

  /// The sum over the sources; those of few rays first, so that the others know how much light
  /// there is beside theirs.
  const std::vector<Estimate>& compute(Part part, bool main)
  {
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
      const double tolerance = std::max(this->job_.options.absoluteTolerance,
                                 this->job_.options.relativeTolerance * known) /
        static_cast<double>(extended);
      for (std::size_t s = 0; s < count; ++s)
      {
        if (this->job_.estimators[s])
        {
          this->of(s, k) = this->job_.estimators[s]->estimate(
            this->view(k, part, s), tolerance > 0.0 ? tolerance : 0.0, this->workspace_);
        }
      }
    }
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

  Estimate& of(std::size_t source, std::size_t k)
  {
    return this->perSource_[source * this->size_ + k];
  }

  /// One source that is not extended, for all receivers of the chunk at once.
  void sightlines(Part part, std::size_t s)
  {
    const Source& source = *this->job_.sources[s];
    this->owners_.clear();
    this->origins_.clear();
    this->directions_.clear();
    this->tMins_.clear();
    this->tMaxs_.clear();
    this->skipOffsets_.assign(1, 0);
    this->skipPrimitives_.clear();
    for (std::size_t k = 0; k < this->size_; ++k)
    {
      if (!this->valid_[k])
      {
        continue;
      }
      const View view = this->view(k, part, s);
      const Vec3 position = this->job_.receivers.positions.triple(this->begin_ + k);
      Estimate& estimate = this->of(s, k);
      Amounts& value = estimate.value;
      if (view.sided)
      {
        value.main = source.irradiance(position, view.normal);
      }
      else
      {
        value.main = source.scalarIrradiance(position);
        if (view.vector)
        {
          value.vector = source.lightVector(position);
        }
        if (view.cylindrical)
        {
          const Vec3 way = source.sightline(position).direction;
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
        continue;
      }
      estimate.method = EstimateMethod::Sightline;
      if (!this->job_.scene.shadowRays)
      {
        continue;
      }
      const Ray ray =
        (*this->job_.scene.shadowRays)(source, position, view.sided ? &view.normal : nullptr);
      if (!isValid(ray))
      {
        continue;
      }
      this->owners_.push_back(static_cast<std::uint32_t>(k));
      this->origins_.insert(this->origins_.end(), ray.origin.begin(), ray.origin.end());
      this->directions_.insert(this->directions_.end(), ray.direction.begin(), ray.direction.end());
      this->tMins_.push_back(ray.tMin);
      this->tMaxs_.push_back(ray.tMax);
      this->skipPrimitives_.insert(
        this->skipPrimitives_.end(), view.skip, view.skip + view.skipCount);
      this->skipOffsets_.push_back(this->skipPrimitives_.size());
    }
    this->cast(s);
  }

  void cast(std::size_t s)
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
    if (this->job_.receivers.skip.offsets)
    {
      batch.skip.offsets = this->skipOffsets_.data();
      batch.skip.primitives = this->skipPrimitives_.data();
    }
    QueryOptions query;
    query.precision = this->job_.options.precision;
    query.threads = 1; // the chunks themselves run side by side
    this->hit_.resize(batch.size);
    this->job_.options.occluders->any(batch, this->hit_.data(), query);
    for (std::size_t r = 0; r < batch.size; ++r)
    {
      Estimate& estimate = this->of(s, this->owners_[r]);
      estimate.rays = 1;
      if (this->hit_[r])
      {
        estimate.value = {};
        estimate.lower = 0.0;
        estimate.upper = 0.0;
      }
    }
  }

  void write(double* to, const std::vector<Estimate>& from) const
  {
    for (std::size_t k = 0; k < this->size_ && to; ++k)
    {
      to[this->begin_ + k] = this->valid_[k] ? from[k].value.main : nan;
    }
  }

  void writeMain(const std::vector<Estimate>& from) const
  {
    const EstimateOutputs& out = this->job_.outputs;
    for (std::size_t k = 0; k < this->size_; ++k)
    {
      const std::size_t i = this->begin_ + k;
      const bool valid = this->valid_[k] != 0;
      if (out.lower)
      {
        out.lower[i] = valid ? from[k].lower : nan;
      }
      if (out.upper)
      {
        out.upper[i] = valid ? from[k].upper : nan;
      }
      if (out.unoccluded)
      {
        out.unoccluded[i] = valid ? from[k].unoccluded : nan;
      }
      if (out.method)
      {
        out.method[i] = valid ? from[k].method : EstimateMethod::None;
      }
      if (out.shadow)
      {
        out.shadow[i] = valid ? Chunk::shadow(from[k]) : ShadowState::Averted;
      }
    }
  }

  static ShadowState shadow(const Estimate& estimate)
  {
    constexpr double whole = 1.0 - 1e-9; // the sum over what is left of a light that is cut
    if (!(estimate.unoccluded > 0.0))
    {
      return ShadowState::Averted;
    }
    if (!(estimate.value.main > 0.0))
    {
      return ShadowState::Umbra;
    }
    return estimate.value.main >= whole * estimate.unoccluded ? ShadowState::Lit
                                                              : ShadowState::Penumbra;
  }

  void writeFree(const std::vector<Estimate>& from) const
  {
    const EstimateOutputs& out = this->job_.outputs;
    for (std::size_t k = 0; k < this->size_; ++k)
    {
      const std::size_t i = this->begin_ + k;
      const bool valid = this->valid_[k] != 0;
      const Amounts& value = from[k].value;
      for (int c = 0; c < 3 && out.vector; ++c)
      {
        out.vector[3 * i + c] = valid ? value.vector[c] : nan;
      }
      if (out.cylindrical)
      {
        out.cylindrical[i] = valid ? value.cylindrical : nan;
      }
      if (out.hemispherical)
      {
        const bool sided = this->job_.sided();
        const Vec3 normal = sided ? this->job_.receivers.normals.triple(i) : Vec3{};
        out.hemispherical[i] =
          valid && sided ? std::max(0.0, 0.25 * (value.main + dot(normal, value.vector))) : nan;
      }
    }
  }

  Job& job_;
  EstimateWorkspace& workspace_;
  std::size_t begin_;
  std::size_t size_;
  std::vector<std::uint8_t> valid_;
  std::vector<std::uint32_t> rays_;
  std::vector<std::uint8_t> missed_;
  std::vector<Estimate> perSource_;
  std::vector<Estimate> sum_;
  std::vector<std::uint32_t> owners_; // of the rays: index within the chunk
  std::vector<double> origins_;
  std::vector<double> directions_;
  std::vector<double> tMins_;
  std::vector<double> tMaxs_;
  std::vector<std::uint64_t> skipOffsets_;
  std::vector<PrimitiveId> skipPrimitives_;
  std::vector<std::uint8_t> hit_;
};

/// A workspace for one chunk, given back afterwards.
class Borrowed
{
public:
  explicit Borrowed(Job& job)
    : job_(job)
  {
    const std::lock_guard<std::mutex> lock(job.mutex);
    if (job.workspaces.empty())
    {
      this->workspace_ = std::make_unique<EstimateWorkspace>();
    }
    else
    {
      this->workspace_ = std::move(job.workspaces.back());
      job.workspaces.pop_back();
    }
  }
  ~Borrowed()
  {
    const std::lock_guard<std::mutex> lock(this->job_.mutex);
    this->job_.workspaces.push_back(std::move(this->workspace_));
  }
  Borrowed(const Borrowed&) = delete;
  Borrowed& operator=(const Borrowed&) = delete;

  EstimateWorkspace& operator*() { return *this->workspace_; }

private:
  Job& job_;
  std::unique_ptr<EstimateWorkspace> workspace_;
};

void check(const std::vector<const Source*>& sources, const EstimateOutputs& outputs,
  const EstimateOptions& options)
{
  const auto notNegative = [](double x) { return x >= 0.0 && std::isfinite(x); };
  if (!notNegative(options.relativeTolerance) || !notNegative(options.absoluteTolerance))
  {
    throw std::invalid_argument("Tolerances must be finite and not negative.");
  }
  if (options.maximumRays < 64 || options.maximumRays > 1u << 24)
  {
    throw std::invalid_argument(
      "The number of rays must be 64 to 2^24, but is " + std::to_string(options.maximumRays) + ".");
  }
  if (!(std::fabs(dot(options.axis, options.axis) - 1.0) < 1e-9))
  {
    throw std::invalid_argument("The axis of cylindrical irradiance must be of length 1.");
  }
  if (!outputs.perSource.empty() && outputs.perSource.size() != sources.size())
  {
    throw std::invalid_argument("estimateLight: one output per source is needed, or none.");
  }
  if (options.occluders && !options.occluders->supports(options.precision))
  {
    throw UnsupportedQuery("The structure " +
      std::string(name(options.occluders->options().structure)) +
      " does not support the precision " + std::string(name(options.precision)) + ".");
  }
}

} // namespace

EstimateReport estimateLight(const Receivers& receivers, const std::vector<const Source*>& sources,
  const EstimateOutputs& outputs, const EstimateOptions& options)
{
  check(sources, outputs, options);
  std::optional<ShadowRays> shadowRays;
  const Accelerator* occluders = options.occluders;
  if (occluders && occluders->surface().hittable().empty())
  {
    occluders = nullptr;
  }
  if (occluders)
  {
    const bool coarse = receivers.stored == ArrayView::Scalar::Float ||
      occluders->surface().scalar() == ArrayView::Scalar::Float;
    shadowRays.emplace(*occluders, coarse ? ArrayView::Scalar::Float : ArrayView::Scalar::Double);
  }
  Job job{ receivers, sources, outputs, options,
    { options, occluders, shadowRays ? &*shadowRays : nullptr,
      occluders ? occluders->surface().triangleCount() : 0 },
    {}, {}, {}, {}, {}, {} };
  for (const Source* source : sources)
  {
    job.estimators.push_back(source->extended() ? makeEstimator(*source, job.scene) : nullptr);
  }
  EstimateReport report;
  report.completed = parallelFor(receivers.size, chunkSize, options.threads, options.control,
    [&](std::size_t begin, std::size_t end)
    {
      Borrowed workspace(job);
      Chunk(job, *workspace, begin, end).run();
    });
  report.invalidReceivers = job.invalid;
  report.missedTolerance = job.missed;
  report.rays = job.rays;
  return report;
}

} // namespace lumitree
