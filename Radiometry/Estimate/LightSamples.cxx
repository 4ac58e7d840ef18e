// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Estimate/LightSamples.h"

#include "Radiometry/Constants.h"
#include "Radiometry/Frame.h"

#include <algorithm>
#include <cmath>

namespace lumitree
{

void WholeSourceSamples::draw(
  const std::array<double, 2>* points, std::size_t count, SourceSample* samples) const
{
  for (std::size_t i = 0; i < count; ++i)
  {
    samples[i] = this->source_.sample(this->eye_, points[i][0], points[i][1]);
  }
}

namespace
{

/// Of the unit square, by the cosine with the third axis. (Malley's method.)
struct CosineDirection
{
  CosineDirection(const std::array<Vec3, 3>& axes, double u, double v)
    : cosine(std::sqrt(1.0 - u))
  {
    const double sine = std::sqrt(u);
    const double azimuth = 2.0 * pi * v;
    this->direction = (sine * std::cos(azimuth)) * axes[0] + (sine * std::sin(azimuth)) * axes[1] +
      this->cosine * axes[2];
  }

  double cosine;
  Vec3 direction;
};

std::array<Vec3, 3> axesAround(const Vec3& z)
{
  const Frame frame = Frame::around(z);
  return { frame.x, frame.y, frame.z };
}

} // namespace

CosineSkySamples::CosineSkySamples(const SkySource& sky, const Vec3& normal)
  : sky_(sky)
  , axes_(axesAround(normal))
{
}

bool CosineSkySamples::suits(const SkySource& sky, const View& view)
{
  return view.sided && sky.groundRadiance() == 0.0 && dot(view.normal, sky.up()) > 0.7;
}

void CosineSkySamples::draw(
  const std::array<double, 2>* points, std::size_t count, SourceSample* samples) const
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const CosineDirection to(this->axes_, points[i][0], points[i][1]);
    SourceSample& sample = samples[i];
    sample.sightline.direction = to.direction;
    sample.sightline.endless = true;
    sample.radiance = this->sky_.radianceOfSample(to.direction);
    sample.weight = pi / to.cosine;
  }
}

template <std::size_t count>
void RadianceSkySamples::Steps<count>::set(const std::array<double, count>& weights)
{
  double sum = 0.0;
  for (const double weight : weights)
  {
    sum += weight;
  }
  double below = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    below += weights[i];
    this->ends_[i + 1] =
      sum > 0.0 ? below / sum : static_cast<double>(i + 1) / static_cast<double>(count);
  }
  this->ends_[count] = 1.0;
  std::size_t step = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    this->perHeight_[i] = 1.0 / (this->ends_[i + 1] - this->ends_[i]);
    while (static_cast<double>(i) / count >= this->ends_[step + 1])
    {
      ++step;
    }
    this->first_[i] = static_cast<std::uint8_t>(step);
  }
}

RadianceSkySamples::RadianceSkySamples(const SkySource& sky)
  : sky_(sky)
  , axes_(axesAround(sky.up()))
{
  std::array<double, rings> ofRings{};
  for (std::size_t r = 0; r < rings; ++r)
  {
    std::array<double, sectors> ofSectors{};
    for (std::size_t s = 0; s < sectors; ++s)
    {
      const CosineDirection to(this->axes_, (static_cast<double>(r) + 0.5) / rings,
        (static_cast<double>(s) + 0.5) / sectors);
      ofSectors[s] = this->sky_.radianceFrom(to.direction);
      ofRings[r] += ofSectors[s];
    }
    // A part of it even, so that what the middle of a step does not show is drawn all the same.
    constexpr double even = 0.1;
    for (double& weight : ofSectors)
    {
      weight += even * ofRings[r] / sectors;
    }
    this->sectorSteps_[r].set(ofSectors);
  }
  this->ringSteps_.set(ofRings);
  for (std::size_t r = 0; r < rings; ++r)
  {
    for (std::size_t s = 0; s < sectors; ++s)
    {
      const double density =
        this->ringSteps_.height(r) * this->sectorSteps_[r].height(s) * (rings * sectors);
      this->weights_[r][s] = density > 0.0 ? pi / density : 0.0;
    }
  }
  for (std::size_t s = 0; s < sectors; ++s)
  {
    const double azimuth = 2.0 * pi * (static_cast<double>(s) + 0.5) / sectors;
    this->middles_[s] = { std::cos(azimuth), std::sin(azimuth) };
  }
}

bool RadianceSkySamples::suits(const SkySource& sky, const View& view)
{
  return view.sided && sky.groundRadiance() == 0.0 && dot(view.normal, sky.up()) > 0.95;
}

void RadianceSkySamples::draw(
  const std::array<double, 2>* points, std::size_t count, SourceSample* samples) const
{
  for (std::size_t i = 0; i < count; ++i)
  {
    auto [u, v] = points[i];
    const std::size_t ring = this->ringSteps_.place(u);
    const std::size_t sector = this->sectorSteps_[ring].place(v);
    const double squared = (static_cast<double>(ring) + u) / rings;
    const double sine = std::sqrt(squared);
    const double cosine = std::sqrt(1.0 - squared);
    // The azimuth from the middle of the sector, by Taylor's series: 1e-17 off at most.
    const double off = 2.0 * pi / sectors * (v - 0.5);
    const double x = off * off;
    const double offSine = off * (1.0 - x / 6.0 * (1.0 - x / 20.0 * (1.0 - x / 42.0)));
    const double offCosine = 1.0 - x / 2.0 * (1.0 - x / 12.0 * (1.0 - x / 30.0 * (1.0 - x / 56.0)));
    const auto& [c, s] = this->middles_[sector];
    SourceSample& sample = samples[i];
    sample.sightline.direction = (sine * (c * offCosine - s * offSine)) * this->axes_[0] +
      (sine * (s * offCosine + c * offSine)) * this->axes_[1] + cosine * this->axes_[2];
    sample.sightline.endless = true;
    sample.radiance = this->sky_.radianceOfSample(sample.sightline.direction);
    sample.weight = cosine > 0.0 ? this->weights_[ring][sector] / cosine : 0.0;
  }
}

} // namespace lumitree
