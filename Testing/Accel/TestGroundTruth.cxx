// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// CGAL's exact arithmetic against every structure: which primitives are hit, in what order, at what
// t. Rays through vertices and edges, in planes, at limits, far from the origin; and ordinary ones.
#include "Accel/Reference/CGAL/CgalReference.h"
#include "ClosedScenes.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <thread>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

struct Scene
{
  std::string name;
  std::shared_ptr<const Surface> surface;
};

/// Coordinates on a grid, so that differences of floats are floats.
data::Mesh snapped(data::Mesh mesh, double scale, double grid)
{
  for (double& x : mesh.points)
  {
    x = std::nearbyint(x * scale / grid) * grid;
  }
  return mesh;
}

const std::vector<Scene>& scenes()
{
  static const std::vector<Scene> all = {
    { "cornell box", surfaceOf<float>(data::cornellBox(2)) },
    { "sphere on a grid", surfaceOf<float>(snapped(data::sphere(8), 100, 0x1p-10)) },
    { "bumpy torus on a grid, far away",
      surfaceOf<float>(snapped(data::torus(32, 16, 0.3), 100, 0x1p-4), { 1e6, 1e6, 1e6 }) },
    { "teapot in doubles, far away", surfaceOf<double>(data::teapot(3), { 5e5, 4649776, 100 }) },
    { "teapot in a stadium", surfaceOf<double>(data::teapotInStadium(3)) },
    { "flat grid", surfaceOf<float>(data::terrain(8, 1, 0.0)) },
    { "terrain", surfaceOf<double>(data::terrain(12)) },
    { "slivers", surfaceOf<double>(data::slivers(60, 1e6)) },
    { "cloud", surfaceOf<float>(data::randomCloud(300, 3, 0.5)) },
  };
  return all;
}

/// Rays meant to be hard: exactly through vertices, along edges, in planes, along axes; some with
/// limits.
Rays degenerateRays(const Surface& surface, std::size_t count)
{
  Uniform uniform(17);
  const Box box = surface.bounds();
  Rays rays;
  while (rays.size() < count)
  {
    const auto a = surface.vertices(static_cast<PrimitiveId>(uniform.index(surface.size())));
    const auto b = surface.vertices(static_cast<PrimitiveId>(uniform.index(surface.size())));
    Vec3 origin;
    for (int k = 0; k < 3; ++k)
    {
      origin[k] = std::nearbyint(uniform(box.lower[k], box.upper[k]) * 8) / 8;
    }
    rays.add(origin, a[0] - origin);
    rays.add(origin, a[0] + a[1] - 2.0 * origin);
    rays.add(a[0], a[1] - a[0]);
    rays.add(2.0 * a[0] - a[1], a[1] - a[0]);
    rays.add(a[0], b[0] - a[0]);
    rays.add(0.5 * (a[0] + a[1]), b[2] - b[1]);
    Vec3 axis = { 0, 0, 0 };
    axis[uniform.index(3)] = uniform.index(2) == 0 ? 1.0 : -1.0;
    rays.add(a[2] - 2.0 * axis, axis);
    rays.add(Ray{ origin, a[0] - origin, 1, 1 });
    rays.add(Ray{ origin, a[0] - origin, -2, 1 });
    rays.add(Ray{ origin, a[0] - origin, 1 });
    rays.add(Ray{ origin, 3.0 * (a[0] - origin), -HUGE_VAL, 1.0 / 3.0 });
    rays.add(Ray{ origin, axis, -HUGE_VAL, HUGE_VAL });
    rays.add(Ray{ origin, 0x1p-70 * (a[0] - origin), 0, 0x1p70 });
  }
  return rays;
}

Rays ordinaryRays(const Surface& surface, std::size_t count)
{
  Uniform uniform(23);
  const Box box = surface.bounds();
  const Vec3 size = box.size();
  Rays rays;
  for (std::size_t i = 0; i < count; ++i)
  {
    Vec3 origin;
    Vec3 direction;
    for (int k = 0; k < 3; ++k)
    {
      origin[k] = uniform(box.lower[k] - 0.1 * size[k], box.upper[k] + 0.1 * size[k] + 1e-3);
      direction[k] = uniform(box.lower[k], box.upper[k]) + uniform(-1e-6, 1e-6) - origin[k];
    }
    rays.add(origin, direction);
  }
  return rays;
}

