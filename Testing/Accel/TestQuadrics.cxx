// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Quadrics: closed forms, an oracle in long arithmetic, every structure against brute force.
#include "QuadricOracle.h"
#include "TestHelpers.h"

#include <gtest/gtest.h>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

constexpr double inf = std::numeric_limits<double>::infinity();

using Quadrics = std::vector<Quadric>;

void append(Quadrics& all, const Quadrics& more)
{
  all.insert(all.end(), more.begin(), more.end());
}

std::shared_ptr<const Surface> surfaceOf(const Quadrics& quadrics)
{
  return std::make_shared<const Surface>(PointArray{}, std::vector<Triangle>{}, quadrics);
}

template <class T>
std::shared_ptr<const Surface> surfaceOf(
  const std::vector<std::array<Vec3, 3>>& triangles, const Quadrics& quadrics)
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
    PointArray::from(std::move(points)), std::move(indices), quadrics);
}

std::vector<Hit> hitsOf(const Quadrics& quadrics, const Ray& ray, Precision precision)
{
  return allOf(*build(surfaceOf(quadrics), optionsOf(Structure::BruteForce)), ray, precision);
}

Quadric paraboloidUpTo(double height)
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
Quadrics manyKinds()
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

std::vector<std::array<Vec3, 3>> someTriangles()
{
  // One touches the unit sphere at (0, 0, -1), one lies in the plane of a disc, one cuts.
  return { { Vec3{ -2, -2, -1 }, Vec3{ 3, -2, -1 }, Vec3{ 0, 3, -1 } },
    { Vec3{ -1, -1, 1 }, Vec3{ 2, -1, 1 }, Vec3{ 0, 2, 1 } },
    { Vec3{ -4, 0.1, -1 }, Vec3{ 4, 0, 2 }, Vec3{ 0, 1, 4 } } };
}

/// Rays of every kind: random, on a lattice (through tangents, rims, apexes, corners), nearly
/// tangent, from far away.
Rays raysFor(const Surface& surface, std::size_t count, unsigned seed)
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

TEST(Quadrics, TangentIsOneHit)
{
  for (const Precision precision : everyPrecision)
  {
    const auto hits =
      hitsOf({ Quadric::sphere({ 0, 0, 0 }, 1) }, { { -5, 1, 0 }, { 1, 0, 0 } }, precision);
    ASSERT_EQ(hits.size(), 1u) << name(precision);
    EXPECT_EQ(hits[0].t, 5.0);
  }
}

TEST(Quadrics, TangentByARadiusWhoseSquareRounds)
{
  for (const double r : { 0.1, 1.0 / 3, 1e-150, 1e10 / 7, 1e150 / 3 })
  {
    const Quadrics sphere = { Quadric::sphere({ 0, 0, 0 }, r) };
    const Ray touching{ { -5 * r, r, 0 }, { 1, 0, 0 } };
    const Ray beside{ { -5 * r, std::nextafter(r, inf), 0 }, { 1, 0, 0 } };
    const Ray inside{ { -5 * r, std::nextafter(r, 0.0), 0 }, { 1, 0, 0 } };
    if (r > 1e-140)
    {
      EXPECT_EQ(hitsOf(sphere, touching, Precision::Exact).size(), 1u) << r;
    }
    EXPECT_EQ(hitsOf(sphere, beside, Precision::Exact).size(), 0u) << r;
    EXPECT_EQ(hitsOf(sphere, inside, Precision::Exact).size(), 2u) << r;
  }
}

