// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RaysScenes.h"

#include "Data/Scenes.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace lumitree::benchmarks
{
namespace
{

Vec3 unit(const Vec3& a)
{
  return (1.0 / length(a)) * a;
}

Scene fromMesh(const std::string& name, const data::Mesh& mesh)
{
  Scene scene;
  scene.name = name;
  scene.points.assign(mesh.points.begin(), mesh.points.end());
  for (std::size_t c = 0; c + 1 < mesh.offsets.size(); ++c)
  {
    const auto corner = [&](std::int64_t k)
    { return static_cast<std::uint32_t>(mesh.connectivity[static_cast<std::size_t>(k)]); };
    for (auto j = mesh.offsets[c] + 1; j + 1 < mesh.offsets[c + 1]; ++j)
    {
      scene.triangles.push_back({ corner(mesh.offsets[c]), corner(j), corner(j + 1) });
    }
  }
  return scene;
}

/// Random numbers that are the same everywhere.
class Uniform
{
public:
  double operator()() { return static_cast<double>(this->engine_()) / 4294967296.0; }

private:
  std::mt19937 engine_{ 5 };
};

/// A point that a camera ray hits, and the normal towards the camera.
struct Place
{
  Vec3 point;
  Vec3 normal;
};

/// Just above the surface, so that float's rounding does not put a ray's beginning below it.
std::vector<Place> places(const Surface& surface, const Rays& camera, const std::vector<Hit>& hits)
{
  const double lift = 1e-5 * length(surface.bounds().size());
  std::vector<Place> found;
  for (std::size_t i = 0; i < hits.size(); ++i)
  {
    if (hits[i].primitive != noPrimitive)
    {
      const Ray ray = camera.batch()[i];
      const auto v = surface.vertices(hits[i].primitive);
      Vec3 normal = unit(cross(v[1] - v[0], v[2] - v[0]));
      normal = (dot(normal, ray.direction) > 0.0 ? -1.0 : 1.0) * normal;
      found.push_back({ ray.origin + hits[i].t * ray.direction + lift * normal, normal });
    }
  }
  return found;
}

} // namespace

std::shared_ptr<const Surface> Scene::surface() const
{
  return std::make_shared<const Surface>(PointArray::from(this->points), this->triangles);
}

std::vector<Scene> builtInScenes(const std::string& surface)
{
  std::vector<Scene> scenes;
  if (surface.empty())
  {
    scenes.push_back(fromMesh("torus", data::torus(280, 125, 0.3)));
    scenes.back().eye = { 1.9, 2.4, 2.6 };
    scenes.back().target = { 0.0, 0.0, 0.0 };
    scenes.back().view = 0.42;
    scenes.back().hitShares = { 0.585, 0.113 };
  }
  else
  {
    scenes.push_back(readObj(surface));
  }
  scenes.push_back(fromMesh("city", data::city()));
  scenes.back().eye = { -300.0, -420.0, 160.0 };
  scenes.back().target = { 0.0, 0.0, 0.0 };
  scenes.back().hitShares = { 0.696, 0.531 };
  scenes.push_back(subdivided(subdivided(scenes.front())));
  scenes.back().name = scenes.front().name + " x 16";
  scenes.back().hitShares = { 0.0, 0.0 };
  if (surface.empty())
  {
    scenes.back().hitShares = { 0.585, 0.124 };
  }
  scenes.push_back(fromMesh("stadium", data::teapotInStadium()));
  scenes.back().eye = { 0.5, -0.7, 0.45 };
  scenes.back().target = { 0.0, 0.0, 0.05 };
  scenes.back().view = 0.3;
  scenes.back().hitShares = { 1.0, 1.0 };
  return scenes;
}

Scene subdivided(const Scene& scene)
{
  Scene fine = scene;
  fine.triangles.clear();
  Uniform uniform;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b)
  {
    const auto [place, isNew] =
      middles.insert({ std::minmax(a, b), static_cast<std::uint32_t>(fine.points.size() / 3) });
    if (isNew)
    {
      Vec3 p[2];
      for (int k = 0; k < 3; ++k)
      {
        p[0][k] = static_cast<double>(fine.points[3 * a + static_cast<std::uint32_t>(k)]);
        p[1][k] = static_cast<double>(fine.points[3 * b + static_cast<std::uint32_t>(k)]);
      }
      const double jitter = 0.05 * length(p[1] - p[0]);
      for (int k = 0; k < 3; ++k)
      {
        fine.points.push_back(
          static_cast<float>(0.5 * (p[0][k] + p[1][k]) + jitter * (2.0 * uniform() - 1.0)));
      }
    }
    return place->second;
  };
  for (const Triangle& t : scene.triangles)
  {
    const std::uint32_t m[3] = { middle(t[0], t[1]), middle(t[1], t[2]), middle(t[2], t[0]) };
    fine.triangles.push_back({ t[0], m[0], m[2] });
    fine.triangles.push_back({ m[0], t[1], m[1] });
    fine.triangles.push_back({ m[2], m[1], t[2] });
    fine.triangles.push_back({ m[0], m[1], m[2] });
  }
  return fine;
}

