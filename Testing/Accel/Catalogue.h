// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_Accel_Catalogue_h
#define Lumitree_Testing_Accel_Catalogue_h

#include "CellStructures.h"
#include "QuadricScenes.h"
#include "Trees.h"

/// Scenes on which builders and walks are known to fail, each of triangles, of implicits, and of
/// both.
namespace lumitree::testing
{

using lumitree::operator-; // of vectors, beside that of trees

using Corners = std::array<Vec3, 3>;

struct CatalogueScene
{
  std::string name;
  std::vector<Corners> triangles;
  Quadrics quadrics;
  std::vector<Implicit> implicits;
  Rays rays;
};

/// What a surface is made of.
enum class Matter
{
  FloatTriangles,
  DoubleTriangles,
  Bodies,
  FloatMixed,
  DoubleMixed
};

inline constexpr Matter everyMatter[] = { Matter::FloatTriangles, Matter::DoubleTriangles,
  Matter::Bodies, Matter::FloatMixed, Matter::DoubleMixed };

inline std::shared_ptr<const Surface> surfaceOf(const CatalogueScene& scene, Matter matter)
{
  const bool meshed = matter != Matter::Bodies;
  const bool bodies = matter != Matter::FloatTriangles && matter != Matter::DoubleTriangles;
  const auto triangles = meshed ? scene.triangles : std::vector<Corners>{};
  const auto quadrics = bodies ? scene.quadrics : Quadrics{};
  const auto implicits = bodies ? scene.implicits : std::vector<Implicit>{};
  return matter == Matter::FloatTriangles || matter == Matter::FloatMixed
    ? surfaceOf<float>(triangles, quadrics, implicits)
    : surfaceOf<double>(triangles, quadrics, implicits);
}

/// Every third ray again with a direction 2^±40 times as long, and limits that belong to it.
inline Rays withOtherLengths(const Rays& rays)
{
  Rays all = rays;
  for (std::size_t i = 0; i < rays.size(); i += 3)
  {
    Ray ray = rays.batch()[i];
    const int exponent = i % 2 == 0 ? 40 : -40;
    ray.direction = std::ldexp(1.0, exponent) * ray.direction;
    ray.tMin = std::ldexp(ray.tMin, -exponent);
    ray.tMax = std::ldexp(ray.tMax, -exponent);
    all.add(ray);
  }
  return all;
}

/// From anywhere around at corners, middles of edges and middles of triangles and bodies.
inline void addRaysAt(const CatalogueScene& scene, std::size_t count, unsigned seed, Rays& rays)
{
  Uniform uniform(seed);
  const auto surface = surfaceOf(scene, Matter::DoubleMixed);
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto id = [&] { return surface->hittable()[uniform.index(surface->hittable().size())]; };
    const auto pointOf = [&](PrimitiveId primitive) -> Vec3
    {
      if (!surface->isTriangle(primitive))
      {
        const Box box = surface->box(primitive);
        return { uniform(box.lower[0], box.upper[0]), uniform(box.lower[1], box.upper[1]),
          uniform(box.lower[2], box.upper[2]) };
      }
      const auto corners = surface->vertices(primitive);
      return i % 4 == 0 ? corners[uniform.index(3)]
                        : (i % 4 == 1 ? 0.5 * (corners[0] + corners[1])
                                      : (1 / 3.0) * (corners[0] + corners[1] + corners[2]));
    };
    const Vec3 to = pointOf(id());
    // As far away as a primitive is large, or from another one.
    Vec3 from = pointOf(id());
    if (i % 3 == 0)
    {
      const PrimitiveId near = id();
      const Vec3 size = surface->box(near).size();
      const double reach = 3 * std::max({ size[0], size[1], size[2] });
      from = to + reach * Vec3{ uniform(-1, 1), uniform(-1, 1), uniform(-1, 1) };
    }
    Ray ray = { from, to - from };
    if (i % 5 == 0)
    {
      ray.direction[uniform.index(3)] = i % 10 == 0 ? 0.0 : -0.0;
    }
    if (i % 7 == 0)
    {
      ray.tMin = i % 2 == 0 ? -1.0 : 1.0;
      ray.tMax = i % 3 == 0 ? 1.0 : 2.0;
    }
    rays.add(ray);
  }
}

inline std::vector<Corners> trianglesOf(const data::Mesh& mesh, const Vec3& offset = {})
{
  const auto surface = surfaceOf<double>(mesh, offset);
  std::vector<Corners> triangles;
  for (std::size_t i = 0; i < surface->size(); ++i)
  {
    triangles.push_back(surface->vertices(static_cast<PrimitiveId>(i)));
  }
  return triangles;
}

