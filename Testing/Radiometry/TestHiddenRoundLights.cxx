// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Spheres, disks, the sun, lines and tubes with something before them, against closed forms of what
// is left.
#include "Data/Scenes.h"
#include "Radiometry/Constants.h"
#include "Radiometry/DiskSource.h"
#include "Radiometry/LambertPolygon.h"
#include "Radiometry/LightEstimate.h"
#include "Radiometry/LineSource.h"
#include "Radiometry/SphereSource.h"
#include "Radiometry/SunDiskSource.h"
#include "Radiometry/TubeSource.h"
#include "Testing/Accel/TestHelpers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{

using namespace lumitree;
using lumitree::testing::surfaceOf;

using Triangles = std::vector<std::array<Vec3, 3>>;
const Vec3 up = { 0.0, 0.0, 1.0 };

void addQuad(Triangles& to, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  to.push_back({ a, b, c });
  to.push_back({ a, c, d });
}

struct Result
{
  double value = 0.0, lower = 0.0, upper = 0.0, scalar = 0.0;
  Vec3 vector{};
  EstimateMethod method = EstimateMethod::None;
};

Result at(const Source& source, const Accelerator& occluders, const Vec3& position,
  const Vec3& normal = up, EstimateOptions options = {})
{
  Receivers receivers;
  receivers.size = 1;
  receivers.positions = position.data();
  receivers.normals = normal.data();
  options.occluders = &occluders;
  Result r;
  EstimateOutputs out;
  out.irradiance = &r.value;
  out.lower = &r.lower;
  out.upper = &r.upper;
  out.scalar = &r.scalar;
  out.vector = r.vector.data();
  out.method = &r.method;
  estimateLight(receivers, { &source }, out, options);
  return r;
}

/// A half-plane before a sun in the zenith whose edge is that many of its radii off its middle.
std::shared_ptr<const Accelerator> halfPlane(double offset, double angularRadius)
{
  const double x = offset * std::tan(angularRadius);
  Triangles plane;
  addQuad(plane, { x, -8, 1 }, { x, 8, 1 }, { -8, 8, 1 }, { -8, -8, 1 });
  return build(surfaceOf<double>(plane));
}

TEST(HiddenRoundLights, AnchorN2SunBehindAStraightEdge)
{
  // In the limit of a small sun: a segment of a circle.
  for (const double u : { 0.4, -0.4, 0.0, 0.9, -0.99 })
  {
    const double expected = (std::acos(u) - u * std::sqrt(1.0 - u * u)) / pi;
    for (const double angle : { 1e-4, 2e-5, 1e-7 })
    {
      const SunDiskSource sun(1000.0, { 0, 0, -1 }, 2.0 * angle);
      const Result r = at(sun, *halfPlane(u, angle), { 0, 0, 0 });
      EXPECT_NEAR(r.value, 1000.0 * expected, 1e-8 * 1000.0) << u << " " << angle;
      EXPECT_EQ(r.method, EstimateMethod::Clipping);
    }
  }
  const SunDiskSource small(1.0, { 0, 0, -1 }, 2e-5);
  EXPECT_NEAR(at(small, *halfPlane(0.4, 1e-5), { 0, 0, 0 }).value, 0.2523157877343455, 1e-8);
  // The sun itself: what is left of its disk, projected along its axis, between the arc of the
  // edge and the rim.
  const double angle = 0.5 * sunDiameterInDegrees * pi / 180.0;
  const double sine = std::sin(angle);
  const double tangent = 0.4 * std::tan(angle);
  constexpr int steps = 4000;
  double area = 0.0;
  const double widest = std::acos(0.4);
  for (int i = 0; i < steps; ++i)
  {
    // y = sine cosψ, midpoints: the integrand is smooth and vanishes at both ends.
    const double psi = 0.5 * pi + widest * (2.0 * (i + 0.5) / steps - 1.0);
    const double y = sine * std::cos(psi);
    const double left = tangent * std::sqrt((1.0 - y * y) / (1.0 + tangent * tangent));
    area +=
      std::max(0.0, sine * std::sin(psi) - left) * sine * std::sin(psi) * 2.0 * widest / steps;
  }
  const SunDiskSource sun(1.0, { 0, 0, -1 }, 2.0 * angle);
  EXPECT_NEAR(at(sun, *halfPlane(0.4, angle), { 0, 0, 0 }).value, area / (pi * sine * sine), 1e-6);
}

