// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SourceChecks.h"

#include "Radiometry/Constants.h"
#include "Radiometry/CosineLobeSource.h"
#include "Radiometry/SpotSource.h"
#include "Radiometry/SunDiskSource.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

using namespace lumitree;
using sourcechecks::expectRelative;

const Vec3 origin = { 0.0, 0.0, 0.0 };
const Vec3 up = { 0.0, 0.0, 1.0 };
const Vec3 down = { 0.0, 0.0, -1.0 };
constexpr double degree = pi / 180.0;

TEST(CosineLobe, FluxAndIntensity)
{
  const double axial = CosineLobeSource::axialIntensityOf(1000.0, 20.0);
  expectRelative(axial, 3342.253804929802);
  const CosineLobeSource lobe(axial, 20.0, { 0.0, 0.0, 2.0 }, down);
  expectRelative(*lobe.flux(), 1000.0);
  expectRelative(lobe.irradiance(origin, up), axial / 4.0);
  EXPECT_EQ(*lobe.intensity(up), 0.0);
  EXPECT_EQ(*lobe.intensity({ 1.0, 0.0, 0.0 }), 0.0);
  expectRelative(
    CosineLobeSource(100.0, 20.0, origin, up).fluxWithin(15.0 * degree), 15.47285548634218);
  sourcechecks::expectFluxThroughSphere(lobe, { 0.0, 0.0, 2.0 }, 3.0, 1e-3);
}

TEST(CosineLobe, OfExponentOneIsASmallLambertianSurface)
{
  // Φ = π L A and I₀ = L A.
  expectRelative(*CosineLobeSource(25.0, 1.0, origin, up).flux(), 78.53981633974483);
  expectRelative(*CosineLobeSource(25.0, 1.0, origin, up).intensity({ 0.0, 3.0, 4.0 }), 20.0);
}

TEST(Spot, FluxAndFalloff)
{
  const SpotSource spot(1.0, 20.0 * degree, 30.0 * degree, origin, down);
  expectRelative(*spot.flux(), 0.6103548267347105);
  expectRelative(SpotSource::axialIntensityOf(*spot.flux(), 20.0 * degree, 30.0 * degree), 1.0);
  const auto at = [&](double angle) {
    return *spot.intensity({ std::sin(angle * degree), 0.0, -std::cos(angle * degree) });
  };
  EXPECT_EQ(at(0.0), 1.0);
  EXPECT_EQ(at(19.9), 1.0);
  EXPECT_EQ(at(30.1), 0.0);
  EXPECT_EQ(at(180.0), 0.0);
  const double middle =
    std::acos(0.5 * (std::cos(20.0 * degree) + std::cos(30.0 * degree))) / degree;
  expectRelative(at(middle), 0.5);
  sourcechecks::expectFluxThroughSphere(spot, origin, 1.0, 1e-3);
}

TEST(Spot, SharpEdgeAndNarrowCone)
{
  const double a = 30.0 * degree;
  expectRelative(SpotSource::axialIntensityOf(1000.0, a, a), 1187.948667789373);
  const SpotSource sharp(1.0, a, a, origin, up);
  EXPECT_EQ(*sharp.intensity({ std::sin(a - 1e-9), 0.0, std::cos(a - 1e-9) }), 1.0);
  EXPECT_EQ(*sharp.intensity({ std::sin(a + 1e-9), 0.0, std::cos(a + 1e-9) }), 0.0);
  const double narrow = 1e-6;
  expectRelative(
    *SpotSource(1.0, 0.0, narrow, origin, up).flux(), 0.5 * pi * narrow * narrow, 1e-9);
}

TEST(Spot, RefusesWhatIsNoSource)
{
  EXPECT_THROW(SpotSource(1.0, 0.5, 0.4, origin, up), std::invalid_argument);
  EXPECT_THROW(SpotSource(1.0, 0.0, 0.0, origin, up), std::invalid_argument);
  EXPECT_THROW(SpotSource(1.0, -0.1, 0.4, origin, up), std::invalid_argument);
  EXPECT_THROW(SpotSource(1.0, 0.1, 4.0, origin, up), std::invalid_argument);
  EXPECT_THROW(SpotSource(1.0, 0.1, 0.4, origin, origin), std::invalid_argument);
  EXPECT_THROW(SpotSource(std::nan(""), 0.1, 0.4, origin, up), std::invalid_argument);
  EXPECT_THROW(CosineLobeSource(1.0, -1.0, origin, up), std::invalid_argument);
  EXPECT_THROW(CosineLobeSource(-1.0, 1.0, origin, up), std::invalid_argument);
  EXPECT_THROW(CosineLobeSource(1.0, 1.0, origin, origin), std::invalid_argument);
}

TEST(SunDisk, GivesItsNormalIrradiance)
{
  const double diameter = sunDiameterInDegrees * degree;
  const SunDiskSource sun(1000.0, { 0.0, 0.0, -2.0 }, diameter);
  expectRelative(sun.irradiance(origin, up), 1000.0);
  expectRelative(sun.irradiance(origin, { 0.6, 0.0, 0.8 }), 800.0);
  expectRelative(sun.lightVector(origin)[2], 1000.0);
  expectRelative(sun.scalarIrradiance(origin), 1000.0, 1e-5); // 1 / cos² of half its radius
  EXPECT_TRUE(sun.extended());
  EXPECT_FALSE(sun.flux());
  EXPECT_EQ(sun.radiance(origin, up), sun.diskRadiance());
  EXPECT_EQ(sun.radiance(origin, { std::tan(0.51 * diameter), 0.0, 1.0 }), 0.0);
  // Half set: of the order of its radius, not nothing.
  const double alpha = 0.5 * diameter;
  expectRelative(
    sun.irradiance(origin, { 1.0, 0.0, 0.0 }), 1000.0 * 2.0 * alpha / (3.0 * pi), 1e-4);
  sourcechecks::expectSamplesMeanIrradiance(sun, origin, { 0.6, 0.0, 0.8 }, 1e-6);
}

TEST(SunDisk, RefusesWhatIsNoSun)
{
  EXPECT_THROW(SunDiskSource(-1.0, down, 0.01), std::invalid_argument);
  EXPECT_THROW(SunDiskSource(1.0, origin, 0.01), std::invalid_argument);
  EXPECT_THROW(SunDiskSource(1.0, down, 0.0), std::invalid_argument);
  EXPECT_THROW(SunDiskSource(1.0, down, 4.0), std::invalid_argument);
}

} // namespace
