// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Unions, intersections and differences of quadrics: exact as quadrics are.
#include "QuadricScenes.h"
#include "Trees.h"

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

Quadrics manyTrees()
{
  const ImplicitTree two = ball({ 0, 0, 0 }, 1) | ball({ 1, 0, 0 }, 1);
  Quadrics all = zerosOf(two, boxOf(-4, 4));
  // A brick with a hole, whose ends lie in its sides; a bite taken off by an equal face.
  const ImplicitTree hole = leaf(Quadric::cylinder({ 0, -3, -3 }, { 0, -3, -1 }, 0.5).form) &
    brick({ -1, -4, -3 }, { 1, -2, -1 });
  append(all, zerosOf(brick({ -1, -4, -3 }, { 1, -2, -1 }) - hole, boxOf(-4, 4)));
  append(all,
    zerosOf(brick({ -3, 1, 1 }, { -1, 3, 3 }) - brick({ -2, 2, 1 }, { -1, 3, 2 }), boxOf(-4, 4)));
  append(all,
    zerosOf(then(ball({ 3, 3, 0 }, 0.5), ImplicitTree::Operation::Magnitude) |
        then(ball({ 3, 2.5, 0 }, 0.5), ImplicitTree::Operation::Magnitude),
      boxOf(-4, 4)));
  return all;
}

void expectOracle(const Surface& surface, const Accelerator& accelerator, const Rays& rays)
{
  const RayBatch batch = rays.batch();
  AllHits all;
  accelerator.all(batch, all, with(Precision::Exact));
  std::size_t several = 0;
  for (std::size_t i = 0; i < batch.size; ++i)
  {
    const auto wanted = oracleHits(surface, batch[i]);
    ASSERT_EQ(all.offsets[i + 1] - all.offsets[i], wanted.size()) << i;
    several += wanted.size() > 1 ? 1 : 0;
    for (std::size_t h = 0; h < wanted.size(); ++h)
    {
      const Hit& hit = all.hits[all.offsets[i] + h];
      ASSERT_EQ(hit.primitive, wanted[h].primitive) << i;
      ASSERT_LE(abs(Long(hit.t) - wanted[h].t), ldexp(abs(wanted[h].t), -26)) << i;
      ASSERT_EQ(hit.flags, 0u);
    }
  }
  EXPECT_GT(several, batch.size / 5);
}

TEST(QuadricTrees, ExactIsWhatLongArithmeticSays)
{
  const auto surface = surfaceOf<double>(someTriangles(), manyTrees());
  ASSERT_EQ(surface->hittable().size(), surface->size());
  expectOracle(*surface, *build(surface, optionsOf(Structure::WideBvh)), raysFor(*surface, 300, 3));
}

TEST(QuadricTrees, EveryStructureGivesTheSameBits)
{
  const auto surface = surfaceOf<float>(someTriangles(), manyTrees());
  const Rays rays = raysFor(*surface, 500, 5);
  for (const Precision precision : everyPrecision)
  {
    const Answers wanted(*build(surface, optionsOf(Structure::BruteForce)), rays, precision);
    for (const auto& accelerator : accelerators(surface))
    {
      SCOPED_TRACE(label(accelerator->options()) + " " + std::string(name(precision)));
      const Answers got(*accelerator, rays, precision);
      EXPECT_EQ(got.any, wanted.any);
      EXPECT_EQ(got.counts, wanted.counts);
      ASSERT_EQ(got.all.hits.size(), wanted.all.hits.size());
      for (std::size_t i = 0; i < got.all.hits.size(); ++i)
      {
        ASSERT_TRUE(sameBits(got.all.hits[i], wanted.all.hits[i])) << i;
      }
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        ASSERT_TRUE(sameBits(got.closest[i], wanted.closest[i])) << i;
      }
    }
  }
}

