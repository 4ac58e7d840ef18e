// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// What a structure costs that is not built: refitted to points that moved, or loaded.
//
//     Reuse [threads [repeats]]
//
// Exact rays from around the scene, on one thread. With one thread the processor's time is given,
// else that of the clock; the best of the repeats.
#include "Accel/Save.h"
#include "Data/Scenes.h"
#include "Testing/Accel/TestHelpers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <sstream>

namespace
{

using namespace lumitree;
using namespace lumitree::testing;

int threads = 1;
int repeats = 5;

double now()
{
  timespec time{};
  clock_gettime(threads == 1 ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double bestOf(const std::function<void()>& job)
{
  double best = 1e300;
  for (int i = 0; i < repeats; ++i)
  {
    const double start = now();
    job();
    best = std::min(best, now() - start);
  }
  return best;
}

/// The surface with its points moved along a wave of that height, in parts of its size.
std::shared_ptr<const Surface> waved(const Surface& surface, double height)
{
  std::vector<float> points;
  const Vec3 size = surface.bounds().size();
  const double reach = std::max({ size[0], size[1], size[2] });
  for (std::size_t i = 0; i < surface.pointCount(); ++i)
  {
    const Vec3 p = surface.point(i);
    const double x = 12.0 * (p[0] + 0.7 * p[1]) / reach;
    const double y = 12.0 * (p[1] + 0.4 * p[2]) / reach;
    points.push_back(static_cast<float>(p[0] + height * reach * std::sin(y)));
    points.push_back(static_cast<float>(p[1] + height * reach * std::cos(x + y)));
    points.push_back(static_cast<float>(p[2] + height * reach * std::sin(x)));
  }
  return std::make_shared<const Surface>(PointArray::from(std::move(points)), surface.triangles());
}

double nanosecondsPerRay(const Accelerator& accelerator, const Rays& rays)
{
  std::vector<Hit> hits(rays.size());
  const double best =
    bestOf([&] { accelerator.closest(rays.batch(), hits.data(), with(Precision::Exact)); });
  return 1e9 * best / static_cast<double>(rays.size());
}

void refits(const char* scene, const std::shared_ptr<const Surface>& surface)
{
  for (const Structure structure : { Structure::WideBvh, Structure::Bvh })
  {
    BuildOptions options = optionsOf(structure);
    options.threads = threads;
    const auto built = build(surface, options);
    for (const double height : { 0.01, 0.05, 0.2 })
    {
      const auto there = waved(*surface, height);
      const Rays rays = raysAround(*there, 100000, 1);
      std::shared_ptr<const Accelerator> anew;
      std::shared_ptr<const Accelerator> fitted;
      const double buildSeconds = bestOf([&] { anew = build(there, options); });
      const double refitSeconds = bestOf([&] { fitted = built->refit(there, threads); });
      std::printf("| %s | %s | %g %% | %.1f | %.1f | %.2f | %.0f | %.0f |\n", scene,
        std::string(name(structure)).c_str(), 100.0 * height, 1e3 * buildSeconds,
        1e3 * refitSeconds, fitted->statistics().sahCost / anew->statistics().sahCost,
        nanosecondsPerRay(*anew, rays), nanosecondsPerRay(*fitted, rays));
      std::fflush(stdout);
    }
  }
}

void loads(const char* scene, const std::shared_ptr<const Surface>& surface)
{
  for (BuildOptions options : ownStructures())
  {
    if (options.structure == Structure::BruteForce || options.kdBuild != KdBuild::Sah)
    {
      continue;
    }
    options.threads = threads;
    std::shared_ptr<const Accelerator> built;
    // A BSP-tree takes long enough to be measured once.
    const int before = repeats;
    repeats = options.structure == Structure::BspTree ? 1 : repeats;
    const double buildSeconds = bestOf([&] { built = build(surface, options); });
    repeats = before;
    std::ostringstream saved;
    save(*built, saved);
    const std::string bytes = saved.str();
    const double loadSeconds = bestOf(
      [&]
      {
        std::istringstream stream(bytes);
        (void)load(stream, surface, threads);
      });
    std::printf("| %s | %s | %.1f | %.1f | %.2f | %.2f |\n", scene, label(options).c_str(),
      1e3 * buildSeconds, 1e3 * loadSeconds, 1e-6 * static_cast<double>(bytes.size()),
      1e-6 * static_cast<double>(built->statistics().memory));
    std::fflush(stdout);
  }
}

} // namespace

int main(int argc, char** argv)
{
  threads = argc > 1 ? std::atoi(argv[1]) : threads;
  repeats = argc > 2 ? std::max(1, std::atoi(argv[2])) : repeats;
  const std::pair<const char*, std::shared_ptr<const Surface>> scenes[] = {
    { "bumpy torus", surfaceOf<float>(data::torus(350, 100, 0.02)) },
    { "city", surfaceOf<float>(data::city(24)) },
  };
  std::printf(
    "| scene | structure | points moved by | build [ms] | refit [ms] | SAH cost, refitted "
    "/ built | ns a ray, built | refitted |\n"
    "| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const auto& [scene, surface] : scenes)
  {
    refits(scene, surface);
  }
  std::printf("\n| scene | structure | build [ms] | load [ms] | file [MB] | in memory [MB] |\n"
              "| --- | --- | --- | --- | --- | --- |\n");
  for (const auto& [scene, surface] : scenes)
  {
    loads(scene, surface);
  }
  return 0;
}