TEST(HiddenRoundLights, LessByTheLightOfAPolygonBeforeThem)
{
  const std::vector<Vec3> hides = { { -0.15, -0.1, 1 }, { 0.2, -0.12, 1.1 }, { 0.02, 0.2, 0.9 } };
  const auto occluders = build(surfaceOf<double>({ { hides[0], hides[1], hides[2] } }));
  const SphereSource ball(10.0, { 0.1, 0.05, 4.0 }, 1.8);
  const DiskSource disk(10.0, { 0.2, -0.1, 3.0 }, { 0.3, 0.1, -1 }, 1.6);
  const SunDiskSource sun(10.0, { 0, 0.1, -1 }, 1.2);
  const double radiances[] = { 10.0, 10.0, sun.diskRadiance() };
  const Source* const sources[] = { &ball, &disk, &sun };
  for (int k = 0; k < 3; ++k)
  {
    for (const Vec3& n : { up, Vec3{ 0.6, 0, 0.8 }, Vec3{ 0, -0.8, 0.6 }, Vec3{ 1, 0, 0 } })
    {
      for (const Vec3& p : { Vec3{ 0, 0, 0 }, Vec3{ 0.1, -0.05, 0.2 } })
      {
        std::vector<Vec3> ways;
        for (const Vec3& corner : hides)
        {
          ways.push_back(corner - p);
        }
        const double l = radiances[k];
        const Result r = at(*sources[k], *occluders, p, n);
        const double full = sources[k]->irradiance(p, n);
        EXPECT_NEAR(r.value, full - l * polygonIrradiance(ways.data(), 3, n), 2e-10 * l) << k;
        EXPECT_EQ(r.method, EstimateMethod::Clipping);
        EXPECT_NEAR(r.scalar,
          sources[k]->scalarIrradiance(p) - l * polygonSolidAngle(ways.data(), 3), 2e-10 * l);
        const Vec3 expected = sources[k]->lightVector(p) - l * polygonLightVector(ways.data(), 3);
        EXPECT_NEAR(length(r.vector - expected), 0.0, 2e-10 * l);
      }
    }
  }
}

TEST(HiddenRoundLights, HalvesAreHalves)
{
  Triangles half;
  addQuad(half, { 0, -9, 0.5 }, { 9, -9, 0.5 }, { 9, 9, 0.5 }, { 0, 9, 0.5 });
  const auto occluders = build(surfaceOf<double>(half));
  for (const double size : { 0.4, 1e-3, 1e-6, 1e-9 })
  {
    const SphereSource ball(10.0, { 0, 0, 2 }, size);
    const DiskSource disk(10.0, { 0, 0, 2 }, { 0, 0, -1 }, size);
    for (const Source* source :
      { static_cast<const Source*>(&ball), static_cast<const Source*>(&disk) })
    {
      const double full = source->irradiance({ 0, 0, 0 }, up);
      const Result r = at(*source, *occluders, { 0, 0, 0 });
      EXPECT_NEAR(r.value, 0.5 * full, 1e-9 * full) << size;
      EXPECT_EQ(r.method, EstimateMethod::Clipping);
    }
  }
}

TEST(HiddenRoundLights, CutAndSampledAgree)
{
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  Triangles triangles;
  for (int i = 0; i < 60; ++i)
  {
    const Vec3 middle = { 1.5 * any(random), 1.5 * any(random), 1.5 + 0.5 * any(random) };
    std::array<Vec3, 3> triangle;
    for (Vec3& corner : triangle)
    {
      corner = middle + 0.3 * Vec3{ any(random), any(random), any(random) };
    }
    triangles.push_back(triangle);
  }
  const auto occluders = build(surfaceOf<double>(triangles));
  const SphereSource ball(10.0, { 0, 0, 4 }, 1.0);
  const DiskSource disk(10.0, { 0, 0, 3 }, { 0.1, 0.2, -1 }, 1.0, true);
  const SunDiskSource sun(10.0, { 0.1, 0, -1 }, 0.5);
  int inside = 0;
  int all = 0;
  for (const Source* source : { static_cast<const Source*>(&ball),
         static_cast<const Source*>(&disk), static_cast<const Source*>(&sun) })
  {
    for (int i = 0; i < 12; ++i)
    {
      const Vec3 p = { any(random), any(random), 0.0 };
      EstimateOptions rays;
      rays.mostClipped = 0;
      rays.relativeTolerance = 2e-3;
      rays.maximumRays = 1u << 18;
      rays.seed = 77 + i;
      const Result exact = at(*source, *occluders, p);
      const Result sampled = at(*source, *occluders, p, up, rays);
      EXPECT_EQ(exact.method, EstimateMethod::Clipping);
      EXPECT_NEAR(sampled.value, exact.value, 0.02 * source->irradiance(p, up));
      EXPECT_NEAR(sampled.scalar, exact.scalar, 0.02 * source->scalarIrradiance(p));
      ++all;
      inside += exact.value >= sampled.lower && exact.value <= sampled.upper ? 1 : 0;
    }
  }
  EXPECT_GE(inside, all * 8 / 10);
}

