// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Our scalar structures against another binary hierarchy, version 2 of madmann91/bvh
// (https://github.com/madmann91/bvh), one thread, on the same rays:
//   RaysVersusBvh2 [torus|city|stadium|surface.obj [width [repeats [kind [contender]]]]]
// Built where LUMITREE_BVH2_INCLUDE_DIR names the directory that holds bvh/v2/bvh.h. Processor
// time, medians over the repeats; contenders take turns. Prints tables in Markdown. With a kind of
// rays and part of a contender's name only that is run, for those who count instructions.
#include "Accel/Accelerator.h"
#include "RaysScenes.h"

#include <bvh/v2/bvh.h>
#include <bvh/v2/default_builder.h>
#include <bvh/v2/node.h>
#include <bvh/v2/stack.h>
#include <bvh/v2/tri.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <functional>

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

/// Expected cost of a ray that meets the root: a node costs 1, a leaf its triangles or its blocks
/// of four.
struct Cost
{
  double triangles = 0.0;
  double blocks = 0.0;

  void add(double area, bool leaf, std::size_t count)
  {
    this->triangles += area * (leaf ? static_cast<double>(count) : 1.0);
    this->blocks += area * (leaf ? static_cast<double>((count + 3) / 4) : 1.0);
  }
};

/// What a contender's name must have in it to be built.
std::string only;

bool isWanted(const std::string& title)
{
  return title.find(only) != std::string::npos;
}

struct Contender
{
  std::string name;
  double build = 0.0;
  Cost cost;
  std::function<void(const Rays&, std::vector<Hit>&)> closest;
  std::function<void(const Rays&, std::vector<std::uint8_t>&)> any;
  std::vector<double> times;
  std::size_t hits = 0;

  [[nodiscard]] double median()
  {
    std::sort(this->times.begin(), this->times.end());
    return this->times[this->times.size() / 2];
  }
};

/// The other's tree and triangles, permuted into the order of its leaves as its own benchmark can.
template <class T>
class Bvh2
{
  using Node = bvh::v2::Node<T, 3>;
  using Vec = bvh::v2::Vec<T, 3>;
  using Tri = bvh::v2::Tri<T, 3>;

public:
  using Config = typename bvh::v2::DefaultBuilder<Node>::Config;

  Bvh2(const Scene& scene, const Config& config)
  {
    std::vector<bvh::v2::BBox<T, 3>> boxes;
    std::vector<Vec> centres;
    std::vector<Tri> triangles;
    for (const Triangle& t : scene.triangles)
    {
      const auto corner = [&](std::size_t i)
      {
        const float* const p = scene.points.data() + 3 * std::size_t{ t[i] };
        return Vec(static_cast<T>(p[0]), static_cast<T>(p[1]), static_cast<T>(p[2]));
      };
      triangles.emplace_back(corner(0), corner(1), corner(2));
      boxes.push_back(triangles.back().get_bbox());
      centres.push_back(triangles.back().get_center());
    }
    this->bvh_ = bvh::v2::DefaultBuilder<Node>::build(boxes, centres, config);
    for (const std::size_t id : this->bvh_.prim_ids)
    {
      this->triangles_.emplace_back(triangles[id]);
    }
  }

  [[nodiscard]] Cost cost() const
  {
    Cost cost;
    const double root = static_cast<double>(this->bvh_.nodes[0].get_bbox().get_half_area());
    for (const Node& node : this->bvh_.nodes)
    {
      cost.add(static_cast<double>(node.get_bbox().get_half_area()) / root, node.is_leaf(),
        node.index.prim_count());
    }
    return cost;
  }

