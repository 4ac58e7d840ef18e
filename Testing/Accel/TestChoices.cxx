// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Names, the registry of back ends, and what Auto chooses.
#include "Accel/AutoChoice.h"
#include "Accel/Registry.h"
#include "TestHelpers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <thread>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

const std::vector<std::array<Vec3, 3>> oneTriangle = { { Vec3{ 0, 0, 0 }, Vec3{ 1, 0, 0 },
  Vec3{ 0, 1, 0 } } };

TEST(Choices, NamesRoundTripAndAreDistinct)
{
  std::set<std::string_view> names;
  for (int i = 0; i < structureCount; ++i)
  {
    const auto structure = static_cast<Structure>(i);
    EXPECT_EQ(structureFromName(name(structure)), structure);
    names.insert(name(structure));
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(structureCount));
  for (const Precision precision : everyPrecision)
  {
    EXPECT_EQ(precisionFromName(name(precision)), precision);
  }
  EXPECT_EQ(name(QueryKind::Closest), "closest");
  EXPECT_EQ(name(QueryKind::Count), "count");
  EXPECT_EQ(name(QueryKind::Crossings), "crossings");
  EXPECT_EQ(name(QueryKind::Ties), "ties");
  EXPECT_EQ(name(BvhBuild::LongestAxisMedian), "longest_axis_median");
}

TEST(Choices, ValuesAreThoseOfTheDataModel)
{
  EXPECT_EQ(static_cast<int>(Structure::Auto), 0);
  EXPECT_EQ(static_cast<int>(Structure::BruteForce), 1);
  EXPECT_EQ(static_cast<int>(Structure::Bvh), 2);
  EXPECT_EQ(static_cast<int>(Structure::WideBvh), 3);
  EXPECT_EQ(static_cast<int>(Structure::Grid), 4);
  EXPECT_EQ(static_cast<int>(Structure::Octree), 5);
  EXPECT_EQ(static_cast<int>(Structure::KdTree), 6);
  EXPECT_EQ(static_cast<int>(Structure::BspTree), 7);
  EXPECT_EQ(static_cast<int>(Structure::Embree), 8);
  EXPECT_EQ(static_cast<int>(Structure::Cgal), 9);
  EXPECT_EQ(static_cast<int>(Structure::CgalEpick), 10);
  EXPECT_EQ(static_cast<int>(Structure::CgalCartesian), 11);
  EXPECT_EQ(static_cast<int>(Precision::Exact), 2);
}

TEST(Choices, UnknownNamesAndValuesAreNotGuessed)
{
  EXPECT_FALSE(structureFromName("bvh2"));
  EXPECT_FALSE(structureFromName("BVH"));
  EXPECT_FALSE(structureFromName(""));
  EXPECT_FALSE(precisionFromName("exactly"));
  EXPECT_EQ(name(static_cast<Structure>(99)), "unknown");
  EXPECT_EQ(name(static_cast<Precision>(-1)), "unknown");
}

TEST(Registry, ListsWhatIsThereAscending)
{
  const auto structures = Registry::instance().structures();
  EXPECT_TRUE(std::is_sorted(structures.begin(), structures.end()));
  for (const Structure structure : structures)
  {
    EXPECT_TRUE(Registry::instance().has(structure));
    EXPECT_FALSE(Registry::instance().find(structure).description.empty());
    EXPECT_EQ(Registry::instance().find(structure).structure, structure);
  }
  EXPECT_TRUE(Registry::instance().has(Structure::BruteForce));
  EXPECT_TRUE(Registry::instance().has(Structure::Bvh));
  EXPECT_FALSE(Registry::instance().has(Structure::Auto));
}

TEST(Registry, AMissingStructureIsReportedWithTheAlternatives)
{
  // This test does not link CGAL.
  ASSERT_FALSE(Registry::instance().has(Structure::Cgal));
  try
  {
    (void)build(surfaceOf<float>(oneTriangle), optionsOf(Structure::Cgal));
    FAIL() << "built what is not there";
  }
  catch (const UnknownStructure& error)
  {
    const std::string message = error.what();
    EXPECT_NE(message.find("'cgal'"), std::string::npos) << message;
    for (const Structure structure : Registry::instance().structures())
    {
      EXPECT_NE(message.find(std::string(name(structure))), std::string::npos) << message;
    }
  }
}

