// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Implicits: closed forms, every structure, what is not certain, what makes no sense.
#include "QuadricScenes.h"
#include "Trees.h"

#include <atomic>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

std::shared_ptr<const Surface> surfaceOf(
  std::vector<Implicit> implicits, const Quadrics& quadrics = {})
{
  return std::make_shared<const Surface>(
    PointArray{}, std::vector<Triangle>{}, quadrics, std::move(implicits));
}

Implicit implicitOf(const ImplicitTree& tree, const Box& box)
{
  return { functionOf(std::make_shared<const ImplicitTree>(tree)), box, 0.0 };
}

Superquadric rounded(double phi, double theta, double alpha = 0.0)
{
  Superquadric s;
  s.phiRoundness = phi;
  s.thetaRoundness = theta;
  s.alpha = alpha;
  return s;
}

/// Any function, known by its values alone; remembers whether two threads asked at once.
class Sampled : public ImplicitFunction
{
public:
  explicit Sampled(std::function<double(const Vec3&)> f)
    : f_(std::move(f))
  {
  }
  [[nodiscard]] double value(const Vec3& x) const override { return this->f_(x); }
  [[nodiscard]] Vec3 gradient(const Vec3&) const override { return { 0, 0, 1 }; }

private:
  std::function<double(const Vec3&)> f_;
};

Implicit sampled(std::function<double(const Vec3&)> f, double step = 0.0)
{
  return { std::make_shared<const Sampled>(std::move(f)), boxOf(-2, 2), step };
}

TEST(Implicits, RoundSuperquadricIsASphere)
{
  const auto tree = build(surfaceOf({ implicitOf(leaf(rounded(1, 1)), boxOf(-1.5, 1.5)) }));
  const auto sphere = build(lumitree::testing::surfaceOf({ Quadric::sphere({ 0, 0, 0 }, 1) }));
  const Rays rays = raysFor(sphere->surface(), 1500, 3);
  const RayBatch batch = rays.batch();
  const Answers got(*tree, rays, Precision::Exact);
  const Answers wanted(*sphere, rays, Precision::Exact);
  std::size_t certain = 0;
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    const auto first = static_cast<std::ptrdiff_t>(got.all.offsets[i]);
    const bool sure = std::all_of(got.all.hits.begin() + first,
      got.all.hits.begin() + static_cast<std::ptrdiff_t>(got.all.offsets[i + 1]),
      [](const Hit& hit) { return hit.flags == 0; });
    // Tangents, and starts on the surface, are not certain.
    if (sure && got.counts[i] > 0)
    {
      ++certain;
      ASSERT_EQ(got.counts[i], wanted.counts[i]) << i;
      const double speed = length(batch[i].direction);
      const double scale = 1e-13 * (1.0 + 1e-2 * length(batch[i].origin)) / speed;
      ASSERT_NEAR(got.closest[i].t, wanted.closest[i].t, scale + 1e-15 * wanted.closest[i].t) << i;
    }
    ASSERT_GE(got.any[i], wanted.any[i]) << i;
  }
  EXPECT_GT(certain, 300u);
}

TEST(Implicits, SquareSuperquadricIsNearlyABox)
{
  // With exponents of 2000 the sides are within 1e-3 of those of the box.
  const auto tree = build(surfaceOf({ implicitOf(leaf(rounded(1e-3, 1e-3)), boxOf(-1.5, 1.5)) }));
  Uniform uniform(4);
  for (int i = 0; i < 200; ++i)
  {
    const Ray ray{ { -3, uniform(-0.9, 0.9), uniform(-0.9, 0.9) }, { 1, 0, 0 } };
    const auto hits = allOf(*tree, ray, Precision::Exact);
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_NEAR(hits[0].t, 2.0, 1e-3);
    EXPECT_NEAR(hits[1].t, 4.0, 1e-3);
    EXPECT_EQ(hits[0].flags, 0u);
  }
}

TEST(Implicits, ToroidalSuperquadricIsATorus)
{
  // The tube has radius 1 around a circle of radius 3 in the plane y = 0.
  const auto tree = build(surfaceOf({ implicitOf(leaf(rounded(1, 1, 3)), boxOf(-5, 5)) }));
  const auto along = allOf(*tree, { { -6, 0, 0 }, { 1, 0, 0 } }, Precision::Exact);
  ASSERT_EQ(along.size(), 4u);
  const double wanted[4] = { 2, 4, 8, 10 };
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(along[i].t, wanted[i], 1e-12);
    EXPECT_EQ(along[i].flags, 0u);
  }
  EXPECT_TRUE(allOf(*tree, { { 0, -6, 0 }, { 0, 1, 0 } }, Precision::Exact).empty());
  const auto top = allOf(*tree, { { -6, 0.5, 0 }, { 1, 0, 0 } }, Precision::Exact);
  ASSERT_EQ(top.size(), 4u);
  EXPECT_NEAR(top[0].t, 6 - 3 - std::sqrt(0.75), 1e-12);
  // The normal grows outward.
  EXPECT_NEAR(tree->surface().normal(0, { 3, 1, 0 })[1], 1.0, 1e-12);
}