  template <bool any, bool robust, class Take>
  void trace(const Rays& rays, const Take& take) const
  {
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      const float* const o = rays.origins.data() + 3 * i;
      const float* const d = rays.directions.data() + 3 * i;
      bvh::v2::Ray<T, 3> ray(
        Vec(o[0], o[1], o[2]), Vec(d[0], d[1], d[2]), T{ 0 }, static_cast<T>(rays.tMax));
      Hit hit;
      // One for each ray: a walk that stops at any hit leaves it as it is.
      bvh::v2::SmallStack<typename bvh::v2::Bvh<Node>::Index, 64> stack;
      this->bvh_.template intersect<any, robust>(ray, this->bvh_.get_root().index, stack,
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t k = begin; k < end; ++k)
          {
            if (const auto found = this->triangles_[k].intersect(ray))
            {
              hit.primitive = static_cast<PrimitiveId>(this->bvh_.prim_ids[k]);
              std::tie(ray.tmax, hit.u, hit.v) = *found;
              if (any)
              {
                return true;
              }
            }
          }
          return hit.primitive != noPrimitive;
        });
      hit.t = static_cast<double>(ray.tmax);
      take(i, hit);
    }
  }

private:
  bvh::v2::Bvh<Node> bvh_;
  std::vector<bvh::v2::PrecomputedTri<T>> triangles_;
};

template <class T, bool robust>
void addTheirs(std::vector<Contender>& all, const Scene& scene, const std::string& title,
  const typename Bvh2<T>::Config& config)
{
  if (!isWanted(title))
  {
    return;
  }
  Contender c;
  const double start = processorTime();
  const auto tree = std::make_shared<const Bvh2<T>>(scene, config);
  c.build = processorTime() - start;
  c.name = title;
  c.cost = tree->cost();
  c.closest = [tree](const Rays& rays, std::vector<Hit>& hits)
  {
    tree->template trace<false, robust>(
      rays, [&](std::size_t i, const Hit& hit) { hits[i] = hit; });
  };
  c.any = [tree](const Rays& rays, std::vector<std::uint8_t>& hit)
  {
    tree->template trace<true, robust>(
      rays, [&](std::size_t i, const Hit& h) { hit[i] = h.primitive != noPrimitive ? 1 : 0; });
  };
  all.push_back(std::move(c));
}

void addOurs(std::vector<Contender>& all, const std::shared_ptr<const Surface>& surface,
  const BuildOptions& options, const std::string& title, Precision precision)
{
  Contender c;
  c.name = title + ", " + std::string(name(precision));
  if (!isWanted(c.name))
  {
    return;
  }
  const double start = processorTime();
  const auto tree = build(surface, options);
  c.build = processorTime() - start;
  const HierarchyView view = tree->hierarchy();
  for (const HierarchyNode& node : view.nodes)
  {
    c.cost.add(node.box.area() / view.nodes[0].box.area(), node.leaf, node.referenceCount);
  }
  QueryOptions query;
  query.threads = 1;
  query.precision = precision;
  c.closest = [=](const Rays& rays, std::vector<Hit>& hits)
  { tree->closest(rays.batch(), hits.data(), query); };
  c.any = [=](const Rays& rays, std::vector<std::uint8_t>& hit)
  { tree->any(rays.batch(), hit.data(), query); };
  all.push_back(std::move(c));
}

std::vector<Contender> contenders(const Scene& scene, const std::shared_ptr<const Surface>& surface)
{
  using Float = Bvh2<float>::Config;
  using Double = Bvh2<double>::Config;
  using Quality = bvh::v2::DefaultBuilder<bvh::v2::Node<float, 3>>::Quality;
  std::vector<Contender> all;
  Float config;
  addTheirs<float, false>(all, scene, "bvh v2, float", config);
  addTheirs<float, true>(all, scene, "bvh v2, float, robust", config);
  addTheirs<double, true>(all, scene, "bvh v2, double, robust", Double{});
  config.quality = Quality::Low;
  addTheirs<float, true>(all, scene, "bvh v2, float, robust, binned", config);
  // Leaves of up to four for one: our cost.
  config.sah = bvh::v2::SplitHeuristic<float>(2);
  config.max_leaf_size = 4;
  addTheirs<float, true>(all, scene, "bvh v2, float, robust, binned, blocks of 4", config);
  config.quality = Quality::Medium;
  addTheirs<float, true>(all, scene, "bvh v2, float, robust, swept, blocks of 4", config);
  config.quality = Quality::High;
  addTheirs<float, true>(all, scene, "bvh v2, float, robust, reinserted, blocks of 4", config);
  BuildOptions options;
  options.threads = 1;
  options.structure = Structure::Bvh;
  for (const BvhBuild build : { BvhBuild::BinnedSah, BvhBuild::SweepSah })
  {
    options.bvhBuild = build;
    const std::string title = "bvh, " + std::string(name(build));
    addOurs(all, surface, options, title, Precision::Fast);
    addOurs(all, surface, options, title, Precision::Exact);
  }
  options.structure = Structure::KdTree;
  addOurs(all, surface, options, "kd_tree", Precision::Fast);
  addOurs(all, surface, options, "kd_tree", Precision::Exact);
  return all;
}