Scene readObj(const std::string& file)
{
  std::ifstream input(file);
  if (!input)
  {
    throw std::runtime_error(file + " cannot be read");
  }
  Scene scene;
  scene.name = file.substr(file.find_last_of('/') + 1);
  Box bounds;
  for (std::string line; std::getline(input, line);)
  {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v")
    {
      Vec3 p{};
      words >> p[0] >> p[1] >> p[2];
      bounds.extend(p);
      scene.points.insert(scene.points.end(), p.begin(), p.end());
    }
    else if (word == "f")
    {
      std::vector<std::uint32_t> corners;
      while (words >> word)
      {
        const long index = std::stol(word); // the part before a slash
        corners.push_back(static_cast<std::uint32_t>(
          index > 0 ? index - 1 : static_cast<long>(scene.points.size() / 3) + index));
      }
      for (std::size_t k = 2; k < corners.size(); ++k)
      {
        scene.triangles.push_back({ corners[0], corners[k - 1], corners[k] });
      }
    }
  }
  if (scene.triangles.empty())
  {
    throw std::runtime_error(file + " holds no faces");
  }
  scene.target = bounds.centre();
  scene.eye = scene.target + length(bounds.size()) * Vec3{ 0.8, 0.7, 0.9 };
  scene.view = 0.35;
  return scene;
}

void Rays::add(const Vec3& origin, const Vec3& direction)
{
  this->origins.insert(this->origins.end(), origin.begin(), origin.end());
  this->directions.insert(this->directions.end(), direction.begin(), direction.end());
}

RayBatch Rays::batch() const
{
  RayBatch batch;
  batch.size = this->size();
  batch.origins = ArrayView(this->origins.data());
  batch.directions = ArrayView(this->directions.data());
  batch.tMax = static_cast<double>(this->tMax);
  return batch;
}

Rays cameraRays(const Scene& scene, int width)
{
  const int height = std::max(1, 3 * width / 4);
  Rays rays;
  rays.kind = "camera";
  rays.coherent = true;
  const Vec3 forward = unit(scene.target - scene.eye);
  const Vec3 right = unit(cross(forward, Vec3{ 0.0, 0.0, 1.0 }));
  const Vec3 up = cross(right, forward);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const double a = scene.view * (2.0 * (x + 0.5) / width - 1.0);
      const double b = scene.view * (height - 2.0 * (y + 0.5)) / width;
      rays.add(scene.eye, unit(forward + (a * right + b * up)));
    }
  }
  return rays;
}

Rays bounces(
  const Surface& surface, const Rays& camera, const std::vector<Hit>& hits, std::size_t count)
{
  Uniform uniform;
  const std::vector<Place> seen = places(surface, camera, hits);
  Rays rays;
  rays.kind = "incoherent";
  for (std::size_t i = 0; i < count && !seen.empty(); ++i)
  {
    const Place& place =
      seen[static_cast<std::size_t>(uniform() * static_cast<double>(seen.size()))];
    // A point on the unit ball about the normal's tip is distributed by the cosine.
    const double z = 2.0 * uniform() - 1.0;
    const double turn = 6.283185307179586 * uniform();
    const double r = std::sqrt(1.0 - z * z);
    rays.add(
      place.point, unit(1.0001 * place.normal + Vec3{ r * std::cos(turn), r * std::sin(turn), z }));
  }
  return rays;
}

Rays sampled(const Rays& rays, std::size_t n)
{
  Rays some = rays;
  some.origins.clear();
  some.directions.clear();
  for (std::size_t i = 0; i < n; ++i)
  {
    const Ray ray = rays.batch()[i * rays.size() / n];
    some.add(ray.origin, ray.direction);
  }
  return some;
}

Rays occlusion(Rays rays)
{
  rays.kind = "occlusion";
  rays.any = true;
  return rays;
}

} // namespace lumitree::benchmarks
