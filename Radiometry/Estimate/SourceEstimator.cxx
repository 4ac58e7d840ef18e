// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Estimate/SourceEstimator.h"

#include "Radiometry/Estimate/PolygonEstimator.h"
#include "Radiometry/Estimate/RoundEstimator.h"
#include "Radiometry/Estimate/SkyEstimator.h"
#include "Radiometry/Estimate/Sobol.h"
#include "Radiometry/Frame.h"
#include "Radiometry/SkySource.h"

#include <algorithm>
#include <cmath>

namespace lumitree
{

namespace
{

/// Tubes, lines, many polygons: closed forms, and rays where something is in the shaft to their
/// bounds.
class BoundedEstimator : public SourceEstimatorBase
{
public:
  BoundedEstimator(const Source& source, const EstimateScene& scene)
    : SourceEstimatorBase(source, scene)
  {
  }

  [[nodiscard]] Estimate estimate(
    const View& view, double tolerance, EstimateWorkspace& workspace) const override
  {
    const Estimate full = this->unoccluded(view, workspace);
    if (!(full.unoccluded > 0.0) || !this->scene_.occluders ||
      (this->shaft(view, workspace) && workspace.found.empty()))
    {
      return full;
    }
    return this->sampleAll(view, full, tolerance, workspace);
  }

private:
  /// Finds what is in the pyramid from the eye around the source's box; false where there is none.
  bool shaft(const View& view, EstimateWorkspace& workspace) const
  {
    const std::optional<Box> box = this->source_.bounds();
    if (!box || box->empty())
    {
      return false;
    }
    const Vec3 way = box->centre() - view.eye;
    const double distance = length(way);
    if (!(distance > 0.0))
    {
      return false;
    }
    const Frame frame = Frame::around((1.0 / distance) * way);
    std::array<double, 2> low = { 0.0, 0.0 };
    std::array<double, 2> high = { 0.0, 0.0 };
    double deepest = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const Vec3 p = { (corner & 1) != 0 ? box->upper[0] : box->lower[0],
        (corner & 2) != 0 ? box->upper[1] : box->lower[1],
        (corner & 4) != 0 ? box->upper[2] : box->lower[2] };
      const Vec3 local = frame.toLocal(p - view.eye);
      if (!(local[2] > 1e-3 * distance))
      {
        return false; // within the box, or nearly
      }
      deepest = std::max(deepest, local[2]);
      for (int k = 0; k < 2; ++k)
      {
        low[k] = std::min(low[k], local[k] / local[2]);
        high[k] = std::max(high[k], local[k] / local[2]);
      }
    }
    return this->pyramid(view, frame, low, high, deepest, workspace);
  }

  /// Finds what is in directions z + x low … high, down to that depth along z.
  bool pyramid(const View& view, const Frame& frame, const std::array<double, 2>& low,
    const std::array<double, 2>& high, double deepest, EstimateWorkspace& workspace) const
  {
    ConvexRegion& region = workspace.region;
    region.clear();
    const auto add = [&](const Vec3& outward, double beyond) {
      region.push_back({ outward, dot(outward, view.eye) + beyond });
    };
    const double slack = 1.0 + 0x1p-40;
    add(frame.x - (slack * high[0]) * frame.z, 0.0);
    add((slack * low[0]) * frame.z - frame.x, 0.0);
    add(frame.y - (slack * high[1]) * frame.z, 0.0);
    add((slack * low[1]) * frame.z - frame.y, 0.0);
    add(frame.z, deepest);
    if (view.sided)
    {
      add(-1.0 * view.normal, 0.0);
    }
    return this->find(view, 0, workspace);
  }
};

} // namespace

void Estimate::add(const Estimate& other)
{
  this->value.add(other.value);
  this->lower += other.lower;
  this->upper += other.upper;
  this->unoccluded += other.unoccluded;
  this->method = std::max(this->method, other.method);
  this->rays += other.rays;
  this->missed = this->missed || other.missed;
}

