// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Cases at which methods fail, for every structure and precision, against rational numbers: what
// the precision promises is kept. The cases of one seed, and random ones for some time:
// LUMITREE_STRESS_SEED (default 1, "random" for another each time) and LUMITREE_STRESS_SECONDS
// (default 2).
#include "Promises.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <tuple>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

struct Known
{
  StressCase input;
  std::vector<Truth> truth;
};

const std::vector<Known>& cases()
{
  static const std::vector<Known> all = []
  {
    std::vector<Known> made;
    for (StressCase& c : stressCases(1))
    {
      made.push_back({ std::move(c), {} });
      made.back().truth = truthOf(made.back().input);
    }
    return made;
  }();
  return all;
}

/// Letters and digits only, as names of tests must be.
std::string plain(std::string text)
{
  text.erase(std::remove_if(text.begin(), text.end(),
               [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }),
    text.end());
  return text;
}

using Choice = std::tuple<std::size_t, Precision>;

class Stress : public ::testing::TestWithParam<Choice>
{
};

TEST_P(Stress, PromisesAreKept)
{
  const BuildOptions options = ownStructures()[std::get<0>(GetParam())];
  for (const Known& known : cases())
  {
    const auto accelerator = build(known.input.surface, options);
    EXPECT_EQ(brokenPromise(*accelerator, std::get<1>(GetParam()), known.input, known.truth), "");
  }
}

INSTANTIATE_TEST_SUITE_P(Every, Stress,
  ::testing::Combine(
    ::testing::Range<std::size_t>(0, ownStructures().size()), ::testing::ValuesIn(everyPrecision)),
  [](const auto& choice)
  {
    return plain(label(ownStructures()[std::get<0>(choice.param)])) + "_" +
      std::string(name(std::get<1>(choice.param)));
  });

TEST(StressCases, AreWorthTheirName)
{
  for (const Known& known : cases())
  {
    std::size_t hits = 0;
    for (const Truth& truth : known.truth)
    {
      hits += truth.hits.size();
    }
    EXPECT_GE(hits, 5u) << known.input.name;
  }
}

TEST(RandomStress, PromisesAreKept)
{
  const char* const wanted = std::getenv("LUMITREE_STRESS_SEED");
  const char* const time = std::getenv("LUMITREE_STRESS_SECONDS");
  unsigned seed = 1;
  if (wanted)
  {
    seed = std::string(wanted) == "random"
      ? std::random_device{}()
      : static_cast<unsigned>(std::strtoul(wanted, nullptr, 10));
  }
  const auto end =
    std::chrono::steady_clock::now() + std::chrono::duration<double>(time ? std::atof(time) : 2.0);
  std::printf("LUMITREE_STRESS_SEED=%u\n", seed);
  std::size_t rounds = 0;
  do
  {
    ++seed;
    ++rounds;
    for (const StressCase& c : stressCases(seed))
    {
      const auto truth = truthOf(c);
      for (const BuildOptions& options : ownStructures())
      {
        const auto accelerator = build(c.surface, options);
        for (const Precision precision : everyPrecision)
        {
          const std::string broken = brokenPromise(*accelerator, precision, c, truth);
          ASSERT_EQ(broken, "") << "seed " << seed << ", " << label(options) << ", "
                                << name(precision);
        }
      }
    }
  } while (std::chrono::steady_clock::now() < end);
  std::printf("%zu rounds\n", rounds);
}

} // namespace
