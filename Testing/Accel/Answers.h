// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_Accel_Answers_h
#define Lumitree_Testing_Accel_Answers_h

#include "TestHelpers.h"

#include <gtest/gtest.h>

namespace lumitree::testing
{

/// All that the queries answer.
struct Answers
{
  std::vector<Hit> closest;
  std::vector<std::uint8_t> any;
  std::vector<std::uint32_t> counts;
  AllHits all;
  std::uint64_t exactTests = 0;
};

inline Answers ask(
  const Accelerator& accelerator, const RayBatch& rays, const QueryOptions& options)
{
  Answers a;
  a.closest.resize(rays.size);
  a.any.resize(rays.size);
  a.counts.resize(rays.size);
  a.exactTests = accelerator.closest(rays, a.closest.data(), options).exactTests;
  accelerator.any(rays, a.any.data(), options);
  accelerator.count(rays, a.counts.data(), options);
  accelerator.all(rays, a.all, options);
  return a;
}

/// From any two structures.
inline void expectSameHits(const Answers& a, const Answers& b)
{
  ASSERT_EQ(a.closest.size(), b.closest.size());
  for (std::size_t i = 0; i < a.closest.size(); ++i)
  {
    ASSERT_TRUE(sameBits(a.closest[i], b.closest[i])) << "ray " << i;
  }
  EXPECT_EQ(a.any, b.any);
  EXPECT_EQ(a.counts, b.counts);
  EXPECT_EQ(a.all.offsets, b.all.offsets);
  ASSERT_EQ(a.all.hits.size(), b.all.hits.size());
  for (std::size_t i = 0; i < a.all.hits.size(); ++i)
  {
    ASSERT_TRUE(sameBits(a.all.hits[i], b.all.hits[i])) << "hit " << i;
  }
}

/// From the same structure.
inline void expectSame(const Answers& a, const Answers& b)
{
  expectSameHits(a, b);
  EXPECT_EQ(a.exactTests, b.exactTests);
}

} // namespace lumitree::testing

#endif