TEST(Quadrics, FromInsideOnAndFarAway)
{
  const Quadrics sphere = { Quadric::sphere({ 0, 0, 0 }, 1) };
  for (const Precision precision : everyPrecision)
  {
    SCOPED_TRACE(name(precision));
    const auto centre = hitsOf(sphere, { { 0, 0, 0 }, { 0, 2, 0 } }, precision);
    ASSERT_EQ(centre.size(), 1u);
    EXPECT_EQ(centre[0].t, 0.5);
    const auto on = hitsOf(sphere, { { -1, 0, 0 }, { 1, 0, 0 } }, precision);
    ASSERT_EQ(on.size(), 2u);
    EXPECT_EQ(on[0].t, 0.0);
    EXPECT_EQ(on[1].t, 2.0);
    const auto far = hitsOf(sphere, { { 1e8, 0.5, 0 }, { -1, 0, 0 } }, precision);
    ASSERT_EQ(far.size(), 2u);
    EXPECT_NEAR(far[0].t, 1e8 - std::sqrt(0.75), 2e-8);
    EXPECT_NEAR(far[1].t, 1e8 + std::sqrt(0.75), 2e-8);
  }
}

TEST(Quadrics, AxesAndGenerators)
{
  const Quadrics tube = { Quadric::cylinder({ 0, 0, 0 }, { 0, 0, 2 }, 1) };
  const Quadrics can = Quadric::cappedCylinder({ 0, 0, 0 }, { 0, 0, 2 }, 1);
  const Quadrics cone = { Quadric::cone({ 0, 0, 0 }, { 0, 0, 2 }, 2) };
  for (const Precision precision : everyPrecision)
  {
    SCOPED_TRACE(name(precision));
    EXPECT_EQ(hitsOf(tube, { { 0, 0, -1 }, { 0, 0, 1 } }, precision).size(), 0u);
    EXPECT_EQ(hitsOf(tube, { { 1, 0, -1 }, { 0, 0, 1 } }, precision).size(), 0u);
    EXPECT_EQ(hitsOf(can, { { 0, 0, -1 }, { 0, 0, 1 } }, precision).size(), 2u);
    EXPECT_EQ(hitsOf(can, { { 1, 0, -1 }, { 0, 0, 1 } }, precision).size(), 2u);
    // At the rim the ray meets the tube and the disc.
    EXPECT_EQ(hitsOf(can, { { -2, 0, 2 }, { 1, 0, 0 } }, precision).size(), 2u);
    EXPECT_EQ(hitsOf(tube, { { -2, 0, 2.5 }, { 1, 0, 0 } }, precision).size(), 0u);
    // Along a generator of the cone, along its axis, through its apex.
    EXPECT_EQ(hitsOf(cone, { { 0, 0, 0 }, { 1, 0, 1 } }, precision).size(), 0u);
    EXPECT_EQ(hitsOf(cone, { { 0, 0, -1 }, { 0, 0, 1 } }, precision).size(), 1u);
    EXPECT_EQ(hitsOf(cone, { { -1, 0, 0 }, { 1, 0, 0 } }, precision).size(), 1u);
  }
}

TEST(Quadrics, LimitsAreClosed)
{
  const auto brute =
    build(surfaceOf({ Quadric::sphere({ 0, 0, 0 }, 1) }), optionsOf(Structure::BruteForce));
  const double root = std::sqrt(0.75); // not the root: on one side of it
  for (const Precision precision : everyPrecision)
  {
    SCOPED_TRACE(name(precision));
    EXPECT_EQ(allOf(*brute, { { -3, 0, 0 }, { 1, 0, 0 }, 2, 4 }, precision).size(), 2u);
    EXPECT_EQ(closestOf(*brute, { { -3, 0, 0 }, { 1, 0, 0 }, 3, 4 }, precision).t, 4.0);
  }
  EXPECT_EQ(
    allOf(*brute, { { -3, 0, 0 }, { 1, 0, 0 }, std::nextafter(2, 3), 5 }, Precision::Exact).size(),
    1u);
  const bool below = rational(root) * rational(root) < rational(0.75);
  const Ray ray{ { 0, 0.5, 0 }, { 1, 0, 0 }, 0, root };
  EXPECT_EQ(allOf(*brute, ray, Precision::Exact).size(), below ? 0u : 1u);
  const Ray from{ { 0, 0.5, 0 }, { 1, 0, 0 }, root, 9 };
  EXPECT_EQ(allOf(*brute, from, Precision::Exact).size(), below ? 1u : 0u);
}