class GroundTruth : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { registerCgal(); }

  static std::shared_ptr<const Accelerator> cgal(const std::shared_ptr<const Surface>& surface)
  {
    return build(surface, optionsOf(Structure::Cgal));
  }

  /// Hits of every structure at Exact are those of CGAL: the same primitives in the same order, and
  /// t within the promise.
  static void compare(const Scene& scene, const Rays& rays)
  {
    AllHits truth;
    cgal(scene.surface)->all(rays.batch(), truth, with(Precision::Exact));
    ASSERT_GT(truth.hits.size(), 0u);
    for (const auto& accelerator : accelerators(scene.surface))
    {
      SCOPED_TRACE(scene.name + ", " + label(accelerator->options()));
      std::vector<Hit> closest(rays.size());
      std::vector<std::uint8_t> any(rays.size());
      std::vector<std::uint32_t> counts(rays.size());
      AllHits all;
      accelerator->closest(rays.batch(), closest.data(), with(Precision::Exact));
      accelerator->any(rays.batch(), any.data(), with(Precision::Exact));
      accelerator->count(rays.batch(), counts.data(), with(Precision::Exact));
      accelerator->all(rays.batch(), all, with(Precision::Exact));
      ASSERT_EQ(all.offsets, truth.offsets);
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        const std::size_t first = truth.offsets[i];
        const std::size_t number = truth.offsets[i + 1] - first;
        ASSERT_EQ(counts[i], number) << "ray " << i;
        ASSERT_EQ(any[i], number > 0 ? 1 : 0) << "ray " << i;
        ASSERT_EQ(closest[i].primitive, number > 0 ? truth.hits[first].primitive : noPrimitive)
          << "ray " << i;
        for (std::size_t h = first; h < first + number; ++h)
        {
          ASSERT_EQ(all.hits[h].primitive, truth.hits[h].primitive) << "ray " << i;
          ASSERT_NEAR(all.hits[h].t, truth.hits[h].t, std::fabs(truth.hits[h].t) * 0x1p-24)
            << "ray " << i;
        }
      }
    }
  }
};

TEST_F(GroundTruth, DegenerateRaysHitExactlyWhatTheyShould)
{
  for (const Scene& scene : scenes())
  {
    compare(scene, degenerateRays(*scene.surface, 520));
  }
}

TEST_F(GroundTruth, TiesAndRoundedTAreTheSame)
{
  std::size_t several = 0;
  for (const Scene& scene : scenes())
  {
    const Rays rays = degenerateRays(*scene.surface, 130);
    AllHits truth;
    cgal(scene.surface)->ties(rays.batch(), truth, with(Precision::Exact));
    several += truth.hits.size() - rays.size();
    QueryOptions options = with(Precision::Exact);
    options.roundedT = true;
    for (const auto& accelerator : accelerators(scene.surface))
    {
      SCOPED_TRACE(scene.name + ", " + label(accelerator->options()));
      AllHits ties;
      accelerator->ties(rays.batch(), ties, options);
      ASSERT_EQ(ties.offsets, truth.offsets);
      for (std::size_t h = 0; h < truth.hits.size(); ++h)
      {
        ASSERT_EQ(ties.hits[h].primitive, truth.hits[h].primitive);
        ASSERT_EQ(ties.hits[h].t, truth.hits[h].t);
      }
    }
  }
  EXPECT_GT(several, 100u);
}

TEST_F(GroundTruth, ClosedSurfacesFromInsideAndFromAfar)
{
  for (const bool torus : { false, true })
  {
    for (const Place& place : closedPlaces())
    {
      const ClosedScene c = closedScene(torus, place, 5);
      Rays all;
      for (const Aim aim : everyAim)
      {
        const Rays inside = raysFromInside(c, aim, 25);
        for (std::size_t i = 0; i < inside.size(); ++i)
        {
          all.add(inside.batch()[i]);
        }
        for (const double distance : { 1e4, 1e6, 1e8 })
        {
          const Rays afar = raysFromAfar(c, aim, distance, 5);
          for (std::size_t i = 0; i < afar.size(); ++i)
          {
            all.add(afar.batch()[i]);
          }
        }
      }
      compare({ c.name, c.surface }, all);
    }
  }
}

TEST_F(GroundTruth, OrdinaryRaysHitExactlyWhatTheyShould)
{
  for (const Scene& scene : scenes())
  {
    compare(scene, ordinaryRays(*scene.surface, 500));
  }
}

