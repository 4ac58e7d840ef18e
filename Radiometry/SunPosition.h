// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_SunPosition_h
#define Lumitree_Radiometry_SunPosition_h

#include "Accel/Vec3.h"
#include "Radiometry/Export.h"

namespace lumitree
{

/// A moment: the proleptic Gregorian calendar, and the time of a clock that is so many hours ahead
/// of universal time.
struct Moment
{
  int year = 2000;
  int month = 1;          ///< 1 … 12
  int day = 1;            ///< 1 … the month's last; more or less roll over
  double hour = 12.0;     ///< 0 … 24; more or less roll over
  double utcOffset = 0.0; ///< hours, east positive
};

/// A place on the earth, and its air.
struct Site
{
  double latitude = 0.0;     ///< degrees, north positive, −90 … 90
  double longitude = 0.0;    ///< degrees, east positive
  double pressure = 1013.25; ///< mean over the year, hPa; 0: no refraction
  double temperature = 12.0; ///< mean over the year, °C
};

/// Where the sun's middle is seen.
struct SunPosition
{
  double zenith =
    0.0; ///< apparent, with refraction while it is up: degrees from the zenith, 0 … 180
  double azimuth = 0.0;    ///< degrees from north over east, 0 … 360
  double trueZenith = 0.0; ///< without refraction
  double distance = 1.0;   ///< of the earth from the sun, astronomical units
};

/// Within 0.01° in 1800 … 2200: Meeus, "Astronomical Algorithms", chapter 25, whose own accuracy that
/// is, with the terms of Venus, Jupiter and the moon of his "Astronomical Formulae for Calculators",
/// chapter 18, which take it further (0.0003° from NREL's SPA at that one's worked example); nutation
/// and sidereal time as there; parallax; refraction as the SPA has it (Reda & Andreas, Solar Energy
/// 76, 2004, eq. 42). Throws std::invalid_argument for a month that is none, values that are not
/// finite, and a latitude or a year (−2000 … 6000) out of range.
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT SunPosition sunPosition(
  const Moment& moment, const Site& site);

/// Unit vector to a sun at that place of the sky: north and up are directions of any length but 0,
/// north is taken at right angles to up. Throws std::invalid_argument where they make no frame.
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT Vec3 towardsSun(
  const SunPosition& sun, const Vec3& north, const Vec3& up);

/// Irradiance beyond the atmosphere on a plane that faces the sun [W/m²]: 1361.1 W/m² (Gueymard,
/// Solar Energy 168, 2018) at one astronomical unit.
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT double extraterrestrialIrradiance(const SunPosition& sun);

} // namespace lumitree

#endif
