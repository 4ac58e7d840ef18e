// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Reference values: the closed form and quadrature with 30 digits; horizontal irradiances of the
// CIE general skies by Gauss-Legendre rules of 300² and 450² points, which agree to 1e-14.
#include "SourceChecks.h"

#include "Radiometry/Constants.h"
#include "Radiometry/GeneralSky.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace
{

using namespace lumitree;
using sourcechecks::expectRelative;

const Vec3 origin = { 0.0, 0.0, 0.0 };
const Vec3 up = { 0.0, 0.0, 1.0 };
constexpr double degree = pi / 180.0;
constexpr SkyLevel unitZenith = { SkyLevel::Kind::ZenithRadiance, 1.0 };

Vec3 sunAt(double zenithDegrees)
{
  return { std::sin(zenithDegrees * degree), 0.0, std::cos(zenithDegrees * degree) };
}

TEST(OvercastSky, HorizontalVerticalAndTilted)
{
  const OvercastSky sky(unitZenith);
  const auto tilted = [&](double degrees) { return sky.irradiance(origin, sunAt(degrees)); };
  expectRelative(tilted(0.0), 2.443460952792061);
  expectRelative(tilted(90.0), 0.9680432200427433);
  expectRelative(tilted(90.0) / tilted(0.0), 0.396177077819309);
  expectRelative(tilted(36.0), 2.112117629610605);
  EXPECT_NEAR(tilted(180.0), 0.0, 1e-15);
  sourcechecks::expectSamplesMeanIrradiance(sky, origin, sunAt(36.0), 1e-3);
}

TEST(OvercastSky, AtTheBottomOfAWell)
{
  // Rings of the sky up to tan a = 1/2.
  const OvercastSky sky(unitZenith);
  constexpr int rings = 20000;
  const double limit = std::atan(0.5);
  double sum = 0.0;
  for (int i = 0; i < rings; ++i)
  {
    const double z = limit * (i + 0.5) / rings;
    sum += *sky.radiance(origin, { std::sin(z), 0.0, std::cos(z) }) * std::cos(z) * std::sin(z);
  }
  expectRelative(sum * 2.0 * pi * limit / rings, 0.6066181500867688, 1e-8);
}

TEST(GeneralSky, HorizontalIrradianceOfAllTypes)
{
  constexpr double references[15][3] = {
    { 2.4495408740, 2.4495408740, 2.4495408740 },
    { 2.0860232056, 2.3635213100, 2.5565793191 },
    { 2.7699878256, 2.7699878256, 2.7699878256 },
    { 2.3154191055, 2.6467338177, 2.8901470589 },
    { pi, pi, pi },
    { 2.5841604075, 2.9774578144, 3.2778254045 },
    { 2.4212252606, 3.1430926159, 3.6730455882 },
    { 2.3283799476, 3.3387461830, 4.1230765944 },
    { 3.4593233661, 4.0587013265, 4.5527532913 },
    { 3.1702604660, 4.2534223492, 5.1449109948 },
    { 2.9890607981, 4.4853601258, 5.8176314747 },
    { 3.1905727869, 4.8485240888, 6.3941058516 },
    { 3.0258530712, 4.9826690683, 6.9952153128 },
    { 3.2169567678, 5.3753156519, 7.7080971312 },
    { 3.0158562488, 5.2711242914, 8.1160234147 },
  };
  for (int type = 1; type <= 15; ++type)
  {
    for (int i = 0; i < 3; ++i)
    {
      const GeneralSky sky(cieSky(type), sunAt(30.0 + 15.0 * i), unitZenith);
      expectRelative(sky.irradiance(origin, up), references[type - 1][i], 1e-10);
      expectRelative(sky.lightVector(origin)[2], references[type - 1][i], 1e-10);
    }
  }
  expectRelative(
    GeneralSky(cieSky(12), sunAt(45.0), unitZenith).irradiance(origin, up), 4.848524088837507);
}

TEST(GeneralSky, TiltedPlanesAgainstSamplesAndTheLightVector)
{
  const GeneralSky sky(cieSky(13), { 0.5, 0.5, 0.3 }, unitZenith);
  for (const Vec3& normal :
    { sunAt(60.0), Vec3{ 0.0, 1.0, 0.0 }, Vec3{ -0.6, 0.0, 0.8 }, Vec3{ 0.48, 0.64, -0.6 } })
  {
    sourcechecks::expectSamplesMeanIrradiance(sky, origin, normal, 2e-3);
    expectRelative(sky.irradiance(origin, normal) - sky.irradiance(origin, -1.0 * normal),
      dot(sky.lightVector(origin), normal), 1e-9);
  }
}

TEST(GeneralSky, RadianceOfSamplesIsTheRadiance)
{
  for (int type = 0; type <= 15; ++type)
  {
    for (const double zenithAngle : { 0.0, 0.6, 1.5 })
    {
      const SkyDistribution distribution =
        type > 0 ? cieSky(type) : perezSky(skyCondition(600.0, 150.0, 0.6, 1361.0), 0.6);
      const GeneralSky sky(distribution, { std::sin(zenithAngle), 0.0, std::cos(zenithAngle) },
        SkyLevel{ SkyLevel::Kind::ZenithRadiance, 1.0 });
      double brightest = 0.0;
      double worst = 0.0;
      for (int i = 0; i < 4000; ++i)
      {
        const double z = i % 5 == 0 ? 1e-3 * (i % 50) : (i + 0.5) / 4000;
        const double r = std::sqrt(1.0 - z * z);
        const double azimuth = i % 7 == 0 ? 1e-3 * i : 2.39996 * i;
        const Vec3 w = { r * std::cos(azimuth), r * std::sin(azimuth), z };
        brightest = std::max(brightest, sky.radianceFrom(w));
        worst = std::max(worst, std::fabs(sky.radianceOfSample(w) - sky.radianceFrom(w)));
      }
      EXPECT_LE(worst, 1e-7 * brightest) << type << ' ' << zenithAngle;
    }
  }
}

TEST(GeneralSky, TypeFiveIsUniformAndTypeOneIsNotMoonAndSpencer)
{
  const GeneralSky uniform(cieSky(5), up, unitZenith);
  for (const double tilt : { 0.0, 36.0, 90.0, 140.0 })
  {
    expectRelative(
      uniform.irradiance(origin, sunAt(tilt)), 0.5 * pi * (1.0 + std::cos(tilt * degree)), 1e-10);
  }
  const double one = GeneralSky(cieSky(1), up, unitZenith).irradiance(origin, up);
  EXPECT_NEAR(one / OvercastSky(unitZenith).irradiance(origin, up) - 1.0, 0.0025, 1e-4);
}

TEST(GeneralSky, LevelsAndOrientation)
{
  const SkyLevel horizontal = { SkyLevel::Kind::HorizontalIrradiance, 10000.0 };
  const Vec3 north = { 0.0, 1.0, 0.0 };
  const GeneralSky sky(cieSky(12), { 0.4, 0.7, 0.2 }, horizontal, { 0.0, 2.0, 0.0 }, 3.0);
  expectRelative(sky.irradiance(origin, north), 10000.0);
  expectRelative(sky.irradiance(origin, -1.0 * north), 3.0 * pi);
  expectRelative(OvercastSky(horizontal).irradiance(origin, up), 10000.0);
  expectRelative(uniformRadiance(horizontal), 10000.0 / pi);
  EXPECT_EQ(sky.radiance(origin, { 0.0, -1.0, 0.2 }), 3.0);
  // The zenith radiance gives the same sky again.
  const GeneralSky again(
    cieSky(12), { 0.4, 0.7, 0.2 }, { SkyLevel::Kind::ZenithRadiance, sky.zenithRadiance() }, north);
  expectRelative(again.irradiance(origin, north), 10000.0);
}

TEST(GeneralSky, RefusesWhatIsNoSky)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)cieSky(0), std::invalid_argument);
  EXPECT_THROW((void)cieSky(16), std::invalid_argument);
  EXPECT_THROW(GeneralSky(cieSky(12), { 0.0, 0.5, -0.5 }, unitZenith), std::invalid_argument);
  EXPECT_NO_THROW(GeneralSky(cieSky(3), { 0.0, 0.5, -0.5 }, unitZenith));
  EXPECT_THROW(GeneralSky(cieSky(12), origin, unitZenith), std::invalid_argument);
  EXPECT_THROW(
    GeneralSky(cieSky(12), up, { SkyLevel::Kind::ZenithRadiance, -1.0 }), std::invalid_argument);
  EXPECT_THROW(OvercastSky({ SkyLevel::Kind::ZenithRadiance, nan }), std::invalid_argument);
  EXPECT_THROW((void)skyCondition(-1.0, 100.0, 0.5), std::invalid_argument);
  EXPECT_THROW((void)skyCondition(100.0, 0.0, 0.5), std::invalid_argument);
  EXPECT_THROW((void)skyCondition(100.0, 100.0, 1.6), std::invalid_argument);
}