TEST(Quadrics, TiesGoToTheLowestPrimitive)
{
  // Two spheres touch at (1, 0, 0); a triangle touches the first at (0, 0, -1).
  const auto mixed = surfaceOf<float>(
    someTriangles(), { Quadric::sphere({ 0, 0, 0 }, 1), Quadric::sphere({ 2, 0, 0 }, 1) });
  for (const auto& accelerator : accelerators(mixed))
  {
    SCOPED_TRACE(label(accelerator->options()));
    const Ray through{ { 1, 0, -0.5 }, { 0, 0, 1 }, 0, 0.75 };
    const auto touching = allOf(*accelerator, through, Precision::Exact);
    ASSERT_EQ(touching.size(), 2u);
    EXPECT_EQ(touching[0].primitive, 3u);
    EXPECT_EQ(touching[1].primitive, 4u);
    EXPECT_EQ(touching[0].t, 0.5);
    const auto up = allOf(*accelerator, { { 0, 0, -3 }, { 0, 0, 1 } }, Precision::Exact);
    ASSERT_GE(up.size(), 2u);
    EXPECT_EQ(up[0].primitive, 0u);
    EXPECT_EQ(up[1].primitive, 3u);
    EXPECT_EQ(up[0].t, up[1].t);
  }
}

TEST(Quadrics, ExactIsWhatLongArithmeticSays)
{
  const auto mixed = surfaceOf<double>(someTriangles(), manyKinds());
  ASSERT_EQ(mixed->hittable().size(), mixed->size());
  const auto brute = build(mixed, optionsOf(Structure::BruteForce));
  const Rays rays = raysFor(*mixed, 1000, 3);
  const RayBatch batch = rays.batch();
  const Answers answers(*brute, rays, Precision::Exact);
  std::size_t several = 0;
  for (std::size_t i = 0; i < batch.size; ++i)
  {
    SCOPED_TRACE(i);
    const auto wanted = oracleHits(*mixed, batch[i]);
    ASSERT_EQ(answers.counts[i], wanted.size());
    ASSERT_EQ(answers.any[i], wanted.empty() ? 0 : 1);
    ASSERT_EQ(answers.all.offsets[i + 1] - answers.all.offsets[i], wanted.size());
    ASSERT_EQ(
      answers.closest[i].primitive, wanted.empty() ? noPrimitive : wanted.front().primitive);
    for (std::size_t h = 0; h < wanted.size(); ++h)
    {
      const Hit& hit = answers.all.hits[answers.all.offsets[i] + h];
      ASSERT_EQ(hit.primitive, wanted[h].primitive);
      ASSERT_LE(abs(Long(hit.t) - wanted[h].t), ldexp(abs(wanted[h].t), -26));
      several += wanted.size() > 1 ? 1 : 0;
    }
  }
  EXPECT_GT(several, 500u);
}

TEST(Quadrics, TinyHugeAndFar)
{
  for (const double scale : { 1e-100, 1e-9, 1.0, 1e9, 1e100 })
  {
    for (const double offset : { 0.0, 1e6 })
    {
      Quadrics all;
      const Vec3 at = { offset * scale, -offset * scale, 0 };
      all.push_back(Quadric::sphere(at, scale));
      append(all, Quadric::cappedCylinder(at, at + Vec3{ 0, 0, 3 * scale }, 0.5 * scale));
      all.push_back(Quadric::cone(at, at + Vec3{ scale, scale, scale }, scale));
      const auto surface = surfaceOf(all);
      const auto brute = build(surface, optionsOf(Structure::BruteForce));
      Uniform uniform(9);
      for (int i = 0; i < 60; ++i)
      {
        const double away = std::pow(10.0, uniform(0, 8)) * scale;
        Ray ray;
        Vec3 target;
        for (int k = 0; k < 3; ++k)
        {
          ray.origin[k] = at[k] + uniform(-1, 1) * away;
          target[k] = at[k] + uniform(-1, 1) * scale;
        }
        ray.direction = target - ray.origin;
        const auto wanted = oracleHits(*surface, ray);
        const auto hits = allOf(*brute, ray, Precision::Exact);
        ASSERT_EQ(hits.size(), wanted.size()) << scale << " " << offset << " " << i;
        for (std::size_t h = 0; h < hits.size(); ++h)
        {
          EXPECT_EQ(hits[h].primitive, wanted[h].primitive);
          EXPECT_LE(abs(Long(hits[h].t) - wanted[h].t), ldexp(abs(wanted[h].t), -26));
        }
      }
    }
  }
}