TEST(Registry, ABackEndCanBeAddedAndReplaced)
{
  const auto add = [](int& calls)
  {
    Registry::instance().add({ Structure::Cgal, "a stand-in",
      [&calls](std::shared_ptr<const Surface> surface, const BuildOptions& options, JobControl*)
      {
        ++calls;
        BuildOptions other = options;
        other.structure = Structure::BruteForce;
        return build(std::move(surface), other);
      } });
  };
  int first = 0;
  int second = 0;
  add(first);
  const auto surface = surfaceOf<float>(oneTriangle);
  const auto built = build(surface, optionsOf(Structure::Cgal));
  EXPECT_EQ(closestOf(*built, { { 0.25, 0.25, -1 }, { 0, 0, 1 } }, Precision::Fast).t, 1.0);
  add(second);
  (void)build(surface, optionsOf(Structure::Cgal));
  EXPECT_EQ(first, 1);
  EXPECT_EQ(second, 1);
  EXPECT_EQ(Registry::instance().structures().back(), Structure::Cgal);
}

TEST(Registry, AutoBuildsSomethingAndSaysWhat)
{
  for (const auto& surface : { surfaceOf<float>(oneTriangle), surfaceOf<float>(data::sphere(10)),
         surfaceOf<double>(data::cornellBox()) })
  {
    const auto accelerator = build(surface);
    EXPECT_NE(accelerator->options().structure, Structure::Auto);
    EXPECT_TRUE(Registry::instance().has(accelerator->options().structure));
    EXPECT_EQ(accelerator->sharedSurface(), surface);
  }
  EXPECT_EQ(build(surfaceOf<float>(oneTriangle))->options().structure, Structure::BruteForce);
  EXPECT_NE(build(surfaceOf<float>(data::sphere(10)))->options().structure, Structure::BruteForce);
}

TEST(Auto, ModelsNoMoreThanASceneNeeds)
{
  const auto few = build(surfaceOf<float>(std::vector<std::array<Vec3, 3>>(10, oneTriangle[0])));
  EXPECT_EQ(few->options().structure, Structure::BruteForce);
  EXPECT_NE(few->statistics().choice.find("10 primitives"), std::string::npos);
  EXPECT_TRUE(
    build(surfaceOf<float>(oneTriangle), optionsOf(Structure::Bvh))->statistics().choice.empty());
}

TEST(Auto, GoesByTheNumberOfRays)
{
  const auto surface = surfaceOf<float>(data::teapot(12));
  BuildOptions options;
  options.expectedRays = 1;
  EXPECT_EQ(chooseStructure(*surface, options).choice.structure, Structure::BruteForce);
  options.expectedRays = 1000;
  EXPECT_EQ(chooseStructure(*surface, options).choice.structure, Structure::WideBvh);
  EXPECT_EQ(chooseStructure(*surface, options).choice.bvhBuild, BvhBuild::Morton);
  options.expectedRays = 1e9;
  const AutoReport many = chooseStructure(*surface, options);
  EXPECT_EQ(many.choice.structure, Structure::WideBvh);
  EXPECT_NE(many.choice.bvhBuild, BvhBuild::Morton);
  EXPECT_EQ(many.rays, 1e9);
  options.expectedRays = std::nan("");
  EXPECT_THROW((void)build(surface, options), std::invalid_argument);
  options.expectedRays = -1;
  EXPECT_THROW((void)build(surface, options), std::invalid_argument);
}