/// All in one place, around one centre, through everything, of no area, not finite.
inline CatalogueScene badSoup()
{
  CatalogueScene scene{ "bad soup", {}, {}, {}, {} };
  const Corners unit = { Vec3{ 0, 0, 0 }, Vec3{ 1, 0, 0 }, Vec3{ 0, 1, 0 } };
  scene.triangles.assign(60, unit);
  Uniform uniform(1);
  for (int i = 1; i <= 60; ++i)
  {
    const double r = i;
    scene.triangles.push_back({ Vec3{ -r, -r, 0.5 }, Vec3{ r, -r, -0.5 }, Vec3{ 0, r, 0 } });
    const Vec3 a = { uniform(-40, 40), uniform(-40, 40), -40 };
    const Vec3 b = { uniform(-40, 40), uniform(-40, 40), 40 };
    scene.triangles.push_back({ a, b, b + Vec3{ 1e-3, 1e-3, 0 } });
    scene.triangles.push_back({ a, a, i % 2 == 0 ? a : b });
  }
  scene.triangles[7][1][2] = inf;
  scene.triangles[70][0] = { std::nan(""), 0, 0 };
  for (int i = 1; i <= 8; ++i)
  {
    scene.quadrics.push_back(Quadric::sphere({ 0, 0, 0 }, 1));
    scene.quadrics.push_back(Quadric::sphere({ 0, 0, 0 }, i));
    scene.quadrics.push_back(Quadric::disc({ 0, 0, 0 }, { 0, 0, 1 }, i));
    scene.quadrics.push_back(
      Quadric::cylinder({ uniform(-40, 40), 0, -40 }, { uniform(-40, 40), 0, 40 }, 1e-3));
  }
  scene.quadrics.push_back(Quadric::sphere({ inf, 0, 0 }, 1));
  scene.quadrics.push_back(Quadric::sphere({ 0, 0, 0 }, -1));
  addRaysAt(scene, 90, 2, scene.rays);
  return scene;
}

/// 2e7 times its size around a teapot.
inline CatalogueScene smallInHuge()
{
  CatalogueScene scene{ "small in huge", trianglesOf(data::teapotInStadium(2, 1e6)), {}, {}, {} };
  for (int i = 0; i < 40; ++i)
  {
    scene.quadrics.push_back(
      Quadric::sphere({ 0.01 * (i % 7), 0.01 * (i % 5), 0.01 * (i % 3) }, 0.006));
  }
  append(scene.quadrics, Quadric::sides({ { -2e5, -2e5, -2e5 }, { 2e5, 2e5, 2e5 } }));
  addRaysAt(scene, 150, 3, scene.rays);
  return scene;
}

inline CatalogueScene farFromTheOrigin(const std::string& name, const Vec3& offset)
{
  CatalogueScene scene{ name, trianglesOf(data::teapot(2), offset), {}, {}, {} };
  for (int i = 0; i < 30; ++i)
  {
    const Vec3 at = offset + Vec3{ 0.5 * (i % 5), 0.5 * (i % 3), 0.25 * (i % 7) };
    append(scene.quadrics,
      i % 2 == 0 ? Quadrics{ Quadric::sphere(at, 0.25) }
                 : Quadric::cappedCylinder(at, at + Vec3{ 0.5, 0.25, 0.25 }, 0.125));
  }
  addRaysAt(scene, 150, 4, scene.rays);
  return scene;
}

/// In the planes that divide space, touching them in points and edges, across all cells; rays in
/// planes, along edges, through corners, ending on borders.
inline CatalogueScene onALattice()
{
  CatalogueScene scene{ "on a lattice", latticeTriangles(120, 8, 5), {}, {}, {} };
  Uniform uniform(6);
  for (int i = 0; i < 60; ++i)
  {
    const auto whole = [&] { return static_cast<double>(uniform.index(9)); };
    const Vec3 p = { whole(), whole(), whole() };
    Vec3 axis = { 0, 0, 0 };
    axis[uniform.index(3)] = 1.0;
    switch (i % 5)
    {
      case 0:
        scene.quadrics.push_back(Quadric::sphere(p, i % 2 == 0 ? 0.5 : 1.0));
        break;
      case 1:
        scene.quadrics.push_back(Quadric::disc(p, axis, 1));
        break;
      case 2:
        append(scene.quadrics, Quadric::cappedCylinder(p, p + 2 * axis, 0.5));
        break;
      case 3:
        append(scene.quadrics, Quadric::cappedCone(p, p - axis, 1));
        break;
      default:
        append(scene.quadrics, Quadric::sides({ p, p + Vec3{ 1, 1, 1 } }));
        break;
    }
  }
  append(
    scene.quadrics, zerosOf(ball({ 4, 4, 4 }, 4) - brick({ 4, 0, 4 }, { 8, 8, 8 }), boxOf(0, 8)));
  Superquadric rounded;
  rounded.phiRoundness = 0.5;
  rounded.shift = { -4, -4, -4 };
  const auto tree = std::make_shared<const ImplicitTree>(leaf(rounded));
  scene.implicits.push_back({ functionOf(tree), boxOf(2, 6), 0.0 });
  scene.rays = latticeRays(120, 8, 7);
  for (const Vec3& d : { Vec3{ 1, 1, 1 }, Vec3{ 1, 1, 0 }, Vec3{ 0, -1, 1 }, Vec3{ -1, 1, -1 } })
  {
    for (const double start : { -1.0, 0.0, 0.5, 8.0, 9.0 })
    {
      scene.rays.add({ start, start, start }, d);
      scene.rays.add({ start, 8 - start, start }, d);
    }
  }
  return scene;
}

