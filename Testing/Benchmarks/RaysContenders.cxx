// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RaysContenders.h"

#include "Accel/Accelerator.h"
#if LUMITREE_EMBREE_MAJOR
#include "RaysEmbree.h"
#include "RaysSort.h"
#endif
#if LUMITREE_BENCHMARK_LOCATOR
#include "RaysLocator.h"
#endif
#if LUMITREE_BENCHMARK_CGAL
#include "Accel/Reference/CGAL/CgalReference.h"
#endif

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <stdexcept>

namespace lumitree::benchmarks
{
namespace
{

constexpr std::size_t noLimit = std::numeric_limits<std::size_t>::max();

double processorTime()
{
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

QueryOptions oneThread(Precision precision)
{
  QueryOptions query;
  query.precision = precision;
  query.threads = 1;
  return query;
}

using AcceleratorPlace = std::shared_ptr<std::shared_ptr<const Accelerator>>;

void addOurs(std::vector<Contender>& all, const AcceleratorPlace& place, BuildOptions options,
  Precision precision, const std::string& title, std::size_t limit)
{
  Contender c;
  c.name = title;
  c.limit = limit;
  c.prepare = [=](Course& course)
  {
    if (!*place)
    {
      *place = build(course.surface(), options);
    }
  };
  const QueryOptions query = oneThread(precision);
  c.closest = [=](const Rays& rays, Hit* hits) { (*place)->closest(rays.batch(), hits, query); };
  c.any = [=](const Rays& rays, std::uint8_t* hit) { (*place)->any(rays.batch(), hit, query); };
  all.push_back(std::move(c));
}

#if LUMITREE_EMBREE_MAJOR

void addEmbree(std::vector<Contender>& all, bool robust)
{
  const auto place = std::make_shared<std::shared_ptr<const RawEmbree>>();
  const auto order = std::make_shared<RayOrder>();
  const std::vector<std::string> interfaces = RawEmbree::interfaces();
  for (std::size_t i = 0; i < interfaces.size(); ++i)
  {
    for (const bool sorted : { false, true })
    {
      for (const bool coherent : { false, true })
      {
        Contender c;
        c.name = std::string("Embree ") + (robust ? "robust" : "fast") + ", " + interfaces[i] +
          (sorted ? ", sorted" : "") + (coherent ? ", coherent" : "");
        c.limit = noLimit;
        c.prepare = [=](Course& course)
        {
          if (!*place)
          {
            *place = std::make_shared<const RawEmbree>(course.scene, robust);
          }
        };
        const auto call = [=](const Rays& rays) {
          return EmbreeCall{ i, coherent, sorted ? order->sort(rays) : nullptr };
        };
        c.closest = [=](const Rays& rays, Hit* hits) { (*place)->closest(rays, call(rays), hits); };
        c.any = [=](const Rays& rays, std::uint8_t* hit) { (*place)->any(rays, call(rays), hit); };
        // A camera's rays come sorted; rays in random order are not coherent.
        c.kinds = sorted ? std::vector<std::size_t>{ 1, 2 }
          : coherent     ? std::vector<std::size_t>{ 0 }
                         : std::vector<std::size_t>{ 0, 1, 2 };
        all.push_back(std::move(c));
      }
    }
  }
}

#endif

#if LUMITREE_BENCHMARK_LOCATOR

void addLocator(std::vector<Contender>& all)
{
  const auto place = std::make_shared<std::shared_ptr<const RawLocator>>();
  Contender c;
  c.name = "vtkStaticCellLocator";
  c.limit = 500;   // milliseconds a ray where a scene is large and what is in it small
  c.misses = true; // where walls lie in the bounds of the surface
  c.prepare = [=](Course& course)
  {
    if (!*place)
    {
      *place = std::make_shared<const RawLocator>(surfaceData(course.scene));
    }
  };
  c.closest = [=](const Rays& rays, Hit* hits) { (*place)->closest(rays, 0, rays.size(), hits); };
  c.kinds = { 0, 1 }; // it has no query for any hit
  all.push_back(std::move(c));
}

#endif

} // namespace

const std::shared_ptr<const Surface>& Course::surface()
{
  if (!this->surface_)
  {
    this->surface_ = this->scene.surface();
  }
  return this->surface_;
}

const Rays& Course::rays(std::size_t kind)
{
  if (this->rays_.empty())
  {
    const auto tree = build(this->surface());
    const QueryOptions query = oneThread(Precision::Exact);
    std::vector<Rays> all = { cameraRays(this->scene) };
    std::vector<double> shares;
    for (std::size_t k = 0; k < 2; ++k)
    {
      std::vector<Hit> hits(all[k].size());
      tree->closest(all[k].batch(), hits.data(), query);
      const auto count = std::count_if(
        hits.begin(), hits.end(), [](const Hit& hit) { return hit.primitive != noPrimitive; });
      shares.push_back(static_cast<double>(count) / static_cast<double>(hits.size()));
      const double expected = this->scene.hitShares[k];
      if (expected > 0.0 ? std::fabs(shares[k] - expected) > 5e-3 : k == 0 && shares[k] < 0.05)
      {
        throw std::runtime_error(this->scene.name + ", " + all[k].kind + ": " +
          std::to_string(shares[k]) + " of the rays hit, not " + std::to_string(expected));
      }
      if (k == 0)
      {
        all.push_back(bounces(*this->surface(), all[0], hits));
      }
    }
    all.push_back(occlusion(all[1]));
    shares.push_back(shares[1]);
    this->rays_ = std::move(all);
    this->hitShares_ = std::move(shares);
  }
  return this->rays_[kind];
}

double Course::hitShare(std::size_t kind)
{
  this->rays(kind);
  return this->hitShares_[kind];
}

std::vector<Contender> contenders()
{
  std::vector<Contender> all;
  const auto place = [] { return std::make_shared<std::shared_ptr<const Accelerator>>(); };
  BuildOptions options;
  options.threads = 1;
  options.structure = Structure::WideBvh;
  const AcceleratorPlace wide = place();
  for (const Precision precision : { Precision::Fast, Precision::Watertight, Precision::Exact })
  {
    addOurs(all, wide, options, precision, "wide_bvh " + std::string(name(precision)), noLimit);
  }
  for (const Structure structure :
    { Structure::Bvh, Structure::Grid, Structure::Octree, Structure::KdTree, Structure::BspTree })
  {
    options.structure = structure;
    addOurs(
      all, place(), options, Precision::Exact, std::string(name(structure)) + " exact", 10000);
    // A BSP-tree takes seconds to build, and its builder minutes where triangles are many.
    all.back().mostTriangles = structure == Structure::BspTree ? 100000 : all.back().mostTriangles;
  }
#if LUMITREE_EMBREE_MAJOR
  addEmbree(all, false);
  addEmbree(all, true);
#endif
#if LUMITREE_BENCHMARK_LOCATOR
  addLocator(all);
#endif
#if LUMITREE_BENCHMARK_CGAL
  registerCgal();
  options.structure = Structure::Cgal;
  addOurs(all, place(), options, Precision::Exact, "CGAL EPECK", 1000);
  all.back().mostTriangles = 500000; // a minute and gigabytes for a million
  options.structure = Structure::CgalCartesian;
  addOurs(all, place(), options, Precision::Fast, "CGAL doubles", 10000);
#endif
  return all;
}

std::vector<Builder> builders()
{
  std::vector<Builder> all;
  for (const BvhBuild how : { BvhBuild::BinnedSah, BvhBuild::Morton })
  {
    all.push_back({ "wide_bvh " + std::string(name(how)),
      [how](Course& course)
      {
        BuildOptions options;
        options.structure = Structure::WideBvh;
        options.bvhBuild = how;
        options.threads = 1;
        const auto& surface = course.surface();
        const double start = processorTime();
        const auto tree = build(surface, options);
        return BuildCost{ processorTime() - start, tree->statistics().memory };
      } });
  }
#if LUMITREE_EMBREE_MAJOR
  for (const bool robust : { false, true })
  {
    all.push_back({ robust ? "Embree robust" : "Embree fast",
      [robust](Course& course)
      {
        const RawEmbree embree(course.scene, robust);
        return BuildCost{ embree.commitSeconds(), embree.memory() };
      } });
  }
#endif
#if LUMITREE_BENCHMARK_LOCATOR
  all.push_back({ "vtkStaticCellLocator",
    [](Course& course)
    {
      const auto surface = surfaceData(course.scene);
      const double start = processorTime();
      const RawLocator locator(surface);
      return BuildCost{ processorTime() - start, 0 };
    } });
#endif
  return all;
}

std::string embreeVersion()
{
#if LUMITREE_EMBREE_MAJOR
  Scene triangle;
  triangle.points = { 0, 0, 0, 1, 0, 0, 0, 1, 0 };
  triangle.triangles = { { 0, 1, 2 } };
  return RawEmbree(triangle, false).version();
#else
  return {};
#endif
}

} // namespace lumitree::benchmarks