TEST(Implicits, EveryStructureGivesTheSameBits)
{
  Quadrics quadrics = { Quadric::sphere({ 1, 1, 1 }, 0.5) };
  std::vector<Implicit> implicits = { implicitOf(leaf(rounded(0.4, 1.7)), boxOf(-1.5, 1.5)),
    implicitOf(leaf(rounded(1, 1, 2)) - ball({ 2, 0, 0 }, 1), boxOf(-4, 4)),
    sampled([](const Vec3& x) { return std::sin(3 * x[0]) + std::cos(2 * x[1]) - x[2]; }) };
  std::vector<double> points;
  std::vector<Triangle> triangles;
  for (const auto& triangle : someTriangles())
  {
    const auto first = static_cast<std::uint32_t>(points.size() / 3);
    triangles.push_back({ first, first + 1, first + 2 });
    for (const Vec3& p : triangle)
    {
      points.insert(points.end(), p.begin(), p.end());
    }
  }
  const auto surface =
    std::make_shared<const Surface>(PointArray::from(points), triangles, quadrics, implicits);
  const Rays rays = raysFor(*surface, 60, 5);
  for (const Precision precision : { Precision::Fast, Precision::Exact })
  {
    const Answers wanted(*build(surface, optionsOf(Structure::BruteForce)), rays, precision);
    for (const auto& accelerator : accelerators(surface))
    {
      SCOPED_TRACE(label(accelerator->options()) + " " + std::string(name(precision)));
      const Answers got(*accelerator, rays, precision);
      EXPECT_EQ(got.any, wanted.any);
      EXPECT_EQ(got.counts, wanted.counts);
      ASSERT_EQ(got.all.offsets, wanted.all.offsets);
      for (std::size_t i = 0; i < got.all.hits.size(); ++i)
      {
        ASSERT_TRUE(sameBits(got.all.hits[i], wanted.all.hits[i])) << i;
        ASSERT_EQ(got.all.hits[i].flags, wanted.all.hits[i].flags) << i;
      }
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        ASSERT_TRUE(sameBits(got.closest[i], wanted.closest[i])) << i;
      }
    }
  }
}

TEST(Implicits, OrderIsCertifiedWhereIntervalsAllow)
{
  const Implicit body = implicitOf(leaf(rounded(1, 1)), boxOf(-1.5, 1.5));
  // A disc a little before the surface, and one that touches it.
  for (const double gap : { 1e-9, 0.0 })
  {
    const auto tree =
      build(surfaceOf({ body }, { Quadric::disc({ -1 - gap, 0, 0 }, { 1, 0, 0 }, 0.5) }));
    const auto hits = allOf(*tree, { { -3, 0, 0 }, { 1, 0, 0 } }, Precision::Exact);
    ASSERT_EQ(hits.size(), 3u);
    EXPECT_EQ(hits[0].primitive, 0u);
    EXPECT_EQ(hits[0].flags, gap > 0 ? 0u : HitFlag::UncertainOrder);
  }
}

TEST(Implicits, WhatIsNotCertainIsMarked)
{
  // The square of a plane has no change of sign.
  QuadricForm squared;
  squared.coefficients = { 1 };
  const auto touch = build(surfaceOf({ implicitOf(leaf(squared), boxOf(-1, 1)) }));
  const Ray through{ { -3, 0.1, 0.2 }, { 1, 0, 0 } };
  const auto hits = allOf(*touch, through, Precision::Exact);
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_NEAR(hits[0].t, 3.0, 1e-7);
  EXPECT_EQ(hits[0].flags, HitFlag::Uncertain);
  EXPECT_TRUE(allOf(*touch, through, Precision::Fast).empty());
  // A form that is 0 all along the ray.
  const auto flat =
    build(surfaceOf({ implicitOf(leaf(Quadric::plane({}, { 0, 0, 1 }, {}).form), boxOf(-1, 1)) }));
  const auto in = allOf(*flat, { { -3, 0, 0 }, { 1, 0, 0 } }, Precision::Exact);
  ASSERT_EQ(in.size(), 1u);
  EXPECT_EQ(in[0].flags, HitFlag::Uncertain);
}

