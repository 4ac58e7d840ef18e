// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Estimate/SourceEstimator.h"

#include "Radiometry/Estimate/BoundedEstimator.h"
#include "Radiometry/Estimate/LineEstimator.h"
#include "Radiometry/Estimate/PolygonEstimator.h"
#include "Radiometry/Estimate/RoundEstimator.h"
#include "Radiometry/Estimate/SkyEstimator.h"
#include "Radiometry/Estimate/Sobol.h"
#include "Radiometry/SkySource.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lumitree
{

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
  return this->sampleAll(view, full, tolerance,
    std::make_shared<const WholeSourceSamples>(this->source_, view.eye), workspace);
}

Estimate SourceEstimatorBase::sampleAll(const View& view, const Estimate& full, double tolerance,
  std::shared_ptr<const LightSamples> samples, EstimateWorkspace& workspace) const
{
  Estimate result = full;
  sample(view, {}, full.value, tolerance, std::move(samples), workspace, result);
  return result;
}

void SourceEstimatorBase::sample(const View& view, const Amounts& certain, const Amounts& open,
  double tolerance, std::shared_ptr<const LightSamples> samples, EstimateWorkspace& workspace,
  Estimate& result)
{
  workspace.sampler.add(
    { view, open, certain.main, tolerance, std::move(samples), workspace.result });
  result.value = certain;
  result.lower = certain.main;
  result.upper = certain.main;
}

std::size_t EstimateScene::mostClipped(double absolute, double unoccluded) const
{
  // As measured, the cost of rays grows about as the tolerance shrinks.
  constexpr double measuredAt = 0.01;
  constexpr double leastTolerance = 1e-3;
  constexpr double fewest = 10.0; // what the first rays cost, whatever the tolerance
  // An absolute tolerance asks for as few rays as one four times as wide that is relative, since
  // what is nearly dark needs no more of them.
  const double relative = std::max(this->options.relativeTolerance, 4.0 * absolute / unoccluded);
  const double atOnePercent = this->options.mostClipped;
  const double ratio = measuredAt / std::max(relative, leastTolerance);
  return static_cast<std::size_t>(std::max(std::min(fewest, atOnePercent), atOnePercent * ratio));
}

RaySamplerOptions EstimateScene::sampling() const
{
  RaySamplerOptions result;
  result.occluders = this->occluders;
  result.shadowRays = this->shadowRays;
  // Fast allows any answer, and whether anything is hit is known sooner without its parameter,
  // which only Fast computes at once.
  const bool sooner = this->options.precision == Precision::Fast && this->occluders &&
    this->occluders->supports(Precision::Exact) && this->occluders->surface().bodyCount() == 0;
  result.precision = sooner ? Precision::Exact : this->options.precision;
  result.relativeTolerance = this->options.relativeTolerance;
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
  if (LineEstimator::suits(source))
  {
    return std::make_unique<LineEstimator>(source, scene);
  }
  return std::make_unique<BoundedEstimator>(source, scene);
}

} // namespace lumitree
