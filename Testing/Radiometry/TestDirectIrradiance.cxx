// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/DirectIrradiance.h"
#include "Radiometry/DirectionalSource.h"
#include "Radiometry/IsotropicPointSource.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <vector>

namespace
{

using namespace lumitree;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::shared_ptr<const Accelerator> accelerate(
  std::vector<double> points, std::vector<Triangle> triangles)
{
  return build(
    std::make_shared<Surface>(PointArray::from(std::move(points)), std::move(triangles)));
}

/// The wall x = 1, |y| <= 10, 0 <= z <= 2.
std::shared_ptr<const Accelerator> wall()
{
  return accelerate({ 1, -10, 0, 1, 10, 0, 1, 10, 2, 1, -10, 2 }, { { 0, 1, 2 }, { 0, 2, 3 } });
}

/// Receivers on the floor, facing up, along x at y = 0.3.
struct Floor
{
  std::vector<double> positions;
  std::vector<double> normals;

  Floor(double from, double to, std::size_t count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      const double share = static_cast<double>(i) / static_cast<double>(count - 1);
      positions.insert(positions.end(), { from + share * (to - from), 0.3, 0.0 });
      normals.insert(normals.end(), { 0.0, 0.0, 1.0 });
    }
  }

  [[nodiscard]] Receivers view() const
  {
    Receivers receivers;
    receivers.size = this->positions.size() / 3;
    receivers.positions = this->positions.data();
    receivers.normals = this->normals.data();
    return receivers;
  }
};

TEST(DirectIrradiance, ShadowOfAWallEndsWhereItMust)
{
  const auto occluders = wall();
  const Floor floor(-4.0, 0.999, 40001);
  // The ray from (3, ·, 4) over the top of the wall (1, ·, 2) meets the floor at x = −1.
  const IsotropicPointSource source(1000.0, { 3.0, 0.3, 4.0 });
  DirectOptions options;
  options.occluders = occluders.get();
  std::vector<double> shadowed(floor.view().size);
  std::vector<double> open(floor.view().size);
  const DirectReport report =
    directIrradiance(floor.view(), { &source }, shadowed.data(), {}, options);
  directIrradiance(floor.view(), { &source }, open.data());
  EXPECT_TRUE(report.completed);
  EXPECT_EQ(report.invalidReceivers, 0u);
  EXPECT_EQ(report.shadowRays, floor.view().size);
  for (std::size_t i = 0; i < shadowed.size(); ++i)
  {
    const double x = floor.positions[3 * i];
    const Vec3 position = { x, 0.3, 0.0 };
    EXPECT_EQ(open[i], source.irradiance(position, { 0.0, 0.0, 1.0 }));
    if (std::fabs(x + 1.0) > 1e-9)
    {
      ASSERT_EQ(shadowed[i], x < -1.0 ? open[i] : 0.0) << x;
    }
  }
}

TEST(DirectIrradiance, ParallelLightIsHiddenFromAnyDistance)
{
  const auto occluders = wall();
  const Floor floor(-4.0, 0.999, 1001);
  const DirectionalSource sun(1000.0, { -1.0, 0.0, -1.0 }); // shadow of 2 behind the wall
  DirectOptions options;
  options.occluders = occluders.get();
  std::vector<double> e(floor.view().size);
  directIrradiance(floor.view(), { &sun }, e.data(), {}, options);
  for (std::size_t i = 0; i < e.size(); ++i)
  {
    const double x = floor.positions[3 * i];
    if (std::fabs(x + 1.0) > 1e-9)
    {
      ASSERT_NEAR(e[i], x < -1.0 ? 1000.0 * std::sqrt(0.5) : 0.0, 1e-10) << x;
    }
  }
}

TEST(DirectIrradiance, OnlyReceiversThatFaceALightCastRays)
{
  const auto occluders = wall();
  Floor floor(-4.0, 0.0, 100);
  for (std::size_t i = 0; i < 50; ++i)
  {
    floor.normals[3 * i + 2] = -1.0;
  }
  const IsotropicPointSource source(1000.0, { 3.0, 0.0, 4.0 });
  const IsotropicPointSource dark(0.0, { 3.0, 0.0, 4.0 });
  DirectOptions options;
  options.occluders = occluders.get();
  std::vector<double> e(100);
  EXPECT_EQ(
    directIrradiance(floor.view(), { &source, &dark }, e.data(), {}, options).shadowRays, 50u);
  EXPECT_EQ(e[10], 0.0);
}

