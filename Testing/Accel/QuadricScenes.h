// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_Accel_QuadricScenes_h
#define Lumitree_Testing_Accel_QuadricScenes_h

#include "QuadricOracle.h"
#include "TestHelpers.h"

#include <gtest/gtest.h>

/// Surfaces of quadrics, and rays at them, for the tests of what is no triangle.
namespace lumitree::testing
{

inline constexpr double inf = std::numeric_limits<double>::infinity();

using Quadrics = std::vector<Quadric>;

inline void append(Quadrics& all, const Quadrics& more)
{
  all.insert(all.end(), more.begin(), more.end());
}

inline std::shared_ptr<const Surface> surfaceOf(const Quadrics& quadrics)
{
  return std::make_shared<const Surface>(PointArray{}, std::vector<Triangle>{}, quadrics);
}

template <class T>
std::shared_ptr<const Surface> surfaceOf(const std::vector<std::array<Vec3, 3>>& triangles,
  const Quadrics& quadrics, const std::vector<Implicit>& implicits = {})
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
  return std::make_shared<const Surface>(
    PointArray::from(std::move(points)), std::move(indices), quadrics, implicits);
}

inline std::vector<Hit> hitsOf(const Quadrics& quadrics, const Ray& ray, Precision precision)
{
  return allOf(*build(surfaceOf(quadrics), optionsOf(Structure::BruteForce)), ray, precision);
}

inline Quadric paraboloidUpTo(double height)
{
  QuadricForm form;
  form.coefficients = { 1, 1, 0, 0, 0, 0, 0, 0, -1, 0 };
  Box box;
  box.extend(Vec3{ -2, -2, 0 });
  box.extend(Vec3{ 2, 2, height });
  return Quadric::inBox(form, box);
}

/// One of each kind, some touching, some crossing; numbers from a coarse lattice, so that rays can
/// be aimed at tangents, rims and ties exactly.
inline Quadrics manyKinds()
{
  Quadrics all = { Quadric::sphere({ 0, 0, 0 }, 1), Quadric::sphere({ 2, 0, 0 }, 1),
    Quadric::sphere({ 0, 0, 0 }, 1), Quadric::sphere({ 0.25, 0.5, 3 }, 0.3),
    Quadric::ellipsoid({ -3, 0, 1 }, { Vec3{ 1, 1, 0 }, Vec3{ -0.5, 0.5, 0 }, Vec3{ 0, 0, 2 } }),
    Quadric::disc({ 0, 0, 1 }, { 0, 0, 1 }, 0.5), Quadric::paraboloid({ 0, 3, 0 }, { 0, 3, 2 }, 1),
    paraboloidUpTo(2) };
  append(all, Quadric::cappedCylinder({ 3, 3, -1 }, { 3, 3, 1 }, 0.5));
  append(all, Quadric::cappedCylinder({ -3, -3, -1 }, { -2, -2, 1 }, 0.75));
  append(all, Quadric::cappedCone({ 0, -3, 2 }, { 0, -3, 0 }, 1));
  append(all, Quadric::cappedCone({ 3, -3, 2 }, { 4, -2, 0 }, 0.4));
  Box box;
  box.extend(Vec3{ -1, 2, -3 });
  box.extend(Vec3{ 1, 4, -2 });
  append(all, Quadric::sides(box));
  // One sheet of a hyperboloid, cut by its box alone.
  QuadricForm form;
  form.centre = { -3, 3, 0 };
  form.coefficients = { 1, 1, -1, 0.5, 0, 0.25, 0, 0, 0, -0.25 };
  Box around;
  around.extend(Vec3{ -4, 2, -1 });
  around.extend(Vec3{ -2, 4, 1 });
  all.push_back(Quadric::inBox(form, around));
  return all;
}

inline std::vector<std::array<Vec3, 3>> someTriangles()
{
  // One touches the unit sphere at (0, 0, -1), one lies in the plane of a disc, one cuts.
  return { { Vec3{ -2, -2, -1 }, Vec3{ 3, -2, -1 }, Vec3{ 0, 3, -1 } },
    { Vec3{ -1, -1, 1 }, Vec3{ 2, -1, 1 }, Vec3{ 0, 2, 1 } },
    { Vec3{ -4, 0.1, -1 }, Vec3{ 4, 0, 2 }, Vec3{ 0, 1, 4 } } };
}

/// Rays of every kind: random, on a lattice (through tangents, rims, apexes, corners), nearly
/// tangent, from far away.
inline Rays raysFor(const Surface& surface, std::size_t count, unsigned seed)
{
  Uniform uniform(seed);
  const Box box = surface.bounds();
  Rays rays;
  const auto lattice = [&] { return 0.25 * std::floor(uniform(-16, 17)); };
  const auto inBox = [&](double grow)
  {
    const Vec3 size = box.size();
    Vec3 p;
    for (int k = 0; k < 3; ++k)
    {
      p[k] = uniform(box.lower[k] - grow * size[k], box.upper[k] + grow * size[k]);
    }
    return p;
  };
  for (std::size_t i = 0; i < count; ++i)
  {
    Ray ray;
    switch (i % 5)
    {
      case 0:
        ray.origin = inBox(0.5);
        ray.direction = inBox(0.0) - ray.origin;
        break;
      case 1:
        ray.origin = { lattice(), lattice(), lattice() };
        ray.direction = { lattice(), lattice(), lattice() };
        break;
      case 2:
        // Along an axis, at distances of whole and half radii.
        ray.origin = { lattice(), lattice(), lattice() };
        ray.direction = { 0, 0, 0 };
        ray.direction[uniform.index(3)] = uniform.index(2) == 0 ? -0.5 : 1.0;
        break;
      case 3:
        ray.origin = std::pow(10.0, uniform(4, 8)) * (inBox(0.0) - box.centre());
        ray.direction = inBox(0.0) - ray.origin;
        break;
      default:
        // Past the unit sphere by a few units in the last place.
        ray.origin = { -5, 1 + uniform(-4, 4) * 0x1p-53, 0 };
        ray.direction = { std::ldexp(1.0, static_cast<int>(uniform.index(5)) - 2), 0, 0 };
        break;
    }
    if (i % 7 == 0)
    {
      ray.tMin = -inf;
    }
    if (i % 11 == 0)
    {
      ray.tMin = 0.5;
      ray.tMax = 4.0;
    }
    if (ray.direction != Vec3{ 0, 0, 0 })
    {
      rays.add(ray);
    }
  }
  return rays;
}

/// Every answer of a structure.
struct Answers
{
  Answers(const Accelerator& accelerator, const Rays& rays, Precision precision)
    : closest(rays.size())
    , any(rays.size())
    , counts(rays.size())
  {
    const RayBatch batch = rays.batch();
    const QueryOptions options = with(precision);
    accelerator.closest(batch, this->closest.data(), options);
    accelerator.any(batch, this->any.data(), options);
    accelerator.count(batch, this->counts.data(), options);
    accelerator.all(batch, this->all, options);
  }

  std::vector<Hit> closest;
  std::vector<std::uint8_t> any;
  std::vector<std::uint32_t> counts;
  AllHits all;
};

} // namespace lumitree::testing

#endif