TEST(PerezSky, GivesTheDiffuseIrradianceInAnyWeather)
{
  for (const double zenith : { 5.0, 30.0, 60.0, 85.0 })
  {
    for (const auto& [direct, diffuse] :
      { std::array{ 0.0, 150.0 }, std::array{ 20.0, 300.0 }, std::array{ 200.0, 250.0 },
        std::array{ 500.0, 200.0 }, std::array{ 900.0, 80.0 }, std::array{ 950.0, 20.0 } })
    {
      const SkyCondition condition = skyCondition(direct, diffuse, zenith * degree);
      EXPECT_GE(condition.clearness, 1.0);
      const GeneralSky sky(perezSky(condition, zenith * degree), sunAt(zenith),
        { SkyLevel::Kind::HorizontalIrradiance, diffuse });
      expectRelative(sky.irradiance(origin, up), diffuse, 1e-9);
      double darkest = 1.0;
      for (int i = 0; i < 1000; ++i)
      {
        const SourceSample s = sky.sample(origin, (i + 0.5) / 1000, std::fmod(i * 0.618034, 1.0));
        darkest = std::min(darkest, s.radiance);
      }
      EXPECT_GE(darkest, 0.0);
      EXPECT_TRUE(std::isfinite(sky.scalarIrradiance(origin)));
    }
  }
}

