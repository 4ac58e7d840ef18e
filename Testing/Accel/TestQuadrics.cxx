// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Quadrics: closed forms, limits, ties, normals.
#include "QuadricScenes.h"

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

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

} // namespace
