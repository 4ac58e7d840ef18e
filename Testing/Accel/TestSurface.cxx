// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Surfaces: what is kept, what is refused, what cannot be hit, where primitives came from.
#include "TestHelpers.h"

#include <gtest/gtest.h>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

const std::vector<Triangle> twoTriangles = { { 0, 1, 2 }, { 2, 1, 3 } };

PointArray fourPoints()
{
  return PointArray::from(std::vector<double>{ 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0.1 });
}

TEST(Surface, KeepsFloatsAndDoublesAsTheyAre)
{
  const Surface floats(
    PointArray::from(std::vector<float>{ 0.1f, 0, 0, 1, 0, 0, 0, 1, 0 }), { { 0, 1, 2 } });
  EXPECT_EQ(floats.scalar(), ArrayView::Scalar::Float);
  EXPECT_EQ(floats.point(0)[0], static_cast<double>(0.1f));
  const Surface doubles(
    PointArray::from(std::vector<double>{ 0.1, 0, 0, 1, 0, 0, 0, 1, 0 }), { { 0, 1, 2 } });
  EXPECT_EQ(doubles.scalar(), ArrayView::Scalar::Double);
  EXPECT_EQ(doubles.point(0)[0], 0.1);
  EXPECT_EQ(doubles.bounds().upper, (Vec3{ 1, 1, 0 }));
  EXPECT_EQ(doubles.bounds().lower, (Vec3{ 0, 0, 0 }));
}

TEST(Surface, UsesTheCallersMemoryAndKeepsItAlive)
{
  auto owner =
    std::make_shared<std::vector<float>>(std::vector<float>{ 0, 0, 0, 1, 0, 0, 0, 1, 0 });
  const std::weak_ptr<std::vector<float>> alive = owner;
  PointArray points;
  points.values = ArrayView(static_cast<const float*>(owner->data()));
  points.count = 3;
  points.owner = owner;
  auto surface =
    std::make_shared<const Surface>(std::move(points), std::vector<Triangle>{ { 0, 1, 2 } });
  owner.reset();
  auto accelerator = build(surface);
  surface.reset();
  EXPECT_FALSE(alive.expired());
  EXPECT_EQ(closestOf(*accelerator, { { 0.25, 0.25, -1 }, { 0, 0, 1 } }, Precision::Fast).t, 1.0);
  accelerator.reset();
  EXPECT_TRUE(alive.expired());
}

TEST(Surface, RefusesWhatDoesNotFit)
{
  EXPECT_THROW(Surface(fourPoints(), { { 0, 1, 4 } }), std::invalid_argument);
  EXPECT_THROW(Surface(PointArray{}, { { 0, 1, 2 } }), std::invalid_argument);
  EXPECT_THROW(PointArray::from(std::vector<float>{ 1, 2 }), std::invalid_argument);
  SourceMap tooShort;
  tooShort.cells = { 1 };
  EXPECT_THROW(Surface(fourPoints(), twoTriangles, tooShort), std::invalid_argument);
  SourceMap notFromZero;
  notFromZero.blocks = { { 1, 5 } };
  EXPECT_THROW(Surface(fourPoints(), twoTriangles, notFromZero), std::invalid_argument);
  SourceMap descending;
  descending.blocks = { { 0, 1 }, { 2, 2 }, { 1, 3 } };
  EXPECT_THROW(Surface(fourPoints(), twoTriangles, descending), std::invalid_argument);
  // A bad triangle among many is found, whichever thread comes across it.
  std::vector<Triangle> many(100000, Triangle{ 0, 1, 2 });
  many[77777] = { 0, 1, 9 };
  EXPECT_THROW(Surface(fourPoints(), many), std::invalid_argument);
}

TEST(Surface, CountsWhatCannotBeHitAndKeepsTheNumbering)
{
  const double nan = std::nan("");
  const auto surface = surfaceOf<double>(
    std::vector<std::array<Vec3, 3>>{ { Vec3{ 0, 0, 0 }, Vec3{ 1, 0, 0 }, Vec3{ 0, 1, 0 } },
      { Vec3{ 0, 0, 0 }, Vec3{ 1, 1, 1 }, Vec3{ 3, 3, 3 } },
      { Vec3{ 0, 0, nan }, Vec3{ 1, 0, 0 }, Vec3{ 0, 1, 0 } },
      { Vec3{ 0, 0, 0 }, Vec3{ 0, 0, 0 }, Vec3{ 0, 1, 0 } },
      { Vec3{ 0, 0, 0 }, Vec3{ 1, 0, HUGE_VAL }, Vec3{ 0, 1, 0 } },
      { Vec3{ 0, 0, 1 }, Vec3{ 1, 0, 1.1e300 }, Vec3{ 0, 1, 0 } },
      { Vec3{ 5, 5, 5 }, Vec3{ 6, 5, 5 }, Vec3{ 5, 6, 5 } } });
  EXPECT_EQ(surface->size(), 7u);
  EXPECT_EQ(surface->zeroAreaCount(), 2u);
  EXPECT_EQ(surface->nonFiniteCount(), 3u);
  EXPECT_EQ(surface->hittable(), (std::vector<PrimitiveId>{ 0, 6 }));
  EXPECT_EQ(surface->bounds().upper, (Vec3{ 6, 6, 5 })) << "of what can be hit";
}

TEST(Surface, KnowsWherePrimitivesCameFrom)
{
  const Surface plain(fourPoints(), twoTriangles);
  EXPECT_EQ(plain.source(1).cell, 1);
  EXPECT_EQ(plain.source(1).composite, 0);

  SourceMap sources;
  sources.cells = { 10, 10, 11, 0, 3 };
  sources.blocks = { { 0, 2 }, { 3, 4 }, { 3, 5 }, { 4, 9 } }; // flat index 4 has no primitive
  const Surface mapped(fourPoints(), std::vector<Triangle>(5, Triangle{ 0, 1, 2 }), sources);
  const std::vector<std::pair<std::int64_t, std::int64_t>> wanted = { { 10, 2 }, { 10, 2 },
    { 11, 2 }, { 0, 5 }, { 3, 9 } };
  for (PrimitiveId i = 0; i < 5; ++i)
  {
    EXPECT_EQ(mapped.source(i).cell, wanted[i].first);
    EXPECT_EQ(mapped.source(i).composite, wanted[i].second);
  }
}

TEST(Surface, MemoryGrowsWithWhatIsHeld)
{
  const auto small = surfaceOf<float>(data::sphere(4));
  const auto large = surfaceOf<float>(data::sphere(8));
  const auto doubles = surfaceOf<double>(data::sphere(8));
  EXPECT_GE(small->memory(), 12 * small->pointCount() + 12 * small->size());
  EXPECT_GT(large->memory(), 3 * small->memory());
  EXPECT_EQ(doubles->memory() - large->memory(), 12 * large->pointCount());
}

TEST(Surface, MayBeEmpty)
{
  const Surface empty(PointArray{}, {});
  EXPECT_EQ(empty.size(), 0u);
  EXPECT_TRUE(empty.hittable().empty());
  EXPECT_TRUE(empty.bounds().empty());
}

} // namespace
