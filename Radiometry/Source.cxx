// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Source.h"

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

} // namespace lumitree