class QuadricPrecisions : public ::testing::TestWithParam<Precision>
{
};

TEST_P(QuadricPrecisions, EveryStructureGivesTheSameBits)
{
  Quadrics scattered;
  Uniform uniform(4);
  for (int i = 0; i < 200; ++i)
  {
    const Vec3 at = { uniform(-4, 4), uniform(-4, 4), uniform(-4, 4) };
    const Vec3 to = at + Vec3{ uniform(-1, 1), uniform(-1, 1), uniform(-1, 1) };
    const double r = uniform(0.05, 0.4);
    append(scattered,
      i % 3 == 0
        ? Quadrics{ Quadric::sphere(at, r) }
        : (i % 3 == 1 ? Quadric::cappedCylinder(at, to, r) : Quadric::cappedCone(at, to, r)));
  }
  const std::vector<std::shared_ptr<const Surface>> surfaces = { surfaceOf(manyKinds()),
    surfaceOf<float>(someTriangles(), manyKinds()), surfaceOf<double>(someTriangles(), scattered) };
  for (const auto& surface : surfaces)
  {
    const Rays rays = raysFor(*surface, 3000, 5);
    const Answers wanted(*build(surface, optionsOf(Structure::BruteForce)), rays, GetParam());
    for (const auto& accelerator : accelerators(surface))
    {
      SCOPED_TRACE(label(accelerator->options()));
      const Answers got(*accelerator, rays, GetParam());
      std::size_t differences = 0;
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        differences += sameBits(got.closest[i], wanted.closest[i]) ? 0 : 1;
      }
      EXPECT_EQ(differences, 0u);
      EXPECT_EQ(got.any, wanted.any);
      EXPECT_EQ(got.counts, wanted.counts);
      EXPECT_EQ(got.all.offsets, wanted.all.offsets);
      ASSERT_EQ(got.all.hits.size(), wanted.all.hits.size());
      for (std::size_t i = 0; i < got.all.hits.size(); ++i)
      {
        ASSERT_TRUE(sameBits(got.all.hits[i], wanted.all.hits[i])) << i;
      }
    }
  }
}

TEST_P(QuadricPrecisions, AnswersOfOneStructureAgree)
{
  const auto surface = surfaceOf<double>(someTriangles(), manyKinds());
  const Rays rays = raysFor(*surface, 3000, 6);
  const Answers a(*build(surface, optionsOf(Structure::WideBvh)), rays, GetParam());
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    const std::size_t count = a.all.offsets[i + 1] - a.all.offsets[i];
    ASSERT_EQ(a.counts[i], count);
    ASSERT_EQ(a.any[i], count > 0 ? 1 : 0);
    ASSERT_EQ(a.closest[i].primitive != noPrimitive, count > 0);
    if (count > 0)
    {
      ASSERT_TRUE(sameBits(a.closest[i], a.all.hits[a.all.offsets[i]])) << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Precisions, QuadricPrecisions,
  ::testing::Values(Precision::Fast, Precision::Watertight, Precision::Exact),
  [](const auto& precision) { return std::string(name(precision.param)); });

TEST(Quadrics, WatertightFindsAllThatIsHit)
{
  const auto surface = surfaceOf(manyKinds());
  const auto brute = build(surface, optionsOf(Structure::BruteForce));
  const Rays rays = raysFor(*surface, 5000, 8);
  const Answers exact(*brute, rays, Precision::Exact);
  const Answers watertight(*brute, rays, Precision::Watertight);
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    ASSERT_GE(watertight.any[i], exact.any[i]);
    for (std::size_t h = exact.all.offsets[i]; h < exact.all.offsets[i + 1]; ++h)
    {
      const auto begin = watertight.all.hits.begin();
      ASSERT_TRUE(std::any_of(begin + static_cast<std::ptrdiff_t>(watertight.all.offsets[i]),
        begin + static_cast<std::ptrdiff_t>(watertight.all.offsets[i + 1]),
        [&](const Hit& hit) { return hit.primitive == exact.all.hits[h].primitive; }));
    }
  }
}

