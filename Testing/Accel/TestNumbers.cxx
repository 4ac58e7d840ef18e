// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// The same bits whatever the host's rounding mode, the number of threads, the order and size of
// batches, the type of the ray arrays; and rays that are not valid.
#include "Answers.h"

#include <algorithm>
#include <cfenv>
#include <functional>
#include <numeric>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

const double infinity = std::numeric_limits<double>::infinity();

template <class Check>
void forEverything(const Check& check)
{
  for (const BuildOptions& options : ownStructures())
  {
    for (const Precision precision : everyPrecision)
    {
      SCOPED_TRACE(label(options) + ", " + std::string(name(precision)));
      check(options, precision);
    }
  }
}

/// A host that left the floating-point environment in a bad state.
class Host
{
public:
  Host() { std::fegetenv(&this->saved_); }
  ~Host() { std::fesetenv(&this->saved_); }
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  void roundUpward() { std::fesetround(FE_UPWARD); }
  void flushSubnormals()
  {
#if defined(__SSE__)
    _mm_setcsr(_mm_getcsr() | 0x8040u);
#endif
  }

private:
  std::fenv_t saved_;
};

/// Some coordinates are subnormal, so that flushing them would show: doubles or floats.
template <class T>
std::shared_ptr<const Surface> subnormalSphere(double radius)
{
  data::Mesh mesh = data::sphere(2);
  for (double& x : mesh.points)
  {
    x *= radius;
  }
  return surfaceOf<T>(mesh);
}

void sameUnderAnyHost(const std::shared_ptr<const Surface>& surface, const Rays& rays,
  const std::function<std::shared_ptr<const Surface>()>& again)
{
  forEverything(
    [&](const BuildOptions& options, Precision precision)
    {
      const Answers wanted = ask(*build(surface, options), rays.batch(), with(precision));
      for (const int state : { 1, 2, 3 })
      {
        SCOPED_TRACE(state);
        Answers found;
        {
          Host host;
          if (state & 1)
          {
            host.roundUpward();
          }
          if (state & 2)
          {
            host.flushSubnormals();
          }
          const int rounding = std::fegetround();
          const auto built = build(again(), options);
          found = ask(*built, rays.batch(), with(precision));
          QueryOptions threaded = with(precision);
          threaded.threads = 3;
          std::vector<Hit> hits(rays.size());
          built->closest(rays.batch(), hits.data(), threaded);
          EXPECT_EQ(std::fegetround(), rounding) << "the host's mode is restored";
          found.closest = hits;
        }
        expectSame(wanted, found);
      }
    });
}

TEST(Numbers, TheHostsFloatingPointModeDoesNotMatter)
{
  const auto surface = surfaceOf<float>(data::teapot(3));
  const Rays rays = raysAround(*surface, 600, 4);
  sameUnderAnyHost(surface, rays, [&] { return surface; });
}

TEST(Numbers, NorDoesItForSubnormalCoordinates)
{
  const auto doubles = subnormalSphere<double>(0x1p-1030);
  ASSERT_EQ(doubles->hittable().size(), 80u);
  sameUnderAnyHost(doubles, raysAround(*doubles, 24, 5),
    [&] { return std::make_shared<const Surface>(*doubles); });
  const auto floats = subnormalSphere<float>(0x1p-130);
  ASSERT_EQ(floats->hittable().size(), 80u);
  sameUnderAnyHost(
    floats, raysAround(*floats, 24, 6), [&] { return std::make_shared<const Surface>(*floats); });
}

TEST(Numbers, TheNumberOfThreadsDoesNotMatter)
{
  const auto surface = surfaceOf<float>(data::torus(48, 24, 0.3));
  const Rays rays = raysAround(*surface, 5000, 8);
  forEverything(
    [&](const BuildOptions& options, Precision precision)
    {
      if (options.structure == Structure::BruteForce)
      {
        return;
      }
      const auto accelerator = build(surface, options);
      const Answers wanted = ask(*accelerator, rays.batch(), with(precision));
      for (const int threads : { 0, 2, 3, 4 })
      {
        QueryOptions query = with(precision);
        query.threads = threads;
        expectSame(wanted, ask(*accelerator, rays.batch(), query));
      }
    });
}

