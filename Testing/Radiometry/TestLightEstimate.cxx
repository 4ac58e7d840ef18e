// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Light with what is in its way: reference values, each computed twice with 30 digits, and one
// method against the other.
#include "Data/Scenes.h"
#include "Radiometry/Constants.h"
#include "Radiometry/DirectionalSource.h"
#include "Radiometry/GeneralSky.h"
#include "Radiometry/IsotropicPointSource.h"
#include "Radiometry/LightEstimate.h"
#include "Radiometry/PolygonSource.h"
#include "Radiometry/SkySource.h"
#include "Radiometry/SphereSource.h"
#include "Testing/Accel/TestHelpers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace
{

using namespace lumitree;
using lumitree::testing::surfaceOf;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const Vec3 up = { 0.0, 0.0, 1.0 };

using Triangles = std::vector<std::array<Vec3, 3>>;

void addQuad(Triangles& to, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  to.push_back({ a, b, c });
  to.push_back({ a, c, d });
}

std::shared_ptr<const Accelerator> accelerate(const Triangles& triangles)
{
  return build(surfaceOf<double>(triangles));
}

PolygonSource squareLight(double half, double z, double radiance, bool twoSided = false)
{
  return PolygonSource(
    { { { { -half, -half, z }, { -half, half, z }, { half, half, z }, { half, -half, z } }, {},
      radiance, twoSided } });
}

struct Result
{
  double value = 0.0, lower = 0.0, upper = 0.0, unoccluded = 0.0;
  EstimateMethod method = EstimateMethod::None;
  ShadowState shadow = ShadowState::Lit;
  std::uint32_t rays = 0;
};

Result at(const Source& source, const Accelerator* occluders, const Vec3& position,
  EstimateOptions options = {}, const Vec3& normal = up)
{
  Receivers receivers;
  receivers.size = 1;
  receivers.positions = position.data();
  receivers.normals = normal.data();
  options.occluders = occluders;
  Result r;
  EstimateOutputs out;
  out.irradiance = &r.value;
  out.lower = &r.lower;
  out.upper = &r.upper;
  out.unoccluded = &r.unoccluded;
  out.method = &r.method;
  out.shadow = &r.shadow;
  out.rays = &r.rays;
  estimateLight(receivers, { &source }, out, options);
  return r;
}

/// Street along y with walls of that height at x = -left and x = right, long enough to be endless.
Triangles canyon(double left, double right, double height)
{
  constexpr double far = 2e3;
  Triangles walls;
  for (const double x : { -left, right })
  {
    addQuad(walls, { x, -far, 0 }, { x, far, 0 }, { x, far, height }, { x, -far, height });
  }
  return walls;
}

TEST(LightEstimate, AnchorN3HalfPlaneBeforeASquareLight)
{
  const double profile[] = { 0.0, 0.9360673737, 3.061541777, 5.357482815, 7.565359661, 9.432830351,
    9.958610683 };
  const PolygonSource light = squareLight(0.5, 3.0, 100.0);
  Triangles blocker;
  addQuad(blocker, { -50, -50, 1.5 }, { 0, -50, 1.5 }, { 0, 50, 1.5 }, { -50, 50, 1.5 });
  const auto occluders = accelerate(blocker);
  for (int i = 0; i < 7; ++i)
  {
    const Result r = at(light, occluders.get(), { -0.6 + 0.2 * i, 0.0, 0.0 });
    EXPECT_NEAR(r.value, profile[i], 1e-9);
    EXPECT_EQ(r.rays, 0u);
  }
  const Result r = at(light, occluders.get(), { 0.2, 0.0, 0.0 });
  EXPECT_NEAR(r.value, 7.565359661421048, 1e-8 * 7.5);
  EXPECT_EQ(r.method, EstimateMethod::Clipping);
  EXPECT_EQ(r.shadow, ShadowState::Penumbra);
  EXPECT_EQ(at(light, occluders.get(), { -3.0, 0.0, 0.0 }).shadow, ShadowState::Umbra);
  EXPECT_EQ(at(light, occluders.get(), { 3.0, 0.0, 0.0 }).method, EstimateMethod::ClosedForm);
}

TEST(LightEstimate, AnchorsOfSkies)
{
  const OvercastSky overcast({ SkyLevel::Kind::ZenithRadiance, 1.0 });
  for (const bool horizon : { true, false })
  {
    EstimateOptions options;
    options.horizon = horizon;
    const auto expected = horizon ? EstimateMethod::Horizon : EstimateMethod::Clipping;
    // Y13: a wall of height 2 and width 3, 1 in front of its middle.
    Triangles wall;
    addQuad(wall, { 1, -1.5, 0 }, { 1, 1.5, 0 }, { 1, 1.5, 2 }, { 1, -1.5, 2 });
    const auto one = accelerate(wall);
    const Result y13 = at(UniformSky(1.0), one.get(), { 0, 0, 0 }, options);
    EXPECT_NEAR(y13.value / pi, 0.77127926010688, 1e-8);
    EXPECT_EQ(y13.method, expected);
    // Y4 and Y12: the floor of a canyon.
    const auto street = accelerate(canyon(0.3, 0.7, 1.0));
    EXPECT_NEAR(
      at(UniformSky(1.0), street.get(), { 0, 0, 0 }, options).value / pi, 0.4304051149648369, 1e-8);
    EXPECT_NEAR(at(overcast, street.get(), { 0, 0, 0 }, options).value, 1.182812859917384, 1e-8);
    // K2, Y9: the bottom of a well, whose opening is a polygon.
    constexpr int sides = 24;
    Triangles well;
    double opening = 0.0;
    for (int i = 0; i < sides; ++i)
    {
      const double a = 2.0 * pi * i / sides;
      const double b = 2.0 * pi * (i + 1) / sides;
      const Vec3 p = { std::cos(a), std::sin(a), 0.0 };
      const Vec3 q = { std::cos(b), std::sin(b), 0.0 };
      addQuad(well, p, q, q + 2.0 * up, p + 2.0 * up);
      // Lambert's sum over the edges of the opening.
      const Vec3 n = cross(p + 2.0 * up, q + 2.0 * up);
      opening += 0.5 * n[2] / length(n) * std::atan2(length(n), dot(p + 2.0 * up, q + 2.0 * up));
    }
    const auto deep = accelerate(well);
    EXPECT_NEAR(at(UniformSky(1.0), deep.get(), { 0, 0, 0 }, options).value, opening, 1e-9);
    EXPECT_NEAR(opening / pi, 0.2, 3e-3);
  }
  const auto nothing = accelerate({ { { { 0, 0, -1 }, { 1, 0, -1 }, { 0, 1, -1 } } } });
  EXPECT_NEAR(at(UniformSky(1.0), nothing.get(), { 0, 0, 0 }).value, pi, 1e-14); // Y1
  EXPECT_NEAR(at(overcast, nothing.get(), { 0, 0, 0 }).value, 7.0 * pi / 9.0, 1e-14);
}

TEST(LightEstimate, ExactMethodsAgreeForReceiversOfAnyTilt)
{
  // Houses; the exact methods know nothing of each other.
  Triangles houses;
  for (const auto& [x, y, h] : { std::array<double, 3>{ 2, 1, 3 }, { -2, -1, 1.5 }, { 1, -3, 2 } })
  {
    const Vec3 base[4] = { { x - 1, y - 1, 0 }, { x + 1, y - 1, 0 }, { x + 1, y + 1, 0 },
      { x - 1, y + 1, 0 } };
    for (int i = 0; i < 4; ++i)
    {
      const Vec3& a = base[i];
      const Vec3& b = base[(i + 1) % 4];
      addQuad(houses, a, b, b + h * up, a + h * up);
    }
    addQuad(houses, base[0] + h * up, base[1] + h * up, base[2] + h * up, base[3] + h * up);
  }
  const auto occluders = accelerate(houses);
  EstimateOptions clip;
  clip.horizon = false;
  const OvercastSky overcast({ SkyLevel::Kind::ZenithRadiance, 1.0 });
  const UniformSky uniform(1.0);
  for (const Vec3& n : { up, Vec3{ 1, 0, 0 }, Vec3{ 0.6, 0, 0.8 }, Vec3{ 0, -0.8, -0.6 } })
  {
    for (const Vec3& p : { Vec3{ 0, 0, 0 }, Vec3{ -0.5, 2.5, 0.25 }, Vec3{ 0.2, -1, 1.8 } })
    {
      for (const Source* sky :
        { static_cast<const Source*>(&overcast), static_cast<const Source*>(&uniform) })
      {
        const Result horizon = at(*sky, occluders.get(), p, {}, n);
        const Result cut = at(*sky, occluders.get(), p, clip, n);
        EXPECT_EQ(horizon.method, EstimateMethod::Horizon);
        EXPECT_EQ(cut.rays, 0u);
        EXPECT_NEAR(horizon.value, cut.value, 1e-11);
      }
    }
  }
}

TEST(LightEstimate, WhatHangsInTheAirHasNoSkyline)
{
  Triangles roof;
  addQuad(roof, { -1, -1, 2 }, { 1, -1, 2 }, { 1, 1, 2 }, { -1, 1, 2 });
  const auto occluders = accelerate(roof);
  const Result r = at(UniformSky(1.0), occluders.get(), { 0, 0, 0 });
  EXPECT_EQ(r.method, EstimateMethod::Clipping);
  const PolygonSource same = squareLight(1.0, 2.0, 1.0);
  EXPECT_NEAR(r.value, pi - at(same, nullptr, { 0, 0, 0 }).value, 1e-10);
}

/// The floor of the Cornell box, without what stands on it, and its light.
struct Room
{
  std::vector<double> positions;
  std::vector<double> normals;
  std::shared_ptr<const Accelerator> occluders = build(surfaceOf<double>(data::cornellBox()));
  PolygonSource light{ { { { { 0.35, 0.35, 0.995 }, { 0.35, 0.65, 0.995 }, { 0.65, 0.65, 0.995 },
                             { 0.65, 0.35, 0.995 } },
    {}, 10.0, false } } };

  explicit Room(int side)
  {
    for (int j = 0; j < side; ++j)
    {
      for (int i = 0; i < side; ++i)
      {
        this->positions.insert(this->positions.end(), { (i + 0.5) / side, (j + 0.5) / side, 0.0 });
        this->normals.insert(this->normals.end(), { 0.0, 0.0, 1.0 });
      }
    }
  }
  [[nodiscard]] Receivers view() const
  {
    Receivers r;
    r.size = this->positions.size() / 3;
    r.positions = this->positions.data();
    r.normals = this->normals.data();
    return r;
  }
};

TEST(LightEstimate, IntervalsCoverTheTruthWithTheStoppingRuleOn)
{
  const Room room(24);
  const std::size_t size = room.view().size;
  std::vector<double> exact(size), value(size), lower(size), upper(size);
  std::vector<ShadowState> shadow(size);
  EstimateOptions options;
  options.occluders = room.occluders.get();
  EstimateOutputs reference;
  reference.irradiance = exact.data();
  reference.shadow = shadow.data();
  EXPECT_EQ(estimateLight(room.view(), { &room.light }, reference, options).rays, 0u);
  options.mostClipped = 0; // rays alone
  EstimateOutputs out;
  out.irradiance = value.data();
  out.lower = lower.data();
  out.upper = upper.data();
  for (const double tolerance : { 0.05, 0.01 })
  {
    options.relativeTolerance = tolerance;
    std::size_t covered = 0;
    std::size_t penumbra = 0;
    for (std::uint64_t seed = 0; seed < 2; ++seed)
    {
      options.seed = seed << 32;
      estimateLight(room.view(), { &room.light }, out, options);
      for (std::size_t i = 0; i < size; ++i)
      {
        ASSERT_GE(value[i], lower[i]);
        ASSERT_LE(value[i], upper[i]);
        if (shadow[i] == ShadowState::Penumbra)
        {
          ++penumbra;
          covered += exact[i] >= lower[i] && exact[i] <= upper[i] ? 1 : 0;
        }
        else
        {
          EXPECT_NEAR(value[i], exact[i], 1e-12) << "all or nothing is seen exactly";
        }
      }
    }
    EXPECT_GT(penumbra, 500u);
    EXPECT_GE(static_cast<double>(covered), 0.9 * static_cast<double>(penumbra)) << tolerance;
  }
}

TEST(LightEstimate, RaysToSkiesAgreeWithWhatIsExactForEveryTilt)
{
  // Level ground, a slope and a wall draw their directions in ways of their own.
  Triangles wall;
  addQuad(wall, { 1, -1.5, 0 }, { 1, 1.5, 0 }, { 1, 1.5, 2 }, { 1, -1.5, 2 });
  const auto occluders = accelerate(wall);
  const OvercastSky overcast({ SkyLevel::Kind::ZenithRadiance, 1.0 });
  const GeneralSky clear(
    cieSky(12), { 0.5, 0.5, std::sqrt(0.5) }, SkyLevel{ SkyLevel::Kind::ZenithRadiance, 1.0 });
  EstimateOptions rays;
  rays.mostClipped = 0;
  rays.horizon = false;
  rays.relativeTolerance = 2e-3;
  rays.maximumRays = 1u << 20;
  for (const Vec3& n : { up, Vec3{ 0.6, 0.0, 0.8 }, Vec3{ 1.0, 0.0, 0.0 } })
  {
    const double exact = at(overcast, occluders.get(), { 0, 0, 0 }, {}, n).value;
    const Result sampled = at(overcast, occluders.get(), { 0, 0, 0 }, rays, n);
    EXPECT_EQ(sampled.method, EstimateMethod::Sampling);
    EXPECT_NEAR(sampled.value, exact, 4e-3 * exact);

    // No exact method knows this sky: rings and sectors of it.
    double sum = 0.0;
    constexpr int steps = 400;
    for (int i = 0; i < steps; ++i)
    {
      const double z = (i + 0.5) / steps;
      for (int j = 0; j < 2 * steps; ++j)
      {
        const double a = pi * (j + 0.5) / steps;
        const double r = std::sqrt(1.0 - z * z);
        const Vec3 w = { r * std::cos(a), r * std::sin(a), z };
        const bool hidden = w[0] > 0.0 && std::fabs(w[1]) < 1.5 * w[0] && z < 2.0 * w[0];
        sum += hidden ? 0.0 : clear.radianceFrom(w) * std::max(0.0, dot(n, w));
      }
    }
    sum *= pi / steps / steps;
    EXPECT_NEAR(at(clear, occluders.get(), { 0, 0, 0 }, rays, n).value, sum, 6e-3 * sum);
  }
}

TEST(LightEstimate, IntervalsCoverTheTruthBehindWhatIsFinerThanTheRays)
{
  // Leaves so small that one ray says little about its neighbours.
  const PolygonSource light(
    { { { { 0.3, 0.3, 1.5 }, { 0.3, 0.7, 1.5 }, { 0.7, 0.7, 1.5 }, { 0.7, 0.3, 1.5 } }, {}, 10.0,
      false } });
  for (const double size : { 0.02, 0.01 })
  {
    const auto leaves = build(surfaceOf<double>(data::randomCloud(3000, 7, size)));
    for (const double tolerance : { 0.1, 0.03 })
    {
      std::size_t covered = 0;
      constexpr int count = 60;
      constexpr std::uint64_t repeats = 4;
      for (int i = 0; i < count; ++i)
      {
        const Vec3 p = { 0.2 + 0.01 * i, 0.8 - 0.007 * i, -0.2 };
        EstimateOptions rays;
        rays.seed = 17;
        rays.mostClipped = 0;
        rays.relativeTolerance = 1e-9;
        rays.maximumRays = 1u << 15;
        const double exact = at(light, leaves.get(), p, rays).value;
        rays.relativeTolerance = tolerance;
        for (std::uint64_t seed = 0; seed < repeats; ++seed)
        {
          rays.seed = (repeats * static_cast<std::uint64_t>(i) + seed) << 32;
          const Result r = at(light, leaves.get(), p, rays);
          covered += exact >= r.lower && exact <= r.upper ? 1 : 0;
        }
      }
      EXPECT_GE(covered, 0.9 * count * repeats) << size << ' ' << tolerance;
    }
  }
}

TEST(LightEstimate, RaysGoToTheOutlinesOfWhatHides)
{
  // Half a light is hidden along a line: the finer the rays, the more of them say nothing new.
  Triangles blocker;
  addQuad(blocker, { -50, -50, 1.5 }, { 0, -50, 1.5 }, { 0, 50, 1.5 }, { -50, 50, 1.5 });
  const auto occluders = accelerate(blocker);
  const PolygonSource light = squareLight(0.5, 3.0, 100.0);
  const double exact = at(light, occluders.get(), { 0.2, 0.0, 0.0 }).value;
  EstimateOptions options;
  options.mostClipped = 0;
  options.relativeTolerance = 1e-9; // no ray is left out on the way there
  options.maximumRays = 1u << 14;
  const Result all = at(light, occluders.get(), { 0.2, 0.0, 0.0 }, options);
  EXPECT_GE(all.rays, 1u << 13);
  options.relativeTolerance = 1e-3;
  const Result few = at(light, occluders.get(), { 0.2, 0.0, 0.0 }, options);
  EXPECT_LT(few.rays, all.rays / 3);
  EXPECT_LE(few.upper - few.lower, 2.001e-3 * few.value);
  EXPECT_NEAR(few.value, exact, 1e-3 * exact);
}

TEST(LightEstimate, SameBitsForAnyNumberOfThreads)
{
  const Room room(14); // two chunks
  const std::size_t size = room.view().size;
  const IsotropicPointSource lamp(10.0, { 0.1, 0.5, 0.9 });
  const DirectionalSource sun(1.0, { 0.1, 0.2, -1.0 });
  const UniformSky sky(1.0);
  const std::vector<const Source*> sources = { &room.light, &lamp, &sun, &sky };
  EstimateOptions options;
  options.occluders = room.occluders.get();
  options.mostClipped = 6; // all methods
  options.relativeTolerance = 0.05;
  std::vector<double> reference;
  for (int threads = 1; threads <= 4; ++threads)
  {
    options.threads = threads;
    std::vector<double> all(9 * size);
    EstimateOutputs out;
    out.irradiance = all.data();
    out.scalar = all.data() + size;
    out.vector = all.data() + 2 * size;
    out.lower = all.data() + 5 * size;
    out.upper = all.data() + 6 * size;
    out.hemispherical = all.data() + 7 * size;
    out.perSource = { all.data() + 8 * size, nullptr, nullptr, nullptr };
    estimateLight(room.view(), sources, out, options);
    if (threads == 1)
    {
      reference = all;
    }
    EXPECT_EQ(std::memcmp(all.data(), reference.data(), all.size() * sizeof(double)), 0);
  }
}

TEST(LightEstimate, QuantitiesOfOpenAndHiddenLightHangTogether)
{
  const PolygonSource light = squareLight(0.5, 2.0, 100.0, true);
  Triangles blocker;
  addQuad(blocker, { 0, -5, 1 }, { 5, -5, 1 }, { 5, 5, 1 }, { 0, 5, 1 });
  const auto occluders = accelerate(blocker);
  const Vec3 p = { 0.1, 0.2, 0.0 };
  const Vec3 n = { 0.6, 0.0, 0.8 };
  for (const Accelerator* hides : { static_cast<const Accelerator*>(nullptr), occluders.get() })
  {
    Receivers receivers;
    receivers.size = 1;
    receivers.positions = p.data();
    receivers.normals = n.data();
    double front = 0, back = 0, scalar = 0, cylinder = 0, hemisphere = 0;
    Vec3 vector{};
    EstimateOutputs out;
    out.irradiance = &front;
    out.back = &back;
    out.scalar = &scalar;
    out.vector = vector.data();
    out.cylindrical = &cylinder;
    out.hemispherical = &hemisphere;
    EstimateOptions options;
    options.occluders = hides;
    estimateLight(receivers, { &light }, out, options);
    EXPECT_NEAR(front - back, dot(n, vector), 1e-9);
    EXPECT_NEAR(hemisphere, 0.25 * (scalar + dot(n, vector)), 1e-12);
    // Cylindrical irradiance is the mean over the upright planes around.
    double mean = 0.0;
    constexpr int planes = 2000;
    for (int i = 0; i < planes; ++i)
    {
      const double a = 2.0 * pi * i / planes;
      mean += at(light, hides, p, {}, { std::cos(a), std::sin(a), 0.0 }).value / planes;
    }
    EXPECT_NEAR(cylinder, mean, 2e-5 * mean);
    if (hides)
    {
      options.mostClipped = 0;
      options.relativeTolerance = 2e-3;
      options.maximumRays = 1u << 18;
      double sampled[4];
      Vec3 direction{};
      out.irradiance = sampled;
      out.back = sampled + 1;
      out.scalar = sampled + 2;
      out.cylindrical = sampled + 3;
      out.vector = direction.data();
      estimateLight(receivers, { &light }, out, options);
      EXPECT_NEAR(sampled[0], front, 5e-3 * front);
      EXPECT_NEAR(sampled[2], scalar, 5e-3 * scalar);
      EXPECT_NEAR(sampled[3], cylinder, 5e-3 * cylinder);
      EXPECT_NEAR(length(direction - vector), 0.0, 5e-3 * length(vector));
    }
  }
}

TEST(LightEstimate, ManyOccludersAreSampledAndFewAreNot)
{
  const PolygonSource light = squareLight(0.5, 2.0, 100.0);
  const auto fine = build(surfaceOf<double>(data::torus(64, 32), { 0.0, 0.0, 1.0 }));
  Triangles one = { { { { -1, -1, 1 }, { 1, -1, 1 }, { 0, 0.2, 1 } } } };
  const auto coarse = accelerate(one);
  const Result many = at(light, fine.get(), { 0.1, 0.9, 0.0 });
  const Result few = at(light, coarse.get(), { 0.1, 0.2, 0.0 });
  EXPECT_TRUE(few.method == EstimateMethod::Clipping);
  EXPECT_EQ(few.lower, few.upper);
  if (many.method == EstimateMethod::Sampling)
  {
    EXPECT_GT(many.rays, 0u);
    EXPECT_LE(many.upper - many.lower, 2.0 * 0.01 * many.value + 1e-12);
  }
  // Cut with no limit it is exact, and inside the interval of the rays.
  EstimateOptions all;
  all.mostClipped = 1u << 20;
  all.relativeTolerance = 1e-9;
  all.maximumRays = 64;
  const Result exact = at(light, fine.get(), { 0.1, 0.9, 0.0 }, all);
  EXPECT_NEAR(exact.value, many.value, 0.03 * many.value);
}

TEST(LightEstimate, RoundLightsAreClosedFormWhereNothingIsInTheShaft)
{
  const SphereSource ball(100.0, { 0.0, 0.0, 3.0 }, 1.0);
  Triangles aside = { { { { 4, -1, 1 }, { 5, -1, 1 }, { 4, 1, 1 } } } };
  const auto far = accelerate(aside);
  const Result open = at(ball, far.get(), { 0, 0, 0 });
  EXPECT_EQ(open.method, EstimateMethod::ClosedForm);
  EXPECT_NEAR(open.value, 100.0 * pi / 9.0, 1e-11); // B1, from below
  Triangles half;
  addQuad(half, { 0, -9, 1 }, { 9, -9, 1 }, { 9, 9, 1 }, { 0, 9, 1 });
  const auto near = accelerate(half);
  const Result cut = at(ball, near.get(), { 0, 0, 0 });
  EXPECT_EQ(cut.method, EstimateMethod::Clipping);
  EXPECT_NEAR(cut.value, 0.5 * open.value, 1e-11 * open.value);
}

TEST(LightEstimate, AwkwardPlaces)
{
  // In the light's plane, behind it, touching an occluder, at a vertex, far, huge offsets.
  const PolygonSource l(
    { { { { 0, 0, 1 }, { 2, 0, 1 }, { 2, 1, 1 }, { 1, 1, 1 }, { 1, 2, 1 }, { 0, 2, 1 } }, {}, 10.0,
      true } });
  Triangles blocks;
  addQuad(blocks, { 0.5, -1, 0 }, { 0.5, 3, 0 }, { 0.5, 3, 0.5 }, { 0.5, -1, 0.5 });
  addQuad(blocks, { -9, -9, 0 }, { 9, -9, 0 }, { 9, 9, 0 }, { -9, 9, 0 });
  addQuad(blocks, { 0, 0, 1 }, { 2, 0, 1 }, { 2, 1, 1 }, { 0, 1, 1 }); // the light itself
  const auto occluders = accelerate(blocks);
  for (const Vec3& p : { Vec3{ 0.5, 0.5, 1 }, Vec3{ 1, 1, 1 }, Vec3{ 3, 3, 1 }, Vec3{ 0.5, 1, 0 },
         Vec3{ 0.5, 1, 0.5 }, Vec3{ 0, 0, 0 }, Vec3{ 1, 1, 2 }, Vec3{ 1, 1, 1e-12 },
         Vec3{ 1e6, 0, 0 }, Vec3{ 1, 1, -1e6 }, Vec3{ 1, 1, 1.0 - 1e-15 }, Vec3{ 5e6, 5e6, 5e6 } })
  {
    for (const Vec3& n : { up, -1.0 * up, Vec3{ 1, 0, 0 }, Vec3{ 0.6, 0.0, 0.8 } })
    {
      for (const std::uint32_t clipped : { 192u, 0u })
      {
        EstimateOptions options;
        options.mostClipped = clipped;
        const Result r = at(l, occluders.get(), p, options, n);
        EXPECT_GE(r.value, 0.0);
        EXPECT_LE(r.value, 10.0 * pi * (1.0 + 1e-12));
        EXPECT_LE(r.lower, r.value);
        EXPECT_GE(r.upper, r.value);
      }
    }
  }
}

TEST(LightEstimate, FarFromTheOriginNothingChanges)
{
  // Coordinates that 5e6 does not round.
  const auto scene = [](double offset)
  {
    const Vec3 o = { offset, -offset, 0.0 };
    Triangles blocker;
    addQuad(blocker, o + Vec3{ -8, -8, 1.5 }, o + Vec3{ 0, -8, 1.5 }, o + Vec3{ 0, 8, 1.5 },
      o + Vec3{ -8, 8, 1.5 });
    const auto occluders = accelerate(blocker);
    const PolygonSource light({ { { o + Vec3{ -.5, -.5, 3 }, o + Vec3{ -.5, .5, 3 },
                                    o + Vec3{ .5, .5, 3 }, o + Vec3{ .5, -.5, 3 } },
      {}, 100.0, false } });
    return at(light, occluders.get(), o + Vec3{ 0.25, 0, 0 }).value;
  };
  EXPECT_NEAR(scene(5e6), scene(0.0), 1e-8);
  EXPECT_GT(scene(0.0), 1.0);
}

TEST(LightEstimate, BadInput)
{
  const UniformSky sky(1.0);
  const PolygonSource light = squareLight(0.5, 2.0, 1.0);
  double e[3] = { -1, -1, -1 };
  const double positions[9] = { 0, 0, 0, nan, 0, 0, 0, 0, 1e301 };
  const double normals[9] = { nan, 0, 0, 0, 0, 1, 0, 0, 1 };
  Receivers receivers;
  receivers.size = 3;
  receivers.positions = positions;
  receivers.normals = normals;
  EstimateOutputs out;
  out.irradiance = e;
  const EstimateReport report = estimateLight(receivers, { &sky, &light }, out);
  EXPECT_EQ(report.invalidReceivers, 3u);
  EXPECT_TRUE(std::isnan(e[0]) && std::isnan(e[1]) && std::isnan(e[2]));
  EXPECT_TRUE(estimateLight(Receivers{}, {}, {}).completed);
  const auto refuses = [&](const std::function<void(EstimateOptions&)>& spoil)
  {
    EstimateOptions options;
    spoil(options);
    EXPECT_THROW(estimateLight(receivers, { &sky }, out, options), std::invalid_argument);
  };
  refuses([](EstimateOptions& o) { o.relativeTolerance = -1.0; });
  refuses([](EstimateOptions& o) { o.absoluteTolerance = nan; });
  refuses([](EstimateOptions& o) { o.maximumRays = 1; });
  refuses([](EstimateOptions& o) { o.axis = { 0, 0, 2 }; });
  out.perSource = { nullptr, nullptr };
  EXPECT_THROW(estimateLight(receivers, { &sky }, out), std::invalid_argument);
}

} // namespace
