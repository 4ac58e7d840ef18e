// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiAccuracyRays.h"

#include "Accel/Vec3.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>

namespace lumitree::filters
{

namespace
{

/// The same numbers everywhere (std distributions are not).
class Uniform
{
public:
  explicit Uniform(unsigned int seed)
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

void add(RaySet& rays, const Vec3& origin, const Vec3& direction)
{
  rays.origins.insert(rays.origins.end(), origin.begin(), origin.end());
  rays.directions.insert(rays.directions.end(), direction.begin(), direction.end());
}

Vec3 rounded(Vec3 p)
{
  for (double& x : p)
  {
    // GCC 12 (-O2, -O3) drops a plain conversion to float and back where it makes vectors of the
    // loop.
    const volatile float single = static_cast<float>(x);
    x = single;
  }
  return p;
}

Vec3 randomDirection(Uniform& uniform)
{
  Vec3 d;
  do
  {
    d = { uniform(-1, 1), uniform(-1, 1), uniform(-1, 1) };
  } while (dot(d, d) > 1.0 || dot(d, d) == 0.0);
  return d;
}

RaySet cameraRays(const Box& box, std::size_t count)
{
  RaySet rays;
  rays.kind = "Camera";
  const Vec3 middle = 0.5 * (box.lower + box.upper);
  const double size = length(box.size());
  const Vec3 back = { 0.48, -0.72, 0.5 };
  const Vec3 right = { 0.83205029433784372, 0.55470019622522915, 0 };
  const Vec3 up = cross(right, -1.0 * back);
  const Vec3 eye = middle + (1.2 * size) * back;
  const auto width = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto place = [&](std::size_t pixel)
    { return ((static_cast<double>(pixel) + 0.5) / static_cast<double>(width) - 0.5) * size; };
    add(rays, eye, middle + place(i % width) * right + place(i / width) * up - eye);
  }
  return rays;
}

Vec3 aim(
  const std::string& kind, const Vec3& origin, const std::array<Vec3, 3>& corners, Uniform& uniform)
{
  const std::size_t k = uniform.index(3);
  if (kind == "ThroughVertex")
  {
    return corners[k] - origin;
  }
  if (kind == "ThroughEdge")
  {
    return (corners[k] - origin) + (corners[(k + 1) % 3] - origin);
  }
  const Vec3 d = corners[k] - origin;
  return kind == "TowardVertex" && length(d) > 0.0 ? rounded((1.0 / length(d)) * d)
                                                   : rounded(randomDirection(uniform));
}

} // namespace

RayBatch RaySet::batch() const
{
  RayBatch batch;
  batch.size = this->size();
  batch.origins = ArrayView(this->origins.data());
  batch.directions = ArrayView(this->directions.data());
  return batch;
}

std::vector<PrimitiveId> hittableTriangles(const Surface& surface)
{
  std::vector<PrimitiveId> triangles;
  std::copy_if(surface.hittable().begin(), surface.hittable().end(), std::back_inserter(triangles),
    [&](PrimitiveId id) { return surface.isTriangle(id); });
  return triangles;
}

std::vector<RaySet> accuracyRays(const Surface& surface, std::size_t count, unsigned int seed)
{
  std::vector<RaySet> sets;
  const std::vector<PrimitiveId> hittable = hittableTriangles(surface);
  if (hittable.empty() || count == 0)
  {
    return sets;
  }
  const Box box = surface.bounds();
  const Vec3 middle = 0.5 * (box.lower + box.upper);
  const Vec3 size = box.size();
  for (const char* kind : { "Random", "Camera", "ThroughVertex", "ThroughEdge", "TowardVertex" })
  {
    if (std::string(kind) == "Camera")
    {
      sets.push_back(cameraRays(box, count));
      continue;
    }
    Uniform uniform(seed);
    sets.push_back({ kind, {}, {} });
    while (sets.back().size() < count)
    {
      Vec3 origin;
      for (int k = 0; k < 3; ++k)
      {
        origin[k] = middle[k] + 0.2 * size[k] * uniform(-1, 1);
      }
      origin = rounded(origin);
      const auto corners = surface.vertices(hittable[uniform.index(hittable.size())]);
      const Vec3 direction = aim(kind, origin, corners, uniform);
      add(sets.back(), origin, dot(direction, direction) > 0.0 ? direction : Vec3{ 0, 0, 1 });
    }
  }
  return sets;
}

} // namespace lumitree::filters