TEST_F(GroundTruth, FastAgreesOnOrdinaryRays)
{
  for (const Scene& scene : scenes())
  {
    const Rays rays = ordinaryRays(*scene.surface, 500);
    std::vector<Hit> truth(rays.size());
    cgal(scene.surface)->closest(rays.batch(), truth.data(), with(Precision::Exact));
    for (const auto& accelerator : accelerators(scene.surface))
    {
      SCOPED_TRACE(scene.name + ", " + label(accelerator->options()));
      std::vector<Hit> hits(rays.size());
      accelerator->closest(rays.batch(), hits.data(), with(Precision::Fast));
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        ASSERT_EQ(hits[i].primitive, truth[i].primitive) << "ray " << i;
        if (hits[i].primitive != noPrimitive)
        {
          ASSERT_NEAR(hits[i].t, truth[i].t, 1e-8 * std::fabs(truth[i].t)) << "ray " << i;
          ASSERT_NEAR(hits[i].u, truth[i].u, 1e-4) << "ray " << i;
          ASSERT_NEAR(hits[i].v, truth[i].v, 1e-4) << "ray " << i;
        }
      }
    }
  }
}

TEST_F(GroundTruth, AHitBeyondTheRangeOfDoublesIsAMiss)
{
  const auto surface = surfaceOf<double>(
    std::vector<std::array<Vec3, 3>>{ { Vec3{ 0, 0, 1 }, Vec3{ 1, 0, 1 }, Vec3{ 0, 1, 1 } },
      { Vec3{ 0, 0, -4 }, Vec3{ 1, 0, -4 }, Vec3{ 0, 1, -4 } } });
  std::vector<std::shared_ptr<const Accelerator>> all = accelerators(surface);
  all.push_back(cgal(surface));
  for (const auto& accelerator : all)
  {
    SCOPED_TRACE(label(accelerator->options()));
    const Ray ray = { { 0.25, 0.25, 0 }, { 0, 0, 0x1p-1022 }, -HUGE_VAL, HUGE_VAL };
    const auto hits = allOf(*accelerator, ray, Precision::Exact);
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_EQ(hits[0].t, 0x1p1022);
  }
}

TEST_F(GroundTruth, CgalAnswersExactQueriesOnly)
{
  const auto truth = cgal(scenes().front().surface);
  EXPECT_TRUE(truth->supports(Precision::Exact));
  EXPECT_EQ(truth->bestPrecision(), Precision::Exact);
  Rays rays;
  rays.add({ 0.5, 0.5, 0.5 }, { 0, 0, 1 });
  Hit hit;
  for (const Precision precision : { Precision::Fast, Precision::Watertight })
  {
    EXPECT_FALSE(truth->supports(precision));
    EXPECT_THROW(truth->closest(rays.batch(), &hit, with(precision)), UnsupportedQuery);
  }
}

TEST_F(GroundTruth, TheOtherKernelsAgreeOnOrdinaryRays)
{
  for (const Structure structure : { Structure::CgalEpick, Structure::CgalCartesian })
  {
    for (const Scene& scene : scenes())
    {
      SCOPED_TRACE(scene.name + ", " + std::string(name(structure)));
      const Rays rays = ordinaryRays(*scene.surface, 300);
      std::vector<Hit> truth(rays.size());
      std::vector<Hit> hits(rays.size());
      const auto asked = build(scene.surface, optionsOf(structure));
      build(scene.surface, optionsOf(Structure::WideBvh))
        ->closest(rays.batch(), truth.data(), with(Precision::Exact));
      asked->closest(rays.batch(), hits.data(), with(Precision::Fast));
      std::size_t others = 0;
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        others += hits[i].primitive != truth[i].primitive ? 1 : 0;
        if (hits[i].primitive == truth[i].primitive && truth[i].primitive != noPrimitive)
        {
          EXPECT_NEAR(hits[i].t, truth[i].t, 1e-6 * std::fabs(truth[i].t)) << "ray " << i;
          EXPECT_NEAR(hits[i].u, truth[i].u, 1e-3) << "ray " << i;
          EXPECT_NEAR(hits[i].v, truth[i].v, 1e-3) << "ray " << i;
        }
      }
      EXPECT_LE(others, 3u);
    }
  }
}

