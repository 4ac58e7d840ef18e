// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Any saved structure, with a checksum that fits, of any small surface: it is refused, or what is
// loaded answers as brute force does. The bytes make a surface and a structure, which is saved;
// what follows changes the file.
#include "FuzzInput.h"

#include "Testing/Accel/SavedStructures.h"

#include <algorithm>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

/// Structure, ways to build, leaf size, depth, density, resolution and mailboxing stand before the fingerprint.
constexpr std::size_t optionsSize = 5 * 4 + 8 + 3 * 4 + 1;
constexpr std::size_t fingerprintSize = 16;

/// Changes numbers, takes stretches out, doubles them, or cuts the end off; the fingerprint stays,
/// so that more than the first check is tried.
std::string changed(std::string body, FuzzInput& input)
{
  const std::string fingerprint = body.substr(optionsSize, fingerprintSize);
  while (!input.empty())
  {
    const std::size_t kind = input.byte();
    const std::size_t at = (input.byte() << 8 | input.byte()) % (body.size() + 1);
    const std::size_t count = 1 + input.byte() % 16;
    if (kind < 192)
    {
      // Small numbers are the most telling.
      for (std::size_t i = at; i < std::min(at + (kind < 128 ? 1 : count), body.size()); ++i)
      {
        body[i] = static_cast<char>(input.byte());
      }
    }
    else if (kind < 216)
    {
      body.erase(at, count);
    }
    else if (kind < 240)
    {
      body.insert(at, body.substr(at, count));
    }
    else if (kind < 248)
    {
      body.resize(at);
    }
    else if (at + sizeof(double) <= body.size())
    {
      const double number = input.number();
      std::memcpy(body.data() + at, &number, sizeof(number));
    }
  }
  if (body.size() >= optionsSize + fingerprintSize)
  {
    body.replace(optionsSize, fingerprintSize, fingerprint);
  }
  return body;
}

Rays someRays(const Surface& surface)
{
  Rays rays = surface.hittable().empty() ? Rays{} : raysAround(surface, 12, 1);
  rays.add({ 0.5, 0.25, -3 }, { 0.1, 0.2, 1 });
  return rays;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzInput input(data, size);
  const std::vector<BuildOptions> all = ownStructures();
  BuildOptions options = all[input.byte() % all.size()];
  options.leafSize = 1 + input.byte() % 8;
  const auto surface = input.surface(24);
  const std::string body = changed(bodyOf(saved(*build(surface, options))), input);
  std::shared_ptr<const Accelerator> again;
  try
  {
    again = loaded(sealed(body), surface);
  }
  catch (const SaveError&)
  {
    return 0;
  }
  const Rays rays = someRays(*surface);
  const auto oracle = build(surface, optionsOf(Structure::BruteForce));
  AllHits wanted;
  AllHits found;
  oracle->all(rays.batch(), wanted, with(Precision::Exact));
  again->all(rays.batch(), found, with(Precision::Exact));
  require(found.offsets == wanted.offsets, "another number of hits", again->options());
  for (std::size_t h = 0; h < found.hits.size(); ++h)
  {
    require(sameBits(found.hits[h], wanted.hits[h]), "another hit", again->options());
  }
  (void)again->hierarchy();
  (void)loaded(saved(*again), surface);
  (void)again->refit(surface);
  return 0;
}
