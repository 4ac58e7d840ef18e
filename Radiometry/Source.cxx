// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Source.h"

#include <limits>
#include <stdexcept>

namespace lumitree
{

// Here, so that the class has one table of virtual functions in the process.
Source::Source() = default;
Source::~Source() = default;

SourceSample Source::sample(const Vec3&, double, double) const
{
  throw std::logic_error("Only an extended source is sampled; this one is a point or a direction.");
}

std::optional<double> Source::radiance(const Vec3&, const Vec3&) const
{
  return std::nullopt;
}

void Source::crossings(
  const Vec3& position, const Vec3& direction, std::vector<SourceCrossing>& to) const
{
  const double seen = this->radiance(position, direction).value_or(0.0);
  if (seen > 0.0)
  {
    to.push_back({ std::numeric_limits<double>::infinity(), seen });
  }
}

double Source::sumOfCrossings(const Vec3& position, const Vec3& direction) const
{
  std::vector<SourceCrossing> found;
  this->crossings(position, direction, found);
  double sum = 0.0;
  for (const SourceCrossing& crossing : found)
  {
    sum += crossing.radiance;
  }
  return sum;
}

} // namespace lumitree
