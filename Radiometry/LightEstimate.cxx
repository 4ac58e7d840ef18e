// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/LightEstimate.h"

#include "Accel/Parallel.h"
#include "Radiometry/Estimate/ReceiverChunk.h"

#include <cmath>
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
  EstimateJob job{ receivers, sources, outputs, options,
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
      BorrowedWorkspace workspace(job);
      ReceiverChunk(job, *workspace, begin, end).run();
    });
  report.invalidReceivers = job.invalid;
  report.missedTolerance = job.missed;
  report.rays = job.rays;
  return report;
}

} // namespace lumitree
