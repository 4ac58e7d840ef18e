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

/// Makes sums of weights steps from 0 to 1.
void normalise(double* steps, std::size_t count)
{
  double sum = 0.0;
  for (std::size_t i = 1; i <= count; ++i)
  {
    sum += steps[i];
    steps[i] = sum;
  }
  for (std::size_t i = 1; i <= count; ++i)
  {
    steps[i] = sum > 0.0 ? steps[i] / sum : static_cast<double>(i) / static_cast<double>(count);
  }
  steps[count] = 1.0;
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
    sample.radiance = this->sky_.radianceFrom(to.direction);
    sample.weight = pi / to.cosine;
  }
}

RadianceSkySamples::RadianceSkySamples(const SkySource& sky)
  : sky_(sky)
  , axes_(axesAround(sky.up()))
{
  for (std::size_t r = 0; r < rings; ++r)
  {
    double sum = 0.0;
    for (std::size_t s = 0; s < sectors; ++s)
    {
      const CosineDirection to(this->axes_, (static_cast<double>(r) + 0.5) / rings,
        (static_cast<double>(s) + 0.5) / sectors);
      this->sectorSteps_[r][s + 1] = this->sky_.radianceFrom(to.direction);
      sum += this->sectorSteps_[r][s + 1];
    }
    // A part of it even, so that what the middle of a step does not show is drawn all the same.
    constexpr double even = 0.1;
    for (std::size_t s = 1; s <= sectors; ++s)
    {
      this->sectorSteps_[r][s] += even * sum / sectors;
    }
    this->ringSteps_[r + 1] = sum;
    normalise(this->sectorSteps_[r].data(), sectors);
  }
  normalise(this->ringSteps_.data(), rings);
}

bool RadianceSkySamples::suits(const SkySource& sky, const View& view)
{
  return view.sided && sky.groundRadiance() == 0.0 && dot(view.normal, sky.up()) > 0.95;
}

RadianceSkySamples::Place RadianceSkySamples::place(
  const double* steps, std::size_t count, double x)
{
  const double* const above = std::upper_bound(steps + 1, steps + count, x);
  const auto step = static_cast<std::size_t>(above - steps) - 1;
  return { step, std::min(1.0, (x - steps[step]) / (steps[step + 1] - steps[step])) };
}

void RadianceSkySamples::draw(
  const std::array<double, 2>* points, std::size_t count, SourceSample* samples) const
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const Place ring = RadianceSkySamples::place(this->ringSteps_.data(), rings, points[i][0]);
    const auto& steps = this->sectorSteps_[ring.step];
    const Place sector = RadianceSkySamples::place(steps.data(), sectors, points[i][1]);
    const double density = (this->ringSteps_[ring.step + 1] - this->ringSteps_[ring.step]) *
      (steps[sector.step + 1] - steps[sector.step]) * (rings * sectors);
    const CosineDirection to(this->axes_, (static_cast<double>(ring.step) + ring.within) / rings,
      (static_cast<double>(sector.step) + sector.within) / sectors);
    SourceSample& sample = samples[i];
    sample.sightline.direction = to.direction;
    sample.sightline.endless = true;
    sample.radiance = this->sky_.radianceFrom(to.direction);
    sample.weight = to.cosine > 0.0 && density > 0.0 ? pi / (to.cosine * density) : 0.0;
  }
}

} // namespace lumitree
