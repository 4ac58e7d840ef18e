// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkLumiRayCast end to end against a loop over vtkStaticCellLocator, one thread, the same rays:
//   RayCastVersusLocator [--surface=FILE.obj] [rays [repeats [locator's rays]]]
// By default a million rays, 5 repeats, and all rays for the locator, too, but in the third scene
// (50,000 of them) and in the stadium (1,000). The filter's time is
// that of a whole Update with all output arrays: of a new filter on a new surface, so with
// conversion and build, and of the same filter once more, without. The locator's is that of its
// build and of its calls. Processor time, medians; the locator's rays are cut into as many slices
// as there are repeats, which take turns with the filter. Prints tables in Markdown: the race, and
// where the filter's time goes.
#include "vtkLumiRayCast.h"

#include "RaysLocator.h"

#include "Accel/Accelerator.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using namespace lumitree;
using namespace lumitree::benchmarks;

template <class Work>
double timed(const Work& work)
{
  timespec start{};
  timespec end{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &start);
  work();
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &end);
  return static_cast<double>(end.tv_sec - start.tv_sec) +
    1e-9 * static_cast<double>(end.tv_nsec - start.tv_nsec);
}

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

constexpr const char* phases[] = { "SurfaceSeconds", "BuildSeconds", "ReadSeconds", "CastSeconds",
  "OutputSeconds" };

struct Times
{
  std::vector<double> withBuild;
  std::vector<double> without;
  std::vector<double> phases[5]; ///< by the filter's own clock
  long long hits = 0;
};

/// The same surface as another object, whose tree nobody has.
vtkSmartPointer<vtkPolyData> copyOf(vtkPolyData* surface)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(surface);
  return copy;
}

void runFilter(vtkPolyData* surface, vtkPolyData* rays, Times& times)
{
  const vtkSmartPointer<vtkPolyData> unseen = copyOf(surface);
  const vtkNew<vtkLumiRayCast> cast;
  cast->SetInputDataObject(0, unseen);
  cast->SetRaysData(rays);
  cast->SetNumberOfThreads(1);
  times.withBuild.push_back(timed([&] { cast->Update(); }));
  vtkTable* statistics = vtkTable::SafeDownCast(cast->GetOutputDataObject(3));
  for (std::size_t p = 0; p < 5; ++p)
  {
    times.phases[p].push_back(statistics->GetValueByName(0, phases[p]).ToDouble());
  }
  cast->Modified();
  times.without.push_back(timed([&] { cast->Update(); }));
  times.hits = cast->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT);
}

