// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// A structure whose points have moved answers as brute force does over where they are now.
#include "Answers.h"
#include "SavedStructures.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

std::vector<BuildOptions> refittable()
{
  std::vector<BuildOptions> all;
  for (const Structure structure : { Structure::Bvh, Structure::WideBvh })
  {
    for (const BvhBuild build :
      { BvhBuild::LongestAxisMedian, BvhBuild::BinnedSah, BvhBuild::SweepSah, BvhBuild::Morton })
    {
      all.push_back(optionsOf(structure, build));
    }
    all.push_back(optionsOf(structure));
    all.back().leafSize = 30;
  }
  return all;
}

/// A surface's points as numbers, to be moved.
std::vector<double> pointsOf(const Surface& surface)
{
  std::vector<double> points;
  for (std::size_t i = 0; i < surface.pointCount(); ++i)
  {
    const Vec3 p = surface.point(i);
    points.insert(points.end(), p.begin(), p.end());
  }
  return points;
}

template <class T>
std::shared_ptr<const Surface> with(
  const Surface& surface, const std::vector<double>& points, std::vector<Quadric> quadrics = {})
{
  return std::make_shared<const Surface>(
    PointArray::from(std::vector<T>(points.begin(), points.end())), surface.triangles(),
    std::move(quadrics));
}

void expectAsBruteForce(const Accelerator& tree)
{
  const auto surface = tree.sharedSurface();
  if (surface->hittable().empty())
  {
    EXPECT_EQ(allOf(tree, { { 0.1, 0.1, -9 }, { 0, 0, 1 } }, Precision::Exact).size(), 0u);
    return;
  }
  const Rays rays = raysAround(*surface, 60, 3);
  const auto oracle = build(surface, optionsOf(Structure::BruteForce));
  for (const Precision precision : everyPrecision)
  {
    expectSameHits(ask(tree, rays.batch(), lumitree::testing::with(precision)),
      ask(*oracle, rays.batch(), lumitree::testing::with(precision)));
  }
  // The hierarchy holds each primitive that can be hit, once, in boxes that hold it.
  const HierarchyView view = tree.hierarchy();
  std::vector<PrimitiveId> held = view.references;
  std::sort(held.begin(), held.end());
  EXPECT_EQ(held, surface->hittable());
  for (const HierarchyNode& node : view.nodes)
  {
    for (std::uint32_t i = 0; node.leaf && i < node.referenceCount; ++i)
    {
      Box box = node.box;
      box.extend(surface->box(view.references[node.firstReference + i]));
      const double room = 1e-12 * std::fabs(box.upper[0]) + 1e-12 * std::fabs(box.lower[0]);
      EXPECT_NEAR(box.lower[0], node.box.lower[0], room);
      EXPECT_NEAR(box.upper[0], node.box.upper[0], room);
    }
  }
}

/// The numbers moved in the n-th of many ways.
std::vector<double> moved(std::vector<double> points, int n, unsigned seed)
{
  Uniform uniform(seed);
  const double turn = uniform(0.0, 6.0);
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    double* const p = points.data() + i;
    switch (n % 7)
    {
      case 0: // a wave
        p[2] += 0.3 * std::sin(3.0 * p[0] + turn);
        break;
      case 1: // any way
        for (int k = 0; k < 3; ++k)
        {
          p[k] += uniform(-1.0, 1.0);
        }
        break;
      case 2: // far away and larger
        for (int k = 0; k < 3; ++k)
        {
          p[k] = 1e3 * p[k] + 5e6;
        }
        break;
      case 3: // flat
        p[1] = 0.25;
        break;
      case 4: // here and there no number
        p[uniform.index(3)] = uniform.index(9) == 0 ? std::nan("") : p[0];
        break;
      case 5: // tiny
        for (int k = 0; k < 3; ++k)
        {
          p[k] *= 1e-30;
        }
        break;
      case 6: // everything in one point, or on one line
        p[0] = p[1] = 1.0;
        p[2] = uniform.index(40) == 0 ? p[2] : 1.0;
        break;
    }
  }
  return points;
}

