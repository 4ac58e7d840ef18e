// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/AutoChoice.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lumitree
{
namespace
{

/// Primitives looked at; of more, every so many-th.
constexpr std::size_t sampleSize = 65536;
constexpr int fillCells = 32;

/// Nanoseconds that building takes per primitive, and a ray per halving of the scene; measured on
/// the torus, the city and the stadium of Docs/benchmarks.md, exact rays that have bounced once.
struct Calibration
{
  Structure structure;
  BvhBuild bvhBuild;
  double build;
  double ray;
};

constexpr Calibration calibrations[] = {
  { Structure::WideBvh, BvhBuild::Morton, 180.0, 22.0 },
  { Structure::WideBvh, BvhBuild::BinnedSah, 290.0, 17.0 },
  { Structure::WideBvh, BvhBuild::SweepSah, 620.0, 17.0 },
  { Structure::WideBvh, BvhBuild::SpatialSplits, 2200.0, 17.0 },
  { Structure::WideBvh, BvhBuild::LongestAxisMedian, 280.0, 33.0 },
  { Structure::Bvh, BvhBuild::BinnedSah, 280.0, 50.0 },
  { Structure::Grid, BvhBuild::BinnedSah, 600.0, 50.0 },
  { Structure::Octree, BvhBuild::BinnedSah, 2500.0, 90.0 },
  { Structure::KdTree, BvhBuild::BinnedSah, 2300.0, 65.0 },
  { Structure::BspTree, BvhBuild::BinnedSah, 33000.0, 75.0 },
};
/// Brute force: per primitive built, per ray, and per ray and primitive; from some twenty primitives
/// on a tree is quicker.
constexpr double bruteBuild = 8.0;
constexpr double bruteRay = 12.0;
constexpr double bruteTest = 5.2;
/// What any tree takes to set up, and a ray to begin with.
constexpr double treeSetUp = 3000.0;
constexpr double rayStart = 30.0;
/// Spatial splits halve the time of rays where all that they meet is large and empty.
constexpr double spatialGain = 0.5;
/// A box that is met beyond the one in which the ray ends costs a few nanoseconds.
constexpr double perBox = 2.0;
/// Unless they are planned: ten rays per primitive, a million at least.
///@{
constexpr double raysPerPrimitive = 10.0;
constexpr double leastRays = 1e6;
///@}

double areaOfPrimitive(const Surface& surface, PrimitiveId id, double scale)
{
  const auto v = surface.vertices(id);
  return 0.5 * length(cross(scale * (v[1] - v[0]), scale * (v[2] - v[0])));
}

SceneMeasures measure(const Surface& surface)
{
  SceneMeasures m;
  const std::vector<PrimitiveId>& ids = surface.hittable();
  m.primitives = ids.size();
  if (ids.empty())
  {
    return m;
  }
  const Vec3 size = surface.bounds().size();
  const double longest = std::max({ size[0], size[1], size[2] });
  m.aspect = longest / std::min({ size[0], size[1], size[2] });
  // Scaled, so that no area over- or underflows.
  const double scale = longest > 0.0 ? 1.0 / longest : 1.0;
  const auto scaledArea = [scale](const Box& box)
  {
    const Vec3 s = scale * box.size();
    return 2.0 * (s[0] * s[1] + s[1] * s[2] + s[2] * s[0]);
  };
  const double whole = scaledArea(surface.bounds());

  struct Sample
  {
    double box;
    double triangle; ///< its area, both sides; of a body its box's
  };
  std::vector<Sample> samples;
  std::vector<bool> cells(fillCells * fillCells * fillCells, false);
  const std::size_t step = (ids.size() + sampleSize - 1) / sampleSize;
  for (std::size_t i = 0; i < ids.size(); i += step)
  {
    const Box box = surface.box(ids[i]);
    const double area = scaledArea(box);
    samples.push_back(
      { area, surface.isTriangle(ids[i]) ? 2.0 * areaOfPrimitive(surface, ids[i], scale) : area });
    std::size_t cell = 0;
    for (int k = 2; k >= 0; --k)
    {
      const double share =
        size[k] > 0.0 ? (box.centre()[k] - surface.bounds().lower[k]) / size[k] : 0.0;
      cell = cell * fillCells +
        static_cast<std::size_t>(std::clamp(share * fillCells, 0.0, fillCells - 1.0));
    }
    cells[cell] = true;
  }
  m.fill = static_cast<double>(std::count(cells.begin(), cells.end(), true)) /
    static_cast<double>(cells.size());
  if (!(whole > 0.0))
  {
    return m;
  }
  const auto middle = samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2);
  std::nth_element(samples.begin(), middle, samples.end(),
    [](const Sample& a, const Sample& b) { return a.box < b.box; });
  const double median = middle->box;
  double sum = 0.0;
  double largeEmpty = 0.0;
  for (const Sample& s : samples)
  {
    sum += s.box;
    largeEmpty += s.box > 100.0 * median && s.box > 4.0 * s.triangle ? s.box : 0.0;
  }
  m.depth = sum / whole * static_cast<double>(step);
  m.largeEmpty = sum > 0.0 ? largeEmpty / sum : 0.0;
  return m;
}

AutoEstimate estimate(const Calibration& c, const SceneMeasures& m, double rays)
{
  const auto n = static_cast<double>(m.primitives);
  double ray = c.ray * std::log2(n + 1.0) + perBox * std::min(m.depth, n);
  if (c.bvhBuild == BvhBuild::SpatialSplits)
  {
    ray *= 1.0 - spatialGain * m.largeEmpty;
  }
  if (c.structure == Structure::Grid)
  {
    // Where few cells hold everything, they hold much.
    const double even = std::min(1.0, n / (fillCells * fillCells * fillCells));
    ray *= std::clamp(even / std::max(m.fill, 1e-4), 1.0, 1e3);
  }
  return { c.structure, c.bvhBuild, 1e-9 * (treeSetUp + c.build * n),
    1e-9 * rays * (rayStart + ray) };
}

std::string describe(const AutoEstimate& e)
{
  std::string text(name(e.structure));
  if (e.structure == Structure::Bvh || e.structure == Structure::WideBvh)
  {
    text += " (" + std::string(name(e.bvhBuild)) + ")";
  }
  char times[64];
  std::snprintf(
    times, sizeof(times), ": %.3g s to build, %.3g s for rays", e.buildSeconds, e.raySeconds);
  return text + times;
}

} // namespace

