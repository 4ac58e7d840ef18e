// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Passages through quadrics and implicits: the parity is that of the bodies' own inside.
#include "QuadricScenes.h"
#include "Trees.h"

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

std::vector<std::uint32_t> crossingsOf(const Accelerator& accelerator, const Rays& rays)
{
  std::vector<std::uint32_t> counts(rays.size());
  accelerator.crossings(rays.batch(), counts.data(), with(Precision::Exact));
  return counts;
}

/// From one origin in directions of every kind: along axes, on a lattice, any.
Rays around(const Vec3& origin, int count, unsigned seed)
{
  Uniform uniform(seed);
  Rays rays;
  for (int i = 0; i < count; ++i)
  {
    Vec3 d = { uniform(-1, 1), uniform(-1, 1), uniform(-1, 1) };
    if (i < 6)
    {
      d = { 0, 0, 0 };
      d[i / 2] = i % 2 == 0 ? 1.0 : -1.0;
    }
    else if (i % 2 == 0)
    {
      d = { std::floor(uniform(-2, 3)), std::floor(uniform(-2, 3)), 1 };
    }
    rays.add(origin, d);
  }
  return rays;
}

/// Every direction says the same, and what the forms say where they are not 0.
template <class Inside>
void expectParity(const Accelerator& accelerator, Inside inside, double reach)
{
  Uniform uniform(5);
  for (int i = 0; i < 150; ++i)
  {
    Vec3 origin;
    for (double& x : origin)
    {
      x =
        i % 2 == 0 ? uniform(-reach, reach) : 0.25 * std::floor(uniform(-4 * reach, 4 * reach + 1));
    }
    const auto counts = crossingsOf(accelerator, around(origin, 24, 3 + static_cast<unsigned>(i)));
    const int sign = inside(origin);
    for (std::size_t r = 0; r < counts.size(); ++r)
    {
      ASSERT_EQ(counts[r] % 2, counts[0] % 2) << i << " " << r;
    }
    if (sign != 0)
    {
      ASSERT_EQ(counts[0] % 2, sign < 0 ? 1u : 0u) << i;
    }
  }
}

/// Sign of the largest of some forms, exactly: on the lattice of the tests doubles do not round.
template <class... Forms>
int largest(const Vec3& x, const Forms&... forms)
{
  const double value = std::max({ valueAt(forms, x)... });
  return value > 1e-12 ? 1 : (value < -1e-12 ? -1 : 0);
}

TEST(BodyCrossings, SphereConeAndCylinder)
{
  const Quadric sphere = Quadric::sphere({ 0, 0, 0 }, 1);
  expectParity(
    *build(surfaceOf({ sphere })), [&](const Vec3& x) { return largest(x, sphere.form); }, 1.5);
  const auto can = Quadric::cappedCylinder({ 0, 0, -1 }, { 0, 0, 1 }, 0.75);
  expectParity(
    *build(surfaceOf(can)),
    [&](const Vec3& x) { return largest(x, can[0].form, can[1].form, can[2].form); }, 1.5);
  const auto hat = Quadric::cappedCone({ 0, 0, 1 }, { 0, 0, -1 }, 1);
  expectParity(
    *build(surfaceOf(hat)),
    [&](const Vec3& x)
    {
      // Above the apex is the other half of the cone.
      return x[2] > 1 ? 1 : largest(x, hat[0].form, hat[1].form);
    },
    1.5);
}

TEST(BodyCrossings, EveryStructureCountsTheSame)
{
  Quadrics all = Quadric::sides(boxOf(-1, 1));
  append(all, Quadric::cappedCylinder({ -2, -2, -1 }, { 1, 2, 1.5 }, 0.75));
  append(all, zerosOf(ball({ 1, 1, 1 }, 1) - ball({ 1, 1, 2 }, 1), boxOf(-3, 3)));
  all.push_back(Quadric::sphere({ 0, 0, 0 }, 1));
  const auto surface = surfaceOf<float>(someTriangles(), all);
  const Rays rays = raysFor(*surface, 1500, 4);
  const auto wanted = crossingsOf(*build(surface, optionsOf(Structure::BruteForce)), rays);
  for (const auto& accelerator : accelerators(surface))
  {
    EXPECT_EQ(crossingsOf(*accelerator, rays), wanted) << label(accelerator->options());
  }
}

TEST(BodyCrossings, TouchingIsTwiceOrNotAtAll)
{
  const auto sphere = build(surfaceOf({ Quadric::sphere({ 0, 0, 0 }, 1) }));
  Rays rays;
  for (const double side : { -1.0, 1.0 })
  {
    for (int k = 0; k < 3; ++k)
    {
      Vec3 origin = { 0, 0, 0 };
      Vec3 direction = { 0, 0, 0 };
      origin[k] = side;
      origin[(k + 1) % 3] = -5;
      direction[(k + 1) % 3] = 1;
      rays.add(origin, direction);
    }
  }
  // Moved along x by more than along y and z: only the first is moved in.
  EXPECT_EQ(crossingsOf(*sphere, rays), (std::vector<std::uint32_t>{ 2, 0, 0, 0, 0, 0 }));
}