TEST(Implicits, SampledOnesAreSeenAtTheirStep)
{
  // A slab of a hundredth: seen where samples are closer, else only by chance.
  const auto slab = [](const Vec3& x) { return std::fabs(x[0]) - 0.005; };
  const Ray ray{ { -3, 0.3, 0.1 }, { 1, 0, 0 } };
  const auto fine = allOf(*build(surfaceOf({ sampled(slab, 0.004) })), ray, Precision::Exact);
  ASSERT_EQ(fine.size(), 2u);
  EXPECT_NEAR(fine[0].t, 2.995, 1e-11);
  EXPECT_NEAR(fine[1].t, 3.005, 1e-11);
  EXPECT_EQ(fine[0].flags, HitFlag::Sampled);
  EXPECT_TRUE(allOf(*build(surfaceOf({ sampled(slab, 0.3) })), ray, Precision::Exact).empty());
  // Limits do not move the samples.
  const auto half = build(surfaceOf({ sampled([](const Vec3& x) { return x[0]; }) }));
  EXPECT_EQ(closestOf(*half, ray, Precision::Exact).t,
    closestOf(*half, { ray.origin, ray.direction, 2.99, 3.01 }, Precision::Exact).t);
  // Their passages are not known.
  Rays rays;
  rays.add(ray);
  std::uint32_t count = 0;
  EXPECT_THROW(half->crossings(rays.batch(), &count, with(Precision::Exact)), UnsupportedQuery);
}

TEST(Implicits, BadFunctionsAndBoxes)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Ray ray{ { -3, 0.1, 0 }, { 1, 0, 0 } };
  const auto hitsOf = [&](const std::function<double(const Vec3&)>& f)
  { return allOf(*build(surfaceOf({ sampled(f) })), ray, Precision::Exact).size(); };
  EXPECT_EQ(hitsOf([&](const Vec3&) { return nan; }), 0u);
  EXPECT_EQ(hitsOf([](const Vec3&) { return 1.0; }), 0u);
  EXPECT_EQ(hitsOf([](const Vec3&) { return 0.0; }), 0u);
  EXPECT_EQ(hitsOf([](const Vec3& x) { return x[0] < 0 ? -inf : inf; }), 1u);
  EXPECT_EQ(hitsOf([&](const Vec3& x) { return std::fabs(x[0]) < 0.5 ? nan : x[0]; }), 0u);

  const auto function = functionOf(std::make_shared<const ImplicitTree>(ball({ 0, 0, 0 }, 1)));
  const auto surface = surfaceOf({ { function, Box{}, 0.0 }, { function, boxOf(nan, 1), 0.0 },
    { function, boxOf(-inf, inf), 0.0 }, { function, boxOf(5, 6), 0.0 },
    { function, boxOf(-2, 2), 0.0 } });
  EXPECT_EQ(surface->hittable(), (std::vector<PrimitiveId>{ 4 }));
  EXPECT_EQ(surface->nonFiniteCount(), 2u);
  EXPECT_EQ(surface->emptyQuadricCount(), 2u);
  EXPECT_THROW(surfaceOf({ { nullptr, boxOf(-1, 1), 0.0 } }), std::invalid_argument);
  for (const double step : { -1.0, nan, inf, 1e-9 })
  {
    EXPECT_THROW(surfaceOf({ { function, boxOf(-1, 1), step } }), std::invalid_argument) << step;
  }
  Superquadric bad = rounded(0, 1);
  EXPECT_THROW(
    (void)functionOf(std::make_shared<const ImplicitTree>(leaf(bad))), std::invalid_argument);
  bad = rounded(1, 1);
  bad.scale[1] = 0;
  EXPECT_THROW(
    (void)functionOf(std::make_shared<const ImplicitTree>(leaf(bad))), std::invalid_argument);
}

TEST(Implicits, FarTinyAndHuge)
{
  for (const double scale : { 1e-12, 1.0, 1e12 })
  {
    for (const double offset : { 0.0, 1e6 })
    {
      Superquadric s = rounded(0.5, 1.5);
      s.scale = { scale, scale, scale };
      s.shift = { -offset * scale, 0, 0 };
      const Vec3 at = { offset * scale, 0, 0 };
      const Vec3 reach = { 1.5 * scale, 1.5 * scale, 1.5 * scale };
      const auto tree = build(surfaceOf({ implicitOf(leaf(s), { at - reach, at + reach }) }));
      for (const double away : { 3.0, 1e4, 1e8 })
      {
        const Ray ray{ at + Vec3{ 0, 0, away * scale }, { 0, 0, -scale } };
        const auto hits = allOf(*tree, ray, Precision::Exact);
        ASSERT_EQ(hits.size(), 2u) << scale << " " << offset << " " << away;
        EXPECT_NEAR(hits[0].t, away - 1, 1e-9 + 1e-15 * away);
        EXPECT_EQ(hits[1].flags, 0u);
      }
    }
  }
}

} // namespace
