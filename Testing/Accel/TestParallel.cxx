// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// The loop under every batch: chunks, progress, stopping, exceptions; and jobs seen from a query.
#include "Accel/Parallel.h"
#include "TestHelpers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <mutex>
#include <set>
#include <thread>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

TEST(Parallel, ChunksCoverTheRangeOnceAndDoNotDependOnThreads)
{
  for (const std::size_t n :
    { std::size_t{ 0 }, std::size_t{ 1 }, std::size_t{ 10 }, std::size_t{ 1001 } })
  {
    std::set<std::pair<std::size_t, std::size_t>> wanted;
    for (const int threads : { 1, 2, 4, 0 })
    {
      std::mutex mutex;
      std::set<std::pair<std::size_t, std::size_t>> chunks;
      std::size_t covered = 0;
      EXPECT_TRUE(parallelFor(n, 10, threads, nullptr,
        [&](std::size_t begin, std::size_t end)
        {
          const std::lock_guard<std::mutex> lock(mutex);
          chunks.insert({ begin, end });
          covered += end - begin;
        }));
      EXPECT_EQ(covered, n);
      if (threads == 1)
      {
        wanted = chunks;
      }
      EXPECT_EQ(chunks, wanted);
    }
  }
}

TEST(Parallel, ProgressComesOnTheCallingThreadAndGrows)
{
  for (const int threads : { 1, 2, 4 })
  {
    const auto caller = std::this_thread::get_id();
    std::atomic<int> elsewhere{ 0 };
    std::vector<double> fractions;
    JobControl control;
    control.onProgress = [&](double fraction)
    {
      if (std::this_thread::get_id() != caller)
      {
        ++elsewhere;
        return true;
      }
      fractions.push_back(fraction);
      return true;
    };
    EXPECT_TRUE(parallelFor(200, 1, threads, &control,
      [](std::size_t, std::size_t)
      { std::this_thread::sleep_for(std::chrono::microseconds(50)); }));
    EXPECT_EQ(elsewhere, 0);
    ASSERT_FALSE(fractions.empty()) << threads;
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_GT(fractions.front(), 0.0);
    EXPECT_LE(fractions.back(), 1.0);
  }
}

TEST(Parallel, StopsWhenToldByEitherSide)
{
  for (const int threads : { 1, 2 })
  {
    JobControl told;
    told.onProgress = [](double) { return false; };
    std::atomic<int> chunks{ 0 };
    EXPECT_FALSE(
      parallelFor(100000, 1, threads, &told, [&](std::size_t, std::size_t) { ++chunks; }));
    EXPECT_LT(chunks, 100000);
    EXPECT_TRUE(told.stop);

    JobControl flagged;
    chunks = 0;
    EXPECT_FALSE(parallelFor(100000, 1, threads, &flagged,
      [&](std::size_t, std::size_t)
      {
        if (++chunks == 3)
        {
          flagged.stop = true;
        }
      }));
    EXPECT_LT(chunks, 100000);
  }
  JobControl already;
  already.stop = true;
  EXPECT_FALSE(parallelFor(5, 1, 1, &already, [](std::size_t, std::size_t) { FAIL(); }));
}

TEST(Parallel, ExceptionsArriveAtTheCaller)
{
  for (const int threads : { 1, 2, 4 })
  {
    EXPECT_THROW(parallelFor(1000, 1, threads, nullptr,
                   [](std::size_t begin, std::size_t)
                   {
                     if (begin == 500)
                     {
                       throw std::runtime_error("chunk 500");
                     }
                   }),
      std::runtime_error);
  }
}

TEST(Parallel, ChunksRoundToNearestWhateverTheCallerDoes)
{
  const int before = std::fegetround();
  std::fesetround(FE_DOWNWARD);
  std::atomic<int> others{ 0 };
  parallelFor(64, 1, 2, nullptr,
    [&](std::size_t, std::size_t) { others += std::fegetround() == FE_TONEAREST ? 0 : 1; });
  EXPECT_EQ(std::fegetround(), FE_DOWNWARD);
  std::fesetround(before);
  EXPECT_EQ(others, 0);
}