TEST(PerezSky, ClearSkiesShineAroundTheSunAndOvercastOnesAtTheZenith)
{
  const auto sky = [](double direct, double diffuse)
  { return perezSky(skyCondition(direct, diffuse, 60.0 * degree), 60.0 * degree); };
  const GeneralSky clear(
    sky(900.0, 80.0), sunAt(60.0), { SkyLevel::Kind::HorizontalIrradiance, 80.0 });
  EXPECT_GT(*clear.radiance(origin, sunAt(60.0)), 5.0 * *clear.radiance(origin, sunAt(-60.0)));
  const GeneralSky overcast(
    sky(0.0, 150.0), sunAt(60.0), { SkyLevel::Kind::HorizontalIrradiance, 150.0 });
  EXPECT_GT(*overcast.radiance(origin, up), *overcast.radiance(origin, sunAt(-80.0)));
  // Clearness and brightness by hand: ε = (980/80 + κ) / (1 + κ), κ = 1.041 Zs³.
  const SkyCondition c = skyCondition(900.0, 80.0, 60.0 * degree);
  const double kappa = 1.041 * std::pow(pi / 3.0, 3.0);
  expectRelative(c.clearness, (980.0 / 80.0 + kappa) / (1.0 + kappa));
  EXPECT_NEAR(c.brightness, 80.0 * 1.9928 / 1367.0, 1e-5); // air mass 1.9928 at 60°
}

} // namespace
