// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Scenes.h"
#include "Radiometry/Constants.h"
#include "Radiometry/EmitterIntensity.h"
#include "Testing/Accel/TestHelpers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace
{

using namespace lumitree;
using lumitree::testing::surfaceOf;

using Triangles = std::vector<std::array<Vec3, 3>>;

void addQuad(Triangles& to, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  to.push_back({ a, b, c });
  to.push_back({ a, c, d });
}

std::vector<double> intensities(const Emitter& emitter, const std::vector<Vec3>& directions)
{
  std::vector<double> result;
  EXPECT_TRUE(emitterIntensity(emitter, directions, result).completed);
  return result;
}

TEST(EmitterIntensity, ASquareShinesByTheCosine)
{
  Triangles square;
  addQuad(square, { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 });
  const auto surface = surfaceOf<double>(square);
  const auto occluders = build(surface);
  Emitter emitter;
  emitter.surface = surface.get();
  emitter.occluders = occluders.get();
  emitter.radiance = 100.0;
  const std::vector<Vec3> directions = { { 0, 0, 1 }, { 0, 0.6, 0.8 }, { 0, 1, 0 }, { 0, 0, -5 } };
  EXPECT_NEAR(intensities(emitter, directions)[0], 100.0, 1e-11);
  EXPECT_NEAR(intensities(emitter, directions)[1], 80.0, 1e-11);
  EXPECT_EQ(intensities(emitter, directions)[2], 0.0);
  EXPECT_EQ(intensities(emitter, directions)[3], 0.0);
  emitter.twoSided = true;
  emitter.metresPerUnit = 0.1;
  EXPECT_NEAR(intensities(emitter, directions)[3], 1.0, 1e-13);
  std::vector<double> out;
  EXPECT_NEAR(emitterIntensity(emitter, directions, out).flux, 2.0 * pi, 1e-12); // S7, two sides
}

TEST(EmitterIntensity, AConvexBodyHidesNothingAndASphereIsTheSameAllAround)
{
  const auto surface = surfaceOf<double>(data::sphere(6));
  const auto occluders = build(surface);
  Emitter emitter;
  emitter.surface = surface.get();
  emitter.occluders = occluders.get();
  std::vector<double> out;
  const EmitterReport report =
    emitterIntensity(emitter, { { 0, 0, 1 }, { 1, 2, 3 }, { -1, 0.3, -0.7 } }, out);
  EXPECT_EQ(report.rays, 0u);
  for (const double i : out)
  {
    EXPECT_NEAR(i, report.flux / (4.0 * pi), 0.02 * i); // the polyhedron is not quite the sphere
  }
}

TEST(EmitterIntensity, AnAwningHidesWhatIsBehindIt)
{
  // A unit square that shines up, half of it under a roof one unit above.
  Triangles square;
  addQuad(square, { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 });
  const auto surface = surfaceOf<double>(square);
  Triangles all = square;
  addQuad(all, { 0, -9, 1 }, { 0.5, -9, 1 }, { 0.5, 9, 1 }, { 0, 9, 1 });
  const auto occluders = build(surfaceOf<double>(all));
  Emitter emitter;
  emitter.surface = surface.get();
  emitter.occluders = occluders.get();
  std::vector<double> out;
  std::vector<Vec3> directions;
  for (int i = -10; i <= 10; ++i)
  {
    directions.push_back({ 0.1 * i, 0.0, 1.0 }); // shifts the roof's shadow by −0.1 i
  }
  EXPECT_EQ(emitterIntensity(emitter, directions, out).rays, 0u);
  for (int i = -10; i <= 10; ++i)
  {
    const double from = std::clamp(-0.1 * i, 0.0, 1.0);
    const double to = std::clamp(0.5 - 0.1 * i, 0.0, 1.0);
    const double cosine = 1.0 / std::sqrt(1.0 + 0.01 * i * i);
    EXPECT_NEAR(out[i + 10], (1.0 - (to - from)) * cosine, 1e-10) << i;
  }
  // Rays say the same.
  emitter.mostClipped = 0;
  emitter.rays = 4096;
  std::vector<double> sampled;
  EXPECT_GT(emitterIntensity(emitter, directions, sampled).rays, 0u);
  for (std::size_t i = 0; i < out.size(); ++i)
  {
    EXPECT_NEAR(sampled[i], out[i], 5e-3);
  }
}

TEST(EmitterIntensity, SameBitsForAnyNumberOfThreads)
{
  const auto surface = surfaceOf<double>(data::torus(24, 12));
  const auto occluders = build(surface);
  Emitter emitter;
  emitter.surface = surface.get();
  emitter.occluders = occluders.get();
  emitter.mostClipped = 12;
  std::vector<Vec3> directions;
  for (int i = 0; i < 40; ++i)
  {
    directions.push_back({ std::cos(0.7 * i), std::sin(0.7 * i), 0.05 * (i - 20) });
  }
  emitter.threads = 1;
  const std::vector<double> one = intensities(emitter, directions);
  emitter.threads = 3;
  const std::vector<double> three = intensities(emitter, directions);
  EXPECT_EQ(std::memcmp(one.data(), three.data(), one.size() * sizeof(double)), 0);
}

TEST(EmitterIntensity, BadInput)
{
  const auto nothing = surfaceOf<double>(Triangles{});
  Emitter emitter;
  emitter.surface = nothing.get();
  std::vector<double> out;
  EXPECT_EQ(emitterIntensity(emitter, { { 0, 0, 1 } }, out).flux, 0.0);
  EXPECT_EQ(out, std::vector<double>{ 0.0 });
  EXPECT_THROW(emitterIntensity(emitter, { { 0, 0, 0 } }, out), std::invalid_argument);
  emitter.radiance = -1.0;
  EXPECT_THROW(emitterIntensity(emitter, {}, out), std::invalid_argument);
}

TEST(SurfaceSolidAngles, ClosedSurfacesAndVertices)
{
  const auto surface = surfaceOf<double>(data::sphere(4));
  const Vec3 vertex = surface->point(0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double positions[] = { 0.1, 0.2, 0.3, 3, 0, 0, vertex[0], vertex[1], vertex[2], nan, 0, 0 };
  double omega[4];
  EXPECT_TRUE(surfaceSolidAngles(*surface, positions, 4, omega));
  EXPECT_NEAR(omega[0], 4.0 * pi, 1e-12);
  EXPECT_NEAR(omega[1], 0.0, 1e-12);
  EXPECT_TRUE(std::isfinite(omega[2]));
  EXPECT_TRUE(std::isnan(omega[3]));
}

} // namespace