bool SourceEstimatorBase::find(
  const View& view, std::size_t limit, EstimateWorkspace& workspace) const
{
  std::vector<PrimitiveId>& found = workspace.found;
  this->scene_.occluders->overlap(workspace.region, found, limit + view.skipCount);
  if (view.skipCount > 0)
  {
    found.erase(std::remove_if(found.begin(), found.end(),
                  [&](PrimitiveId id)
                  { return std::binary_search(view.skip, view.skip + view.skipCount, id); }),
      found.end());
  }
  return found.size() <= limit && (found.empty() || found.back() < this->scene_.triangles);
}

Estimate SourceEstimatorBase::unoccluded(const View& view, EstimateWorkspace&) const
{
  Estimate result;
  if (view.sided)
  {
    result.value.main = this->source_.irradiance(view.position, view.normal);
  }
  else
  {
    result.value.main = this->source_.scalarIrradiance(view.position);
    if (view.vector)
    {
      result.value.vector = this->source_.lightVector(view.position);
    }
    if (view.cylindrical)
    {
      // No closed form is known for all sources: an integral over samples, good to about 1e-4.
      constexpr std::uint32_t samples = 4096;
      const Sobol sobol(0);
      Amounts sum;
      for (std::uint32_t i = 0; i < samples; ++i)
      {
        const auto [u, v] = sobol(i);
        sum.add(amountsOf(view, this->source_.sample(view.position, u, v)));
      }
      result.value.cylindrical =
        sum.main > 0.0 ? result.value.main * sum.cylindrical / sum.main : 0.0;
    }
  }
  result.lower = result.value.main;
  result.upper = result.value.main;
  result.unoccluded = result.value.main;
  result.method = result.value.main > 0.0 ? EstimateMethod::ClosedForm : EstimateMethod::None;
  return result;
}

Estimate SourceEstimatorBase::sampleAll(
  const View& view, const Estimate& full, double tolerance, EstimateWorkspace& workspace) const
{
  return this->sampleAll(
    view, full, tolerance, WholeSourceSamples(this->source_, view.eye), workspace);
}

Estimate SourceEstimatorBase::sampleAll(const View& view, const Estimate& full, double tolerance,
  const LightSamples& samples, EstimateWorkspace& workspace) const
{
  const RaySample sampled =
    workspace.sampler.run(view, full.value, 0.0, samples, this->scene_.sampling(tolerance));
  Estimate result = full;
  result.value = sampled.value;
  result.lower = std::max(0.0, sampled.value.main - sampled.halfWidth);
  result.upper = std::min(full.unoccluded, sampled.value.main + sampled.halfWidth);
  result.method = EstimateMethod::Sampling;
  result.rays = sampled.rays;
  result.missed = sampled.missed;
  return result;
}

std::size_t EstimateScene::mostClipped() const
{
  constexpr double measuredAt = 0.01;
  const double share = std::min(1.0, measuredAt / std::max(this->options.relativeTolerance, 1e-6));
  return static_cast<std::size_t>(share * this->options.mostClipped);
}

RaySamplerOptions EstimateScene::sampling(double tolerance) const
{
  RaySamplerOptions result;
  result.occluders = this->occluders;
  result.shadowRays = this->shadowRays;
  result.precision = this->options.precision;
  result.relativeTolerance = this->options.relativeTolerance;
  result.absoluteTolerance = tolerance;
  result.maximumRays = this->options.maximumRays;
  return result;
}

std::unique_ptr<const SourceEstimator> makeEstimator(
  const Source& source, const EstimateScene& scene)
{
  constexpr std::size_t fewPolygons = 32;
  if (const auto* sky = dynamic_cast<const SkySource*>(&source))
  {
    return std::make_unique<SkyEstimator>(*sky, scene);
  }
  if (source.polygons() && source.polygons()->size() <= fewPolygons)
  {
    return std::make_unique<PolygonEstimator>(source, scene);
  }
  if (RoundEstimator::suits(source))
  {
    return std::make_unique<RoundEstimator>(source, scene);
  }
  return std::make_unique<BoundedEstimator>(source, scene);
}

} // namespace lumitree