TEST(DirectIrradiance, SourcesAddUpInTheirOrder)
{
  const auto occluders = wall();
  const Floor floor(-4.0, 4.0, 5000);
  std::vector<std::unique_ptr<Source>> owned;
  for (int i = 0; i < 7; ++i)
  {
    owned.push_back(std::make_unique<IsotropicPointSource>(
      100.0 / (i + 1), Vec3{ -3.0 + i, 0.1 * i, 1.0 + 0.7 * i }));
  }
  owned.push_back(std::make_unique<DirectionalSource>(33.0, Vec3{ -0.3, 0.1, -1.0 }));
  std::vector<const Source*> sources;
  std::vector<std::vector<double>> each(owned.size(), std::vector<double>(floor.view().size));
  std::vector<double*> outputs;
  for (std::size_t s = 0; s < owned.size(); ++s)
  {
    sources.push_back(owned[s].get());
    outputs.push_back(each[s].data());
  }
  outputs[3] = nullptr; // asked of nobody
  DirectOptions options;
  options.occluders = occluders.get();
  std::vector<double> total(floor.view().size);
  directIrradiance(floor.view(), sources, total.data(), outputs, options);
  directIrradiance(floor.view(), { sources[3] }, each[3].data(), {}, options);
  for (std::size_t i = 0; i < total.size(); ++i)
  {
    double sum = 0.0;
    for (const auto& values : each)
    {
      sum += values[i];
    }
    ASSERT_EQ(total[i], sum);
  }
}

TEST(DirectIrradiance, SameBitsForAnyNumberOfThreads)
{
  const auto occluders = wall();
  const Floor floor(-4.0, 4.0, 50000);
  const IsotropicPointSource a(1000.0, { 3.0, 0.3, 4.0 });
  const IsotropicPointSource b(300.0, { -2.0, 1.0, 3.0 });
  const DirectionalSource c(20.0, { -1.0, 0.2, -1.0 });
  DirectOptions options;
  options.occluders = occluders.get();
  options.threads = 1;
  std::vector<double> reference(floor.view().size);
  directIrradiance(floor.view(), { &a, &b, &c }, reference.data(), {}, options);
  for (int threads = 2; threads <= 4; ++threads)
  {
    options.threads = threads;
    std::vector<double> e(floor.view().size);
    directIrradiance(floor.view(), { &a, &b, &c }, e.data(), {}, options);
    EXPECT_EQ(std::memcmp(e.data(), reference.data(), e.size() * sizeof(double)), 0) << threads;
  }
}

TEST(DirectIrradiance, InvalidReceiversHaveNoValue)
{
  Floor floor(-4.0, 4.0, 10);
  floor.positions[3 * 2 + 1] = nan;
  floor.positions[3 * 3] = std::numeric_limits<double>::infinity();
  floor.normals[3 * 4 + 2] = nan;
  floor.positions[3 * 5] = 1e301;
  const IsotropicPointSource source(1000.0, { 3.0, 0.0, 4.0 });
  std::vector<double> e(10, -1.0);
  std::vector<double> each(10, -1.0);
  const DirectReport report =
    directIrradiance(floor.view(), { &source }, e.data(), { each.data() });
  EXPECT_EQ(report.invalidReceivers, 4u);
  for (std::size_t i = 0; i < 10; ++i)
  {
    EXPECT_EQ(std::isnan(e[i]), i >= 2 && i <= 5) << i;
    EXPECT_EQ(std::isnan(each[i]), i >= 2 && i <= 5) << i;
  }
  EXPECT_EQ(directIrradiance(floor.view(), {}, e.data()).invalidReceivers, 4u);
  EXPECT_EQ(e[0], 0.0);
  EXPECT_TRUE(std::isnan(e[2]));
}

TEST(DirectIrradiance, NothingToDo)
{
  const IsotropicPointSource source(1000.0, { 3.0, 0.0, 4.0 });
  const auto nothing = accelerate({}, {});
  DirectOptions options;
  options.occluders = nothing.get();
  const DirectReport empty = directIrradiance(Receivers{}, { &source }, nullptr, {}, options);
  EXPECT_TRUE(empty.completed);
  const Floor floor(-4.0, 4.0, 10);
  std::vector<double> e(10);
  EXPECT_EQ(directIrradiance(floor.view(), { &source }, e.data(), {}, options).shadowRays, 0u);
  EXPECT_GT(e[0], 0.0);
  EXPECT_THROW(directIrradiance(floor.view(), { &source }, e.data(), { nullptr, nullptr }),
    std::invalid_argument);
}

