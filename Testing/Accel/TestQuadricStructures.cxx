// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Quadrics in every structure: against brute force; what else is asked of them.
#include "QuadricScenes.h"

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

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