/// Prints a row of the table; returns that of the filter's phases.
std::string race(const Scene& scene, const Rays& rays, int repeats, std::size_t locatorRays)
{
  const vtkSmartPointer<vtkPolyData> surface = surfaceData(scene);
  const vtkSmartPointer<vtkPolyData> data = rayData(rays);
  // A thousand times as slow where a scene is large and what is in it small: fewer are enough
  // there.
  const std::size_t bearable = scene.name == "stadium" ? 1000
    : scene.triangles.size() > 1000000                 ? 50000
                                                       : rays.size();
  const std::size_t asked = std::min({ locatorRays, rays.size(), bearable });
  const Rays theirRays = asked < rays.size() ? sampled(rays, asked) : rays;
  const auto slices = static_cast<std::size_t>(repeats);
  std::vector<Hit> hits(asked);
  Times ours;
  std::vector<double> locatorBuilds;
  double calls = 0.0;
  for (std::size_t r = 0; r < slices; ++r)
  {
    runFilter(surface, data, ours);
    std::unique_ptr<RawLocator> locator;
    locatorBuilds.push_back(timed([&] { locator = std::make_unique<RawLocator>(surface); }));
    calls += timed([&]
      { locator->closest(theirRays, r * asked / slices, (r + 1) * asked / slices, hits.data()); });
  }
  const double share = static_cast<double>(ours.hits) / static_cast<double>(rays.size());
  const auto found = std::count_if(
    hits.begin(), hits.end(), [](const Hit& hit) { return hit.primitive != noPrimitive; });
  // The locator loses rays where walls lie in the bounds
  // of the surface, so its hits are told.
  const double foundShare =
    asked == 0 ? 0.0 : static_cast<double>(found) / static_cast<double>(asked);
  const double expected = scene.hitShares[rays.kind == "camera" ? 0 : 1];
  if (expected > 0.0 ? std::fabs(share - expected) > 5e-3 : share < 0.05)
  {
    throw std::runtime_error(scene.name + ", " + rays.kind + ": " + std::to_string(share) +
      " of the rays hit, not " + std::to_string(expected));
  }
  const double theirs =
    calls * static_cast<double>(rays.size()) / static_cast<double>(std::max<std::size_t>(asked, 1));
  const double theirBuild = median(locatorBuilds);
  const double withBuild = median(ours.withBuild);
  const double without = median(ours.without);
  std::printf("| %s, %s | %.2f | %.2f | %.2f | %.2f | %.3f | %.3f | %.0f | **%.0f** | **%.0f** |\n",
    scene.name.c_str(), rays.kind.c_str(), 100.0 * share, 100.0 * foundShare, theirBuild, theirs,
    withBuild - without, without, 1e9 * without / static_cast<double>(rays.size()),
    (theirBuild + theirs) / withBuild, theirs / without);
  std::fflush(stdout);
  std::string row = "| " + scene.name + ", " + rays.kind + " |";
  for (std::size_t p = 0; p < 5; ++p)
  {
    char cell[32];
    std::snprintf(cell, sizeof cell, " %.1f |", 1e3 * median(ours.phases[p]));
    row += cell;
  }
  return row + "\n";
}

/// Repeated over and over until there are so many.
Rays repeated(Rays rays, std::size_t count)
{
  const std::size_t own = rays.origins.size();
  rays.origins.resize(3 * count);
  rays.directions.resize(3 * count);
  for (std::size_t i = own; i < 3 * count; ++i)
  {
    rays.origins[i] = rays.origins[i - own];
    rays.directions[i] = rays.directions[i - own];
  }
  return rays;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    std::vector<std::string> arguments(argv + 1, argv + argc);
    std::string file;
    if (!arguments.empty() && arguments.front().rfind("--surface=", 0) == 0)
    {
      file = arguments.front().substr(10);
      arguments.erase(arguments.begin());
    }
    const auto number = [&](std::size_t i, double otherwise)
    { return arguments.size() > i ? std::atof(arguments[i].c_str()) : otherwise; };
    const auto count = static_cast<std::size_t>(number(0, 1e6));
    const int repeats = std::max(1, static_cast<int>(number(1, 5)));
    const auto locatorRays = static_cast<std::size_t>(number(2, static_cast<double>(count)));

    const tbb::global_control serial(tbb::global_control::max_allowed_parallelism, 1);
    std::printf("%zu rays, one thread, medians of %d\n\n"
                "| scene, rays | hit [%%] | by the locator [%%] | its build [s] | its calls [s] | "
                "filter: conversion "
                "and build [s] | the rest [s] | of it [ns per ray] | times as fast, with builds | "
                "without |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
      count, repeats);
    std::string rows;
    const int width = static_cast<int>(std::sqrt(static_cast<double>(count) * 4.0 / 3.0));
    for (const Scene& scene : builtInScenes(file))
    {
      const auto surface = scene.surface();
      const Rays camera = cameraRays(scene, width);
      std::vector<Hit> seen(camera.size());
      build(surface)->closest(camera.batch(), seen.data());
      rows += race(scene, repeated(camera, count), repeats, locatorRays);
      rows += race(scene, bounces(*surface, camera, seen, count), repeats, locatorRays);
    }
    std::printf("\nWhat the filter spends where [ms], by the clock\n\n"
                "| scene, rays | conversion | build | reading rays | cast | outputs |\n"
                "| --- | --- | --- | --- | --- | --- |\n%s",
      rows.c_str());
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "RayCastVersusLocator: %s\n", error.what());
    return 1;
  }
  return 0;
}
