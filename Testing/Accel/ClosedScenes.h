// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_Accel_ClosedScenes_h
#define Lumitree_Testing_Accel_ClosedScenes_h

#include "Testing/Accel/TestHelpers.h"

/// Closed surfaces, from which no ray may leave, and rays that try to.
namespace lumitree::testing
{

/// The nearest number that a float holds. GCC 12 (-O2, -O3) drops a plain conversion to float and
/// back where it makes vectors of the loop.
inline double asFloat(double x)
{
  const volatile float rounded = static_cast<float>(x);
  return rounded;
}

enum class Aim
{
  Vertex,           ///< exactly through a vertex, where the surface has a grid
  Edge,             ///< exactly through the middle of an edge
  NormalisedVertex, ///< toward a vertex, the direction normalised and rounded to float
  Random
};

inline constexpr std::array<Aim, 4> everyAim = { Aim::Vertex, Aim::Edge, Aim::NormalisedVertex,
  Aim::Random };

inline const char* name(Aim aim)
{
  constexpr const char* names[] = { "through a vertex", "through an edge's middle",
    "toward a vertex", "random" };
  return names[static_cast<int>(aim)];
}

struct ClosedScene
{
  std::string name;
  std::shared_ptr<const Surface> surface;
  Vec3 offset;
  double grid = 0.0;  ///< coordinates are multiples of it; 0: full mantissas
  bool torus = false; ///< else a sphere
};

inline constexpr double closedRadius = 100.0;

/// Where the closed scenes stand. Georeferenced coordinates are doubles with full mantissas.
struct Place
{
  const char* name;
  bool floats;
  Vec3 offset;
  double grid;
};

inline const std::vector<Place>& closedPlaces()
{
  static const std::vector<Place> all = { { "floats", true, { 0, 0, 0 }, 0x1p-10 },
    { "floats at 1e4", true, { 1e4, 1e4, 1e4 }, 0x1p-10 },
    { "floats at 1e6", true, { 1e6, 1e6, 1e6 }, 0x1p-4 }, { "doubles", false, { 0, 0, 0 }, 0.0 },
    { "doubles at UTM coordinates", false, { 500000, 4649776, 100 }, 0.0 } };
  return all;
}

/// A sphere of 20 detail^2 triangles, or a bumpy torus of about as many.
inline ClosedScene closedScene(bool torus, const Place& place, int detail)
{
  data::Mesh mesh = torus ? data::torus(5 * detail, 2 * detail, 0.3) : data::sphere(detail);
  for (double& x : mesh.points)
  {
    x = place.grid > 0.0 ? std::nearbyint(x * closedRadius / place.grid) * place.grid
                         : x * closedRadius;
  }
  return { (torus ? "torus of " : "sphere of ") + std::string(place.name),
    place.floats ? surfaceOf<float>(mesh, place.offset) : surfaceOf<double>(mesh, place.offset),
    place.offset, place.grid, torus };
}

/// A room of long axis-aligned edges: walls of strips from end to end, 20 times as long as high.
inline ClosedScene closedRoom(const Place& place)
{
  constexpr int strips = 7;
  constexpr std::array<double, 3> half = { 1000, 100, 50 };
  std::vector<std::array<Vec3, 3>> triangles;
  for (int k = 0; k < 3; ++k)
  {
    // Walls across k; along x they are whole, along y and z cut into strips.
    const int a = (k + 1) % 3;
    const int b = (k + 2) % 3;
    const int cutsA = a == 0 ? 1 : strips;
    const int cutsB = b == 0 ? 1 : strips;
    for (int cell = 0; cell < 2 * cutsA * cutsB; ++cell)
    {
      const auto corner = [&](int alongA, int alongB)
      {
        Vec3 p;
        p[k] = cell % 2 == 0 ? -half[k] : half[k];
        p[a] = half[a] * (2.0 * (cell / 2 % cutsA + alongA) / cutsA - 1);
        p[b] = half[b] * (2.0 * (cell / 2 / cutsA + alongB) / cutsB - 1);
        for (double& x : p)
        {
          x = place.grid > 0.0 ? std::nearbyint(x / place.grid) * place.grid : x;
        }
        return p + place.offset;
      };
      triangles.push_back({ corner(0, 0), corner(1, 0), corner(1, 1) });
      triangles.push_back({ corner(0, 0), corner(1, 1), corner(0, 1) });
    }
  }
  return { std::string("room of ") + place.name,
    place.floats ? surfaceOf<float>(triangles) : surfaceOf<double>(triangles), place.offset,
    place.grid, false };
}

/// A point well inside, on the surface's grid.
inline Vec3 inside(const ClosedScene& c, Uniform& uniform)
{
  Vec3 p = { uniform(-20, 20), uniform(-20, 20), uniform(-20, 20) };
  if (c.torus)
  {
    // On the ring, within half of the thinnest tube.
    const double angle = uniform(0, 6.28);
    p = { closedRadius * std::cos(angle) + p[0] / 4, closedRadius * std::sin(angle) + p[1] / 4,
      p[2] / 4 };
  }
  const double grid = c.grid > 0.0 ? c.grid : 0x1p-20;
  for (double& x : p)
  {
    x = std::nearbyint(x / grid) * grid;
  }
  return p + c.offset;
}

/// A point many sizes away, on the surface's grid (of 53 bits at most).
inline Vec3 afar(const ClosedScene& c, double sizes, Uniform& uniform)
{
  const double grid = c.grid > 0.0 ? c.grid : 0x1p-12;
  Vec3 p;
  for (double& x : p)
  {
    x = std::nearbyint(uniform(-1, 1) * sizes * 2 * closedRadius / grid) * grid;
  }
  p[uniform.index(3)] = (uniform.index(2) == 0 ? -1 : 1) * sizes * 2 * closedRadius;
  return p + c.offset;
}

/// From that point. Random ones go anywhere from inside, and to the middle part from afar.
inline Ray aimed(const ClosedScene& c, const Vec3& o, Aim aim, bool fromInside, Uniform& uniform)
{
  const auto corners =
    c.surface->vertices(static_cast<PrimitiveId>(uniform.index(c.surface->size())));
  const std::size_t k = uniform.index(3);
  Vec3 d = { uniform(-1, 1), uniform(-1, 1), uniform(-1, 1) };
  switch (aim)
  {
    case Aim::Vertex:
      d = corners[k] - o;
      break;
    case Aim::Edge:
      d = (corners[k] - o) + (corners[(k + 1) % 3] - o);
      break;
    case Aim::NormalisedVertex:
      d = corners[k] - o;
      d = (1 / length(d)) * d;
      for (double& x : d)
      {
        x = asFloat(x);
      }
      break;
    case Aim::Random:
      if (!fromInside)
      {
        d = c.offset + closedRadius * d - o;
      }
      break;
  }
  return { o, d };
}

inline Rays raysFromInside(const ClosedScene& c, Aim aim, std::size_t count, unsigned seed = 41)
{
  Uniform uniform(seed);
  Rays all;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vec3 o = inside(c, uniform);
    all.add(aimed(c, o, aim, true, uniform));
  }
  return all;
}

