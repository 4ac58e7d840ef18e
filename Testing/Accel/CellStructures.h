// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_Accel_CellStructures_h
#define Lumitree_Testing_Accel_CellStructures_h

#include "TestHelpers.h"

/// What the tests of grid and octree share.
namespace lumitree::testing
{

/// Triangles with corners on a lattice of whole numbers, small and large ones.
inline std::vector<std::array<Vec3, 3>> latticeTriangles(
  std::size_t count, int extent, unsigned seed)
{
  Uniform uniform(seed);
  const auto whole = [&](int size)
  { return static_cast<double>(uniform.index(static_cast<std::size_t>(size))); };
  std::vector<std::array<Vec3, 3>> triangles(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const int size = i % 16 == 0 ? extent : 3;
    const Vec3 p = { whole(extent), whole(extent), whole(extent) };
    for (Vec3& corner : triangles[i])
    {
      corner = p + Vec3{ whole(size), whole(size), whole(size) };
    }
  }
  return triangles;
}

/// Rays with origins and directions on the same lattice, many with components of ±0, some ending on
/// it.
inline Rays latticeRays(std::size_t count, int extent, unsigned seed)
{
  Uniform uniform(seed);
  Rays rays;
  for (std::size_t i = 0; i < count; ++i)
  {
    Ray ray;
    for (int k = 0; k < 3; ++k)
    {
      ray.origin[k] = static_cast<double>(uniform.index(static_cast<std::size_t>(extent) + 4)) - 2;
      ray.direction[k] = static_cast<double>(uniform.index(7)) - 3;
      ray.direction[k] *= ray.direction[k] == 0 && i % 2 == 0 ? -1 : 1;
    }
    if (i % 4 == 0)
    {
      ray.tMin = static_cast<double>(uniform.index(3));
      ray.tMax = ray.tMin + static_cast<double>(uniform.index(5));
    }
    rays.add(ray);
  }
  return rays;
}

/// How many rays have another closest hit, another number of hits, or another answer to "any" than
/// brute force.
inline std::size_t differences(const std::shared_ptr<const Surface>& surface,
  const BuildOptions& options, const Rays& rays, Precision precision = Precision::Exact)
{
  const auto oracle = build(surface, optionsOf(Structure::BruteForce));
  const auto asked = build(surface, options);
  std::vector<Hit> wanted(rays.size());
  std::vector<Hit> hits(rays.size());
  std::vector<std::uint32_t> wantedCounts(rays.size());
  std::vector<std::uint32_t> counts(rays.size());
  std::vector<std::uint8_t> any(rays.size());
  oracle->closest(rays.batch(), wanted.data(), with(precision));
  oracle->count(rays.batch(), wantedCounts.data(), with(precision));
  asked->closest(rays.batch(), hits.data(), with(precision));
  asked->count(rays.batch(), counts.data(), with(precision));
  asked->any(rays.batch(), any.data(), with(precision));
  std::size_t different = 0;
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    different += sameBits(hits[i], wanted[i]) && counts[i] == wantedCounts[i] &&
        any[i] == (wanted[i].primitive != noPrimitive ? 1 : 0)
      ? 0
      : 1;
  }
  return different;
}

} // namespace lumitree::testing

#endif
