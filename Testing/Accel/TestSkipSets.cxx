// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays that must not see some primitives: the same as a surface without them.
#include "TestHelpers.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

struct Sets
{
  std::vector<std::uint32_t> setOfRay;
  std::vector<std::uint64_t> offsets = { 0 };
  std::vector<std::uint32_t> primitives;

  void add(std::vector<std::uint32_t> set)
  {
    std::sort(set.begin(), set.end());
    this->primitives.insert(this->primitives.end(), set.begin(), set.end());
    this->offsets.push_back(this->primitives.size());
  }

  [[nodiscard]] bool holds(std::size_t set, PrimitiveId id) const
  {
    const auto begin = this->primitives.begin();
    return std::binary_search(begin + static_cast<std::ptrdiff_t>(this->offsets[set]),
      begin + static_cast<std::ptrdiff_t>(this->offsets[set + 1]), id);
  }

  [[nodiscard]] SkipSets view() const
  {
    return { this->setOfRay.empty() ? nullptr : this->setOfRay.data(), this->offsets.data(),
      this->primitives.data() };
  }
};

/// The same hit. All of Exact reports a greater t again where the next would descend: what went
/// before decides by 2^-26 at most.
bool same(const Hit& a, const Hit& b, Precision precision)
{
  Hit c = a;
  if (precision == Precision::Exact && std::fabs(a.t - b.t) <= 0x1p-25 * std::fabs(b.t))
  {
    c.t = b.t;
  }
  return sameBits(c, b);
}

/// Checks every query against the hits that are left of all hits without sets.
void check(const Accelerator& accelerator, const Rays& rays, const Sets& sets, Precision precision)
{
  AllHits everything;
  accelerator.all(rays.batch(), everything, with(precision));
  RayBatch batch = rays.batch();
  batch.skip = sets.view();
  std::vector<Hit> closest(rays.size());
  std::vector<std::uint8_t> any(rays.size());
  std::vector<std::uint32_t> counts(rays.size());
  AllHits all;
  accelerator.closest(batch, closest.data(), with(precision));
  accelerator.any(batch, any.data(), with(precision));
  accelerator.count(batch, counts.data(), with(precision));
  accelerator.all(batch, all, with(precision));
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    const std::size_t set = sets.setOfRay.empty() ? i : sets.setOfRay[i];
    std::vector<Hit> left;
    for (auto h = everything.offsets[i]; h < everything.offsets[i + 1]; ++h)
    {
      if (!sets.holds(set, everything.hits[h].primitive))
      {
        left.push_back(everything.hits[h]);
      }
    }
    ASSERT_TRUE(same(closest[i], left.empty() ? Hit{} : left.front(), precision)) << "ray " << i;
    ASSERT_EQ(any[i], left.empty() ? 0 : 1) << "ray " << i;
    ASSERT_EQ(counts[i], left.size()) << "ray " << i;
    ASSERT_EQ(all.offsets[i + 1] - all.offsets[i], left.size()) << "ray " << i;
    for (std::size_t h = 0; h < left.size(); ++h)
    {
      ASSERT_TRUE(same(all.hits[all.offsets[i] + h], left[h], precision)) << "ray " << i;
    }
  }
}

TEST(SkipSets, OneSetPerRay)
{
  const auto surface = surfaceOf<float>(data::randomCloud(200, 5, 0.6));
  const Rays rays = raysAround(*surface, 300, 3);
  for (const auto& accelerator : accelerators(surface))
  {
    for (const Precision precision : everyPrecision)
    {
      SCOPED_TRACE(label(accelerator->options()) + ", " + std::string(name(precision)));
      std::vector<Hit> closest(rays.size());
      accelerator->closest(rays.batch(), closest.data(), with(precision));
      Uniform uniform(4);
      Sets sets;
      for (const Hit& hit : closest)
      {
        // What the ray hits first, and some others; or nothing at all.
        std::vector<std::uint32_t> set;
        if (hit.primitive != noPrimitive)
        {
          set = { hit.primitive, static_cast<std::uint32_t>(uniform.index(200)), 199 };
        }
        sets.add(set);
      }
      check(*accelerator, rays, sets, precision);
    }
  }
}

TEST(SkipSets, SharedSets)
{
  const auto surface = surfaceOf<double>(data::teapot(3));
  const Rays rays = raysAround(*surface, 300, 6);
  Sets sets;
  std::vector<std::uint32_t> even;
  std::vector<std::uint32_t> everything;
  for (std::uint32_t i = 0; i < surface->size(); ++i)
  {
    everything.push_back(i);
    if (i % 2 == 0)
    {
      even.push_back(i);
    }
  }
  sets.add({});
  sets.add(even);
  sets.add(everything);
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    sets.setOfRay.push_back(static_cast<std::uint32_t>(i % 3));
  }
  for (const auto& accelerator : accelerators(surface))
  {
    for (const Precision precision : everyPrecision)
    {
      SCOPED_TRACE(label(accelerator->options()) + ", " + std::string(name(precision)));
      check(*accelerator, rays, sets, precision);
    }
  }
}

TEST(SkipSets, AReceiverDoesNotShadowItself)
{
  // A ray that starts on a flat quad of two triangles and leaves it: neither occludes.
  const auto surface = surfaceOf<float>(data::terrain(1, 1, 0.0));
  ASSERT_EQ(surface->size(), 2u);
  Sets sets;
  sets.add({ 0, 1 });
  sets.setOfRay = { 0 };
  Rays rays;
  rays.add({ 0.5, 0.5, 0 }, { 0.1, 0.2, 1 });
  RayBatch batch = rays.batch();
  for (const auto& accelerator : accelerators(surface))
  {
    for (const Precision precision : everyPrecision)
    {
      std::uint8_t any = 9;
      batch.skip = {};
      accelerator->any(batch, &any, with(precision));
      EXPECT_EQ(any, 1);
      batch.skip = sets.view();
      accelerator->any(batch, &any, with(precision));
      EXPECT_EQ(any, 0);
    }
  }
}

} // namespace