AutoReport chooseStructure(const Surface& surface, const BuildOptions& options)
{
  AutoReport report;
  report.choice = options;
  report.measures = measure(surface);
  const auto n = static_cast<double>(report.measures.primitives);
  report.rays =
    options.expectedRays > 0.0 ? options.expectedRays : std::max(leastRays, raysPerPrimitive * n);
  report.estimates.push_back({ Structure::BruteForce, BvhBuild::BinnedSah, 1e-9 * bruteBuild * n,
    1e-9 * report.rays * (bruteRay + bruteTest * n) });
  for (const Calibration& c : calibrations)
  {
    report.estimates.push_back(estimate(c, report.measures, report.rays));
  }
  std::stable_sort(report.estimates.begin(), report.estimates.end(),
    [](const AutoEstimate& a, const AutoEstimate& b)
    { return a.buildSeconds + a.raySeconds < b.buildSeconds + b.raySeconds; });
  const AutoEstimate& best = report.estimates.front();
  report.choice.structure = best.structure;
  if (best.structure == Structure::Bvh || best.structure == Structure::WideBvh)
  {
    report.choice.bvhBuild = best.bvhBuild;
  }
  char head[160];
  std::snprintf(head, sizeof(head),
    "for %zu primitives (boxes met by a ray: %.3g, of them large and empty: %.0f %%) and %.3g "
    "rays ",
    report.measures.primitives, report.measures.depth, 100.0 * report.measures.largeEmpty,
    report.rays);
  report.reason = head + describe(best) + "; next " + describe(report.estimates[1]);
  return report;
}

} // namespace lumitree