TEST(Auto, TellsEveryAlternative)
{
  const AutoReport report = chooseStructure(*surfaceOf<double>(data::city(4)));
  std::set<Structure> structures;
  for (std::size_t i = 0; i < report.estimates.size(); ++i)
  {
    const AutoEstimate& e = report.estimates[i];
    structures.insert(e.structure);
    EXPECT_GT(e.buildSeconds, 0.0);
    EXPECT_GT(e.raySeconds, 0.0);
    EXPECT_TRUE(i == 0 ||
      e.buildSeconds + e.raySeconds >=
        report.estimates[i - 1].buildSeconds + report.estimates[i - 1].raySeconds);
  }
  for (const BuildOptions& own : ownStructures())
  {
    EXPECT_EQ(structures.count(own.structure), 1u) << label(own);
  }
  EXPECT_GT(report.measures.depth, 1.0);
  EXPECT_GT(report.measures.fill, 0.0);
  EXPECT_LT(report.measures.fill, 1.0);
  EXPECT_GE(report.measures.aspect, 1.0);
}

TEST(Auto, TriesSpatialSplitsWhereLargeTrianglesAreAmongSmallOnes)
{
  Uniform uniform(3);
  std::vector<std::array<Vec3, 3>> triangles;
  for (int i = 0; i < 4000; ++i)
  {
    std::array<Vec3, 3> t;
    const Vec3 p = { uniform(0, 10), uniform(0, 10), uniform(0, 10) };
    for (Vec3& corner : t)
    {
      const double size = i % 20 == 0 ? 8.0 : 0.1;
      corner = p + Vec3{ uniform(-size, size), uniform(-size, size), uniform(-size, size) };
    }
    triangles.push_back(t);
  }
  EXPECT_EQ(chooseStructure(*surfaceOf<float>(triangles)).choice.bvhBuild, BvhBuild::SpatialSplits);
  EXPECT_EQ(
    chooseStructure(*surfaceOf<float>(data::teapot(6))).choice.bvhBuild, BvhBuild::BinnedSah);
}

TEST(Auto, TakesScenesOfAnyKind)
{
  for (const auto& surface : { surfaceOf<double>(std::vector<std::array<Vec3, 3>>{}),
         surfaceOf<double>(data::terrain(4, 1, 0.0)), surfaceOf<float>(data::sphere(6)) })
  {
    const AutoReport report = chooseStructure(*surface);
    EXPECT_FALSE(report.reason.empty());
    EXPECT_FALSE(std::isnan(report.measures.depth));
    EXPECT_FALSE(std::isnan(report.measures.largeEmpty));
    EXPECT_TRUE(build(surface));
  }
}

TEST(Registry, OptionsAreKeptAsAsked)
{
  BuildOptions options = optionsOf(Structure::Bvh, BvhBuild::LongestAxisMedian);
  options.leafSize = 7;
  options.maxDepth = 20;
  EXPECT_TRUE(build(surfaceOf<float>(data::sphere(4)), options)->options() == options);
  BuildOptions other = options;
  other.leafSize = 8;
  EXPECT_FALSE(other == options);
}

TEST(Registry, EveryOwnStructureSupportsEveryPrecision)
{
  for (const auto& accelerator : accelerators(surfaceOf<float>(oneTriangle)))
  {
    for (const Precision precision : everyPrecision)
    {
      EXPECT_TRUE(accelerator->supports(precision)) << label(accelerator->options());
    }
  }
}

TEST(Registry, AnAcceleratorAnswersSeveralThreadsAtOnce)
{
  const auto surface = surfaceOf<float>(data::teapot(4));
  const Rays rays = raysAround(*surface, 500, 3);
  for (const auto& accelerator : accelerators(surface))
  {
    std::vector<std::vector<Hit>> answers(3, std::vector<Hit>(rays.size()));
    std::vector<std::thread> threads;
    for (auto& hits : answers)
    {
      threads.emplace_back(
        [&] { accelerator->closest(rays.batch(), hits.data(), with(Precision::Exact)); });
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      ASSERT_TRUE(sameBits(answers[0][i], answers[1][i]));
      ASSERT_TRUE(sameBits(answers[0][i], answers[2][i]));
    }
  }
}

} // namespace
