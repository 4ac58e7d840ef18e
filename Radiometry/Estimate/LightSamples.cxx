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

CosineSkySamples::CosineSkySamples(const SkySource& sky, const Vec3& normal)
  : sky_(sky)
{
  const Frame frame = Frame::around(normal);
  this->axes_ = { frame.x, frame.y, frame.z };
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
    const double cosine = std::sqrt(1.0 - points[i][0]);
    const double sine = std::sqrt(points[i][0]);
    const double azimuth = 2.0 * pi * points[i][1];
    SourceSample& sample = samples[i];
    sample.sightline.direction = (sine * std::cos(azimuth)) * this->axes_[0] +
      (sine * std::sin(azimuth)) * this->axes_[1] + cosine * this->axes_[2];
    sample.sightline.endless = true;
    sample.radiance = this->sky_.radianceFrom(sample.sightline.direction);
    sample.weight = pi / cosine;
  }
}

} // namespace lumitree
