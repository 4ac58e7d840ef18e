// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rays of ours beside Embree, vtkStaticCellLocator and CGAL, one thread, the same rays:
//   Rays [--surface=FILE.obj] [flags of Google Benchmark]
// Four scenes; the first, and the third that is made of it, are those of the Wavefront file where
// one is given. Every contender reads the same arrays of floats and writes its hits to the same (a
// Hit, or a byte for occlusion). One iteration is a batch; repetitions of all contenders come in
// random order, so that a disturbance hits all alike. A contender that hits something else than the
// exact answer, but for 2 rays in 1000, is an error
// (vtkStaticCellLocator excepted, whose hits are told), and so is a scene that is not seen.
// Docs/make_benchmarks.py makes the tables of it.
#include "RaysContenders.h"

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>

namespace
{

using namespace lumitree;
using namespace lumitree::benchmarks;

constexpr const char* kinds[] = { "camera", "incoherent", "occlusion" };

bool failed = false;

void fail(benchmark::State& state, const std::string& problem)
{
  failed = true;
  state.SkipWithError(problem.c_str());
}

std::size_t trace(benchmark::State& state, const Contender& contender, const Rays& rays)
{
  static std::vector<Hit> hits;
  static std::vector<std::uint8_t> hit;
  hits.resize(std::max(hits.size(), rays.size()));
  hit.resize(std::max(hit.size(), rays.size()));
  for (auto _ : state)
  {
    rays.any ? contender.any(rays, hit.data()) : contender.closest(rays, hits.data());
  }
  const auto end = static_cast<std::ptrdiff_t>(rays.size());
  return static_cast<std::size_t>(rays.any
      ? std::count(hit.begin(), hit.begin() + end, 1)
      : std::count_if(hits.begin(), hits.begin() + end,
          [](const Hit& h) { return h.primitive != noPrimitive; }));
}

void race(benchmark::State& state, Course& course, const Contender& contender, std::size_t kind)
{
  try
  {
    const Rays& rays = course.rays(kind);
    contender.prepare(course);
    const std::size_t n = std::min(contender.limit, rays.size());
    const std::size_t hits = trace(state, contender, n == rays.size() ? rays : sampled(rays, n));
    const auto count = static_cast<double>(n);
    const double share = static_cast<double>(hits) / count;
    const double truth = course.hitShare(kind);
    // A sample may differ by its coarseness.
    if (!contender.misses &&
      std::fabs(share - truth) > 2e-3 + (n == rays.size() ? 0.0 : 2.0 / std::sqrt(count)))
    {
      fail(state,
        contender.name + " hits " + std::to_string(share) + " of the rays, not " +
          std::to_string(truth));
    }
    state.counters["rays"] = count;
    state.counters["hit_share"] = share;
  }
  catch (const std::exception& error)
  {
    fail(state, error.what());
  }
}

void timeBuild(benchmark::State& state, Course& course, const Builder& builder)
{
  try
  {
    course.surface();
    BuildCost cost;
    for (auto _ : state)
    {
      cost = builder.build(course);
      state.SetIterationTime(cost.seconds);
    }
    const auto triangles = static_cast<double>(course.scene.triangles.size());
    state.counters["triangles"] = triangles;
    state.counters["bytes_per_triangle"] = static_cast<double>(cost.bytes) / triangles;
  }
  catch (const std::exception& error)
  {
    fail(state, error.what());
  }
}

void enlist(const std::shared_ptr<Course>& course)
{
  const std::string& scene = course->scene.name;
  for (const Contender& contender : contenders())
  {
    if (course->scene.triangles.size() > contender.mostTriangles)
    {
      continue;
    }
    for (const std::size_t kind : contender.kinds)
    {
      benchmark::RegisterBenchmark((scene + "/" + kinds[kind] + "/" + contender.name).c_str(),
        [=](benchmark::State& state) { race(state, *course, contender, kind); })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
    }
  }
  for (const Builder& builder : builders())
  {
    benchmark::RegisterBenchmark((scene + "/build/" + builder.name).c_str(),
      [=](benchmark::State& state) { timeBuild(state, *course, builder); })
      ->Iterations(1)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
  }
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    // Builders, too, on one thread: Embree's and ours both go by this.
    const tbb::global_control serial(tbb::global_control::max_allowed_parallelism, 1);
    std::string random = "--benchmark_enable_random_interleaving=true";
    std::string repetitions = "--benchmark_repetitions=5";
    std::vector<char*> arguments = { argv[0], random.data(), repetitions.data() };
    std::string surface;
    for (int i = 1; i < argc; ++i)
    {
      const std::string argument = argv[i];
      if (argument.rfind("--surface=", 0) == 0)
      {
        surface = argument.substr(10);
      }
      else
      {
        arguments.push_back(argv[i]);
      }
    }
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data()))
    {
      return 1;
    }
    benchmark::AddCustomContext("embree", embreeVersion());
    for (Scene& scene : builtInScenes(surface))
    {
      const auto course = std::make_shared<Course>(std::move(scene));
      benchmark::AddCustomContext(
        course->scene.name, std::to_string(course->scene.triangles.size()));
      enlist(course);
    }
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "Rays: %s\n", error.what());
    return 1;
  }
  return failed ? 1 : 0;
}
