// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How time grows with triangles, rays and threads:
//   Growth [most triangles [most rays]]
// By default 16 million and 100 million. On a terrain, wide_bvh, precision exact; rays are made as
// they are traced (RayStream), so that memory does not grow with them. Prints lines
//   what,n,seconds
// with what one of build, camera, incoherent (n triangles, seconds for a million rays), rays (n
// incoherent rays), threads build, threads rays (n threads). Processor time, for threads the
// clock's; the median of three where one takes less than a second. Docs/make_benchmarks.py makes
// tables and pictures of it.
#include "Accel/RayStream.h"
#include "Data/Scenes.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <functional>
#include <stdexcept>
#include <thread>
#include <vector>

namespace
{

using namespace lumitree;

double seconds(clockid_t which)
{
  timespec now{};
  clock_gettime(which, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double timed(const std::function<void()>& work, clockid_t which = CLOCK_PROCESS_CPUTIME_ID)
{
  std::array<double, 3> times{};
  for (std::size_t r = 0; r < times.size(); ++r)
  {
    const double start = seconds(which);
    work();
    times[r] = seconds(which) - start;
    if (r == 0 && times[r] > 1.0)
    {
      return times[r];
    }
  }
  std::sort(times.begin(), times.end());
  return times[1];
}

void print(const char* what, double n, double time)
{
  std::printf("%s,%.0f,%.6g\n", what, n, time);
  std::fflush(stdout);
}

std::shared_ptr<const Surface> terrain(int divisions)
{
  const data::Mesh mesh = data::terrain(divisions);
  std::vector<Triangle> triangles;
  triangles.reserve(2 * static_cast<std::size_t>(mesh.numberOfCells()));
  for (std::size_t i = 0; i + 3 < mesh.connectivity.size(); i += 4)
  {
    const auto corner = [&](std::size_t k)
    { return static_cast<std::uint32_t>(mesh.connectivity[i + k]); };
    triangles.push_back({ corner(0), corner(1), corner(2) });
    triangles.push_back({ corner(0), corner(2), corner(3) });
  }
  return std::make_shared<const Surface>(
    PointArray::from(std::vector<float>(mesh.points.begin(), mesh.points.end())), triangles);
}

/// The number of a ray, well mixed (SplitMix64), as a number in [0, 1).
double random(std::uint64_t i)
{
  i += 0x9e3779b97f4a7c15u;
  i = (i ^ (i >> 30u)) * 0xbf58476d1ce4e5b9u;
  i = (i ^ (i >> 27u)) * 0x94d049bb133111ebu;
  return static_cast<double>((i ^ (i >> 31u)) >> 11u) * 0x1p-53;
}

/// Rays towards the terrain: of a camera above it, or from anywhere above to anywhere below.
class Source
{
public:
  Source(std::size_t count, bool camera)
    : width_(static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count)))))
    , camera_(camera)
  {
    this->stream.size = count;
    this->stream.rays = [this](std::size_t first, std::size_t n) { return this->make(first, n); };
  }

  RayStream stream;

private:
  RayBatch make(std::size_t first, std::size_t count)
  {
    this->origins_.resize(3 * count);
    this->directions_.resize(3 * count);
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::size_t ray = first + i;
      const auto across = static_cast<double>(this->width_);
      const Vec3 from =
        this->camera_ ? Vec3{ 0.5, 0.5, 2.0 } : Vec3{ random(4 * ray), random(4 * ray + 1), 0.5 };
      const Vec3 to = this->camera_
        ? Vec3{ (static_cast<double>(ray % this->width_) + 0.5) / across,
            (static_cast<double>(ray / this->width_) + 0.5) / across, 0.0 }
        : Vec3{ random(4 * ray + 2), random(4 * ray + 3), -0.01 };
      for (std::size_t k = 0; k < 3; ++k)
      {
        this->origins_[3 * i + k] = static_cast<float>(from[k]);
        this->directions_[3 * i + k] = static_cast<float>(to[k] - from[k]);
      }
    }
    RayBatch batch;
    batch.size = count;
    batch.origins = ArrayView(this->origins_.data());
    batch.directions = ArrayView(this->directions_.data());
    return batch;
  }

  std::size_t width_;
  bool camera_;
  std::vector<float> origins_;
  std::vector<float> directions_;
};

/// Traces so many rays, nearly all of which must hit.
void trace(const Accelerator& tree, std::size_t count, bool camera, int threads)
{
  const Source source(count, camera);
  QueryOptions options;
  options.precision = Precision::Exact;
  options.threads = threads;
  std::size_t hits = 0;
  streamClosest(
    tree, source.stream,
    [&](std::size_t, std::size_t n, const Hit* hit)
    {
      hits += static_cast<std::size_t>(
        std::count_if(hit, hit + n, [](const Hit& h) { return h.primitive != noPrimitive; }));
    },
    options);
  if (static_cast<double>(hits) < 0.98 * static_cast<double>(count))
  {
    throw std::runtime_error("more than 2 % of the rays pass by the terrain");
  }
}

BuildOptions wide(int threads)
{
  BuildOptions options;
  options.structure = Structure::WideBvh;
  options.threads = threads;
  return options;
}

void growTriangles(double most)
{
  for (double divisions = 22; 2 * divisions * divisions <= 1.05 * most; divisions *= 2)
  {
    const auto surface = terrain(static_cast<int>(divisions));
    const double n = 2 * divisions * divisions;
    std::shared_ptr<const Accelerator> tree;
    print("build", n, timed([&] { tree = build(surface, wide(1)); }));
    print("camera", n, timed([&] { trace(*tree, 1000000, true, 1); }));
    print("incoherent", n, timed([&] { trace(*tree, 1000000, false, 1); }));
  }
}

void growRaysAndThreads(double most)
{
  const auto surface = terrain(512);
  std::shared_ptr<const Accelerator> tree = build(surface, wide(0));
  for (double n = 1000; n <= 1.05 * most; n *= 10)
  {
    print("rays", n, timed([&] { trace(*tree, static_cast<std::size_t>(n), false, 1); }));
  }
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  for (int threads = 1; threads <= cores; threads = std::max(threads + 1, 2 * threads))
  {
    const tbb::global_control limit(
      tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    print("threads build", threads,
      timed([&] { tree = build(surface, wide(threads)); }, CLOCK_MONOTONIC));
    print("threads rays", threads,
      timed([&] { trace(*tree, 1000000, false, threads); }, CLOCK_MONOTONIC));
  }
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    growTriangles(argc > 1 ? std::atof(argv[1]) : 16e6);
    growRaysAndThreads(argc > 2 ? std::atof(argv[2]) : 100e6);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "Growth: %s\n", error.what());
    return 1;
  }
  return 0;
}
