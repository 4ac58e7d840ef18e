// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Checks_h
#define Lumitree_Radiometry_Checks_h

#include "Accel/Ray.h"
#include "Accel/Vec3.h"

#include <algorithm>
#include <stdexcept>
#include <string>

/// Arguments of constructors: each gives back what it was given, or throws std::invalid_argument.
namespace lumitree::checks
{

inline double notNegative(double value, const char* what)
{
  if (!(value >= 0.0) || !std::isfinite(value))
  {
    throw std::invalid_argument(std::string(what) + " must be finite and not negative, but is " +
      std::to_string(value) + ".");
  }
  return value;
}

inline double positive(double value, const char* what)
{
  if (!(value > 0.0) || !std::isfinite(value))
  {
    throw std::invalid_argument(
      std::string(what) + " must be finite and positive, but is " + std::to_string(value) + ".");
  }
  return value;
}

inline Vec3 coordinates(const Vec3& value, const char* what)
{
  for (const double component : value)
  {
    if (!(std::fabs(component) <= coordinateLimit))
    {
      throw std::invalid_argument(std::string(what) + " must be finite.");
    }
  }
  return value;
}

/// The unit vector of that direction, however long or short it is.
inline Vec3 unit(const Vec3& value, const char* what)
{
  const double scale = std::max({ std::fabs(value[0]), std::fabs(value[1]), std::fabs(value[2]) });
  if (!isFinite(value) || scale == 0.0)
  {
    throw std::invalid_argument(std::string(what) + " must be finite and not zero.");
  }
  const Vec3 scaled = { value[0] / scale, value[1] / scale, value[2] / scale };
  const double size = length(scaled);
  return { scaled[0] / size, scaled[1] / size, scaled[2] / size };
}

} // namespace lumitree::checks

#endif
