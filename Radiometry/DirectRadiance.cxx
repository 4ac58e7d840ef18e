// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/DirectRadiance.h"

#include "Radiometry/Looking/PartOfJob.h"
#include "Radiometry/Looking/RadianceJob.h"

#include <algorithm>
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
