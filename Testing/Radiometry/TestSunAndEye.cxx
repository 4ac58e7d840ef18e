// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SourceChecks.h"

#include "Radiometry/LuminousEfficacy.h"
#include "Radiometry/SunPosition.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace
{

using namespace lumitree;

TEST(SunPosition, AsTheSolarPositionAlgorithmHasIt)
{
  // The worked example of NREL's SPA: Golden, Colorado.
  const Moment moment = { 2003, 10, 17, 12.5 + 30.0 / 3600.0, -7.0 };
  const Site site = { 39.742476, -105.1786, 820.0, 11.0 };
  const SunPosition sun = sunPosition(moment, site);
  EXPECT_NEAR(sun.zenith, 50.11162202, 0.001);
  EXPECT_NEAR(sun.azimuth, 194.34024051, 0.001);
  EXPECT_NEAR(sun.trueZenith, 50.1279, 0.003);
  EXPECT_NEAR(sun.distance, 0.9965422974, 2e-5);
}

TEST(SunPosition, SeasonsAndPoles)
{
  // At the June solstice noon in Greenwich, from the tropic to the pole.
  const Moment noon = { 2024, 6, 20, 12.0, 0.0 };
  EXPECT_NEAR(sunPosition(noon, { 23.44, 0.0, 0.0, 12.0 }).zenith, 0.4, 0.2); // 2 minutes off
  EXPECT_NEAR(sunPosition(noon, { 90.0, 0.0, 0.0, 12.0 }).zenith, 90.0 - 23.44, 0.01);
  EXPECT_NEAR(sunPosition(noon, { -90.0, 0.0, 0.0, 12.0 }).zenith, 90.0 + 23.44, 0.01);
  EXPECT_NEAR(sunPosition(noon, { 50.0, 0.0, 0.0, 12.0 }).azimuth, 180.0, 1.5);
  EXPECT_NEAR(sunPosition(noon, { -50.0, 0.0, 0.0, 12.0 }).azimuth, 0.4, 0.4);
  // The clock of the place and universal time; a day that rolls over.
  const Site site = { 48.0, 11.0, 1013.25, 12.0 };
  const SunPosition a = sunPosition({ 2024, 3, 31, 1.0, 2.0 }, site);
  const SunPosition b = sunPosition({ 2024, 3, 30, 23.0, 0.0 }, site);
  EXPECT_NEAR(a.zenith, b.zenith, 1e-6);
  EXPECT_NEAR(a.azimuth, b.azimuth, 1e-6);
  // Air lifts a setting sun by about half a degree.
  for (int minute = 0; minute < 1440; ++minute)
  {
    const SunPosition sun = sunPosition({ 2024, 9, 1, minute / 60.0, 0.0 }, site);
    EXPECT_TRUE(std::isfinite(sun.zenith + sun.azimuth));
    const double lift = sun.trueZenith - sun.zenith;
    EXPECT_GE(lift, 0.0);
    EXPECT_LT(lift, 0.65);
  }
}

TEST(SunPosition, InAFrame)
{
  SunPosition sun;
  sun.zenith = 60.0;
  sun.azimuth = 90.0;
  const Vec3 east = towardsSun(sun, { 0.0, 2.0, 0.0 }, { 0.0, 0.0, 3.0 });
  EXPECT_NEAR(east[0], std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(east[2], 0.5, 1e-12);
  // North leans up: only its level part counts.
  const Vec3 same = towardsSun(sun, { 0.0, 2.0, 5.0 }, { 0.0, 0.0, 3.0 });
  EXPECT_NEAR(length(same - east), 0.0, 1e-12);
  EXPECT_THROW((void)towardsSun(sun, { 0.0, 0.0, 1.0 }, { 0.0, 0.0, 1.0 }), std::invalid_argument);
  EXPECT_NEAR(extraterrestrialIrradiance(sun), 1361.1, 1e-9);
}

TEST(SunPosition, RefusesWhatIsNoMomentOrPlace)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)sunPosition({ 2024, 13, 1, 0.0, 0.0 }, {}), std::invalid_argument);
  EXPECT_THROW((void)sunPosition({ 9999, 1, 1, 0.0, 0.0 }, {}), std::invalid_argument);
  EXPECT_THROW((void)sunPosition({ 2024, 1, 1, nan, 0.0 }, {}), std::invalid_argument);
  EXPECT_THROW((void)sunPosition({}, { 91.0, 0.0, 0.0, 0.0 }), std::invalid_argument);
  EXPECT_THROW((void)sunPosition({}, { 0.0, 0.0, -1.0, 0.0 }), std::invalid_argument);
}

TEST(LuminousEfficacy, OfOneColourAndOfWhite)
{
  EXPECT_EQ(luminousEfficiency(555.0), 1.0);
  EXPECT_EQ(luminousEfficiency(510.0), 0.503);
  EXPECT_EQ(luminousEfficiency(359.0), 0.0);
  EXPECT_EQ(luminousEfficiency(781.0), 0.0);
  EXPECT_EQ(luminousEfficiency(std::nan("")), 0.0);
  EXPECT_NEAR(luminousEfficacy({ { 554.99, 0.0 }, { 555.0, 1.0 }, { 555.01, 0.0 } }), 683.0, 0.01);
  // Equal energy from 360 to 780 nm: ∫ V dλ = 106.857 nm.
  const double white = luminousEfficacy({ { 360.0, 2.0 }, { 780.0, 2.0 } });
  EXPECT_NEAR(white, 683.0 * 106.857 / 420.0, 0.02);
  // Heat counts as radiation.
  EXPECT_NEAR(
    luminousEfficacy({ { 360.0, 2.0 }, { 780.0, 2.0 }, { 1200.0, 2.0 } }), 0.5 * white, 1e-9);
  EXPECT_EQ(luminousEfficacy({ { 1000.0, 1.0 }, { 2000.0, 1.0 } }), 0.0);
}

TEST(LuminousEfficacy, OfADaylightLikeBlackBody)
{
  // Planck's law at 6500 K, 100 nm to 20 µm; of a black body the best is about 95 lm/W near 6600 K.
  std::vector<SpectralValue> body;
  for (double nm = 100.0; nm < 20000.0; nm *= 1.002)
  {
    const double x = 14387768.775 / nm / 6500.0;
    body.push_back({ nm, 1e15 / std::pow(nm, 5.0) / std::expm1(x) });
  }
  EXPECT_NEAR(luminousEfficacy(body), 95.0, 1.0);
}

TEST(LuminousEfficacy, RefusesWhatIsNoSpectrum)
{
  EXPECT_THROW((void)luminousEfficacy({ { 500.0, 1.0 } }), std::invalid_argument);
  EXPECT_THROW((void)luminousEfficacy({ { 500.0, 1.0 }, { 500.0, 1.0 } }), std::invalid_argument);
  EXPECT_THROW((void)luminousEfficacy({ { 500.0, -1.0 }, { 600.0, 1.0 } }), std::invalid_argument);
  EXPECT_THROW((void)luminousEfficacy({ { 500.0, 0.0 }, { 600.0, 0.0 } }), std::invalid_argument);
  EXPECT_THROW(
    (void)luminousEfficacy({ { std::nan(""), 1.0 }, { 600.0, 1.0 } }), std::invalid_argument);
}

} // namespace
