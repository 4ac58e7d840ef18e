// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/PhotometricWeb.h"

#include "Radiometry/Constants.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lumitree
{

namespace
{

constexpr double degree = pi / 180.0;

/// Where a value lies in a growing list: between i and i + 1, at that share of the way.
struct Place
{
  std::size_t i = 0;
  double share = 0.0;
  bool inside = false;
};

Place find(const std::vector<double>& list, double value)
{
  if (list.empty() || !(value >= list.front() && value <= list.back()))
  {
    return {};
  }
  if (list.size() == 1)
  {
    return { 0, 0.0, true };
  }
  const auto next = std::upper_bound(list.begin(), list.end() - 1, value);
  const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, next - list.begin() - 1));
  return { i, (value - list[i]) / (list[i + 1] - list[i]), true };
}

void checkAngles(const std::vector<double>& angles, double low, double high, const char* what)
{
  for (std::size_t i = 0; i < angles.size(); ++i)
  {
    if (!(angles[i] >= low && angles[i] <= high) || (i > 0 && !(angles[i] > angles[i - 1])))
    {
      throw std::invalid_argument(std::string("The ") + what +
        " angles of a photometric web must grow from " + std::to_string(static_cast<int>(low)) +
        " to " + std::to_string(static_cast<int>(high)) + " degrees.");
    }
  }
}

} // namespace

double PhotometricWeb::intensity(double horizontal, double vertical) const
{
  double around = horizontal;
  if (this->type == Type::C)
  {
    around = this->horizontals.size() == 1 ? this->horizontals.front()
                                           : horizontal - 360.0 * std::floor(horizontal / 360.0);
  }
  const Place h = find(this->horizontals, around);
  const Place v = find(this->verticals, vertical);
  if (!h.inside || !v.inside)
  {
    return 0.0;
  }
  const std::size_t count = this->verticals.size();
  const auto along = [&](std::size_t row)
  {
    const double a = this->intensities[row * count + v.i];
    return v.share > 0.0 ? a + v.share * (this->intensities[row * count + v.i + 1] - a) : a;
  };
  const double first = along(h.i);
  return h.share > 0.0 ? first + h.share * (along(h.i + 1) - first) : first;
}

double PhotometricWeb::flux() const
{
  // Weights of the values along the angle that the solid angle depends on, γ or H: of each interval
  // ∫ (1 − x) w and ∫ x w, x the share of the way, w = sinγ or cosH.
  const bool polar = this->type == Type::C;
  const std::vector<double>& weighted = polar ? this->verticals : this->horizontals;
  const std::vector<double>& even = polar ? this->horizontals : this->verticals;
  const auto weigh =
    [](const std::vector<double>& angles, const auto& firstIntegral, const auto& secondIntegral)
  {
    std::vector<double> weights(angles.size(), 0.0);
    for (std::size_t i = 0; i + 1 < angles.size(); ++i)
    {
      const double a = angles[i] * degree;
      const double b = angles[i + 1] * degree;
      const double all = firstIntegral(a, b);
      const double rising = secondIntegral(a, b) / (b - a);
      weights[i] += all - rising;
      weights[i + 1] += rising;
    }
    return weights;
  };
  const std::vector<double> across = polar
    ? weigh(
        weighted, [](double a, double b) { return std::cos(a) - std::cos(b); },
        [](double a, double b) { return std::sin(b) - std::sin(a) - (b - a) * std::cos(b); })
    : weigh(
        weighted, [](double a, double b) { return std::sin(b) - std::sin(a); },
        [](double a, double b) { return (b - a) * std::sin(b) + std::cos(b) - std::cos(a); });
  std::vector<double> along = weigh(
    even, [](double a, double b) { return b - a; },
    [](double a, double b) { return 0.5 * (b - a) * (b - a); });
  if (polar && even.size() == 1)
  {
    along[0] = 2.0 * pi;
  }
  const std::vector<double>& ofHorizontal = polar ? along : across;
  const std::vector<double>& ofVertical = polar ? across : along;
  double sum = 0.0;
  for (std::size_t h = 0; h < this->horizontals.size(); ++h)
  {
    double row = 0.0;
    for (std::size_t v = 0; v < this->verticals.size(); ++v)
    {
      row += ofVertical[v] * this->intensities[h * this->verticals.size() + v];
    }
    sum += ofHorizontal[h] * row;
  }
  return sum;
}

double PhotometricWeb::tiltFactor(double degrees) const
{
  if (this->tiltAngles.empty())
  {
    return 1.0;
  }
  const Place place =
    find(this->tiltAngles, std::clamp(degrees, this->tiltAngles.front(), this->tiltAngles.back()));
  const double a = this->tiltFactors[place.i];
  return place.share > 0.0 ? a + place.share * (this->tiltFactors[place.i + 1] - a) : a;
}

void PhotometricWeb::check() const
{
  const bool polar = this->type == Type::C;
  if (this->verticals.empty() || this->horizontals.empty() ||
    this->intensities.size() != this->verticals.size() * this->horizontals.size() ||
    this->tiltAngles.size() != this->tiltFactors.size())
  {
    throw std::invalid_argument(
      "A photometric web needs an intensity for each pair of its angles.");
  }
  checkAngles(this->verticals, polar ? 0.0 : -90.0, polar ? 180.0 : 90.0, "vertical");
  checkAngles(this->horizontals, polar ? 0.0 : -90.0, polar ? 360.0 : 90.0, "horizontal");
  if (polar && this->horizontals.size() > 1 &&
    !(this->horizontals.front() == 0.0 && this->horizontals.back() == 360.0))
  {
    throw std::invalid_argument(
      "The horizontal angles of a photometric web of type C must go from 0 to 360 degrees.");
  }
  for (const double value : this->intensities)
  {
    if (!(value >= 0.0) || !std::isfinite(value))
    {
      throw std::invalid_argument(
        "The intensities of a photometric web must be finite and not negative.");
    }
  }
}

} // namespace lumitree