TEST_F(GroundTruth, TheOtherKernelsKeepLimitsAndRefuseWhatTheyCannot)
{
  const auto surface = surfaceOf<double>(
    std::vector<std::array<Vec3, 3>>{ { Vec3{ 0, 0, 1 }, Vec3{ 1, 0, 1 }, Vec3{ 0, 1, 1 } },
      { Vec3{ 0, 0, -1 }, Vec3{ 1, 0, -1 }, Vec3{ 0, 1, -1 } },
      { Vec3{ 0, 0, 0 }, Vec3{ 1, 0, 0 }, Vec3{ 0, 0, 1 } } });
  for (const Structure structure : { Structure::CgalEpick, Structure::CgalCartesian })
  {
    const auto asked = build(surface, optionsOf(structure));
    EXPECT_TRUE(asked->supports(Precision::Fast));
    const Vec3 o = { 0.25, 0.25, 0 };
    const auto ids = [&](double tMin, double tMax)
    {
      std::vector<PrimitiveId> found;
      for (const Hit& hit : allOf(*asked, { o, { 0, 0, 1 }, tMin, tMax }, Precision::Fast))
      {
        found.push_back(hit.primitive);
      }
      return found;
    };
    EXPECT_EQ(ids(0, HUGE_VAL), (std::vector<PrimitiveId>{ 0 }));
    EXPECT_EQ(ids(0, 1), (std::vector<PrimitiveId>{ 0 }));
    EXPECT_EQ(ids(-1, 1), (std::vector<PrimitiveId>{ 1, 0 }));
    EXPECT_EQ(ids(-HUGE_VAL, 0.5), (std::vector<PrimitiveId>{ 1 }));
    EXPECT_TRUE(ids(0, 0.5).empty());
    // In the plane of the third: no hit of it.
    EXPECT_EQ(closestOf(*asked, { { 0.25, 0, -0.5 }, { 0, 0, 1 } }, Precision::Fast).primitive, 0u);
    Rays rays;
    rays.add(o, { 0, 0, 1 });
    Hit hit;
    for (const Precision precision : { Precision::Watertight, Precision::Exact })
    {
      EXPECT_FALSE(asked->supports(precision));
      try
      {
        asked->closest(rays.batch(), &hit, with(precision));
        FAIL() << "answered";
      }
      catch (const UnsupportedQuery& refusal)
      {
        EXPECT_NE(std::string(refusal.what()).find(name(structure)), std::string::npos);
      }
    }
    const auto nothing =
      build(surfaceOf<float>(std::vector<std::array<Vec3, 3>>{}), optionsOf(structure));
    EXPECT_EQ(closestOf(*nothing, { o, { 0, 0, 1 } }, Precision::Fast).primitive, noPrimitive);
  }
}

TEST_F(GroundTruth, CgalsQueriesAgreeWithEachOtherAndHonourTheContract)
{
  const auto& surface = scenes().front().surface;
  const auto truth = cgal(surface);
  Rays rays = degenerateRays(*surface, 60);
  rays.add({ 0.5, 0.5, 0.5 }, { 0, 0, 0 });
  rays.add(Ray{ { 0.5, 0.5, 0.5 }, { 0, 0, 1 }, 2, 1 });
  rays.add({ std::nan(""), 0.5, 0.5 }, { 0, 0, 1 });
  const RayBatch batch = rays.batch();
  std::vector<Hit> closest(batch.size);
  std::vector<std::uint8_t> any(batch.size);
  std::vector<std::uint32_t> counts(batch.size);
  AllHits all;
  EXPECT_EQ(truth->closest(batch, closest.data(), with(Precision::Exact)).invalidRays, 3u);
  truth->any(batch, any.data(), with(Precision::Exact));
  truth->count(batch, counts.data(), with(Precision::Exact));
  truth->all(batch, all, with(Precision::Exact));
  for (std::size_t i = 0; i < batch.size; ++i)
  {
    const std::size_t number = all.offsets[i + 1] - all.offsets[i];
    EXPECT_EQ(counts[i], number);
    EXPECT_EQ(any[i], number > 0 ? 1 : 0);
    EXPECT_TRUE(sameBits(closest[i], number > 0 ? all.hits[all.offsets[i]] : Hit{}));
    for (std::size_t h = all.offsets[i] + 1; h < all.offsets[i + 1]; ++h)
    {
      EXPECT_LE(all.hits[h - 1].t, all.hits[h].t);
    }
  }

  // What a ray skips it does not hit.
  const std::vector<std::uint32_t> skipped = { closest[0].primitive };
  const std::vector<std::uint64_t> offsets = { 0, 1 };
  const std::vector<std::uint32_t> setOfRay(batch.size, 0);
  RayBatch skipping = batch;
  skipping.skip = { setOfRay.data(), offsets.data(), skipped.data() };
  std::vector<Hit> others(batch.size);
  truth->closest(skipping, others.data(), with(Precision::Exact));
  for (std::size_t i = 0; i < batch.size; ++i)
  {
    EXPECT_TRUE(others[i].primitive == noPrimitive || others[i].primitive != skipped[0]);
    EXPECT_TRUE(closest[i].primitive == skipped[0] || sameBits(others[i], closest[i]));
  }
}