void race(std::vector<Contender>& all, const Rays& rays, int repeats)
{
  std::vector<Hit> hits(rays.size());
  std::vector<std::uint8_t> hit(rays.size());
  for (Contender& c : all)
  {
    c.times.clear();
  }
  for (int r = 0; r < repeats; ++r)
  {
    for (Contender& c : all)
    {
      const double start = processorTime();
      if (rays.any)
      {
        c.any(rays, hit);
      }
      else
      {
        c.closest(rays, hits);
      }
      c.times.push_back(1e9 * (processorTime() - start) / static_cast<double>(rays.size()));
      c.hits = static_cast<std::size_t>(rays.any
          ? std::count(hit.begin(), hit.end(), 1)
          : std::count_if(
              hits.begin(), hits.end(), [](const Hit& h) { return h.primitive != noPrimitive; }));
    }
  }
}

void measure(const Scene& scene, int width, int repeats, const std::string& kind)
{
  const auto surface = scene.surface();
  std::vector<Contender> all = contenders(scene, surface);
  if (all.empty())
  {
    return;
  }
  const Rays camera = cameraRays(scene, width);
  std::vector<Hit> seen(camera.size());
  build(surface)->closest(camera.batch(), seen.data());
  std::vector<std::vector<std::string>> cells(all.size());
  std::vector<std::string> heads;
  for (const Rays& rays :
    { camera, bounces(*surface, camera, seen), occlusion(bounces(*surface, camera, seen)) })
  {
    if (rays.kind.find(kind) == std::string::npos)
    {
      continue;
    }
    race(all, rays, repeats);
    heads.push_back(rays.kind + " [ns]");
    const double reference = all.front().median();
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      char text[96];
      std::snprintf(text, sizeof(text), "%.0f (%.2f; %.2f %%)", all[i].median(),
        all[i].median() / reference,
        100.0 * static_cast<double>(all[i].hits) / static_cast<double>(rays.size()));
      cells[i].push_back(text);
    }
  }
  std::printf("\n%s, %zu triangles, median of %d\n\n| contender | build [ms] | cost, triangles | "
              "cost, blocks of 4 |",
    scene.name.c_str(), surface->size(), repeats);
  for (const std::string& head : heads)
  {
    std::printf(" %s (of the first; hits) |", head.c_str());
  }
  std::printf("\n| --- | --- | --- | --- |");
  for (std::size_t i = 0; i < heads.size(); ++i)
  {
    std::printf(" --- |");
  }
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    std::printf("\n| %s | %.0f | %.2f | %.2f |", all[i].name.c_str(), 1e3 * all[i].build,
      all[i].cost.triangles, all[i].cost.blocks);
    for (const std::string& cell : cells[i])
    {
      std::printf(" %s |", cell.c_str());
    }
  }
  std::printf("\n");
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    const int width = argc > 2 ? std::atoi(argv[2]) : 256;
    const int repeats = std::max(argc > 3 ? std::atoi(argv[3]) : 5, 1);
    only = argc > 5 ? argv[5] : "";
    std::vector<Scene> scenes;
    if (argc > 1 && std::string(argv[1]).find('.') != std::string::npos)
    {
      scenes.push_back(readObj(argv[1]));
    }
    else
    {
      scenes = builtInScenes();
    }
    for (const Scene& scene : scenes)
    {
      if (argc < 2 || scenes.size() == 1 || scene.name == argv[1])
      {
        measure(scene, width, repeats, argc > 4 ? argv[4] : "");
      }
    }
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "RaysVersusBvh2: %s\n", error.what());
    return 1;
  }
  return 0;
}