/// Two clusters a million sizes apart along an axis, everything in one plane.
inline CatalogueScene flatAndFarApart()
{
  CatalogueScene scene{ "flat and far apart", {}, {}, {}, {} };
  for (int i = 0; i < 120; ++i)
  {
    const double x = (i < 60 ? 0.0 : 1e6) + 0.5 * (i % 60);
    scene.triangles.push_back({ Vec3{ x, 0, 2 }, Vec3{ x + 1, 0, 2 }, Vec3{ x, 1, 2 } });
    scene.quadrics.push_back(Quadric::disc({ x, 0.5, 2 }, { 0, 0, 1 }, 0.25));
  }
  addRaysAt(scene, 150, 8, scene.rays);
  for (int i = 0; i < 100; ++i)
  {
    scene.rays.add({ 1e6 * (i % 2), 0.125 * (i % 9), 3 }, { i % 2 == 0 ? 1e6 : -1e6, 0, -1 });
  }
  return scene;
}

/// One of each kind at each scale from 2^-60 to 2^60, all around the origin, and a triangle
/// through all of them; rays from each scale at each other.
inline CatalogueScene everyScale()
{
  CatalogueScene scene{ "every scale", {}, {}, {}, {} };
  const double most = 0x1p60;
  scene.triangles.push_back(
    { Vec3{ -most, -most, -most }, Vec3{ most, 0, 0 }, Vec3{ 0, most, 0 } });
  for (int exponent = -60; exponent <= 60; exponent += 2)
  {
    const double s = std::ldexp(1.0, exponent);
    const auto at = [&](double x, double y, double z) -> Vec3 { return { s * x, s * y, s * z }; };
    scene.triangles.push_back({ at(1, 0.5, -0.75), at(0.5, 1, 0.25), at(0.75, 0.5, 0.5) });
    scene.triangles.push_back({ at(-1, -1, 0), at(-0.5, -1, 0), at(-1, -0.5, 0) });
    switch ((exponent + 60) / 2 % 3)
    {
      case 0:
        scene.quadrics.push_back(Quadric::sphere(at(-0.75, 0.75, 0.25), 0.25 * s));
        break;
      case 1:
        append(
          scene.quadrics, Quadric::cappedCylinder(at(0.5, -1, 0.5), at(1, -0.5, 1), 0.125 * s));
        break;
      default:
        append(scene.quadrics, Quadric::sides({ at(-1, 0.5, -1), at(-0.75, 0.75, -0.75) }));
        break;
    }
  }
  addRaysAt(scene, 300, 9, scene.rays);
  return scene;
}

/// Tangents, rims, axes, generators, ties, from inside, from 1e8 away.
inline CatalogueScene bodiesOfEveryKind()
{
  CatalogueScene scene{ "bodies of every kind", someTriangles(), manyKinds(), {}, {} };
  scene.rays = raysFor(*surfaceOf(scene, Matter::DoubleMixed), 80, 10);
  return scene;
}

inline std::vector<CatalogueScene> catalogue()
{
  std::vector<CatalogueScene> scenes = { badSoup(), smallInHuge(),
    farFromTheOrigin("far away", { 448262, 5411932, 312 }),
    farFromTheOrigin("at 2^24", { 0x1p24, -0x1p24, 0x1p24 }), onALattice(), flatAndFarApart(),
    everyScale(), bodiesOfEveryKind() };
  for (CatalogueScene& scene : scenes)
  {
    scene.rays = withOtherLengths(scene.rays);
  }
  return scenes;
}

} // namespace lumitree::testing

#endif
