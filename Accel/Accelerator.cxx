// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Accelerator.h"

#include "Accel/AutoChoice.h"
#include "Accel/FloatEnvironment.h"
#include "Accel/Kernel/OverlapIndex.h"
#include "Accel/Registry.h"

#include <limits>
#include <string>

namespace lumitree
{
namespace
{

[[noreturn]] void refuse(const Accelerator& accelerator, QueryKind query)
{
  throw UnsupportedQuery("structure '" + std::string(name(accelerator.options().structure)) +
    "' does not answer the query '" + std::string(name(query)) + "'");
}

void checkRange(const char* what, int value, int low, int high)
{
  if (value < low || value > high)
  {
    throw std::invalid_argument(std::string(what) + " is " + std::to_string(value) +
      ", it must lie in " + std::to_string(low) + "…" + std::to_string(high));
  }
}

void checkGrid(const BuildOptions& options)
{
  // The negation refuses NaN as well.
  if (!(options.gridDensity > 0.0 && options.gridDensity <= 1000.0))
  {
    throw std::invalid_argument("grid density is " + std::to_string(options.gridDensity) +
      ", it must be above 0 and at most 1000 cells per primitive");
  }
  if (options.gridResolution != std::array<int, 3>{ 0, 0, 0 })
  {
    for (const int cells : options.gridResolution)
    {
      checkRange("grid resolution", cells, 1, 1 << 20);
    }
  }
}

} // namespace

void requireValid(const BuildOptions& options)
{
  checkRange("leaf size", options.leafSize, 1, 1024);
  checkRange("greatest depth", options.maxDepth, 1, 64);
  checkRange("number of threads", options.threads, 0, std::numeric_limits<int>::max());
  checkRange("BVH build", static_cast<int>(options.bvhBuild), 0, bvhBuildCount - 1);
  checkRange("KD-tree build", static_cast<int>(options.kdBuild), 0, kdBuildCount - 1);
  checkGrid(options);
  if (!(options.expectedRays >= 0.0))
  {
    throw std::invalid_argument("the number of rays expected must not be negative");
  }
}

std::string_view name(Origin origin)
{
  constexpr std::array<std::string_view, 3> names = { "built", "refitted", "loaded" };
  return names[static_cast<std::size_t>(origin)];
}

Accelerator::Accelerator(std::shared_ptr<const Surface> surface, const BuildOptions& options)
  : options_(options)
  , surface_(std::move(surface))
{
}

Accelerator::~Accelerator() = default;

Precision Accelerator::bestPrecision() const
{
  for (const Precision precision : { Precision::Exact, Precision::Watertight })
  {
    if (this->supports(precision))
    {
      return precision;
    }
  }
  return Precision::Fast;
}

QueryReport Accelerator::ties(const RayBatch&, AllHits&, const QueryOptions&) const
{
  refuse(*this, QueryKind::Ties);
}

QueryReport Accelerator::crossings(const RayBatch&, std::uint32_t*, const QueryOptions&) const
{
  refuse(*this, QueryKind::Crossings);
}

void Accelerator::overlap(
  const ConvexRegion& region, std::vector<PrimitiveId>& primitives, std::size_t limit) const
{
  const FloatEnvironment environment;
  std::call_once(this->overlapOnce_,
    [&]
    {
      this->overlapIndex_ =
        std::make_unique<const OverlapIndex>(this->surface(), this->hierarchy());
    });
  this->overlapIndex_->overlap(region, primitives, limit);
}

std::shared_ptr<const Accelerator> Accelerator::refit(
  std::shared_ptr<const Surface> surface, int threads, JobControl* control) const
{
  if (!surface)
  {
    throw std::invalid_argument("there is no surface to refit to");
  }
  const FloatEnvironment environment;
  return surface->size() == this->surface().size()
    ? this->refitted(std::move(surface), threads, control)
    : nullptr;
}

std::shared_ptr<const Accelerator> Accelerator::refitted(
  std::shared_ptr<const Surface>, int, JobControl*) const
{
  return nullptr;
}

bool Accelerator::saveTo(SaveWriter&) const
{
  return false;
}

std::shared_ptr<const Accelerator> build(
  std::shared_ptr<const Surface> surface, const BuildOptions& asked, JobControl* control)
{
  if (!surface)
  {
    throw std::invalid_argument("there is no surface to build over");
  }
  requireValid(asked);
  // Builders compare and convert coordinates: with subnormals flushed they would enclose other
  // numbers.
  const FloatEnvironment environment;
  BuildOptions options = asked;
  std::string reason;
  if (options.structure == Structure::Auto)
  {
    AutoReport report = chooseStructure(*surface, options);
    options = report.choice;
    reason = std::move(report.reason);
  }
  std::shared_ptr<const Accelerator> built =
    Registry::instance().find(options.structure).build(std::move(surface), options, control);
  if (!reason.empty())
  {
    // Nobody else has seen it yet.
    const_cast<Accelerator&>(*built).statistics_.choice = std::move(reason);
  }
  return built;
}

} // namespace lumitree