TEST(Numbers, TheOrderAndSizeOfBatchesDoNotMatter)
{
  const auto surface = surfaceOf<float>(data::teapot(4));
  const Rays rays = raysAround(*surface, 2000, 9);
  std::vector<std::size_t> order(rays.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::shuffle(order.begin(), order.end(), std::mt19937(1));
  Rays shuffled;
  for (const std::size_t i : order)
  {
    shuffled.add(rays.batch()[i]);
  }
  forEverything(
    [&](const BuildOptions& options, Precision precision)
    {
      if (options.structure == Structure::BruteForce)
      {
        return;
      }
      const auto accelerator = build(surface, options);
      std::vector<Hit> wanted(rays.size());
      accelerator->closest(rays.batch(), wanted.data(), with(precision));

      std::vector<Hit> hits(rays.size());
      accelerator->closest(shuffled.batch(), hits.data(), with(precision));
      for (std::size_t i = 0; i < hits.size(); ++i)
      {
        ASSERT_TRUE(sameBits(hits[i], wanted[order[i]])) << "ray " << order[i];
      }
      for (const std::size_t size : { std::size_t{ 1 }, std::size_t{ 7 }, std::size_t{ 333 } })
      {
        for (std::size_t first = 0; first < std::min<std::size_t>(rays.size(), 60 * size);
             first += size)
        {
          RayBatch part = rays.batch();
          part.size = std::min(size, rays.size() - first);
          part.origins = ArrayView(rays.origins.data() + 3 * first);
          part.directions = ArrayView(rays.directions.data() + 3 * first);
          part.tMins = ArrayView(rays.tMins.data() + first);
          part.tMaxs = ArrayView(rays.tMaxs.data() + first);
          accelerator->closest(part, hits.data() + first, with(precision));
          for (std::size_t i = first; i < first + part.size; ++i)
          {
            ASSERT_TRUE(sameBits(hits[i], wanted[i])) << "ray " << i;
          }
        }
      }
    });
}

TEST(Numbers, FloatRaysAreTheDoublesTheyStandFor)
{
  const auto surface = surfaceOf<float>(data::teapot(4));
  const Rays random = raysAround(*surface, 1000, 10);
  std::vector<float> origins(random.origins.begin(), random.origins.end());
  std::vector<float> directions(random.directions.begin(), random.directions.end());
  Rays rays;
  for (std::size_t i = 0; i < random.size(); ++i)
  {
    rays.add(ArrayView(origins.data()).triple(i), ArrayView(directions.data()).triple(i));
  }
  RayBatch floats;
  floats.size = rays.size();
  floats.origins = ArrayView(origins.data());
  floats.directions = ArrayView(directions.data());
  RayBatch mixed = rays.batch();
  mixed.directions = ArrayView(directions.data());
  const std::vector<float> zeros(rays.size(), 0.0f);
  mixed.tMins = ArrayView(zeros.data());
  mixed.tMaxs = ArrayView();
  forEverything(
    [&](const BuildOptions& options, Precision precision)
    {
      const auto accelerator = build(surface, options);
      const Answers wanted = ask(*accelerator, rays.batch(), with(precision));
      expectSame(wanted, ask(*accelerator, floats, with(precision)));
      expectSame(wanted, ask(*accelerator, mixed, with(precision)));
    });
}

TEST(Numbers, RaysThatAreNotValidHitNothingAndAreCounted)
{
  const auto surface = surfaceOf<float>(data::sphere(4));
  const double nan = std::nan("");
  Rays rays;
  const Vec3 o = { 0, 0, 0 };
  const Vec3 d = { 0.3, 0.2, 0.9 };
  rays.add(o, d);
  rays.add(o, { 0, 0, 0 });
  rays.add(o, { -0.0, 0.0, -0.0 });
  rays.add({ nan, 0, 0 }, d);
  rays.add(o, { 0, nan, 1 });
  rays.add({ infinity, 0, 0 }, d);
  rays.add(o, { 0, -infinity, 1 });
  rays.add({ 0, 1e301, 0 }, d);
  rays.add(o, { 0, 0, 1e301 });
  rays.add(Ray{ o, d, 2, 1 });
  rays.add(Ray{ o, d, nan, 1 });
  rays.add(Ray{ o, d, 0, nan });
  rays.add(Ray{ o, d, infinity, -infinity });
  rays.add(o, d);
  const std::uint64_t invalid = rays.size() - 2;
  forEverything(
    [&](const BuildOptions& options, Precision precision)
    {
      const auto accelerator = build(surface, options);
      std::vector<RayCounters> counters(rays.size(), RayCounters{ 9, 9, 9, 9 });
      QueryOptions query = with(precision);
      query.perRay = counters.data();
      const Hit rubbish = { 1, 2, 3, 4 };
      std::vector<Hit> hits(rays.size(), rubbish);
      std::vector<std::uint8_t> any(rays.size(), 9);
      std::vector<std::uint32_t> counts(rays.size(), 9);
      AllHits all;
      EXPECT_EQ(accelerator->closest(rays.batch(), hits.data(), query).invalidRays, invalid);
      EXPECT_EQ(accelerator->any(rays.batch(), any.data(), query).invalidRays, invalid);
      EXPECT_EQ(accelerator->count(rays.batch(), counts.data(), query).invalidRays, invalid);
      EXPECT_EQ(accelerator->all(rays.batch(), all, query).invalidRays, invalid);
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        SCOPED_TRACE(i);
        const bool valid = i == 0 || i + 1 == rays.size();
        EXPECT_EQ(hits[i].primitive != noPrimitive, valid);
        EXPECT_EQ(any[i], valid ? 1 : 0);
        EXPECT_EQ(counts[i] > 0, valid);
        EXPECT_EQ(all.offsets[i + 1] > all.offsets[i], valid);
        if (!valid)
        {
          EXPECT_TRUE(sameBits(hits[i], Hit{}));
          EXPECT_EQ(
            counters[i].nodes + counters[i].cells + counters[i].leaves + counters[i].primitives,
            0u);
        }
      }
    });
}