TEST(Jobs, AStoppedQuerySaysSoAndTheRestAreMisses)
{
  const auto surface = surfaceOf<float>(data::sphere(6));
  Rays rays;
  for (int i = 0; i < 20000; ++i)
  {
    rays.add({ 0, 0, 0 }, { 0.1, 0.2, 0.3 });
  }
  for (const auto& accelerator : accelerators(surface))
  {
    SCOPED_TRACE(label(accelerator->options()));
    JobControl control;
    control.onProgress = [](double fraction) { return fraction < 0.3; };
    QueryOptions options = with(Precision::Fast);
    options.control = &control;
    std::vector<Hit> hits(rays.size(), Hit{ 1, 2, 3, 4 });
    EXPECT_FALSE(accelerator->closest(rays.batch(), hits.data(), options).completed);
    const auto found = std::count_if(
      hits.begin(), hits.end(), [](const Hit& h) { return h.primitive != noPrimitive; });
    EXPECT_GT(found, 0);
    EXPECT_LT(found, 20000);
    EXPECT_TRUE(sameBits(hits.back(), Hit{}));

    JobControl patient;
    double last = 0.0;
    patient.onProgress = [&](double fraction)
    {
      last = fraction;
      return true;
    };
    options.control = &patient;
    EXPECT_TRUE(accelerator->closest(rays.batch(), hits.data(), options).completed);
    EXPECT_EQ(last, 1.0);

    JobControl stopped;
    stopped.stop = true;
    options.control = &stopped;
    AllHits all;
    EXPECT_FALSE(accelerator->all(rays.batch(), all, options).completed);
    EXPECT_EQ(all.offsets, std::vector<std::uint64_t>(rays.size() + 1, 0));
    EXPECT_TRUE(all.hits.empty());
  }
}

/// What a builder told of its progress.
struct Told
{
  explicit Told(double patience = 2.0)
  {
    this->control.onProgress = [this, patience](double fraction)
    {
      this->elsewhere += std::this_thread::get_id() == this->caller ? 0 : 1;
      this->fractions.push_back(fraction);
      return fraction < patience;
    };
  }
  JobControl control;
  std::thread::id caller = std::this_thread::get_id();
  int elsewhere = 0;
  std::vector<double> fractions;
};

/// Those of our own, and Embree where it is there.
std::vector<BuildOptions> allBuilds()
{
  std::vector<BuildOptions> all = ownStructures();
  if (Registry::instance().has(Structure::Embree))
  {
    all.push_back(optionsOf(Structure::Embree));
  }
  return all;
}

TEST(Jobs, BuildsTellTheirProgress)
{
  const auto surface = surfaceOf<float>(data::terrain(96));
  for (BuildOptions options : allBuilds())
  {
    for (const int threads : { 1, 2 })
    {
      SCOPED_TRACE(label(options) + ", threads " + std::to_string(threads));
      options.threads = threads;
      Told told;
      EXPECT_TRUE(build(surface, options, &told.control));
      EXPECT_EQ(told.elsewhere, 0);
      EXPECT_TRUE(std::is_sorted(told.fractions.begin(), told.fractions.end()));
      if (options.structure != Structure::Embree)
      {
        ASSERT_FALSE(told.fractions.empty());
        EXPECT_EQ(told.fractions.front(), 0.0);
        EXPECT_EQ(told.fractions.back(), 1.0);
        EXPECT_GT(told.fractions.size(), options.structure == Structure::BruteForce ? 1u : 8u);
      }
    }
  }
}

TEST(Jobs, AStoppedBuildThrowsWhereverItWas)
{
  const auto surface = surfaceOf<float>(data::terrain(96));
  for (BuildOptions options : allBuilds())
  {
    SCOPED_TRACE(label(options));
    JobControl stopped;
    stopped.stop = true;
    EXPECT_THROW((void)build(surface, options, &stopped), BuildStopped);
    if (options.structure == Structure::Embree || options.structure == Structure::BruteForce)
    {
      continue; // so quick that it may be over first
    }
    for (const double patience : { 0.01, 0.3, 0.6, 0.9 })
    {
      for (const int threads : { 1, 2 })
      {
        options.threads = threads;
        Told told(patience);
        EXPECT_THROW((void)build(surface, options, &told.control), BuildStopped) << patience;
        ASSERT_FALSE(told.fractions.empty());
        EXPECT_GE(told.fractions.back(), patience);
        EXPECT_LT(told.fractions.back(), 1.0);
      }
    }
  }
}

TEST(Jobs, AWorkerCanStopABuild)
{
  const auto surface = surfaceOf<float>(data::terrain(256));
  BuildOptions options = optionsOf(Structure::KdTree);
  JobControl control;
  std::thread other(
    [&]
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      control.stop = true;
    });
  EXPECT_THROW((void)build(surface, options, &control), BuildStopped);
  other.join();
}

} // namespace
