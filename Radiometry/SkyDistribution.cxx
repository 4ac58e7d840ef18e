// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/SkyDistribution.h"

#include "Radiometry/Checks.h"
#include "Radiometry/Constants.h"

#include <algorithm>
#include <cmath>

namespace lumitree
{

namespace
{

// ISO 15469:2004, table 1: a, b, c, d, e.
constexpr double cieParameters[15][5] = {
  { 4.0, -0.70, 0.0, -1.0, 0.0 },
  { 4.0, -0.70, 2.0, -1.5, 0.15 },
  { 1.1, -0.80, 0.0, -1.0, 0.0 },
  { 1.1, -0.80, 2.0, -1.5, 0.15 },
  { 0.0, -1.00, 0.0, -1.0, 0.0 },
  { 0.0, -1.00, 2.0, -1.5, 0.15 },
  { 0.0, -1.00, 5.0, -2.5, 0.30 },
  { 0.0, -1.00, 10.0, -3.0, 0.45 },
  { -1.0, -0.55, 2.0, -1.5, 0.15 },
  { -1.0, -0.55, 5.0, -2.5, 0.30 },
  { -1.0, -0.55, 10.0, -3.0, 0.45 },
  { -1.0, -0.32, 10.0, -3.0, 0.45 },
  { -1.0, -0.32, 16.0, -3.0, 0.30 },
  { -1.0, -0.15, 16.0, -3.0, 0.30 },
  { -1.0, -0.15, 24.0, -2.8, 0.15 },
};

// Perez, Seals & Michalsky (1993), table 1: for each bin of clearness x₁ … x₄ of a, b, c, d, e,
// with x = x₁ + x₂ Zs + Δ (x₃ + x₄ Zs).
constexpr double perezBins[8] = { 1.0, 1.065, 1.23, 1.5, 1.95, 2.8, 4.5, 6.2 };
constexpr double perezParameters[8][5][4] = {
  { { 1.3525, -0.2576, -0.2690, -1.4366 }, { -0.7670, 0.0007, 1.2734, -0.1233 },
    { 2.8000, 0.6004, 1.2375, 1.0000 }, { 1.8734, 0.6297, 0.9738, 0.2809 },
    { 0.0356, -0.1246, -0.5718, 0.9938 } },
  { { -1.2219, -0.7730, 1.4148, 1.1016 }, { -0.2054, 0.0367, -3.9128, 0.9156 },
    { 6.9750, 0.1774, 6.4477, -0.1239 }, { -1.5798, -0.5081, -1.7812, 0.1080 },
    { 0.2624, 0.0672, -0.2190, -0.4285 } },
  { { -1.1000, -0.2515, 0.8952, 0.0156 }, { 0.2782, -0.1812, -4.5000, 1.1766 },
    { 24.7219, -13.0812, -37.7000, 34.8438 }, { -5.0000, 1.5218, 3.9229, -2.6204 },
    { -0.0156, 0.1597, 0.4199, -0.5562 } },
  { { -0.5484, -0.6654, -0.2672, 0.7117 }, { 0.7234, -0.6219, -5.6812, 2.6297 },
    { 33.3389, -18.3000, -62.2500, 52.0781 }, { -3.5000, 0.0016, 1.1477, 0.1062 },
    { 0.4659, -0.3296, -0.0876, -0.0329 } },
  { { -0.6000, -0.3566, -2.5000, 2.3250 }, { 0.2937, 0.0496, -5.6812, 1.8415 },
    { 21.0000, -4.7656, -21.5906, 7.2492 }, { -3.5000, -0.1554, 1.4062, 0.3988 },
    { 0.0032, 0.0766, -0.0656, -0.1294 } },
  { { -1.0156, -0.3670, 1.0078, 1.4051 }, { 0.2875, -0.5328, -3.8500, 3.3750 },
    { 14.0000, -0.9999, -7.1406, 7.5469 }, { -3.4000, -0.1078, -1.0750, 1.5702 },
    { -0.0672, 0.4016, 0.3017, -0.4844 } },
  { { -1.0000, 0.0211, 0.5025, -0.5119 }, { -0.3000, 0.1922, 0.7023, -1.6317 },
    { 19.0000, -5.0000, 1.2438, -1.9094 }, { -4.0000, 0.0250, 0.3844, 0.2656 },
    { 1.0468, -0.3788, -2.4517, 1.4656 } },
  { { -1.0500, 0.0289, 0.4260, 0.3590 }, { -0.3250, 0.1156, 0.7781, 0.0025 },
    { 31.0625, -14.5000, -46.1148, 55.3750 }, { -7.2312, 0.4050, 13.3500, 0.6234 },
    { 1.5000, -0.6426, 1.8564, 0.5636 } },
};

} // namespace

double SkyDistribution::gradation(double cosineOfZ) const
{
  if (this->a == 0.0)
  {
    return 1.0;
  }
  // A b above 0, which the all-weather model has for a few skies, would have no end at the horizon.
  const double cosine = std::max(cosineOfZ, this->b > 0.0 ? 0.01 : 1e-300);
  return 1.0 + this->a * std::exp(this->b / cosine);
}

double SkyDistribution::indicatrix(double chi, double cosineOfChi) const
{
  return this->base + this->c * std::exp(this->d * chi) + this->e * cosineOfChi * cosineOfChi;
}

SkyDistribution cieSky(int type)
{
  if (type < 1 || type > 15)
  {
    throw std::invalid_argument(
      "A CIE general sky has a type from 1 to 15, not " + std::to_string(type) + ".");
  }
  const double* p = cieParameters[type - 1];
  SkyDistribution sky{ p[0], p[1], p[2], p[3], p[4], 1.0 };
  sky.base = 1.0 - sky.c * std::exp(0.5 * pi * sky.d);
  return sky;
}

SkyCondition skyCondition(
  double directNormal, double diffuseHorizontal, double sunZenith, double extraterrestrial)
{
  checks::notNegative(directNormal, "The direct normal irradiance");
  checks::positive(diffuseHorizontal, "The diffuse horizontal irradiance");
  checks::positive(extraterrestrial, "The extraterrestrial irradiance");
  if (!(sunZenith >= 0.0 && sunZenith < 0.5 * pi))
  {
    throw std::invalid_argument(
      "The all-weather sky needs the sun above the horizon (zenith angle below 90 degrees).");
  }
  const double cubic = 1.041 * sunZenith * sunZenith * sunZenith;
  // Air mass of Kasten (1966).
  const double degrees = sunZenith * 180.0 / pi;
  const double airMass = 1.0 / (std::cos(sunZenith) + 0.15 * std::pow(93.885 - degrees, -1.253));
  return { ((diffuseHorizontal + directNormal) / diffuseHorizontal + cubic) / (1.0 + cubic),
    diffuseHorizontal * airMass / extraterrestrial };
}

SkyDistribution perezSky(const SkyCondition& condition, double sunZenith)
{
  const double clearness = std::clamp(condition.clearness, 1.0, 12.01);
  double brightness = std::clamp(condition.brightness, 0.01, 0.6);
  if (clearness > 1.065 && clearness < 2.8)
  {
    brightness = std::max(brightness, 0.2);
  }
  const auto* end = std::upper_bound(perezBins, perezBins + 8, clearness);
  const auto bin = static_cast<int>(end - perezBins) - 1;
  const auto parameter = [&](int which)
  {
    const double* x = perezParameters[bin][which];
    return x[0] + x[1] * sunZenith + brightness * (x[2] + x[3] * sunZenith);
  };
  SkyDistribution sky{ parameter(0), parameter(1), parameter(2), parameter(3), parameter(4), 1.0 };
  if (bin == 0)
  {
    const double* c = perezParameters[0][2];
    const double* d = perezParameters[0][3];
    sky.c = std::exp(std::pow(brightness * (c[0] + c[1] * sunZenith), c[2])) - c[3];
    sky.d = -std::exp(brightness * (d[0] + d[1] * sunZenith)) + d[2] + brightness * d[3];
  }
  return sky;
}

} // namespace lumitree
