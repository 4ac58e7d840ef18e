// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Every structure against brute force: all queries, all precisions, built-in scenes, float and
// double.
#include "TestHelpers.h"

#include <gtest/gtest.h>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

struct Case
{
  std::string name;
  std::shared_ptr<const Surface> surface;
  std::size_t rays;
};

std::vector<Case> cases()
{
  return {
    { "box", surfaceOf<float>(data::cornellBox()), 2000 },
    { "teapot", surfaceOf<float>(data::teapot(4)), 2000 },
    { "teapot in doubles, far away", surfaceOf<double>(data::teapot(4), { 5e5, 4.6e6, 100 }),
      2000 },
    { "city", surfaceOf<float>(data::city(2)), 2000 },
    { "stadium", surfaceOf<double>(data::teapotInStadium(4)), 2000 },
    { "cloud", surfaceOf<float>(data::randomCloud(500)), 2000 },
    { "terrain", surfaceOf<float>(data::terrain(16)), 2000 },
    { "slivers", surfaceOf<double>(data::slivers(100)), 300 },
  };
}

std::vector<BuildOptions> structures()
{
  std::vector<BuildOptions> all = { optionsOf(Structure::Bvh, BvhBuild::LongestAxisMedian),
    optionsOf(Structure::Bvh, BvhBuild::BinnedSah) };
  all.push_back(all.back());
  all.back().leafSize = 1;
  all.push_back(all.front());
  all.back().leafSize = 17;
  all.push_back(optionsOf(Structure::WideBvh));
  all.push_back(optionsOf(Structure::WideBvh, BvhBuild::LongestAxisMedian));
  all.back().leafSize = 9;
  all.push_back(optionsOf(Structure::KdTree));
  all.push_back(optionsOf(Structure::KdTree));
  all.back().kdBuild = KdBuild::SpatialMedian;
  all.back().leafSize = 1;
  all.push_back(optionsOf(Structure::Grid));
  all.push_back(optionsOf(Structure::Grid));
  all.back().gridResolution = { 7, 1, 30 };
  all.push_back(optionsOf(Structure::BspTree));
  all.push_back(optionsOf(Structure::Octree));
  all.push_back(optionsOf(Structure::Octree));
  all.back().leafSize = 1;
  all.back().maxDepth = 6;
  return all;
}

bool same(const Hit& a, const Hit& b)
{
  return a.primitive == b.primitive && a.t == b.t && a.u == b.u && a.v == b.v;
}

void expectAgreement(
  const std::shared_ptr<const Surface>& surface, const RayBatch& batch, Precision precision)
{
  QueryOptions options;
  options.precision = precision;
  const auto oracle = build(surface, optionsOf(Structure::BruteForce));
  std::vector<Hit> wanted(batch.size);
  std::vector<std::uint32_t> wantedCounts(batch.size);
  AllHits wantedAll;
  oracle->closest(batch, wanted.data(), options);
  oracle->count(batch, wantedCounts.data(), options);
  oracle->all(batch, wantedAll, options);

  for (const BuildOptions& build : structures())
  {
    SCOPED_TRACE(label(build));
    const auto tree = lumitree::build(surface, build);
    std::vector<Hit> hits(batch.size);
    std::vector<std::uint8_t> any(batch.size);
    std::vector<std::uint32_t> counts(batch.size);
    AllHits all;
    tree->closest(batch, hits.data(), options);
    tree->any(batch, any.data(), options);
    tree->count(batch, counts.data(), options);
    tree->all(batch, all, options);
    std::size_t differences = 0;
    for (std::size_t i = 0; i < batch.size; ++i)
    {
      differences += same(hits[i], wanted[i]) ? 0 : 1;
      differences += any[i] == (wanted[i].primitive != noPrimitive ? 1 : 0) ? 0 : 1;
      differences += counts[i] == wantedCounts[i] ? 0 : 1;
    }
    EXPECT_EQ(differences, 0u);
    EXPECT_EQ(all.offsets, wantedAll.offsets);
    ASSERT_EQ(all.hits.size(), wantedAll.hits.size());
    for (std::size_t i = 0; i < all.hits.size(); ++i)
    {
      ASSERT_TRUE(same(all.hits[i], wantedAll.hits[i])) << "hit " << i;
    }
  }
}

class AgainstBruteForce : public ::testing::TestWithParam<Precision>
{
};

TEST_P(AgainstBruteForce, EveryQueryAgrees)
{
  for (const Case& c : cases())
  {
    SCOPED_TRACE(c.name);
    expectAgreement(c.surface, raysAround(*c.surface, c.rays, 7).batch(), GetParam());
  }
}

/// Needles in planes of the axes, seen lengthwise, each with a triangle a little before it: the t
/// that weights give is vague, so that some needles seem to be in front.
TEST_P(AgainstBruteForce, NeedlesBehindTriangles)
{
  Uniform uniform(8);
  std::vector<std::array<Vec3, 3>> triangles;
  Rays rays;
  for (int i = 0; i < 200; ++i)
  {
    const std::size_t across = i % 2;
    const Vec3 from = { uniform(0.5, 3), uniform(0.5, 3), uniform(1, 2) };
    Vec3 along = { uniform(0.1, 0.3), uniform(0.1, 0.3), uniform(0.5, 1) };
    along[across] = 0;
    Vec3 side{};
    side[1 - across] = 1;
    const Vec3 width = std::ldexp(1.0, -20 - i % 24) * side;
    Vec3 before = from;
    before[across] -= std::ldexp(1.0, -25 - i % 10);
    triangles.push_back({ from, from + 0.5 * along + width, from + along });
    triangles.push_back({ before - 0.2 * along - 0.3 * side, before + 0.5 * along + 0.5 * side,
      before + 1.2 * along - 0.3 * side });
    for (int ray = 0; ray < 8; ++ray)
    {
      const Vec3 eye = { uniform(-0.2, 0), uniform(-0.2, 0), uniform(-1, -0.8) };
      const double s = uniform(0.1, 0.9);
      const double share = uniform(0.2, 0.8) * std::min(2 * s, 2 - 2 * s);
      rays.add(eye, from + s * along + share * width - eye);
    }
  }
  expectAgreement(surfaceOf<double>(triangles), rays.batch(), GetParam());
}

TEST_P(AgainstBruteForce, HundredThousandRaysAgree)
{
  QueryOptions options;
  options.precision = GetParam();
  for (const auto& surface : { surfaceOf<float>(data::cornellBox()),
         surfaceOf<double>(data::teapot(3)), surfaceOf<float>(data::randomCloud(300)) })
  {
    const Rays rays = raysAround(*surface, 100000, 11);
    std::vector<Hit> wanted(rays.size());
    std::vector<Hit> hits(rays.size());
    build(surface, optionsOf(Structure::BruteForce))->closest(rays.batch(), wanted.data(), options);
    for (const Structure structure :
      { Structure::Bvh, Structure::WideBvh, Structure::KdTree, Structure::Grid, Structure::Octree })
    {
      build(surface, optionsOf(structure))->closest(rays.batch(), hits.data(), options);
      std::size_t differences = 0;
      for (std::size_t i = 0; i < hits.size(); ++i)
      {
        differences += same(hits[i], wanted[i]) ? 0 : 1;
      }
      EXPECT_EQ(differences, 0u) << name(structure);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Precisions, AgainstBruteForce,
  ::testing::Values(Precision::Fast, Precision::Watertight, Precision::Exact),
  [](const auto& precision) { return std::string(name(precision.param)); });

} // namespace
