// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Any rays on any small surface: Exact gives the same bits from every structure, all queries agree
// with each other, and Watertight loses no hit.
#include "FuzzInput.h"

#include <algorithm>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

struct Answers
{
  std::vector<Hit> closest;
  std::vector<std::uint8_t> any;
  std::vector<std::uint32_t> counts;
  AllHits all;
};

Answers ask(const Accelerator& accelerator, const Rays& rays, Precision precision)
{
  Answers a;
  a.closest.resize(rays.size());
  a.any.resize(rays.size());
  a.counts.resize(rays.size());
  accelerator.closest(rays.batch(), a.closest.data(), with(precision));
  accelerator.any(rays.batch(), a.any.data(), with(precision));
  accelerator.count(rays.batch(), a.counts.data(), with(precision));
  accelerator.all(rays.batch(), a.all, with(precision));
  return a;
}

void requireConsistency(const Answers& a, const BuildOptions& options)
{
  for (std::size_t i = 0; i < a.closest.size(); ++i)
  {
    const std::size_t first = a.all.offsets[i];
    const std::size_t number = a.all.offsets[i + 1] - first;
    require(a.counts[i] == number, "count and all disagree", options);
    require(a.any[i] == (number > 0 ? 1 : 0), "any and all disagree", options);
    require(sameBits(a.closest[i], number > 0 ? a.all.hits[first] : Hit{}),
      "closest and all disagree", options);
  }
}

void requireSame(const Answers& a, const Answers& b, const BuildOptions& options)
{
  require(a.all.offsets == b.all.offsets, "another number of hits", options);
  for (std::size_t h = 0; h < a.all.hits.size(); ++h)
  {
    require(sameBits(a.all.hits[h], b.all.hits[h]), "another hit", options);
  }
}

void requireSuperset(const Answers& exact, const Answers& watertight, const BuildOptions& options)
{
  for (std::size_t i = 0; i < exact.closest.size(); ++i)
  {
    const auto first =
      watertight.all.hits.begin() + static_cast<std::ptrdiff_t>(watertight.all.offsets[i]);
    const auto last =
      watertight.all.hits.begin() + static_cast<std::ptrdiff_t>(watertight.all.offsets[i + 1]);
    for (std::size_t h = exact.all.offsets[i]; h < exact.all.offsets[i + 1]; ++h)
    {
      require(std::any_of(first, last,
                [&](const Hit& hit) { return hit.primitive == exact.all.hits[h].primitive; }),
        "watertight loses a hit", options);
    }
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzInput input(data, size);
  const auto surface = input.surface(24);
  Rays rays;
  while (!input.empty() && rays.size() < 16)
  {
    rays.add(input.ray());
  }
  const BuildOptions oracleOptions = optionsOf(Structure::BruteForce);
  const Answers oracle = ask(*build(surface, oracleOptions), rays, Precision::Exact);
  for (const BuildOptions& options : ownStructures())
  {
    const auto accelerator = build(surface, options);
    const Answers exact = ask(*accelerator, rays, Precision::Exact);
    requireConsistency(exact, options);
    requireSame(exact, oracle, options);
    const Answers watertight = ask(*accelerator, rays, Precision::Watertight);
    requireConsistency(watertight, options);
    requireSuperset(exact, watertight, options);
    requireConsistency(ask(*accelerator, rays, Precision::Fast), options);
  }
  return 0;
}