TEST(Quadrics, SolidsDoNotLeak)
{
  // From inside a closed body every ray leaves it, also through rims, edges and corners.
  Box box;
  box.extend(Vec3{ -1, -1, -1 });
  box.extend(Vec3{ 1, 1, 1 });
  const std::vector<Quadrics> bodies = { Quadric::cappedCylinder(
                                           { -1, -1, -1 }, { 1, 1.3, 1 }, 0.7),
    Quadric::cappedCone({ 1, 1, 1 }, { -1, -1, -1.1 }, 2), Quadric::sides(box) };
  for (const Quadrics& body : bodies)
  {
    const auto accelerator = build(surfaceOf(body), optionsOf(Structure::WideBvh));
    Uniform uniform(12);
    for (int i = 0; i < 3000; ++i)
    {
      Ray ray{ { 0, 0, 0 }, { uniform(-1, 1), uniform(-1, 1), uniform(-1, 1) } };
      if (i % 2 == 0)
      {
        ray.direction = { std::floor(uniform(-2, 3)), std::floor(uniform(-2, 3)), 1 };
      }
      for (const Precision precision : { Precision::Watertight, Precision::Exact })
      {
        ASSERT_NE(closestOf(*accelerator, ray, precision).primitive, noPrimitive)
          << i << name(precision);
      }
    }
  }
}

TEST(Quadrics, BadOnesAreCountedAndNeverHit)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  QuadricForm imaginary;
  imaginary.coefficients = { 1, 1, 1, 0, 0, 0, 0, 0, 0, 1 };
  QuadricForm constant;
  constant.coefficients[9] = 0.0;
  Box box;
  box.extend(Vec3{ -1, -1, -1 });
  box.extend(Vec3{ 1, 1, 1 });
  Quadric outside = Quadric::sphere({ 0, 0, 0 }, 1);
  outside.clip = Box{};
  outside.clip.extend(Vec3{ 5, 5, 5 });
  outside.clip.extend(Vec3{ 6, 6, 6 });
  const Quadrics bad = { Quadric::sphere({ nan, 0, 0 }, 1), Quadric::sphere({ 0, inf, 0 }, 1),
    Quadric::inBox(imaginary, { { -inf, -1, -1 }, { 1, 1, 1 } }), // three that are not finite
    Quadric::sphere({ 0, 0, 0 }, nan), Quadric::sphere({ 0, 0, 0 }, -1),
    Quadric::sphere({ 0, 0, 0 }, 0), Quadric::sphere({ 0, 0, 0 }, inf),
    Quadric::cylinder({ 1, 1, 1 }, { 1, 1, 1 }, 1), Quadric::disc({ 0, 0, 0 }, { 0, 0, 0 }, 1),
    Quadric::inBox(imaginary, box), Quadric::inBox(constant, box), outside, Quadric{} };
  Quadrics all = bad;
  all.push_back(Quadric::sphere({ 0, 0, 0 }, 1));
  const auto surface = surfaceOf(all);
  EXPECT_EQ(surface->size(), all.size());
  EXPECT_EQ(surface->nonFiniteCount(), 3u);
  EXPECT_EQ(surface->emptyQuadricCount(), bad.size() - 3);
  EXPECT_EQ(surface->hittable().size(), 1u);
  for (const auto& accelerator : accelerators(surface))
  {
    for (const Precision precision : everyPrecision)
    {
      const auto hits = allOf(*accelerator, { { -4, 0, 0 }, { 1, 0, 0 } }, precision);
      ASSERT_EQ(hits.size(), 2u);
      EXPECT_EQ(hits[0].primitive, bad.size());
      EXPECT_TRUE(allOf(*accelerator, { { nan, 0, 0 }, { 1, 0, 0 } }, precision).empty());
    }
  }
  for (const auto& accelerator : accelerators(surfaceOf(bad)))
  {
    EXPECT_TRUE(allOf(*accelerator, { { -4, 0, 0 }, { 1, 0, 0 } }, Precision::Exact).empty());
  }
}

