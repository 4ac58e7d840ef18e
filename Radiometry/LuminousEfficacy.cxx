// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/LuminousEfficacy.h"

#include "Radiometry/Checks.h"

#include <algorithm>
#include <cmath>

namespace lumitree
{

namespace
{

constexpr double firstWavelength = 360.0;
constexpr double step = 5.0;
constexpr double photopic[] = { 0.000003917, 0.000006965, 0.00001239, 0.00002202, 0.000039,
  0.000064, 0.00012, 0.000217, 0.000396, 0.00064, 0.00121, 0.00218, 0.004, 0.0073, 0.0116, 0.01684,
  0.023, 0.0298, 0.038, 0.048, 0.06, 0.0739, 0.09098, 0.1126, 0.13902, 0.1693, 0.20802, 0.2586,
  0.323, 0.4073, 0.503, 0.6082, 0.71, 0.7932, 0.862, 0.91485, 0.954, 0.9803, 0.99495, 1.0, 0.995,
  0.9786, 0.952, 0.9154, 0.87, 0.8163, 0.757, 0.6949, 0.631, 0.5668, 0.503, 0.4412, 0.381, 0.321,
  0.265, 0.217, 0.175, 0.1382, 0.107, 0.0816, 0.061, 0.04458, 0.032, 0.0232, 0.017, 0.01192,
  0.00821, 0.005723, 0.004102, 0.002929, 0.002091, 0.001484, 0.001047, 0.00074, 0.00052, 0.000361,
  0.000249, 0.000172, 0.00012, 0.000085, 0.00006, 0.000042, 0.00003, 0.000021, 0.000015 };
constexpr int count = sizeof(photopic) / sizeof(photopic[0]);
static_assert(count == 85, "360 to 780 nm");

double interpolate(const std::vector<SpectralValue>& spectrum, std::size_t i, double at)
{
  const SpectralValue& a = spectrum[i];
  const SpectralValue& b = spectrum[i + 1];
  return a.value + (b.value - a.value) * (at - a.nanometres) / (b.nanometres - a.nanometres);
}

} // namespace

double luminousEfficiency(double nanometres)
{
  const double place = (nanometres - firstWavelength) / step;
  if (!(place >= 0.0 && place <= count - 1))
  {
    return 0.0;
  }
  const int i = std::min(static_cast<int>(place), count - 2);
  return photopic[i] + (photopic[i + 1] - photopic[i]) * (place - i);
}

double luminousEfficacy(const std::vector<SpectralValue>& spectrum)
{
  if (spectrum.size() < 2)
  {
    throw std::invalid_argument("A spectrum needs at least 2 values.");
  }
  for (std::size_t i = 0; i < spectrum.size(); ++i)
  {
    checks::notNegative(spectrum[i].value, "A value of a spectrum");
    checks::positive(spectrum[i].nanometres, "A wavelength");
    if (i > 0 && !(spectrum[i].nanometres > spectrum[i - 1].nanometres))
    {
      throw std::invalid_argument("The wavelengths of a spectrum must grow.");
    }
  }
  // Between the wavelengths of both tables the product of two straight lines: Simpson's rule is
  // exact.
  double light = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i + 1 < spectrum.size(); ++i)
  {
    const double begin = spectrum[i].nanometres;
    const double end = spectrum[i + 1].nanometres;
    all += 0.5 * (end - begin) * (spectrum[i].value + spectrum[i + 1].value);
    const double last = firstWavelength + step * (count - 1);
    double a = std::max(begin, firstWavelength);
    while (a < std::min(end, last))
    {
      const double next = firstWavelength + step * (std::floor((a - firstWavelength) / step) + 1.0);
      const double b = std::min({ next, end, last });
      const double middle = 0.5 * (a + b);
      const auto at = [&](double x) { return interpolate(spectrum, i, x) * luminousEfficiency(x); };
      light += (b - a) / 6.0 * (at(a) + 4.0 * at(middle) + at(b));
      a = b;
    }
  }
  if (!(all > 0.0))
  {
    throw std::invalid_argument("A spectrum must not be 0 everywhere.");
  }
  return maximumLuminousEfficacy * light / all;
}

} // namespace lumitree
