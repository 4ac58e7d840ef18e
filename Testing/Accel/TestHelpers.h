// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_Accel_TestHelpers_h
#define Lumitree_Testing_Accel_TestHelpers_h

#include "Accel/Accelerator.h"
#include "Accel/Registry.h"
#include "Data/Scenes.h"

#include <cstring>
#include <memory>
#include <random>
#include <vector>

/// Surfaces and rays that several tests of the core share.
namespace lumitree::testing
{

/// A generated scene as triangles (polygons as fans), moved by offset, with points of type T.
template <class T>
std::shared_ptr<const Surface> surfaceOf(const data::Mesh& mesh, const Vec3& offset = { 0, 0, 0 })
{
  std::vector<T> points(mesh.points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i] = static_cast<T>(mesh.points[i] + offset[i % 3]);
  }
  std::vector<Triangle> triangles;
  for (std::size_t c = 0; c + 1 < mesh.offsets.size(); ++c)
  {
    for (auto j = mesh.offsets[c] + 1; j + 1 < mesh.offsets[c + 1]; ++j)
    {
      const auto corner = [&](std::int64_t k)
      { return static_cast<std::uint32_t>(mesh.connectivity[static_cast<std::size_t>(k)]); };
      triangles.push_back({ corner(mesh.offsets[c]), corner(j), corner(j + 1) });
    }
  }
  return std::make_shared<const Surface>(PointArray::from(std::move(points)), std::move(triangles));
}

/// A surface of triangles given corner by corner.
template <class T>
std::shared_ptr<const Surface> surfaceOf(const std::vector<std::array<Vec3, 3>>& triangles)
{
  std::vector<T> points;
  std::vector<Triangle> indices;
  for (const auto& triangle : triangles)
  {
    const auto first = static_cast<std::uint32_t>(points.size() / 3);
    indices.push_back({ first, first + 1, first + 2 });
    for (const Vec3& p : triangle)
    {
      points.insert(
        points.end(), { static_cast<T>(p[0]), static_cast<T>(p[1]), static_cast<T>(p[2]) });
    }
  }
  return std::make_shared<const Surface>(PointArray::from(std::move(points)), std::move(indices));
}

/// Rays with memory of their own.
struct Rays
{
  std::vector<double> origins;
  std::vector<double> directions;
  std::vector<double> tMins;
  std::vector<double> tMaxs;

  void add(const Ray& ray)
  {
    this->origins.insert(this->origins.end(), ray.origin.begin(), ray.origin.end());
    this->directions.insert(this->directions.end(), ray.direction.begin(), ray.direction.end());
    this->tMins.push_back(ray.tMin);
    this->tMaxs.push_back(ray.tMax);
  }

  void add(const Vec3& origin, const Vec3& direction) { this->add(Ray{ origin, direction }); }

  [[nodiscard]] std::size_t size() const { return this->origins.size() / 3; }

  [[nodiscard]] RayBatch batch() const
  {
    RayBatch batch;
    batch.size = this->size();
    batch.origins = ArrayView(this->origins.data());
    batch.directions = ArrayView(this->directions.data());
    batch.tMins = ArrayView(this->tMins.data());
    batch.tMaxs = ArrayView(this->tMaxs.data());
    return batch;
  }
};

/// Uniform numbers that are the same everywhere (std distributions are not).
class Uniform
{
public:
  explicit Uniform(unsigned seed)
    : engine_(seed)
  {
  }
  double operator()(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(this->engine_()) / 4294967296.0);
  }
  std::size_t index(std::size_t n) { return this->engine_() % n; }

private:
  std::mt19937 engine_;
};

/// Rays in all directions from in and around a box, some aimed exactly at vertices and at edge
/// midpoints of the surface.
inline Rays raysAround(const Surface& surface, std::size_t count, unsigned seed)
{
  Uniform uniform(seed);
  const Box box = surface.bounds();
  const Vec3 size = box.size();
  Rays rays;
  for (std::size_t i = 0; i < count; ++i)
  {
    Vec3 origin;
    Vec3 target;
    for (int k = 0; k < 3; ++k)
    {
      origin[k] = uniform(box.lower[k] - 0.6 * size[k] - 0.01, box.upper[k] + 0.6 * size[k] + 0.01);
      target[k] = uniform(box.lower[k], box.upper[k]);
    }
    const auto corners = surface.vertices(static_cast<PrimitiveId>(uniform.index(surface.size())));
    if (i % 4 == 1)
    {
      target = corners[uniform.index(3)];
    }
    else if (i % 4 == 2)
    {
      target = 0.5 * (corners[0] + corners[1]);
    }
    rays.add(origin, target - origin);
  }
  return rays;
}

inline BuildOptions optionsOf(Structure structure, BvhBuild build = BvhBuild::BinnedSah)
{
  BuildOptions options;
  options.structure = structure;
  options.bvhBuild = build;
  return options;
}

inline constexpr std::array<Precision, precisionCount> everyPrecision = { Precision::Fast,
  Precision::Watertight, Precision::Exact };

/// Every structure of our own that this process offers (references make promises of their own),
/// BVHs and KD-trees once per way to build them.
inline std::vector<BuildOptions> ownStructures()
{
  std::vector<BuildOptions> all;
  for (const Structure structure : Registry::instance().structures())
  {
    if (structure < Structure::Embree)
    {
      all.push_back(optionsOf(structure));
    }
  }
  all.push_back(optionsOf(Structure::Bvh, BvhBuild::LongestAxisMedian));
  all.push_back(optionsOf(Structure::Bvh, BvhBuild::SweepSah));
  all.push_back(optionsOf(Structure::WideBvh, BvhBuild::SpatialSplits));
  all.push_back(optionsOf(Structure::WideBvh, BvhBuild::Morton));
  all.push_back(optionsOf(Structure::KdTree));
  all.back().kdBuild = KdBuild::SpatialMedian;
  return all;
}

inline std::string label(const BuildOptions& options)
{
  const bool kdTree = options.structure == Structure::KdTree;
  return std::string(name(options.structure)) + ", " +
    std::string(kdTree ? name(options.kdBuild) : name(options.bvhBuild));
}

/// The surface under every structure of our own.
inline std::vector<std::shared_ptr<const Accelerator>> accelerators(
  const std::shared_ptr<const Surface>& surface)
{
  std::vector<std::shared_ptr<const Accelerator>> all;
  for (const BuildOptions& options : ownStructures())
  {
    all.push_back(build(surface, options));
  }
  return all;
}

inline QueryOptions with(Precision precision)
{
  QueryOptions options;
  options.precision = precision;
  options.threads = 1;
  return options;
}

/// One ray's answers.
///@{
inline Hit closestOf(const Accelerator& accelerator, const Ray& ray, Precision precision)
{
  Rays rays;
  rays.add(ray);
  Hit hit;
  accelerator.closest(rays.batch(), &hit, with(precision));
  return hit;
}

inline std::vector<Hit> allOf(const Accelerator& accelerator, const Ray& ray, Precision precision)
{
  Rays rays;
  rays.add(ray);
  AllHits all;
  accelerator.all(rays.batch(), all, with(precision));
  return all.hits;
}
///@}

/// The same bits, not only equal numbers.
inline bool sameBits(const Hit& a, const Hit& b)
{
  const auto same = [](double x, double y) { return std::memcmp(&x, &y, sizeof(double)) == 0; };
  return a.primitive == b.primitive && same(a.t, b.t) && same(a.u, b.u) && same(a.v, b.v);
}

} // namespace lumitree::testing

#endif
