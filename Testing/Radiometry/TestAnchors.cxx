// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Reference values, each computed twice with 30 digits: the closed form, and quadrature of the
// integral that defines the quantity.
#include "Radiometry/Constants.h"
#include "Radiometry/DirectionalSource.h"
#include "Radiometry/DiskSource.h"
#include "Radiometry/Integration/GaussLegendre.h"
#include "Radiometry/IsotropicPointSource.h"
#include "Radiometry/LightEstimate.h"
#include "Radiometry/SkySource.h"
#include "Radiometry/SolidAngle.h"
#include "Testing/Accel/TestHelpers.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace
{

using namespace lumitree;

constexpr double tolerance = 1e-13; // relative

void expectNear(double value, double reference)
{
  EXPECT_NEAR(value, reference, tolerance * std::fabs(reference));
}

/// Flux of a source at `from` of that intensity through the rectangle, outward or inward.
double fluxThrough(double intensity, const Vec3& from, const std::array<Vec3, 4>& corners)
{
  return intensity *
    std::fabs(solidAngle(from, corners[0], corners[1], corners[2]) +
      solidAngle(from, corners[0], corners[2], corners[3]));
}

TEST(Anchors, IntensityOfAnIsotropicPoint)
{
  const IsotropicPointSource source(1000.0, { 0.0, 0.0, 0.0 });
  expectNear(source.intensity({ 0.0, 0.0, -2.0 }).value(), 79.57747154594767);
  EXPECT_EQ(source.flux().value(), 1000.0);
}

TEST(Anchors, PointOverAPlane)
{
  const IsotropicPointSource source(1000.0, { 1.5, 0.0, 2.0 });
  expectNear(source.irradiance({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }), 10.1859163578813);
}

TEST(Anchors, ScalarIrradianceOfAPoint)
{
  const IsotropicPointSource source(1000.0, { 1.0, 2.0, 2.0 });
  expectNear(source.scalarIrradiance({ 0.0, 0.0, 0.0 }), 8.841941282883074);
}

TEST(Anchors, SunOnATiltedPlane)
{
  // Sun 30° high in the south (−y); the plane is tilted by 30° towards it.
  const double a = pi / 6.0;
  const DirectionalSource sun(1000.0, { 0.0, std::cos(a), -std::sin(a) });
  expectNear(
    sun.irradiance({ 3.0, 4.0, 5.0 }, { 0.0, -std::sin(a), std::cos(a) }), 866.0254037844386);
}

TEST(Anchors, FluxThroughACoaxialDisk)
{
  const IsotropicPointSource source(1000.0, { 0.0, 0.0, 0.0 });
  expectNear(
    source.intensity({ 0.0, 0.0, 1.0 }).value() * diskSolidAngle(3.0, 2.0), 222.6499018873854);
}

TEST(Anchors, FluxThroughARectangle)
{
  const IsotropicPointSource source(1000.0, { 0.0, 0.0, 0.0 });
  const std::array<Vec3, 4> rectangle = { { { -2.0, -1.5, 2.0 }, { 2.0, -1.5, 2.0 },
    { 2.0, 1.5, 2.0 }, { -2.0, 1.5, 2.0 } } };
  expectNear(fluxThrough(*source.intensity({ 0.0, 0.0, 1.0 }), { 0.0, 0.0, 0.0 }, rectangle),
    139.4671680567855);
}

TEST(Anchors, FluxThroughATriangle)
{
  const IsotropicPointSource source(1000.0, { 0.0, 0.0, 0.0 });
  const double omega =
    solidAngle({ 0.0, 0.0, 0.0 }, { 1.0, 0.0, 2.0 }, { 0.0, 1.0, 2.0 }, { -1.0, -1.0, 2.0 });
  expectNear(*source.intensity({ 0.0, 0.0, 1.0 }) * omega, 26.67575458393696);
}

TEST(Anchors, IntensityIntegratesToTheFlux)
{
  // The octants of the sphere, each seen as the triangle of its corners.
  const IsotropicPointSource source(1000.0, { 0.0, 0.0, 0.0 });
  double flux = 0.0;
  for (int octant = 0; octant < 8; ++octant)
  {
    const Vec3 x = { octant & 1 ? 1.0 : -1.0, 0.0, 0.0 };
    const Vec3 y = { 0.0, octant & 2 ? 1.0 : -1.0, 0.0 };
    const Vec3 z = { 0.0, 0.0, octant & 4 ? 1.0 : -1.0 };
    flux += *source.intensity(x + y + z) * std::fabs(solidAngle({ 0.0, 0.0, 0.0 }, x, y, z));
  }
  expectNear(flux, 1000.0);
}

TEST(Anchors, AClosedBoxCatchesAllFlux)
{
  const Vec3 from = { 0.3, -0.2, 0.5 };
  const double intensity = *IsotropicPointSource(1000.0, from).intensity({ 1.0, 0.0, 0.0 });
  // Faces x+, x−, y+, y−, z+, z−.
  const std::array<double, 6> references = { 209.147946259, 109.866163836, 119.132294714,
    182.637855263, 283.524161537, 95.6915783906 };
  double sum = 0.0;
  for (int face = 0; face < 6; ++face)
  {
    const int axis = face / 2;
    std::array<Vec3, 4> corners;
    for (int i = 0; i < 4; ++i)
    {
      corners[i][axis] = face % 2 == 0 ? 1.0 : -1.0;
      corners[i][(axis + 1) % 3] = i == 1 || i == 2 ? 1.0 : -1.0;
      corners[i][(axis + 2) % 3] = i >= 2 ? 1.0 : -1.0;
    }
    const double flux = fluxThrough(intensity, from, corners);
    EXPECT_NEAR(flux, references[face], 1e-11 * references[face]); // as many digits as it has
    sum += flux;
  }
  expectNear(sum, 1000.0);
}

TEST(Anchors, CylindricalIrradianceOfAPoint)
{
  const double angle = 50.0 * pi / 180.0;
  const IsotropicPointSource source(
    4.0 * pi * 100.0, { 3.0 * std::sin(angle), 0.0, 3.0 * std::cos(angle) });
  const Vec3 place = { 0.0, 0.0, 0.0 };
  double value = 0.0;
  Receivers receivers;
  receivers.size = 1;
  receivers.positions = place.data();
  EstimateOutputs outputs;
  outputs.cylindrical = &value;
  estimateLight(receivers, { &source }, outputs);
  expectNear(value, 2.709327994454747);
}

/// Irradiance of upward receivers under the uniform sky of radiance 1 between walls along y, far
/// enough to be endless.
double underSky(double x, const std::vector<std::pair<double, double>>& wallsAndHeights)
{
  std::vector<std::array<Vec3, 3>> walls;
  constexpr double far = 1e4;
  for (const auto& [at, height] : wallsAndHeights)
  {
    const Vec3 a = { at, -far, 0.0 };
    const Vec3 b = { at, far, 0.0 };
    const Vec3 up = { 0.0, 0.0, height };
    walls.push_back({ { a, b, b + up } });
    walls.push_back({ { a, b + up, a + up } });
  }
  const auto occluders = build(lumitree::testing::surfaceOf<double>(walls));
  const Vec3 place = { x, 0.0, 0.0 };
  const Vec3 normal = { 0.0, 0.0, 1.0 };
  double value = 0.0;
  Receivers receivers;
  receivers.size = 1;
  receivers.positions = place.data();
  receivers.normals = normal.data();
  EstimateOutputs outputs;
  outputs.irradiance = &value;
  EstimateOptions options;
  options.occluders = occluders.get();
  estimateLight(receivers, { std::make_unique<UniformSky>(1.0).get() }, outputs, options);
  return value;
}

TEST(Anchors, AWallAtThePointHidesHalfTheSky)
{
  EXPECT_NEAR(underSky(0.0, { { 1e-6, 1e4 } }), 1.570796326794897, 1e-8);
}

TEST(Anchors, MeanSkyViewOfACanyon)
{
  const double mean = integrate<16>(0.0, 1.0,
    [](double x) {
      return underSky(x, { { 0.0, 1.0 }, { 1.0, 1.0 } }) / pi;
    });
  EXPECT_NEAR(mean, 0.414213562373095, 1e-8);
}

TEST(Anchors, ACylinderSeesItself)
{
  // What its ends do not see of each other they see of it, and it of them.
  const DiskSource top(1.0, { 0.0, 0.0, 2.0 }, { 0.0, 0.0, -1.0 }, 1.0);
  const double between = integrate<24>(0.0, 1.0,
    [&](double r) {
      return 2.0 * r * top.irradiance({ r, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }) / pi;
    });
  EXPECT_NEAR(1.0 - 0.5 * (1.0 - between), 0.585786437626905, 1e-10);
}

TEST(SolidAngle, SignSaysWhichSideIsSeen)
{
  const Vec3 a = { 1.0, 0.0, 0.0 };
  const Vec3 b = { 0.0, 1.0, 0.0 };
  const Vec3 c = { 0.0, 0.0, 1.0 };
  expectNear(solidAngle({ 0.0, 0.0, 0.0 }, a, b, c), pi / 2.0);
  expectNear(solidAngle({ 0.0, 0.0, 0.0 }, a, c, b), -pi / 2.0);
  // Beside it, in its plane.
  EXPECT_NEAR(solidAngle({ 3.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, a, b), 0.0, 1e-15);
}

TEST(SolidAngle, SmallAndFarKeepTheirDigits)
{
  const Vec3 from = { 0.0, 0.0, 0.0 };
  const double h = 1e6;
  const double omega = solidAngle(from, { 0.0, 0.0, h }, { 1.0, 0.0, h }, { 0.0, 1.0, h });
  EXPECT_NEAR(omega / (0.5 / (h * h)), 1.0, 1e-6); // the determinant of far corners cancels
  EXPECT_NEAR(diskSolidAngle(1.0, 1e8) / (pi * 1e-16), 1.0, 1e-15);
}

} // namespace
