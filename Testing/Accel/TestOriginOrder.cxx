// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// The order in which rays go through a large structure: each of them once, and with the same
// answer.
#include "Accel/Kernel/OriginOrder.h"
#include "TestHelpers.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

constexpr std::size_t large = std::size_t{ 1 } << 30;

/// From anywhere in the cube of 2 to anywhere.
Rays scattered(std::size_t count)
{
  Uniform uniform(11);
  Rays rays;
  for (std::size_t i = 0; i < count; ++i)
  {
    rays.add({ uniform(-1, 1), uniform(-1, 1), uniform(-1, 1) },
      { uniform(-1, 1), uniform(-1, 1), uniform(-1, 1) });
  }
  return rays;
}

Box cube()
{
  Box box;
  box.extend(Vec3{ -1, -1, -1 });
  box.extend(Vec3{ 1, 1, 1 });
  return box;
}

} // namespace

TEST(RadixOrder, IsStable)
{
  RadixOrder order;
  for (const int bits : { 1, 2, 19, 21, 24 })
  {
    for (const std::size_t count : { 0, 1, 511, 512, 5000 })
    {
      Uniform uniform(static_cast<unsigned>(bits));
      std::vector<std::uint32_t> keys(count);
      for (std::uint32_t& key : keys)
      {
        const auto any = static_cast<std::uint32_t>(uniform.index(std::size_t{ 1 } << bits));
        key = uniform.index(4) == 0 ? (1u << bits) - 1 : any; // many equal ones, the greatest
      }
      std::vector<std::uint32_t> wanted(count);
      std::iota(wanted.begin(), wanted.end(), 0u);
      std::stable_sort(wanted.begin(), wanted.end(),
        [&](std::uint32_t a, std::uint32_t b) { return keys[a] < keys[b]; });
      EXPECT_EQ(order.sort(keys, bits), wanted) << bits << " bits, " << count;
    }
  }
}

TEST(OriginOrder, HasEachRayOnce)
{
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Rays rays = scattered(3000);
  for (const double x : { nan, inf, -inf, 1e300, -1e300, 0.0 })
  {
    rays.add({ x, 0, 0 }, { 1, 0, -0.0 });
    rays.add({ 0, 0, x }, { x, nan, 0 });
  }
  Box flat;
  flat.extend(Vec3{ -1, -1, 0 });
  flat.extend(Vec3{ 1, 1, 0 });
  Box point;
  point.extend(Vec3{ 0.5, 0.5, 0.5 });
  const RayBatch batch = rays.batch();
  for (const Box& bounds : { cube(), flat, point, Box() })
  {
    OriginOrder order;
    order.make(batch, bounds, 100, batch.size);
    std::vector<std::size_t> met = order.rays();
    std::sort(met.begin(), met.end());
    ASSERT_EQ(met.size(), batch.size - 100);
    for (std::size_t i = 0; i < met.size(); ++i)
    {
      ASSERT_EQ(met[i], 100 + i);
    }
  }
}

TEST(OriginOrder, PutsNeighboursTogether)
{
  const Rays rays = scattered(20000);
  const RayBatch batch = rays.batch();
  OriginOrder order;
  order.make(batch, cube(), 0, batch.size);
  const auto distance = [&](std::size_t a, std::size_t b)
  { return length(batch[a].origin - batch[b].origin); };
  double before = 0.0;
  double after = 0.0;
  for (std::size_t i = 1; i < batch.size; ++i)
  {
    before += distance(i, i - 1);
    after += distance(order.rays()[i], order.rays()[i - 1]);
  }
  EXPECT_LT(after, before / 4);
}

TEST(OriginOrder, IsMadeWhereItPays)
{
  const Rays rays = scattered(20000);
  EXPECT_TRUE(OriginOrder::pays(rays.batch(), cube(), large));
  EXPECT_FALSE(OriginOrder::pays(rays.batch(), cube(), 1 << 20)) << "it fits the caches";
  const Rays few = scattered(1000);
  EXPECT_FALSE(OriginOrder::pays(few.batch(), cube(), large));
  Rays inRows;
  for (int i = 0; i < 20000; ++i)
  {
    inRows.add({ (i % 200) * 0.01 - 1, (i / 200) * 0.02 - 1, -1 }, { 0.1, 0.2, 1 });
  }
  EXPECT_FALSE(OriginOrder::pays(inRows.batch(), cube(), large)) << "it is one already";
}

TEST(OriginOrder, ChangesNoAnswer)
{
  const auto surface = surfaceOf<float>(data::torus(60, 30, 0.3));
  BuildOptions options = optionsOf(Structure::Grid);
  options.gridResolution = { 256, 256, 144 };
  const auto accelerator = build(surface, options);
  const Rays rays = raysAround(*surface, 17000, 5);
  const RayBatch batch = rays.batch();
  ASSERT_TRUE(OriginOrder::pays(batch, surface->bounds(), accelerator->statistics().memory));
  QueryOptions ordered;
  ordered.threads = 1;
  std::vector<RayCounters> counters(batch.size);
  QueryOptions asTheyCome = ordered;
  asTheyCome.perRay = counters.data();
  std::vector<Hit> wanted(batch.size);
  std::vector<Hit> got(batch.size);
  const QueryReport a = accelerator->closest(batch, wanted.data(), asTheyCome);
  const QueryReport b = accelerator->closest(batch, got.data(), ordered);
  EXPECT_EQ(a.invalidRays, b.invalidRays);
  std::size_t hits = 0;
  for (std::size_t i = 0; i < batch.size; ++i)
  {
    hits += wanted[i].primitive != noPrimitive ? 1 : 0;
    ASSERT_TRUE(sameBits(wanted[i], got[i])) << "ray " << i;
  }
  EXPECT_GT(hits, batch.size / 10);
  std::vector<std::uint8_t> anyWanted(batch.size);
  std::vector<std::uint8_t> anyGot(batch.size);
  accelerator->any(batch, anyWanted.data(), asTheyCome);
  accelerator->any(batch, anyGot.data(), ordered);
  EXPECT_EQ(anyWanted, anyGot);
  std::vector<std::uint32_t> countWanted(batch.size);
  std::vector<std::uint32_t> countGot(batch.size);
  accelerator->count(batch, countWanted.data(), asTheyCome);
  accelerator->count(batch, countGot.data(), ordered);
  EXPECT_EQ(countWanted, countGot);
}
