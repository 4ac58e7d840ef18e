// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// A structure that was saved and loaded again answers with the same bits; what is no such file, or
// of another surface, is refused; and no file, however it came about, makes a wrong answer.
#include "Answers.h"
#include "SavedStructures.h"

#include "Accel/Save.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

std::vector<std::pair<const char*, std::shared_ptr<const Surface>>> surfaces()
{
  return {
    { "box", surfaceOf<float>(data::cornellBox()) },
    { "teapot", surfaceOf<float>(data::teapot(3)) },
    { "teapot in doubles, far away", surfaceOf<double>(data::teapot(3), { 5e5, 4.6e6, 100 }) },
    { "city", surfaceOf<float>(data::city(2)) },
    { "cloud", surfaceOf<double>(data::randomCloud(400)) },
    { "quadrics", quadrics() },
    { "mixed, floats", mixed<float>() },
    { "mixed, doubles", mixed<double>() },
    { "one triangle", surfaceOf<float>({ { Vec3{ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } } }) },
    { "nothing", surfaceOf<float>(std::vector<std::array<Vec3, 3>>{}) },
    { "nothing but bad",
      surfaceOf<double>({ { Vec3{ 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } },
        { Vec3{ HUGE_VAL, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } } }) },
  };
}

std::vector<BuildOptions> everyStructure()
{
  std::vector<BuildOptions> all = ownStructures();
  all.push_back(optionsOf(Structure::Bvh, BvhBuild::SpatialSplits));
  all.push_back(optionsOf(Structure::Bvh, BvhBuild::Morton));
  all.push_back(optionsOf(Structure::WideBvh, BvhBuild::SweepSah));
  all.back().leafSize = 40;
  all.push_back(optionsOf(Structure::Grid));
  all.back().gridResolution = { 7, 1, 12 };
  return all;
}

Rays raysFor(const Surface& surface)
{
  return surface.size() > 0 && !surface.bounds().empty() ? raysAround(surface, 300, 5)
                                                         : []
  {
    Rays rays;
    rays.add({ 0.1, 0.1, -1 }, { 0, 0, 1 });
    return rays;
  }();
}

std::string problemWith(const std::string& bytes, const std::shared_ptr<const Surface>& surface)
{
  try
  {
    (void)loaded(bytes, surface);
  }
  catch (const SaveError& error)
  {
    return error.what();
  }
  return "";
}

TEST(Save, EveryStructureAnswersWithTheSameBits)
{
  for (const auto& [title, surface] : surfaces())
  {
    SCOPED_TRACE(title);
    const Rays rays = raysFor(*surface);
    for (const BuildOptions& options : everyStructure())
    {
      SCOPED_TRACE(label(options));
      const auto built = build(surface, options);
      const auto again = loaded(saved(*built), surface);
      EXPECT_TRUE(again->options() == built->options());
      const BuildStatistics& a = built->statistics();
      const BuildStatistics& b = again->statistics();
      EXPECT_EQ(b.origin, Origin::Loaded);
      EXPECT_EQ(b.nodes, a.nodes);
      EXPECT_EQ(b.leaves, a.leaves);
      EXPECT_EQ(b.depth, a.depth);
      EXPECT_EQ(b.sahCostBuilt, a.sahCost);
      // Parts of primitives are clipped once more.
      EXPECT_NEAR(b.sahCost, a.sahCost, 1e-3 * a.sahCost);
      EXPECT_NEAR(static_cast<double>(b.references), static_cast<double>(a.references),
        1e-2 * static_cast<double>(a.references));
      for (const Precision precision : everyPrecision)
      {
        expectSameHits(
          ask(*again, rays.batch(), with(precision)), ask(*built, rays.batch(), with(precision)));
      }
      EXPECT_EQ(saved(*again).size(), saved(*built).size());
    }
  }
}