TEST(BodyCrossings, RimsThatTheSimplestMoveWouldFollow)
{
  // y = x² + z², ended by z = 0: seen along z from the origin the rim is y = x², which the move
  // (e, e², e³) would run along. Closed by the plane and by y = 1.
  QuadricForm bowl;
  bowl.coefficients = { 1, 0, 1, 0, 0, 0, 0, -1, 0, 0 };
  const ImplicitTree tree =
    leaf(bowl) & halfSpace({ 0, 0, 0 }, { 0, 0, -1 }) & halfSpace({ 0, 1, 0 }, { 0, 1, 0 });
  const auto half = build(surfaceOf(zerosOf(tree, boxOf(-2, 2))));
  for (const Vec3& origin : { Vec3{ 0, 0, 0 }, Vec3{ 0, 0, -1 }, Vec3{ 0.5, 0.25, -1 },
         Vec3{ 0.5, 0.25, 0 }, Vec3{ 0, 0.5, 0 }, Vec3{ 0, 1, 0.5 } })
  {
    const auto counts = crossingsOf(*half, around(origin, 40, 2));
    for (std::size_t r = 0; r < counts.size(); ++r)
    {
      EXPECT_EQ(counts[r] % 2, counts[0] % 2) << origin[0] << " " << origin[2] << " " << r;
    }
  }
}

TEST(BodyCrossings, TreesThatShareFaces)
{
  const ImplicitTree left = brick({ -1, -1, -1 }, { 0, 1, 1 });
  const ImplicitTree right = brick({ 0, -1, -1 }, { 1, 1, 1 });
  // Not the same numbers, but the same plane.
  QuadricForm scaled = halfSpace({ 0, 0, 0 }, { 3, 0, 0 }).forms[0];
  scaled.centre = { 0, 7, 0 };
  const auto inside = [](const Vec3& x)
  {
    const double m = std::max({ std::fabs(x[0]), std::fabs(x[1]), std::fabs(x[2]) });
    return m > 1 ? 1 : (m < 1 && x[0] != 0 ? -1 : 0);
  };
  expectParity(*build(surfaceOf(zerosOf(left | right, boxOf(-2, 2)))), inside, 1.5);
  // Two that only touch, as one tree, have no surface between them.
  EXPECT_EQ(crossingsOf(*build(surfaceOf(zerosOf(left | right, boxOf(-2, 2)))),
              around({ -0.5, 0.1, 0.2 }, 1, 1))[0],
    1u);
  const ImplicitTree whole = brick({ -1, -1, -1 }, { 1, 1, 1 });
  expectParity(
    *build(surfaceOf(zerosOf(whole & leaf(scaled), boxOf(-2, 2)))),
    [&](const Vec3& x) { return x[0] > 0 ? 1 : inside(x); }, 1.5);
  expectParity(
    *build(surfaceOf(zerosOf((whole & leaf(scaled)) | left, boxOf(-2, 2)))),
    [&](const Vec3& x) { return x[0] > 0 ? 1 : inside(x); }, 1.5);
}

TEST(BodyCrossings, SegmentsOfALineAddUp)
{
  Quadrics all = Quadric::cappedCylinder({ -1, -1, -1 }, { 1, 1, 1 }, 0.75);
  append(all, zerosOf(ball({ 0, 0, 0 }, 1) | ball({ 1, 0, 0 }, 1), boxOf(-3, 3)));
  const auto tree = build(surfaceOf(all));
  Uniform uniform(8);
  for (int i = 0; i < 300; ++i)
  {
    Ray ray;
    for (int k = 0; k < 3; ++k)
    {
      ray.origin[k] = 0.5 * std::floor(uniform(-4, 5));
      ray.direction[k] = std::floor(uniform(-2, 3));
    }
    if (ray.direction == Vec3{ 0, 0, 0 })
    {
      continue;
    }
    const double b = 0.5 * std::floor(uniform(0, 6));
    Rays rays;
    rays.add({ ray.origin, ray.direction, -2.0, b });
    rays.add({ ray.origin, ray.direction, b, 7.0 });
    rays.add({ ray.origin, ray.direction, -2.0, 7.0 });
    const auto counts = crossingsOf(*tree, rays);
    EXPECT_EQ(counts[0] + counts[1], counts[2]) << i;
  }
}

TEST(BodyCrossings, ImplicitsByTheirSigns)
{
  Superquadric pillow;
  pillow.phiRoundness = 0.5;
  pillow.thetaRoundness = 0.5;
  const auto tree = std::make_shared<const ImplicitTree>(leaf(pillow) - ball({ 1, 0, 0 }, 0.5));
  const auto function = functionOf(tree);
  const auto surface = std::make_shared<const Surface>(PointArray{}, std::vector<Triangle>{},
    std::vector<Quadric>{}, std::vector<Implicit>{ { function, boxOf(-1.5, 1.5), 0.0 } });
  expectParity(
    *build(surface),
    [&](const Vec3& x)
    {
      const double value = function->value(x);
      return std::fabs(value) < 1e-9 ? 0 : (value < 0 ? -1 : 1);
    },
    1.5);
}

} // namespace
