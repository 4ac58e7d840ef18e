// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StressCases.h"

#include "Testing/Accel/CellStructures.h"
#include "Testing/Accel/ClosedScenes.h"

#include <limits>

namespace lumitree::testing
{
namespace
{

using Corners = std::array<Vec3, 3>;

constexpr std::size_t fewRays = 30;

Vec3 any(Uniform& uniform, double size = 1.0)
{
  return { uniform(-size, size), uniform(-size, size), uniform(-size, size) };
}

/// A length between 10^low and 10^high, every magnitude as likely.
double magnitude(Uniform& uniform, double low, double high)
{
  return std::pow(10.0, uniform(low, high));
}

/// From a point through a corner, an edge's middle or the inside of a triangle.
Ray through(const Vec3& origin, const Corners& c, Uniform& uniform)
{
  switch (uniform.index(3))
  {
    case 0:
      return { origin, c[uniform.index(3)] - origin };
    case 1:
      return { origin, (c[0] - origin) + (c[1] - origin) };
    default:
      return { origin, 0.25 * c[0] + 0.25 * c[1] + 0.5 * c[2] - origin };
  }
}

Corners someTriangle(const Surface& surface, Uniform& uniform)
{
  return surface.vertices(static_cast<PrimitiveId>(uniform.index(surface.size())));
}

/// 1 : 1 to 1e6 : 1.
StressCase slivers(Uniform& uniform)
{
  std::vector<Corners> triangles;
  for (int i = 0; i < 60; ++i)
  {
    const Vec3 a = any(uniform);
    const Vec3 along = any(uniform);
    triangles.push_back(
      { a, a + along, a + 0.5 * along + magnitude(uniform, -6, 0) * any(uniform) });
  }
  StressCase c{ "Slivers", surfaceOf<double>(triangles), {} };
  for (std::size_t i = 0; i < fewRays; ++i)
  {
    c.rays.add(through(any(uniform, 3), someTriangle(*c.surface, uniform), uniform));
  }
  return c;
}

/// Down to 1e-5 rad to the triangles.
StressCase grazing(Uniform& uniform)
{
  std::vector<Corners> triangles;
  for (int i = 0; i < 60; ++i)
  {
    const double flat = magnitude(uniform, -5, -2);
    Corners corners;
    for (Vec3& p : corners)
    {
      p = { uniform(-1, 1), uniform(-1, 1), flat * uniform(-1, 1) };
    }
    triangles.push_back(corners);
  }
  StressCase c{ "Grazing", surfaceOf<double>(triangles), {} };
  for (std::size_t i = 0; i < fewRays; ++i)
  {
    const double angle = magnitude(uniform, -5, 0);
    c.rays.add({ uniform(-2, 2), uniform(-2, 2), uniform(-1, 1) * angle },
      { uniform(-1, 1), uniform(-1, 1), uniform(-1, 1) * angle });
  }
  return c;
}

StressCase duplicates(Uniform& uniform)
{
  std::vector<Corners> triangles;
  for (int i = 0; i < 6; ++i)
  {
    const Corners one = { any(uniform), any(uniform), any(uniform) };
    for (std::size_t n = 0; n < 10; ++n)
    {
      triangles.push_back({ one[n % 3], one[(n + 1) % 3], one[(n + 2) % 3] });
    }
  }
  StressCase c{ "Duplicates", surfaceOf<float>(triangles), {} };
  for (std::size_t i = 0; i < fewRays; ++i)
  {
    c.rays.add(through(any(uniform, 2), someTriangle(*c.surface, uniform), uniform));
  }
  return c;
}

/// Triangles and rays with NaN, infinity and zero area among good ones.
StressCase notFinite(Uniform& uniform)
{
  std::vector<Corners> triangles;
  const double bad[] = { std::nan(""), HUGE_VAL, -HUGE_VAL, 1e301 };
  for (int i = 0; i < 60; ++i)
  {
    Corners corners = { any(uniform), any(uniform), any(uniform) };
    if (i % 3 == 0)
    {
      corners[uniform.index(3)][uniform.index(3)] = bad[uniform.index(4)];
    }
    else if (i % 7 == 0)
    {
      corners[1] = corners[0];
    }
    triangles.push_back(corners);
  }
  StressCase c{ "NotFinite", surfaceOf<double>(triangles), {} };
  const auto& good = c.surface->hittable();
  for (std::size_t i = 0; i < fewRays; ++i)
  {
    Ray ray =
      through(any(uniform, 2), c.surface->vertices(good[uniform.index(good.size())]), uniform);
    if (i % 5 == 0)
    {
      (uniform.index(2) == 0 ? ray.origin : ray.direction)[uniform.index(3)] = bad[i % 4];
    }
    c.rays.add(ray);
  }
  c.rays.add({ 0, 0, 0 }, { 0, 0, 0 });
  c.rays.add(Ray{ { 0, 0, 0 }, { 0, 0, 1 }, 2, 1 });
  return c;
}

/// Nested copies of a closed surface, an ulp apart.
StressCase shells(Uniform& uniform)
{
  const auto one = surfaceOf<double>(data::sphere(1));
  std::vector<Corners> triangles;
  double size = 1.0;
  for (int shell = 0; shell < 4; ++shell, size = std::nextafter(size, 2.0))
  {
    for (PrimitiveId i = 0; i < one->size(); ++i)
    {
      Corners corners = one->vertices(i);
      for (Vec3& p : corners)
      {
        p = size * p;
      }
      triangles.push_back(corners);
    }
  }
  // The nearer ones have the higher numbers.
  std::reverse(triangles.begin(), triangles.end());
  StressCase c{ "Shells", surfaceOf<double>(triangles), {} };
  for (std::size_t i = 0; i < fewRays; ++i)
  {
    c.rays.add(
      through(any(uniform, i % 2 == 0 ? 0.3 : 5), someTriangle(*c.surface, uniform), uniform));
  }
  return c;
}

/// Magnitudes of 2^-60 to 2^60, rays and surfaces, together and apart.
StressCase exponents(Uniform& uniform)
{
  std::vector<Corners> triangles;
  for (int i = 0; i < 60; ++i)
  {
    const double size = std::ldexp(1.0, static_cast<int>(uniform.index(121)) - 60);
    const Vec3 a = any(uniform, size);
    triangles.push_back({ a, a + any(uniform, size), a + any(uniform, size) });
  }
  StressCase c{ "Exponents", surfaceOf<double>(triangles), {} };
  for (std::size_t i = 0; i < fewRays; ++i)
  {
    const Corners target = someTriangle(*c.surface, uniform);
    const double away = std::ldexp(1.0, static_cast<int>(uniform.index(121)) - 60);
    Ray ray = through(target[0] + any(uniform, away), target, uniform);
    ray.direction = std::ldexp(1.0, static_cast<int>(uniform.index(121)) - 60) * ray.direction;
    c.rays.add(ray);
  }
  return c;
}

/// Limits at a hit's t, and an ulp to either side.
StressCase limits(Uniform& uniform)
{
  std::vector<Corners> triangles;
  for (int i = 0; i < 40; ++i)
  {
    triangles.push_back({ any(uniform), any(uniform), any(uniform) });
  }
  StressCase c{ "Limits", surfaceOf<double>(triangles), {} };
  const auto oracle = build(c.surface, optionsOf(Structure::BruteForce));
  while (c.rays.size() < 2 * fewRays)
  {
    Ray ray = { any(uniform, 2), any(uniform) };
    const auto hits = allOf(*oracle, ray, Precision::Exact);
    if (hits.empty())
    {
      continue;
    }
    double t = hits[uniform.index(hits.size())].t;
    const std::size_t side = uniform.index(3);
    t = side == 0 ? t : std::nextafter(t, side == 1 ? -HUGE_VAL : HUGE_VAL);
    ray.tMin = uniform.index(2) == 0 ? t : 0.0;
    ray.tMax = ray.tMin == t && uniform.index(2) == 0 ? HUGE_VAL : t;
    c.rays.add(ray);
  }
  return c;
}

/// Boxes side by side, with rays in their faces and along their edges.
StressCase touchingBoxes(Uniform& uniform)
{
  std::vector<Corners> triangles;
  for (int n = 0; n < 6; ++n)
  {
    const Vec3 low = { static_cast<double>(n % 2), static_cast<double>(n / 2 % 2),
      static_cast<double>(n / 4) };
    for (int k = 0; k < 3; ++k)
    {
      for (const double side : { 0.0, 1.0 })
      {
        std::array<Vec3, 4> corners;
        for (int i = 0; i < 4; ++i)
        {
          corners[i] = low;
          corners[i][k] += side;
          corners[i][(k + 1) % 3] += i == 1 || i == 2 ? 1.0 : 0.0;
          corners[i][(k + 2) % 3] += i >= 2 ? 1.0 : 0.0;
        }
        triangles.push_back({ corners[0], corners[1], corners[2] });
        triangles.push_back({ corners[0], corners[2], corners[3] });
      }
    }
  }
  StressCase c{ "TouchingBoxes", surfaceOf<float>(triangles), {} };
  for (std::size_t i = 0; i < 2 * fewRays; ++i)
  {
    Vec3 origin;
    Vec3 direction;
    for (int k = 0; k < 3; ++k)
    {
      origin[k] = static_cast<double>(uniform.index(9)) / 2 - 1;
      direction[k] = static_cast<double>(uniform.index(3)) - 1;
    }
    direction = i % 2 == 0 ? direction : Vec3{ 0, 0, 0 };
    direction[i % 3] = 1;
    c.rays.add(origin, direction);
  }
  return c;
}

/// A terrain, and rays along axes on its border planes and through its points.
StressCase borders(Uniform& uniform)
{
  StressCase c{ "Borders", surfaceOf<float>(data::terrain(6)), {} };
  const Box box = c.surface->bounds();
  for (std::size_t i = 0; i < 2 * fewRays; ++i)
  {
    const Corners corners = someTriangle(*c.surface, uniform);
    Vec3 origin = corners[uniform.index(3)];
    const std::size_t axis = uniform.index(3);
    const std::size_t other = (axis + 1 + uniform.index(2)) % 3;
    origin[other] = uniform.index(2) == 0 ? box.lower[other] : box.upper[other];
    Vec3 direction = { 0, 0, 0 };
    direction[axis] = uniform.index(2) == 0 ? 1 : -1;
    c.rays.add(origin - 2.0 * direction, direction);
  }
  return c;
}

StressCase farOrigins(Uniform& uniform)
{
  StressCase c{ "FarOrigins", surfaceOf<float>(data::sphere(2)), {} };
  for (std::size_t i = 0; i < fewRays; ++i)
  {
    c.rays.add(
      through(any(uniform, magnitude(uniform, 4, 8)), someTriangle(*c.surface, uniform), uniform));
  }
  return c;
}

/// Full mantissas far from the origin of the coordinates.
StressCase georeferenced(Uniform& uniform)
{
  StressCase c{ "Georeferenced",
    surfaceOf<double>(data::torus(9, 5, 0.3), { 500000, 4649776, 100 }), {} };
  const Vec3 middle = { 500000, 4649776, 100 };
  for (std::size_t i = 0; i < fewRays; ++i)
  {
    c.rays.add(through(middle + any(uniform, 2), someTriangle(*c.surface, uniform), uniform));
  }
  return c;
}

/// Corners, directions and limits on a lattice: every kind of tie.
StressCase lattice(Uniform& uniform)
{
  const auto seed = static_cast<unsigned>(uniform.index(1u << 30));
  return { "Lattice", surfaceOf<float>(latticeTriangles(70, 8, seed)),
    latticeRays(2 * fewRays, 8, seed + 1) };
}

/// A triangle soup without shared points, as STL files are.
StressCase unwelded(Uniform& uniform)
{
  const auto welded = surfaceOf<float>(data::sphere(2));
  std::vector<Corners> triangles;
  for (PrimitiveId i = 0; i < welded->size(); ++i)
  {
    triangles.push_back(welded->vertices(i));
  }
  StressCase c{ "Unwelded", surfaceOf<float>(triangles), {}, true };
  for (std::size_t i = 0; i < fewRays; ++i)
  {
    const auto onGrid = [](double x) { return std::nearbyint(x * 1024) / 1024; };
    const Vec3 p = any(uniform, 0.5);
    c.rays.add(through(
      { onGrid(p[0]), onGrid(p[1]), onGrid(p[2]) }, someTriangle(*c.surface, uniform), uniform));
  }
  return c;
}

/// Everything at random, sizes of the triangles over six magnitudes.
StressCase soup(Uniform& uniform)
{
  std::vector<Corners> triangles;
  for (int i = 0; i < 70; ++i)
  {
    const double size = magnitude(uniform, -5, 1);
    const Vec3 a = any(uniform);
    triangles.push_back({ a, a + any(uniform, size), a + any(uniform, size) });
  }
  StressCase c{ "Soup", surfaceOf<double>(triangles), {} };
  for (std::size_t i = 0; i < fewRays; ++i)
  {
    c.rays.add(through(any(uniform, 2), someTriangle(*c.surface, uniform), uniform));
  }
  return c;
}

} // namespace

std::vector<StressCase> stressCases(unsigned seed)
{
  Uniform uniform(seed);
  std::vector<StressCase> cases;
  for (auto* const make : { slivers, grazing, duplicates, notFinite, shells, exponents, limits,
         touchingBoxes, borders, farOrigins, georeferenced, lattice, unwelded, soup })
  {
    cases.push_back(make(uniform));
  }
  return cases;
}

} // namespace lumitree::testing