TEST(Save, SameNodesForHierarchiesOfBoxes)
{
  const auto surface = surfaceOf<float>(data::teapot(3));
  for (const Structure structure : { Structure::Bvh, Structure::WideBvh })
  {
    const auto built = build(surface, optionsOf(structure));
    const auto again = loaded(saved(*built), surface);
    const HierarchyView a = built->hierarchy();
    const HierarchyView b = again->hierarchy();
    EXPECT_EQ(leavesOf(a), leavesOf(b));
    ASSERT_EQ(a.nodes.size(), b.nodes.size());
    for (std::size_t i = 0; i < a.nodes.size(); ++i)
    {
      EXPECT_EQ(a.nodes[i].box.lower, b.nodes[i].box.lower);
      EXPECT_EQ(a.nodes[i].box.upper, b.nodes[i].box.upper);
      EXPECT_EQ(a.nodes[i].parent, b.nodes[i].parent);
    }
    EXPECT_EQ(saved(*loaded(saved(*again), surface)), saved(*again));
  }
}

TEST(Save, NoByteCanChangeUnnoticed)
{
  const auto surface = surfaceOf<float>(data::cornellBox());
  for (const BuildOptions& options : everyStructure())
  {
    SCOPED_TRACE(label(options));
    const std::string whole = saved(*build(surface, options));
    for (std::size_t i = 0; i < whole.size(); ++i)
    {
      std::string bytes = whole;
      bytes[i] = static_cast<char>(bytes[i] ^ (1 << i % 8));
      ASSERT_NE(problemWith(bytes, surface), "") << "byte " << i;
      bytes[i] = static_cast<char>(~whole[i]);
      ASSERT_NE(problemWith(bytes, surface), "") << "byte " << i;
    }
    for (std::size_t size = 0; size < whole.size(); ++size)
    {
      ASSERT_NE(problemWith(whole.substr(0, size), surface), "") << "first " << size;
    }
    EXPECT_NE(problemWith(whole + "x", surface), "");
    EXPECT_NE(problemWith(whole + whole, surface), "");
    EXPECT_EQ(problemWith(whole, surface), "");
  }
}

/// With a checksum that fits again, what is loaded is right nevertheless, or refused.
TEST(Save, NoByteCanMakeAWrongAnswer)
{
  for (const auto& surface : { surfaceOf<float>(data::cornellBox()), mixed<double>() })
  {
    const Rays rays = raysAround(*surface, 20, 5);
    const auto oracle = build(surface, optionsOf(Structure::BruteForce));
    const Answers wanted = ask(*oracle, rays.batch(), with(Precision::Exact));
    std::size_t taken = 0;
    for (const BuildOptions& options : everyStructure())
    {
      SCOPED_TRACE(label(options));
      const std::string whole = saved(*build(surface, options));
      const std::string body = bodyOf(whole);
      const std::size_t step = 1 + body.size() / 100;
      for (std::size_t i = 0; i < body.size(); i += step)
      {
        for (const int change : { 1 << i % 8, 0xff })
        {
          std::string changed = body;
          changed[i] = static_cast<char>(changed[i] ^ change);
          try
          {
            const auto again = loaded(sealed(changed), surface);
            ++taken;
            ASSERT_NO_FATAL_FAILURE(
              expectSameHits(ask(*again, rays.batch(), with(Precision::Exact)), wanted))
              << "byte " << i;
            (void)again->hierarchy();
          }
          catch (const SaveError&)
          {
            continue;
          }
        }
      }
    }
    EXPECT_GT(taken, 100u); // or the test would say nothing
  }
}

