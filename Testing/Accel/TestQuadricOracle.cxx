// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Quadrics against an oracle in long arithmetic.
#include "QuadricScenes.h"

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

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

} // namespace