TEST_F(GroundTruth, CgalMindsNeitherTheHostsRoundingNorOtherThreads)
{
  const auto& surface = scenes().front().surface;
  const Rays rays = degenerateRays(*surface, 130);
  std::vector<Hit> wanted(rays.size());
  cgal(surface)->closest(rays.batch(), wanted.data(), with(Precision::Exact));

  std::vector<Hit> hits(rays.size());
  const int before = std::fegetround();
  std::fesetround(FE_UPWARD);
  const auto truth = cgal(surface);
  truth->closest(rays.batch(), hits.data(), with(Precision::Exact));
  EXPECT_EQ(std::fegetround(), FE_UPWARD);
  std::fesetround(before);
  std::vector<Hit> others(rays.size());
  std::thread other([&] { truth->closest(rays.batch(), others.data(), with(Precision::Exact)); });
  std::vector<Hit> mine(rays.size());
  truth->closest(rays.batch(), mine.data(), with(Precision::Exact));
  other.join();
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    ASSERT_TRUE(sameBits(hits[i], wanted[i])) << "ray " << i;
    ASSERT_TRUE(sameBits(others[i], wanted[i])) << "ray " << i;
    ASSERT_TRUE(sameBits(mine[i], wanted[i])) << "ray " << i;
  }
}

TEST_F(GroundTruth, CgalStopsWhenTold)
{
  const auto& surface = scenes().front().surface;
  const Rays rays = ordinaryRays(*surface, 500);
  JobControl control;
  control.onProgress = [](double) { return false; };
  QueryOptions options = with(Precision::Exact);
  options.control = &control;
  std::vector<Hit> hits(rays.size(), Hit{ 1, 2, 3, 4 });
  EXPECT_FALSE(cgal(surface)->closest(rays.batch(), hits.data(), options).completed);
  EXPECT_TRUE(sameBits(hits.back(), Hit{}));
  AllHits all;
  EXPECT_FALSE(cgal(surface)->all(rays.batch(), all, options).completed);
  EXPECT_EQ(all.offsets.size(), rays.size() + 1);
  EXPECT_EQ(all.offsets.back(), all.hits.size());
}

TEST_F(GroundTruth, CgalShowsOneNodeAndKeepsBadTrianglesOut)
{
  const double nan = std::nan("");
  const auto surface = surfaceOf<double>(
    std::vector<std::array<Vec3, 3>>{ { Vec3{ nan, 0, 0 }, Vec3{ 1, 0, 0 }, Vec3{ 0, 1, 0 } },
      { Vec3{ 0, 0, 0 }, Vec3{ 1, 1, 0 }, Vec3{ 2, 2, 0 } },
      { Vec3{ 0, 0, 1 }, Vec3{ 1, 0, 1 }, Vec3{ 0, 1, 1 } } });
  const auto truth = cgal(surface);
  const HierarchyView view = truth->hierarchy();
  ASSERT_EQ(view.nodes.size(), 1u);
  EXPECT_TRUE(view.nodes[0].leaf);
  EXPECT_EQ(view.references, std::vector<PrimitiveId>{ 2u });
  EXPECT_EQ(truth->statistics().nodes, 1u);
  EXPECT_EQ(truth->statistics().sahCost, 1.0);
  EXPECT_EQ(closestOf(*truth, { { 0.25, 0.25, 0 }, { 0, 0, 1 } }, Precision::Exact).primitive, 2u);

  const auto empty = cgal(surfaceOf<float>(std::vector<std::array<Vec3, 3>>{}));
  EXPECT_EQ(
    closestOf(*empty, { { 0, 0, 0 }, { 0, 0, 1 } }, Precision::Exact).primitive, noPrimitive);
}

} // namespace
