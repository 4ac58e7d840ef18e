// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// How long structures take to build, what they weigh and what they are expected to cost, beside
// Embree's trees in the same run:
//
//     Builds [scene [threads [repeats [grid]]]]
//
// With one thread the processor's time is given, else that of the clock; the best of the repeats,
// contenders taking turns. scene is one of those built in, a Wavefront file, or terrain:N for 2 N²
// triangles.
#include "Accel/Registry.h"
#include "Data/Scenes.h"
#include "RaysEmbree.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <functional>

namespace
{

using namespace lumitree;
using namespace lumitree::benchmarks;

double now(bool processor)
{
  timespec time{};
  clock_gettime(processor ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Contender
{
  std::string name;
  std::function<BuildStatistics()> build;
  std::function<std::shared_ptr<const Accelerator>()> accelerator; ///< of our own
  double best = 1e300;
  BuildStatistics statistics;
};

void addOurs(
  std::vector<Contender>& all, const std::shared_ptr<const Surface>& surface, BuildOptions options)
{
  std::string title(name(options.structure));
  if (options.structure == Structure::Bvh || options.structure == Structure::WideBvh)
  {
    title += ", " + std::string(name(options.bvhBuild));
  }
  if (options.structure == Structure::KdTree)
  {
    title += ", " + std::string(name(options.kdBuild));
  }
  all.push_back({ title, [=] { return build(surface, options)->statistics(); },
    [=] { return build(surface, options); }, 1e300, {} });
}

std::vector<Contender> contenders(
  const Scene& scene, const std::shared_ptr<const Surface>& surface, int threads)
{
  std::vector<Contender> all;
  for (const bool robust : { false, true })
  {
    all.push_back({ robust ? "Embree, robust" : "Embree",
      [&scene, robust]
      {
        BuildStatistics statistics;
        const RawEmbree embree(scene, robust);
        statistics.memory = embree.memory();
        statistics.buildSeconds = embree.commitSeconds();
        return statistics;
      },
      {}, 1e300, {} });
  }
  BuildOptions options;
  options.threads = threads;
  for (const Structure structure : { Structure::WideBvh, Structure::Bvh })
  {
    options.structure = structure;
    for (int build = 0; build < bvhBuildCount; ++build)
    {
      options.bvhBuild = static_cast<BvhBuild>(build);
      addOurs(all, surface, options);
    }
  }
  options.bvhBuild = BvhBuild::BinnedSah;
  for (const Structure structure : Registry::instance().structures())
  {
    const int builds = structure == Structure::KdTree ? kdBuildCount : 1;
    for (int build = 0;
         structure >= Structure::Grid && structure < Structure::Embree && build < builds; ++build)
    {
      options.structure = structure;
      options.kdBuild = static_cast<KdBuild>(build);
      addOurs(all, surface, options);
    }
  }
  return all;
}

/// Nanoseconds of processor time per ray that bounced off what the camera sees; exact, one thread.
double traced(const Accelerator& accelerator, const Rays& rays)
{
  std::vector<Hit> hits(rays.size());
  QueryOptions query;
  query.precision = Precision::Exact;
  query.threads = 1;
  double best = 1e300;
  for (int r = 0; r < 3; ++r)
  {
    const double start = now(true);
    accelerator.closest(rays.batch(), hits.data(), query);
    best = std::min(best, now(true) - start);
  }
  return rays.size() == 0 ? 0.0 : 1e9 * best / static_cast<double>(rays.size());
}

Scene chosen(const std::string& name)
{
  if (name.rfind("terrain:", 0) == 0)
  {
    const data::Mesh mesh = data::terrain(std::atoi(name.c_str() + 8));
    Scene scene;
    scene.name = name;
    scene.points.assign(mesh.points.begin(), mesh.points.end());
    for (std::size_t c = 0; c + 1 < mesh.offsets.size(); ++c)
    {
      for (auto j = mesh.offsets[c] + 1; j + 1 < mesh.offsets[c + 1]; ++j)
      {
        const auto corner = [&](std::int64_t k)
        { return static_cast<std::uint32_t>(mesh.connectivity[static_cast<std::size_t>(k)]); };
        scene.triangles.push_back({ corner(mesh.offsets[c]), corner(j), corner(j + 1) });
      }
    }
    return scene;
  }
  for (Scene& scene : builtInScenes())
  {
    if (name == scene.name)
    {
      return std::move(scene);
    }
  }
  return readObj(name);
}

void measure(const Scene& scene, int threads, int repeats, const std::string& only)
{
  const auto surface = scene.surface();
  std::vector<Contender> all = contenders(scene, surface, threads);
  all.erase(std::remove_if(all.begin(), all.end(),
              [&](const Contender& c) { return c.name.find(only) == std::string::npos; }),
    all.end());
  for (int r = 0; r < repeats; ++r)
  {
    for (Contender& c : all)
    {
      const double start = now(threads == 1);
      c.statistics = c.build();
      const double time = now(threads == 1) - start;
      // Embree copies the triangles first, which is not its build.
      c.best = std::min(c.best, c.name.rfind("Embree", 0) == 0 ? c.statistics.buildSeconds : time);
    }
  }
  const Rays camera = cameraRays(scene, 200);
  std::vector<Hit> seen(camera.size());
  build(surface)->closest(camera.batch(), seen.data());
  const Rays rays = bounces(*surface, camera, seen);
  const auto triangles = static_cast<double>(scene.triangles.size());
  std::printf("\n%s, %.0f triangles, threads %d, best of %d\n\n"
              "| structure | build [ms] | bytes per triangle | expected cost | references per "
              "triangle | nodes | ray [ns] |\n| --- | --- | --- | --- | --- | --- | --- |\n",
    scene.name.c_str(), triangles, threads, repeats);
  for (const Contender& c : all)
  {
    std::printf("| %s | %.1f | %.0f | %.2f | %.2f | %zu | %.0f |\n", c.name.c_str(), 1e3 * c.best,
      static_cast<double>(c.statistics.memory) / triangles, c.statistics.sahCost,
      c.statistics.duplication, c.statistics.nodes,
      c.accelerator ? traced(*c.accelerator(), rays) : 0.0);
  }
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    const int threads = argc > 2 ? std::atoi(argv[2]) : 1;
    const int repeats = argc > 3 ? std::atoi(argv[3]) : 3;
    const tbb::global_control limit(
      tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(std::max(threads, 1)));
    std::vector<std::string> names = { "torus", "city", "stadium" };
    if (argc > 1)
    {
      names = { argv[1] };
    }
    for (const std::string& name : names)
    {
      measure(chosen(name), threads, repeats, argc > 4 ? argv[4] : "");
    }
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "Builds: %s\n", error.what());
    return 1;
  }
  return 0;
}
