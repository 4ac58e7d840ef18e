// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays in blocks: the same answers as in one batch.
#include "TestHelpers.h"

#include "Accel/RayStream.h"
#include "Data/Scenes.h"

#include <gtest/gtest.h>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

class Stream : public ::testing::Test
{
protected:
  const std::shared_ptr<const Surface> surface_ = surfaceOf<float>(data::torus(24, 12, 0.2));
  const std::shared_ptr<const Accelerator> tree_ = build(this->surface_);
  const Rays rays_ = raysAround(*this->surface_, 1000, 7);
  std::size_t most_ = 0; ///< rays that were in memory at a time

  RayStream stream(std::size_t block)
  {
    RayStream stream;
    stream.size = this->rays_.batch().size;
    stream.block = block;
    stream.rays = [this](std::size_t first, std::size_t count)
    {
      this->most_ = std::max(this->most_, count);
      this->some_ = Rays{};
      for (std::size_t i = first; i < first + count; ++i)
      {
        this->some_.add(this->rays_.batch()[i]);
      }
      return this->some_.batch();
    };
    return stream;
  }

private:
  Rays some_;
};

TEST_F(Stream, AnswersAreThoseOfOneBatch)
{
  const std::size_t size = this->rays_.batch().size;
  std::vector<Hit> whole(size);
  std::vector<RayCounters> wholeCost(size);
  std::vector<std::uint8_t> wholeAny(size);
  QueryOptions options = with(Precision::Exact);
  this->tree_->any(this->rays_.batch(), wholeAny.data(), options);
  options.perRay = wholeCost.data();
  const QueryReport report = this->tree_->closest(this->rays_.batch(), whole.data(), options);
  for (const std::size_t block : { std::size_t{ 1 }, std::size_t{ 77 }, size, 2 * size })
  {
    this->most_ = 0;
    std::vector<RayCounters> cost(size);
    options.perRay = cost.data();
    std::size_t next = 0;
    const QueryReport streamed = streamClosest(
      *this->tree_, this->stream(block),
      [&](std::size_t first, std::size_t count, const Hit* hits)
      {
        EXPECT_EQ(first, next);
        for (std::size_t i = 0; i < count; ++i)
        {
          EXPECT_TRUE(sameBits(hits[i], whole[first + i]));
          EXPECT_EQ(cost[first + i].nodes, wholeCost[first + i].nodes);
        }
        next = first + count;
      },
      options);
    EXPECT_EQ(next, size);
    EXPECT_EQ(this->most_, std::min(block, size));
    EXPECT_EQ(streamed.invalidRays, report.invalidRays);
    EXPECT_EQ(streamed.exactTests, report.exactTests);
    EXPECT_TRUE(streamed.completed);
    options.perRay = nullptr;
    streamAny(
      *this->tree_, this->stream(block),
      [&](std::size_t first, std::size_t count, const std::uint8_t* hit)
      { EXPECT_TRUE(std::equal(hit, hit + count, wholeAny.data() + first)); },
      options);
  }
}

TEST_F(Stream, StopsAndTellsOneProgress)
{
  JobControl control;
  std::vector<double> told;
  control.onProgress = [&](double done)
  {
    told.push_back(done);
    return done < 0.5;
  };
  QueryOptions options;
  options.control = &control;
  options.threads = 1;
  std::size_t seen = 0;
  const QueryReport report = streamClosest(
    *this->tree_, this->stream(100),
    [&](std::size_t, std::size_t count, const Hit*) { seen += count; }, options);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_LT(seen, this->rays_.batch().size);
  EXPECT_TRUE(control.stop);
  EXPECT_FALSE(report.completed);
}

TEST_F(Stream, RefusesWhatItCannotUse)
{
  const auto ignore = [](std::size_t, std::size_t, const Hit*) {};
  EXPECT_THROW(streamClosest(*this->tree_, this->stream(0), ignore), std::invalid_argument);
  RayStream wrong = this->stream(10);
  wrong.rays = [](std::size_t, std::size_t) { return RayBatch{}; };
  EXPECT_THROW(streamClosest(*this->tree_, wrong, ignore), std::invalid_argument);
  wrong.size = 0;
  EXPECT_TRUE(streamClosest(*this->tree_, wrong, ignore).completed);
}

} // namespace