TEST(Quadrics, NormalsPointOutward)
{
  const auto surface = surfaceOf<double>(someTriangles(), manyKinds());
  const Vec3 n = surface->normal(3, { 0.6, 0, 0.8 });
  EXPECT_NEAR(n[0], 0.6, 1e-15);
  EXPECT_NEAR(n[2], 0.8, 1e-15);
  EXPECT_EQ(surface->normal(0, {}), (Vec3{ 0, 0, 1 }));
  // The apex of a cone has none.
  const auto cone = surfaceOf({ Quadric::cone({ 0, 0, 0 }, { 0, 0, 1 }, 1) });
  EXPECT_EQ(cone->normal(0, { 0, 0, 0 }), (Vec3{ 0, 0, 0 }));
}

TEST(Quadrics, AreSkippedWithBothRoots)
{
  const auto tree =
    build(surfaceOf({ Quadric::sphere({ 0, 0, 0 }, 1), Quadric::sphere({ 0, 0, 0 }, 2) }),
      optionsOf(Structure::Bvh));
  Rays rays;
  rays.add({ 0, 0, 0 }, { 1, 0, 0 });
  RayBatch batch = rays.batch();
  const std::uint64_t offsets[] = { 0, 1 };
  const std::uint32_t skipped[] = { 0 };
  batch.skip.offsets = offsets;
  batch.skip.primitives = skipped;
  Hit hit;
  tree->closest(batch, &hit, with(Precision::Exact));
  EXPECT_EQ(hit.primitive, 1u);
  EXPECT_EQ(hit.t, 2.0);
}

TEST(Quadrics, OverlapGoesByTheirBoxes)
{
  const auto surface = surfaceOf<double>(someTriangles(), manyKinds());
  Uniform uniform(2);
  for (int i = 0; i < 50; ++i)
  {
    HalfSpace half;
    half.normal = { uniform(-1, 1), uniform(-1, 1), uniform(-1, 1) };
    half.offset = uniform(-4, 4);
    std::vector<PrimitiveId> wanted;
    for (const auto& accelerator : accelerators(surface))
    {
      std::vector<PrimitiveId> found;
      accelerator->overlap({ half }, found);
      if (wanted.empty())
      {
        wanted = found;
      }
      EXPECT_EQ(found, wanted) << label(accelerator->options());
    }
  }
}

TEST(Quadrics, ReferencesOfTrianglesRefuseThem)
{
  if (!Registry::instance().has(Structure::Embree))
  {
    GTEST_SKIP() << "built without Embree";
  }
  try
  {
    (void)build(surfaceOf({ Quadric::sphere({ 0, 0, 0 }, 1) }), optionsOf(Structure::Embree));
    FAIL() << "no refusal";
  }
  catch (const std::invalid_argument& e)
  {
    EXPECT_STREQ(e.what(), "Embree knows triangles only, the surface has quadrics: 1");
  }
}

} // namespace
