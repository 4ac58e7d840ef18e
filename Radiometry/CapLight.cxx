// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/CapLight.h"

#include "Radiometry/Constants.h"

#include <algorithm>
#include <cmath>

namespace lumitree
{

namespace
{

/// z − atan z for z ≥ 0
double beyondItsArcTangent(double z)
{
  if (z > 0.3)
  {
    return z - std::atan(z);
  }
  const double squared = z * z;
  double power = z * squared;
  double sum = 0.0;
  for (int n = 3; n < 33; n += 4)
  {
    sum += power / n - power * squared / (n + 2);
    power *= squared * squared;
  }
  return sum;
}

} // namespace

double capIrradiance(double sineOfRadius, double cosine)
{
  const double k = sineOfRadius;
  if (cosine >= k)
  {
    return pi * k * k * cosine;
  }
  if (!(cosine > -k))
  {
    return 0.0;
  }
  const double u = cosine / k;
  const double q = std::sqrt((1.0 - u) * (1.0 + u));
  const double w = std::sqrt((1.0 - k) * (1.0 + k));
  const double y = k * q;
  const double wedge = k * k * cosine * std::atan2(q, -w * u);
  // atan(y / w) − y w; for small k both are y, and what is left is of order k³.
  const double z = y / w;
  const double rest = z < 0.3 ? y * k * k / w - beyondItsArcTangent(z) : std::atan2(y, w) - y * w;
  return std::max(0.0, wedge + rest);
}

} // namespace lumitree