/// From one point inside, side by side as a camera's are: at the triangles one after the other.
inline Rays raysFromOnePoint(const ClosedScene& c, Aim aim, std::size_t count, unsigned seed)
{
  Uniform uniform(seed);
  const Vec3 o = inside(c, uniform);
  const std::size_t first = uniform.index(c.surface->size());
  Rays all;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto corners =
      c.surface->vertices(static_cast<PrimitiveId>((first + i) % c.surface->size()));
    Vec3 d = corners[i % 3] - o;
    if (aim == Aim::Edge)
    {
      d = d + (corners[(i + 1) % 3] - o);
    }
    else if (aim == Aim::NormalisedVertex)
    {
      d = (1 / length(d)) * d;
      for (double& x : d)
      {
        x = asFloat(x);
      }
    }
    else if (aim == Aim::Random)
    {
      d = uniform(0, 1) * d + uniform(0, 1) * (corners[(i + 1) % 3] - o) +
        uniform(0, 1) * (corners[(i + 2) % 3] - o);
    }
    all.add(o, d);
  }
  return all;
}

inline Rays raysFromAfar(
  const ClosedScene& c, Aim aim, double sizes, std::size_t count, unsigned seed = 43)
{
  Uniform uniform(seed);
  Rays all;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vec3 o = afar(c, sizes, uniform);
    all.add(aimed(c, o, aim, false, uniform));
  }
  return all;
}

} // namespace lumitree::testing

#endif