template <class T>
void moveInManyWays(const std::shared_ptr<const Surface>& surface)
{
  const std::vector<double> points = pointsOf(*surface);
  for (const BuildOptions& options :
    { refittable()[1], refittable()[4], refittable()[6], refittable()[9] })
  {
    SCOPED_TRACE(label(options));
    const auto built = build(surface, options);
    for (int n = 0; n < 7; ++n)
    {
      SCOPED_TRACE(n);
      const auto there = with<T>(*surface, moved(points, n, 17), someQuadrics(0.25 * n));
      const auto fitted = built->refit(there);
      ASSERT_NE(fitted, nullptr);
      EXPECT_EQ(fitted->sharedSurface(), there);
      EXPECT_EQ(fitted->statistics().origin, Origin::Refitted);
      EXPECT_EQ(fitted->statistics().sahCostBuilt, built->statistics().sahCost);
      expectAsBruteForce(*fitted);
      // What was lost on the way comes back only by building; from the first tree always.
      if (there->hittable().size() == surface->hittable().size())
      {
        const auto back = fitted->refit(surface);
        ASSERT_NE(back, nullptr);
        EXPECT_EQ(back->statistics().sahCost, built->statistics().sahCost);
        EXPECT_EQ(back->statistics().nodes, built->statistics().nodes);
      }
      else
      {
        EXPECT_EQ(fitted->refit(surface), nullptr);
      }
      // What is saved of it is as good.
      const auto again = loaded(saved(*fitted), there);
      EXPECT_EQ(again->statistics().sahCostBuilt, built->statistics().sahCost);
      expectAsBruteForce(*again);
    }
  }
}

TEST(Refit, AnswersAsBruteForce)
{
  const auto teapot = surfaceOf<double>(data::teapot(2));
  moveInManyWays<double>(with<double>(*teapot, pointsOf(*teapot), someQuadrics()));
  moveInManyWays<float>(with<float>(*teapot, pointsOf(*teapot), someQuadrics()));
}

TEST(Refit, NothingMovedGivesTheSameBoxes)
{
  const auto surface = surfaceOf<float>(data::teapot(3), { 1e4, 0, 0 });
  for (const BuildOptions& options : refittable())
  {
    SCOPED_TRACE(label(options));
    const auto built = build(surface, options);
    const HierarchyView a = built->hierarchy();
    const HierarchyView b = built->refit(surface)->hierarchy();
    ASSERT_EQ(a.nodes.size(), b.nodes.size());
    EXPECT_EQ(leavesOf(a), leavesOf(b));
    for (std::size_t i = 0; i < a.nodes.size(); ++i)
    {
      EXPECT_EQ(a.nodes[i].box.lower, b.nodes[i].box.lower);
      EXPECT_EQ(a.nodes[i].box.upper, b.nodes[i].box.upper);
    }
  }
}

TEST(Refit, WhatCannotBeRefittedSaysSo)
{
  const auto surface = surfaceOf<float>(data::teapot(2));
  for (const BuildOptions& options : ownStructures())
  {
    SCOPED_TRACE(label(options));
    const bool boxes =
      options.structure == Structure::Bvh || options.structure == Structure::WideBvh;
    const auto built = build(surface, options);
    EXPECT_EQ(
      built->refit(surface) != nullptr, boxes && options.bvhBuild != BvhBuild::SpatialSplits);
    EXPECT_EQ(built->refit(surfaceOf<float>(data::teapot(3))), nullptr);
    EXPECT_THROW((void)built->refit(nullptr), std::invalid_argument);
  }
}

TEST(Refit, WithoutAnything)
{
  const auto nothing = surfaceOf<float>(std::vector<std::array<Vec3, 3>>{});
  const auto surface = surfaceOf<float>(data::cornellBox());
  for (const BuildOptions& options : refittable())
  {
    SCOPED_TRACE(label(options));
    const auto fitted = build(nothing, options)->refit(nothing);
    ASSERT_NE(fitted, nullptr);
    expectAsBruteForce(*fitted);
    // All of it gone, and back.
    std::vector<double> points = pointsOf(*surface);
    std::fill(points.begin(), points.end(), std::nan(""));
    const auto built = build(surface, options);
    const auto gone = built->refit(with<float>(*surface, points));
    ASSERT_NE(gone, nullptr);
    expectAsBruteForce(*gone);
    EXPECT_EQ(gone->refit(surface), nullptr);
  }
}

TEST(Refit, TheSameForAnyNumberOfThreads)
{
  const auto surface = surfaceOf<float>(data::teapot(8));
  const auto there = with<float>(*surface, moved(pointsOf(*surface), 4, 3));
  for (const Structure structure : { Structure::Bvh, Structure::WideBvh })
  {
    const auto built = build(surface, optionsOf(structure));
    EXPECT_EQ(saved(*built->refit(there, 1)), saved(*built->refit(there, 4)));
    JobControl control;
    control.stop = true;
    EXPECT_THROW((void)built->refit(there, 1, &control), BuildStopped);
  }
}

} // namespace