TEST(HiddenRoundLights, LinesAndTubesWithoutOneHalf)
{
  Triangles half;
  addQuad(half, { 0, -9, 0.5 }, { 9, -9, 0.5 }, { 9, 9, 0.5 }, { 0, 9, 0.5 });
  const auto occluders = build(surfaceOf<double>(half));
  using Distribution = LineSource::Distribution;
  const Vec3 begin = { -1, 0.2, 2 };
  const LineSource lambertian(10.0, begin, { 1.5, 0.2, 2 });
  const LineSource lambertianHalf(10.0, begin, { 0, 0.2, 2 });
  const LineSource even(10.0, begin, { 1.5, 0.2, 2 }, Distribution::Isotropic);
  const LineSource evenHalf(10.0, begin, { 0, 0.2, 2 }, Distribution::Isotropic);
  const TubeSource tube(10.0, begin, { 1.5, 0.2, 2 }, 0.3);
  const TubeSource tubeHalf(10.0, begin, { 0, 0.2, 2 }, 0.3);
  const std::pair<const Source*, const Source*> pairs[] = { { &lambertian, &lambertianHalf },
    { &even, &evenHalf }, { &tube, &tubeHalf } };
  for (const auto& [whole, left] : pairs)
  {
    for (const Vec3& n : { up, Vec3{ 0, 0.6, 0.8 }, Vec3{ -0.8, 0, 0.6 }, Vec3{ -1, 0, 0 } })
    {
      const Vec3 p = { 0, 0.1, 0 };
      const Result r = at(*whole, *occluders, p, n);
      const double expected = left->irradiance(p, n);
      EXPECT_NEAR(r.value, expected, 1e-9 * (1.0 + expected));
      EXPECT_LE(r.method, EstimateMethod::Clipping);
      EXPECT_NEAR(r.scalar, left->scalarIrradiance(p), 1e-9 * r.scalar);
      EXPECT_NEAR(length(r.vector - left->lightVector(p)), 0.0, 1e-9 * r.scalar);
    }
  }
}

TEST(HiddenRoundLights, TubesAndLinesBehindTriangles)
{
  const std::vector<Vec3> hides = { { -0.15, -0.02, 1 }, { 0.2, -0.04, 1.1 }, { 0.02, 0.1, 0.9 } };
  Triangles one = { { { hides[0], hides[1], hides[2] } } };
  const auto small = build(surfaceOf<double>(one));
  const TubeSource tube(10.0, { -1, 0.1, 2 }, { 1, -0.1, 2.2 }, 0.4);
  std::vector<Vec3> ways(hides);
  for (const Vec3& n : { up, Vec3{ 0.6, 0, 0.8 }, Vec3{ 0, -0.8, 0.6 } })
  {
    const Result r = at(tube, *small, { 0, 0, 0 }, n);
    const double expected =
      tube.irradiance({ 0, 0, 0 }, n) - 10.0 * polygonIrradiance(ways.data(), 3, n);
    EXPECT_NEAR(r.value, expected, 1e-8 * expected);
    EXPECT_EQ(r.method, EstimateMethod::Clipping);
  }
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int i = 0; i < 12; ++i)
  {
    const Vec3 middle = { any(random), 0.3 * any(random), 1.0 + 0.5 * any(random) };
    one.push_back({ { middle + 0.3 * Vec3{ any(random), any(random), any(random) },
      middle + 0.3 * Vec3{ any(random), any(random), any(random) },
      middle + 0.3 * Vec3{ any(random), any(random), any(random) } } });
  }
  const auto some = build(surfaceOf<double>(one));
  const LineSource line(10.0, { -1, 0.1, 2 }, { 1, -0.1, 2.2 });
  for (const Source* source :
    { static_cast<const Source*>(&tube), static_cast<const Source*>(&line) })
  {
    for (int i = 0; i < 8; ++i)
    {
      const Vec3 p = { any(random), any(random), 0.0 };
      EstimateOptions rays;
      rays.mostClipped = 0;
      rays.relativeTolerance = 1e-3;
      rays.maximumRays = 1u << 18;
      const Result exact = at(*source, *some, p);
      const Result sampled = at(*source, *some, p, up, rays);
      EXPECT_EQ(exact.method, EstimateMethod::Clipping);
      EXPECT_NEAR(sampled.value, exact.value, 0.01 * source->irradiance(p, up));
      EXPECT_NEAR(sampled.scalar, exact.scalar, 0.01 * source->scalarIrradiance(p));
    }
  }
}

TEST(HiddenRoundLights, WhatIsInTheLightDoesNotHideIt)
{
  const SphereSource ball(10.0, { 0, 0, 3 }, 1.0);
  const auto within = build(surfaceOf<double>(data::sphere(2), { 0, 0, 3 }));
  const Result lit = at(ball, *within, { 0.3, 0, 0 });
  EXPECT_NEAR(lit.value, ball.irradiance({ 0.3, 0, 0 }, up), 1e-9);
  Triangles through;
  addQuad(through, { -5, -5, 3 }, { 5, -5, 3 }, { 5, 5, 3 }, { -5, 5, 3 });
  const auto ceiling = build(surfaceOf<double>(through));
  const Result half = at(ball, *ceiling, { 0, 0, 0 });
  EXPECT_NEAR(half.value, ball.irradiance({ 0, 0, 0 }, up), 1e-9)
    << "the lower half is all one sees";
  const Result oblique = at(ball, *ceiling, { 4, 0, 0 });
  EXPECT_EQ(oblique.method, EstimateMethod::Sampling) << "its upper half is hidden";
  EXPECT_LT(oblique.value, 0.95 * ball.irradiance({ 4, 0, 0 }, up));
}

} // namespace