TEST(DirectIrradiance, WithoutNormalsItIsScalar)
{
  const auto occluders = wall();
  const Floor floor(-4.0, 0.999, 101);
  Receivers receivers = floor.view();
  receivers.normals = {};
  const IsotropicPointSource source(1000.0, { 3.0, 0.3, 4.0 });
  DirectOptions options;
  options.occluders = occluders.get();
  std::vector<double> e(receivers.size);
  directIrradiance(receivers, { &source }, e.data(), {}, options);
  EXPECT_EQ(e.front(), source.scalarIrradiance({ -4.0, 0.3, 0.0 }));
  EXPECT_EQ(e.back(), 0.0);
}

TEST(DirectIrradiance, ALampOnTheCeilingIsNotHiddenByIt)
{
  for (const double offset : { 0.0, 1e4, 1e6 })
  {
    // A ceiling that is tilted, so that the lamp's position in it is rounded.
    std::vector<double> points;
    for (const Vec3& p :
      { Vec3{ -5, -5, 2.9 }, Vec3{ 5, -5, 3.3 }, Vec3{ 5, 5, 3.1 }, Vec3{ -5, 5, 2.7 } })
    {
      points.insert(points.end(), { p[0] + offset, p[1] + offset, p[2] + offset });
    }
    const auto ceiling = accelerate(points, { { 0, 1, 2 }, { 0, 2, 3 } });
    DirectOptions options;
    options.occluders = ceiling.get();
    int hidden = 0;
    for (int i = 0; i < 400; ++i)
    {
      const double a = 0.9 * (i % 20) / 20.0;
      const double b = (1.0 - a) * (i / 20) / 20.0;
      Vec3 lamp;
      for (int k = 0; k < 3; ++k)
      {
        lamp[k] = points[k] + a * (points[3 + k] - points[k]) + b * (points[6 + k] - points[k]);
      }
      const IsotropicPointSource source(100.0, lamp);
      const Vec3 below = { offset + 0.1 * (i % 7), offset - 0.3, offset };
      const Vec3 normal = { 0.0, 0.0, 1.0 };
      Receivers receivers;
      receivers.size = 1;
      receivers.positions = below.data();
      receivers.normals = normal.data();
      double e = 0.0;
      directIrradiance(receivers, { &source }, &e, {}, options);
      hidden += e > 0.0 ? 0 : 1;
    }
    EXPECT_EQ(hidden, 0) << offset;
  }
}

TEST(DirectIrradiance, SkippedPrimitivesCastNoShadow)
{
  const auto occluders = wall();
  const Floor floor(0.0, 0.9, 6000);
  const IsotropicPointSource source(1000.0, { 3.0, 0.3, 2.0 });
  DirectOptions options;
  options.occluders = occluders.get();
  // Every other receiver skips both triangles of the wall.
  std::vector<std::uint64_t> offsets = { 0 };
  std::vector<std::uint32_t> primitives;
  std::vector<std::uint32_t> named;
  for (std::size_t i = 0; i < floor.view().size; ++i)
  {
    if (i % 2 == 0)
    {
      primitives.insert(primitives.end(), { 0, 1 });
    }
    offsets.push_back(primitives.size());
    named.push_back(static_cast<std::uint32_t>(i % 2));
  }
  Receivers receivers = floor.view();
  receivers.skip.offsets = offsets.data();
  receivers.skip.primitives = primitives.data();
  std::vector<double> e(receivers.size);
  directIrradiance(receivers, { &source }, e.data(), {}, options);

  const std::uint64_t twoSets[] = { 0, 2, 2 };
  receivers.skip.offsets = twoSets;
  receivers.skip.setOfRay = named.data();
  std::vector<double> again(receivers.size);
  directIrradiance(receivers, { &source }, again.data(), {}, options);
  for (std::size_t i = 0; i < e.size(); ++i)
  {
    ASSERT_EQ(e[i] > 0.0, i % 2 == 0) << i;
    ASSERT_EQ(again[i], e[i]) << i;
  }
}

TEST(DirectIrradiance, StopsWhenAsked)
{
  const auto occluders = wall();
  const Floor floor(-4.0, 4.0, 50000);
  const IsotropicPointSource source(1000.0, { 3.0, 0.3, 4.0 });
  JobControl control;
  control.onProgress = [](double) { return false; };
  DirectOptions options;
  options.occluders = occluders.get();
  options.threads = 1;
  options.control = &control;
  std::vector<double> e(floor.view().size);
  EXPECT_FALSE(directIrradiance(floor.view(), { &source }, e.data(), {}, options).completed);
}

} // namespace