/// Of two numbers side by side the second stands twice: so a child may get two parents, and another
/// none.
TEST(Save, NoNumberInPlaceOfItsNeighbourMakesAWrongAnswer)
{
  const auto surface = surfaceOf<float>(data::cornellBox());
  const Rays rays = raysAround(*surface, 20, 5);
  const auto oracle = build(surface, optionsOf(Structure::BruteForce));
  const Answers wanted = ask(*oracle, rays.batch(), with(Precision::Exact));
  for (const Structure structure : { Structure::Bvh, Structure::WideBvh, Structure::KdTree,
         Structure::Octree, Structure::BspTree })
  {
    SCOPED_TRACE(name(structure));
    const std::string body = bodyOf(saved(*build(surface, optionsOf(structure))));
    for (std::size_t i = 0; i + 8 <= body.size(); ++i)
    {
      std::string changed = body;
      std::copy_n(body.begin() + static_cast<std::ptrdiff_t>(i) + 4, 4,
        changed.begin() + static_cast<std::ptrdiff_t>(i));
      try
      {
        const auto again = loaded(sealed(changed), surface);
        ASSERT_NO_FATAL_FAILURE(
          expectSameHits(ask(*again, rays.batch(), with(Precision::Exact)), wanted))
          << "byte " << i;
      }
      catch (const SaveError&)
      {
        continue;
      }
    }
  }
}

/// A chain: each inner node has a leaf and the next inner node.
TEST(Save, ATreeDeeperThanWalksGoIsRefused)
{
  for (const std::size_t depth : { 64u, 65u })
  {
    std::vector<std::array<Vec3, 3>> triangles;
    for (std::size_t i = 0; i <= depth; ++i)
    {
      const Vec3 at = { 2.0 * static_cast<double>(i), 0, 0 };
      triangles.push_back({ at, at + Vec3{ 1, 0, 0 }, at + Vec3{ 0, 1, 0 } });
    }
    const auto surface = surfaceOf<float>(triangles);
    BuildOptions options = optionsOf(Structure::Bvh);
    options.leafSize = 1;
    const auto built = build(surface, options);
    const std::size_t nodes = 2 * depth + 1;
    ASSERT_EQ(built->statistics().nodes, nodes);
    std::string kinds;
    std::string children;
    for (std::size_t i = 0; i < nodes; ++i)
    {
      const bool leaf = i % 2 == 1 || i + 1 == nodes;
      kinds += leaf ? '\x03' : '\x00';
      const auto first = static_cast<std::uint32_t>(i + 1);
      children.append(reinterpret_cast<const char*>(&first), leaf ? 0 : sizeof(first));
    }
    // The nodes follow their number.
    std::string body = bodyOf(saved(*built));
    const auto number = static_cast<std::uint64_t>(nodes);
    std::size_t at = body.find(std::string(reinterpret_cast<const char*>(&number), sizeof(number)));
    ASSERT_NE(at, std::string::npos);
    body.replace(at + sizeof(number), nodes + children.size(), kinds + children);
    if (depth == 64)
    {
      const Ray ray{ { 20.25, 0.25, -1 }, { 0, 0, 1 } };
      EXPECT_EQ(closestOf(*loaded(sealed(body), surface), ray, Precision::Exact).primitive, 10u);
      continue;
    }
    EXPECT_NE(problemWith(sealed(body), surface).find("deeper"), std::string::npos);
  }
}

TEST(Save, SaysWhatIsWrong)
{
  const auto surface = surfaceOf<float>(data::teapot(2));
  const std::string whole = saved(*build(surface, optionsOf(Structure::WideBvh)));
  const auto problem = [&](std::size_t at, const std::string& with)
  { return problemWith(std::string(whole).replace(at, with.size(), with), surface); };
  const auto expect = [](const std::string& text, const char* part)
  { EXPECT_NE(text.find(part), std::string::npos) << text; };
  expect(problem(0, "no"), "no saved structure");
  expect(problem(8, std::string("\x01\x02\x03\x04", 4)), "other way");
  expect(problem(12, "\x07"), "version 7, not 2");
  expect(problem(100, "####"), "checksum");
  expect(problemWith("", surface), "no saved structure");
  expect(problemWith(whole.substr(0, 500), surface), "too early");
  expect(problemWith(whole + "\n", surface), "follows");
  expect(problemWith(whole, surfaceOf<double>(data::teapot(2))), "another surface");
  expect(problemWith(whole, surfaceOf<float>(data::teapot(3))), "another surface");
  expect(problemWith(whole, surfaceOf<float>(data::teapot(2), { 0, 0, 1e-3 })), "another surface");
  EXPECT_THROW((void)loaded(whole, nullptr), std::invalid_argument);
}