TEST(Numbers, LimitsMayBeInfiniteNegativeOrEqual)
{
  // A sphere around the origin: every line through it hits twice, at about -1 and 1.
  const auto surface = surfaceOf<double>(data::sphere(6));
  const Vec3 d = { 0.6, 0.0, 0.8 };
  const Vec3 o = { 0.01, 0.02, 0.03 };
  struct Limits
  {
    double tMin, tMax;
    std::size_t hits;
  };
  forEverything(
    [&](const BuildOptions& options, Precision precision)
    {
      const auto accelerator = build(surface, options);
      for (const Limits& limits :
        std::vector<Limits>{ { 0, infinity, 1 }, { -infinity, infinity, 2 }, { -infinity, 0, 1 },
          { -infinity, -infinity, 0 }, { infinity, infinity, 0 }, { -2, 0.5, 1 }, { -0.5, 0.5, 0 },
          { 0, 0, 0 }, { -1e300, 1e300, 2 } })
      {
        EXPECT_EQ(
          allOf(*accelerator, { o, d, limits.tMin, limits.tMax }, precision).size(), limits.hits)
          << limits.tMin << " " << limits.tMax;
        EXPECT_EQ(
          closestOf(*accelerator, { o, d, limits.tMin, limits.tMax }, precision).primitive !=
            noPrimitive,
          limits.hits > 0)
          << limits.tMin << " " << limits.tMax;
      }
      const Hit back = closestOf(*accelerator, { o, d, -infinity, infinity }, precision);
      EXPECT_LT(back.t, -0.9);
    });
}

TEST(Numbers, OneLimitForAllRaysIsTheSameAsOneEach)
{
  const auto surface = surfaceOf<float>(data::sphere(6));
  Rays rays = raysAround(*surface, 300, 12);
  std::fill(rays.tMins.begin(), rays.tMins.end(), 0.25);
  std::fill(rays.tMaxs.begin(), rays.tMaxs.end(), 1.25);
  RayBatch scalar = rays.batch();
  scalar.tMins = ArrayView();
  scalar.tMaxs = ArrayView();
  scalar.tMin = 0.25;
  scalar.tMax = 1.25;
  forEverything(
    [&](const BuildOptions& options, Precision precision)
    {
      const auto accelerator = build(surface, options);
      expectSame(ask(*accelerator, rays.batch(), with(precision)),
        ask(*accelerator, scalar, with(precision)));
    });
}

TEST(Numbers, AnEmptyBatchIsAnswered)
{
  const auto surface = surfaceOf<float>(data::sphere(2));
  forEverything(
    [&](const BuildOptions& options, Precision precision)
    {
      const auto accelerator = build(surface, options);
      AllHits all;
      const QueryReport report = accelerator->all(RayBatch{}, all, with(precision));
      EXPECT_TRUE(report.completed);
      EXPECT_EQ(all.offsets, std::vector<std::uint64_t>{ 0 });
      EXPECT_TRUE(accelerator->closest(RayBatch{}, nullptr, with(precision)).completed);
    });
}

} // namespace
