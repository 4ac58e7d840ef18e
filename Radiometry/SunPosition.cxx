// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/SunPosition.h"

#include "Radiometry/Checks.h"
#include "Radiometry/Constants.h"

#include <algorithm>
#include <cmath>

namespace lumitree
{

namespace
{

constexpr double degree = pi / 180.0;

double sine(double degrees)
{
  return std::sin(degrees * degree);
}

double cosine(double degrees)
{
  return std::cos(degrees * degree);
}

double turn(double degrees)
{
  return degrees - 360.0 * std::floor(degrees / 360.0);
}

/// Meeus (7.1), for universal time.
double julianDay(const Moment& moment)
{
  int year = moment.year;
  int month = moment.month;
  if (month <= 2)
  {
    --year;
    month += 12;
  }
  const double century = std::floor(year / 100.0);
  const double gregorian = 2.0 - century + std::floor(century / 4.0);
  return std::floor(365.25 * (year + 4716)) + std::floor(30.6001 * (month + 1)) + moment.day +
    gregorian - 1524.5 + (moment.hour - moment.utcOffset) / 24.0;
}

/// Terrestrial less universal time [s]; a second of it moves the sun by 0.00001°.
double deltaT(double year)
{
  if (year < 1950.0 || year > 2050.0)
  {
    const double u = (year - 1820.0) / 100.0;
    return -20.0 + 32.0 * u * u;
  }
  const double t = year - 2000.0;
  return t < 5.0 ? 63.9 + t * (0.58 + t * 0.003) : 62.92 + t * (0.32217 + t * 0.005589);
}

/// Degrees by which the air lifts the sun (SPA, eq. 42).
double refraction(double elevation, const Site& site)
{
  constexpr double lowest = -0.26667 - 0.5667;
  return site.pressure > 0.0 && elevation >= lowest
    ? site.pressure / 1010.0 * 283.0 / (273.0 + site.temperature) * 1.02 /
      (60.0 * std::tan((elevation + 10.3 / (elevation + 5.11)) * degree))
    : 0.0;
}

void check(const Moment& moment, const Site& site)
{
  if (moment.month < 1 || moment.month > 12 || moment.year < -2000 || moment.year > 6000 ||
    moment.day < -1000 || moment.day > 1000)
  {
    throw std::invalid_argument("This is no date: " + std::to_string(moment.year) + "-" +
      std::to_string(moment.month) + "-" + std::to_string(moment.day) + ".");
  }
  if (!std::isfinite(moment.hour) || !std::isfinite(moment.utcOffset) ||
    !std::isfinite(site.longitude) || !std::isfinite(site.temperature))
  {
    throw std::invalid_argument("Time, longitude and temperature must be finite.");
  }
  if (!(std::fabs(site.latitude) <= 90.0))
  {
    throw std::invalid_argument("The latitude must be from -90 to 90 degrees.");
  }
  if (!(site.temperature > -273.0))
  {
    throw std::invalid_argument("The temperature must be above -273 degrees.");
  }
  checks::notNegative(site.pressure, "The pressure of the air");
}

} // namespace

SunPosition sunPosition(const Moment& moment, const Site& site)
{
  check(moment, site);
  const double universal = julianDay(moment);
  const double year = 2000.0 + (universal - 2451545.0) / 365.25;
  const double terrestrial = universal + deltaT(year) / 86400.0;
  const double t = (terrestrial - 2451545.0) / 36525.0;

  // Geometric longitude and distance.
  const double meanLongitude = 280.46646 + t * (36000.76983 + t * 0.0003032);
  const double anomaly = 357.52911 + t * (35999.05029 - t * 0.0001537);
  const double eccentricity = 0.016708634 - t * (0.000042037 + t * 0.0000001267);
  const double centre = (1.914602 - t * (0.004817 + t * 0.000014)) * sine(anomaly) +
    (0.019993 - t * 0.000101) * sine(2.0 * anomaly) + 0.000289 * sine(3.0 * anomaly);

  // The pull of Venus, Jupiter and the moon; centuries from 1900.
  const double u = (terrestrial - 2415020.0) / 36525.0;
  const double pulled = 0.00134 * cosine(153.23 + 22518.7541 * u) +
    0.00154 * cosine(216.57 + 45037.5082 * u) + 0.00200 * cosine(312.69 + 32964.3577 * u) +
    0.00179 * sine(350.74 + 445267.1142 * u - 0.00144 * u * u) + 0.00178 * sine(231.19 + 20.20 * u);

  SunPosition result;
  result.distance = 1.000001018 * (1.0 - eccentricity * eccentricity) /
    (1.0 + eccentricity * cosine(anomaly + centre));

  // Nutation and aberration.
  const double node = 125.04452 - t * 1934.136261;
  const double moon = 218.3165 + t * 481267.8813;
  const double nutation = (-17.20 * sine(node) - 1.32 * sine(2.0 * meanLongitude) -
                            0.23 * sine(2.0 * moon) + 0.21 * sine(2.0 * node)) /
    3600.0;
  const double obliquity = 23.4392911 - t * (0.0130042 + t * (1.64e-7 - t * 5.036e-7)) +
    (9.20 * cosine(node) + 0.57 * cosine(2.0 * meanLongitude) + 0.10 * cosine(2.0 * moon) -
      0.09 * cosine(2.0 * node)) /
      3600.0;
  const double longitude =
    meanLongitude + centre + pulled + nutation - 20.4898 / 3600.0 / result.distance;

  const double ascension =
    std::atan2(cosine(obliquity) * sine(longitude), cosine(longitude)) / degree;
  const double declination = std::asin(sine(obliquity) * sine(longitude));

  // Sidereal time at Greenwich (Meeus 12.4), of universal time.
  const double days = universal - 2451545.0;
  const double s = days / 36525.0;
  const double sidereal = 280.46061837 + 360.98564736629 * days +
    s * s * (0.000387933 - s / 38710000.0) + nutation * cosine(obliquity);
  const double hourAngle = (turn(sidereal) + site.longitude - ascension) * degree;

  const double latitude = site.latitude * degree;
  const double elevation = std::asin(std::clamp(std::sin(latitude) * std::sin(declination) +
                               std::cos(latitude) * std::cos(declination) * std::cos(hourAngle),
                             -1.0, 1.0)) /
    degree;
  result.azimuth = turn(180.0 +
    std::atan2(std::sin(hourAngle),
      std::cos(hourAngle) * std::sin(latitude) - std::tan(declination) * std::cos(latitude)) /
      degree);

  const double parallax = 8.794 / 3600.0 / result.distance * cosine(elevation);
  result.trueZenith = 90.0 - elevation + parallax;
  result.zenith = result.trueZenith - refraction(elevation - parallax, site);
  return result;
}

Vec3 towardsSun(const SunPosition& sun, const Vec3& north, const Vec3& up)
{
  const Vec3 zenith = checks::unit(up, "The direction to the zenith");
  const Vec3 given = checks::unit(north, "The direction to the north");
  const Vec3 level = given - dot(given, zenith) * zenith;
  if (length(level) < 1e-6)
  {
    throw std::invalid_argument("North must not be the direction to the zenith.");
  }
  const Vec3 ahead = checks::unit(level, "The direction to the north");
  const Vec3 east = cross(ahead, zenith);
  return cosine(sun.zenith) * zenith +
    sine(sun.zenith) * (cosine(sun.azimuth) * ahead + sine(sun.azimuth) * east);
}

double extraterrestrialIrradiance(const SunPosition& sun)
{
  return 1361.1 / (sun.distance * sun.distance);
}

} // namespace lumitree