TEST(QuadricTrees, UnionOfTwoSpheresInClosedForm)
{
  // The spheres meet in the circle x = 1/2; what is inside the other is no surface.
  const Quadrics both = zerosOf(ball({ 0, 0, 0 }, 1) | ball({ 1, 0, 0 }, 1), boxOf(-4, 4));
  ASSERT_EQ(both.size(), 2u);
  for (const Precision precision : everyPrecision)
  {
    const auto along = hitsOf(both, { { -3, 0, 0 }, { 1, 0, 0 } }, precision);
    ASSERT_EQ(along.size(), 2u) << name(precision);
    EXPECT_EQ(along[0].t, 2.0);
    EXPECT_EQ(along[1].t, 5.0);
  }
  const Quadrics lens = zerosOf(ball({ 0, 0, 0 }, 1) & ball({ 1, 0, 0 }, 1), boxOf(-4, 4));
  const auto in = hitsOf(lens, { { -3, 0, 0 }, { 1, 0, 0 } }, Precision::Exact);
  ASSERT_EQ(in.size(), 2u);
  EXPECT_EQ(in[0].t, 3.0);
  EXPECT_EQ(in[0].primitive, 1u);
  EXPECT_EQ(in[1].t, 4.0);
  const Quadrics bitten = zerosOf(ball({ 0, 0, 0 }, 1) - ball({ 1, 0, 0 }, 1), boxOf(-4, 4));
  const auto left = hitsOf(bitten, { { -3, 0, 0 }, { 1, 0, 0 } }, Precision::Exact);
  ASSERT_EQ(left.size(), 2u);
  EXPECT_EQ(left[1].t, 3.0);
}

TEST(QuadricTrees, ABrickIsItsSides)
{
  const Quadrics tree = zerosOf(brick({ -1, -2, 0 }, { 1, 2, 3 }), boxOf(-4, 4));
  ASSERT_EQ(tree.size(), 6u);
  Box box;
  box.extend(Vec3{ -1, -2, 0 });
  box.extend(Vec3{ 1, 2, 3 });
  const auto a = build(surfaceOf(tree));
  const auto b = build(surfaceOf(Quadric::sides(box)));
  const Rays rays = raysFor(b->surface(), 2000, 7);
  const Answers first(*a, rays, Precision::Exact);
  const Answers second(*b, rays, Precision::Exact);
  EXPECT_EQ(first.counts, second.counts);
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    if (first.any[i] == 0)
    {
      continue;
    }
    EXPECT_NEAR(first.closest[i].t, second.closest[i].t, 1e-12 * std::fabs(second.closest[i].t));
  }
}

TEST(QuadricTrees, TreesThatMakeNoSenseAreRefused)
{
  using Operation = ImplicitTree::Operation;
  const ImplicitTree good = ball({ 0, 0, 0 }, 1);
  std::vector<ImplicitTree> bad(7, good);
  bad[0].steps.clear();
  bad[1].steps.push_back({ Operation::Minimum, 0 });
  bad[2].steps[0].index = 1;
  bad[3].steps[0].index = -1;
  bad[4].steps.push_back({ Operation::Form, 0 });
  bad[5].forms[0].centre[0] = inf;
  bad[6].steps[0].operation = static_cast<Operation>(9);
  for (std::size_t i = 0; i < bad.size(); ++i)
  {
    EXPECT_THROW(zerosOf(bad[i], boxOf(-1, 1)), std::invalid_argument) << i;
    EXPECT_THROW(
      (void)functionOf(std::make_shared<const ImplicitTree>(bad[i])), std::invalid_argument);
  }
  ImplicitTree deep = good;
  for (std::size_t i = 0; i < ImplicitTree::maxDepth; ++i)
  {
    deep.steps.insert(deep.steps.begin(), { Operation::Form, 0 });
    deep.steps.push_back({ Operation::Minimum, 0 });
  }
  EXPECT_THROW(zerosOf(deep, boxOf(-1, 1)), std::invalid_argument);
  EXPECT_THROW(zerosOf(leaf(Superquadric{}), boxOf(-1, 1)), std::invalid_argument);
  // Equal forms are one piece, an empty box none that is hit.
  EXPECT_EQ(zerosOf(good | good, boxOf(-1, 1)).size(), 1u);
  EXPECT_TRUE(surfaceOf(zerosOf(good, Box{}))->hittable().empty());
}

} // namespace
