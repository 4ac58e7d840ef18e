// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Our structures against Embree, one thread, on the same rays:
//   RaysVersusEmbree [torus|city|stadium|surface.obj [width [repeats]]]
// Without a scene: the three built-in ones. Rays and points are floats; every contender reads the
// same arrays and writes its hits (a Hit, or a byte for occlusion). Processor time, the best of the
// repeats; contenders take turns, so that a disturbance does not hit one alone. Prints tables of
// nanoseconds per ray in Markdown.
#include "Accel/Accelerator.h"
#include "RaysEmbree.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <thread>

namespace
{

using namespace lumitree;
using namespace lumitree::benchmarks;

double processorTime()
{
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double timed(const std::function<void()>& work)
{
  const double start = processorTime();
  work();
  return processorTime() - start;
}

struct Contender
{
  std::string name;
  double build = 0.0; ///< [s]
  std::size_t memory = 0;
  std::function<void(const Rays&, Hit*)> closest;
  std::function<void(const Rays&, std::uint8_t*)> any;
  std::vector<double> best; ///< per kind of rays [s]
  std::vector<std::size_t> hits;
};

void addOurs(
  std::vector<Contender>& all, const std::shared_ptr<const Surface>& surface, Structure structure)
{
  BuildOptions options;
  options.structure = structure;
  std::shared_ptr<const Accelerator> accelerator;
  const double build = timed([&] { accelerator = lumitree::build(surface, options); });
  for (const Precision precision : { Precision::Fast, Precision::Watertight, Precision::Exact })
  {
    QueryOptions query;
    query.precision = precision;
    query.threads = 1;
    Contender c;
    c.name = std::string(name(structure)) + ", " + std::string(name(precision));
    c.build = build;
    c.memory = accelerator->statistics().memory;
    c.closest = [=](const Rays& rays, Hit* hits)
    { accelerator->closest(rays.batch(), hits, query); };
    c.any = [=](const Rays& rays, std::uint8_t* hit)
    { accelerator->any(rays.batch(), hit, query); };
    all.push_back(std::move(c));
  }
}

std::string addEmbree(std::vector<Contender>& all, const Scene& scene, bool robust)
{
  std::shared_ptr<const RawEmbree> embree;
  const double build = timed([&] { embree = std::make_shared<const RawEmbree>(scene, robust); });
  for (const unsigned int packet : { 1u, 8u, 16u })
  {
    Contender c;
    c.name = std::string("Embree ") + (robust ? "robust" : "fast") +
      (packet == 1 ? "" : ", packets of " + std::to_string(packet));
    c.build = build;
    c.memory = embree->memory();
    c.closest = [=](const Rays& rays, Hit* hits) { embree->closest(rays, packet, hits); };
    c.any = [=](const Rays& rays, std::uint8_t* hit) { embree->any(rays, packet, hit); };
    all.push_back(std::move(c));
  }
  return embree->version();
}

/// The best time of each contender, and its hits.
void race(std::vector<Contender>& all, const Rays& rays, int repeats)
{
  std::vector<Hit> hits(rays.size());
  std::vector<std::uint8_t> hit(rays.size());
  for (Contender& c : all)
  {
    c.best.push_back(std::numeric_limits<double>::infinity());
    c.hits.push_back(0);
  }
  for (int r = 0; r < repeats; ++r)
  {
    for (Contender& c : all)
    {
      const double time =
        timed([&] { rays.any ? c.any(rays, hit.data()) : c.closest(rays, hits.data()); });
      c.best.back() = std::min(c.best.back(), time);
      c.hits.back() = static_cast<std::size_t>(rays.any
          ? std::count(hit.begin(), hit.end(), 1)
          : std::count_if(
              hits.begin(), hits.end(), [](const Hit& h) { return h.primitive != noPrimitive; }));
    }
  }
}

void require(bool condition, const std::string& what)
{
  if (!condition)
  {
    throw std::runtime_error(what);
  }
}

/// That the rays are what they are meant to be, and that contenders answered the same question.
void check(const std::vector<Contender>& all, const Rays& rays)
{
  const auto share = [&](std::size_t hits)
  { return static_cast<double>(hits) / static_cast<double>(rays.size()); };
  const double truth = share(all.front().hits.back());
  require(rays.kind != "camera" || truth >= 0.05, "fewer than 5 % of the camera's rays hit");
  require(rays.kind != "occlusion" || (truth > 0.0 && truth < 1.0), "no shadow, or no light");
  for (const Contender& c : all)
  {
    require(std::fabs(share(c.hits.back()) - truth) < 2e-3, c.name + " hits something else");
  }
}

void printScene(
  const Scene& scene, const std::vector<Rays>& kinds, const std::vector<Contender>& all)
{
  std::printf("\n%s, %zu triangles", scene.name.c_str(), scene.triangles.size());
  for (std::size_t k = 0; k < kinds.size(); ++k)
  {
    std::printf("; %s: %zu rays, %.1f %% hit", kinds[k].kind.c_str(), kinds[k].size(),
      100.0 * static_cast<double>(all.front().hits[k]) / static_cast<double>(kinds[k].size()));
  }
  std::printf("\n\n| [ns per ray] | camera | incoherent | occlusion | build [ms] | memory [MB] |\n"
              "| --- | --- | --- | --- | --- | --- |\n");
  for (const Contender& c : all)
  {
    std::printf("| %s |", c.name.c_str());
    for (std::size_t k = 0; k < kinds.size(); ++k)
    {
      std::printf(" %.0f |", 1e9 * c.best[k] / static_cast<double>(kinds[k].size()));
    }
    std::printf(" %.0f | %.1f |\n", 1e3 * c.build, 1e-6 * static_cast<double>(c.memory));
  }
  std::fflush(stdout);
}

std::string measure(const Scene& scene, int width, int repeats)
{
  const auto surface = scene.surface();
  std::vector<Contender> all;
  addOurs(all, surface, Structure::WideBvh);
  addOurs(all, surface, Structure::Bvh);
  std::string version = addEmbree(all, scene, false);
  addEmbree(all, scene, true);

  std::vector<Rays> kinds = { cameraRays(scene, width) };
  std::vector<Hit> seen(kinds.front().size());
  all.front().closest(kinds.front(), seen.data());
  kinds.push_back(bounces(*surface, kinds.front(), seen));
  kinds.push_back(occlusion(scene, *surface, kinds.front(), seen));
  for (const Rays& rays : kinds)
  {
    race(all, rays, repeats);
    check(all, rays);
  }
  printScene(scene, kinds, all);
  return version;
}

std::string processor()
{
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
  {
    if (line.rfind("model name", 0) == 0)
    {
      return line.substr(line.find(':') + 2);
    }
  }
  return "unknown processor";
}

/// All that are built in, one of them, or a file.
std::vector<Scene> chosenScenes(const std::string& name)
{
  std::vector<Scene> chosen;
  for (Scene& scene : builtInScenes())
  {
    if (name.empty() || name == scene.name)
    {
      chosen.push_back(std::move(scene));
    }
  }
  return chosen.empty() ? std::vector<Scene>{ readObj(name) } : chosen;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    // Builders, too, on one thread: Embree's and ours both go by this.
    const tbb::global_control serial(tbb::global_control::max_allowed_parallelism, 1);
    const auto scenes = chosenScenes(argc > 1 ? argv[1] : "");
    const int width = argc > 2 ? std::atoi(argv[2]) : 512;
    const int repeats = argc > 3 ? std::atoi(argv[3]) : 3;
    std::string version;
    for (const Scene& scene : scenes)
    {
      version = measure(scene, width, repeats);
    }
    std::printf("\n%s, %u logical cores, one used; Embree %s; best of %d, processor time\n",
      processor().c_str(), std::thread::hardware_concurrency(), version.c_str(), repeats);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "RaysVersusEmbree: %s\n", error.what());
    return 1;
  }
  return 0;
}