TEST(Save, SizesThatAreLiesTakeNoMemory)
{
  const auto surface = surfaceOf<float>(data::cornellBox());
  for (const BuildOptions& options : everyStructure())
  {
    const std::string body = bodyOf(saved(*build(surface, options)));
    for (std::size_t i = 0; i + 8 <= body.size() && i < 200; ++i)
    {
      std::string changed = body;
      changed.replace(i, 8, "\xff\xff\xff\xff\xff\xff\xff\x7f");
      // The options may become others that are as good; a number of elements may not.
      (void)problemWith(sealed(changed), surface);
    }
    std::string header = saved(*build(surface, options));
    header.replace(16, 8, "\xff\xff\xff\xff\xff\xff\xff\x7f");
    EXPECT_NE(problemWith(header, surface), "");
  }
}

TEST(Save, Files)
{
  const auto surface = surfaceOf<float>(data::teapot(2));
  const auto built = build(surface, optionsOf(Structure::KdTree));
  const std::string path =
    (std::filesystem::temp_directory_path() / "LumitreeTestSave.lumitree").string();
  saveFile(*built, path);
  saveFile(*built, path); // over the one that is there
  const Ray ray{ { 0.1, 0.2, -9 }, { 0, 0, 1 } };
  EXPECT_TRUE(sameBits(closestOf(*loadFile(path, surface), ray, Precision::Exact),
    closestOf(*built, ray, Precision::Exact)));
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
  std::ofstream(path) << "something else";
  EXPECT_THROW((void)loadFile(path, surface), SaveError);
  std::filesystem::remove(path);
  EXPECT_THROW((void)loadFile(path, surface), SaveError);
  EXPECT_THROW(saveFile(*built, "/no such directory/file"), SaveError);
  EXPECT_THROW(saveFile(*built, std::filesystem::temp_directory_path().string()), SaveError);
  std::ostringstream broken;
  broken.setstate(std::ios::badbit);
  EXPECT_THROW(save(*built, broken), SaveError);
}

TEST(Save, ReferencesKeepTheirTrees)
{
  const auto surface = surfaceOf<float>(data::cornellBox());
  for (const Structure structure : Registry::instance().structures())
  {
    if (structure >= Structure::Embree)
    {
      const auto built = build(surface, optionsOf(structure));
      EXPECT_THROW((void)saved(*built), SaveError);
      EXPECT_EQ(built->refit(surface), nullptr);
    }
  }
}

TEST(Save, AGridOfTooManyCellsIsNot)
{
  const auto surface = surfaceOf<float>({ { Vec3{ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 1 } } });
  BuildOptions options = optionsOf(Structure::Grid);
  options.gridResolution = { 40, 40, 40 };
  EXPECT_EQ(loaded(saved(*build(surface, options)), surface)->options().gridResolution,
    options.gridResolution);
  options.gridResolution = { 60, 60, 60 };
  EXPECT_THROW((void)saved(*build(surface, options)), SaveError);
}

TEST(Save, CanBeStopped)
{
  const auto surface = surfaceOf<float>(data::teapot(12));
  for (const Structure structure : { Structure::WideBvh, Structure::KdTree, Structure::Octree })
  {
    std::istringstream stream(saved(*build(surface, optionsOf(structure))));
    JobControl control;
    control.stop = true;
    EXPECT_THROW((void)load(stream, surface, 1, &control), BuildStopped);
  }
}

} // namespace
