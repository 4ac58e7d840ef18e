// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/DirectionalSource.h"
#include "Radiometry/IsotropicPointSource.h"
#include "Radiometry/Quantities.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace
{

using namespace lumitree;

const Vec3 origin = { 0.0, 0.0, 0.0 };
const Vec3 up = { 0.0, 0.0, 1.0 };
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Quantities, NamesAndUnits)
{
  EXPECT_EQ(arrayName(Quantity::Irradiance, LightSystem::Radiometric), "Irradiance [W/m^2]");
  EXPECT_EQ(arrayName(Quantity::Irradiance, LightSystem::Photometric), "Illuminance [lx]");
  EXPECT_EQ(
    arrayName(Quantity::ScalarIrradiance, LightSystem::Photometric), "ScalarIlluminance [lx]");
  EXPECT_EQ(arrayName(Quantity::Flux, LightSystem::Radiometric), "RadiantFlux [W]");
  EXPECT_EQ(arrayName(Quantity::Flux, LightSystem::Photometric), "LuminousFlux [lm]");
  EXPECT_EQ(
    arrayName(Quantity::NormalIrradiance, LightSystem::Radiometric), "NormalIrradiance [W/m^2]");
  EXPECT_EQ(arrayName(Quantity::Radiance, LightSystem::Photometric), "Luminance [cd/m^2]");
  EXPECT_EQ(name(LightSystem::Photometric), "photometric");
}

TEST(PointSource, BackFacingReceivesNothing)
{
  const IsotropicPointSource source(1000.0, { 0.0, 0.0, 2.0 });
  EXPECT_GT(source.irradiance(origin, up), 0.0);
  EXPECT_EQ(source.irradiance(origin, { 0.0, 0.0, -1.0 }), 0.0);
  EXPECT_EQ(source.irradiance(origin, { 1.0, 0.0, 0.0 }), 0.0); // edge on
}

TEST(PointSource, AtTheSourceNothingIsDefined)
{
  const IsotropicPointSource source(1000.0, { 1.0, 2.0, 3.0 });
  EXPECT_TRUE(std::isnan(source.irradiance({ 1.0, 2.0, 3.0 }, up)));
  EXPECT_TRUE(std::isnan(source.scalarIrradiance({ 1.0, 2.0, 3.0 })));
}

TEST(PointSource, MillimetresAreNotMetres)
{
  const IsotropicPointSource metres(1000.0, { 0.0, 0.0, 2.0 });
  const IsotropicPointSource millimetres(1000.0, { 0.0, 0.0, 2000.0 }, 1e-3);
  const double e = metres.irradiance(origin, up);
  EXPECT_NEAR(millimetres.irradiance(origin, up), e, 1e-14 * e);
  EXPECT_NEAR(millimetres.scalarIrradiance(origin), e, 1e-14 * e);
}

TEST(PointSource, DistancesOfAnySize)
{
  // r² and r³ would under- or overflow.
  for (const double r : { 1e-140, 1e-110, 1e110, 1e140 })
  {
    const IsotropicPointSource source(1.0, { 0.0, 0.6 * r, 0.8 * r });
    const double expected = source.intensity(up).value() / r / r;
    EXPECT_NEAR(source.scalarIrradiance(origin) / expected, 1.0, 1e-14) << r;
    EXPECT_NEAR(source.irradiance(origin, up) / (0.8 * expected), 1.0, 1e-14) << r;
  }
}

TEST(PointSource, SightlineEndsAtTheSource)
{
  const IsotropicPointSource source(1.0, { 1.0, 2.0, 3.0 });
  const Sightline way = source.sightline({ 0.5, 0.5, 0.5 });
  EXPECT_EQ(way.direction, (Vec3{ 0.5, 1.5, 2.5 }));
  EXPECT_FALSE(way.endless);
}

TEST(PointSource, RefusesWhatIsNoSource)
{
  EXPECT_THROW(IsotropicPointSource(-1.0, origin), std::invalid_argument);
  EXPECT_THROW(IsotropicPointSource(nan, origin), std::invalid_argument);
  EXPECT_THROW(IsotropicPointSource(infinity, origin), std::invalid_argument);
  EXPECT_THROW(IsotropicPointSource(1.0, { 0.0, nan, 0.0 }), std::invalid_argument);
  EXPECT_THROW(IsotropicPointSource(1.0, origin, 0.0), std::invalid_argument);
  EXPECT_NO_THROW(IsotropicPointSource(0.0, origin));
}

TEST(DirectionalSource, LengthOfTheDirectionDoesNotMatter)
{
  const double e = DirectionalSource(500.0, { 0.0, -3.0, -4.0 }).irradiance(origin, up);
  EXPECT_NEAR(e, 400.0, 1e-12);
  for (const double scale : { 1e-320, 1e-200, 1e200, 1e300 })
  {
    const DirectionalSource source(500.0, { 0.0, -3.0 * scale, -4.0 * scale });
    EXPECT_NEAR(source.irradiance(origin, up), e, scale < 1e-300 ? 0.1 : 1e-12) << scale;
  }
}

TEST(DirectionalSource, HasNoFiniteFluxAndNoIntensity)
{
  const DirectionalSource source(500.0, { 0.0, 0.0, -1.0 });
  EXPECT_FALSE(source.flux());
  EXPECT_FALSE(source.intensity(up));
  EXPECT_EQ(source.scalarIrradiance(origin), 500.0);
  EXPECT_EQ(source.irradiance(origin, { 0.0, 0.0, -1.0 }), 0.0);
  const Sightline way = source.sightline(origin);
  EXPECT_EQ(way.direction, up);
  EXPECT_TRUE(way.endless);
}

TEST(DirectionalSource, RefusesWhatIsNoSource)
{
  EXPECT_THROW(DirectionalSource(-1.0, up), std::invalid_argument);
  EXPECT_THROW(DirectionalSource(nan, up), std::invalid_argument);
  EXPECT_THROW(DirectionalSource(1.0, origin), std::invalid_argument);
  EXPECT_THROW(DirectionalSource(1.0, { nan, 0.0, 0.0 }), std::invalid_argument);
}

} // namespace
