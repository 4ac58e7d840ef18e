// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Integration_Elliptic_h
#define Lumitree_Radiometry_Integration_Elliptic_h

#include <algorithm>
#include <cmath>

/// Carlson's symmetric elliptic integrals by duplication (B. C. Carlson, Numerical Algorithms 10,
/// 1995). They take the complements of modulus and characteristic, so that nothing is lost where
/// those are near 1, as the functions of the standard library lose it.
namespace lumitree
{

/// R_F(x, y, z): at most one argument is 0, none negative.
inline double carlsonF(double x, double y, double z)
{
  for (;;)
  {
    const double mean = (x + y + z) / 3.0;
    const double dx = 1.0 - x / mean;
    const double dy = 1.0 - y / mean;
    const double dz = 1.0 - z / mean;
    if (std::max({ std::fabs(dx), std::fabs(dy), std::fabs(dz) }) < 1e-3)
    {
      const double e2 = dx * dy - dz * dz;
      const double e3 = dx * dy * dz;
      return (1.0 - e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0 - 3.0 * e2 * e3 / 44.0) /
        std::sqrt(mean);
    }
    const double lambda = std::sqrt(x * y) + std::sqrt(y * z) + std::sqrt(z * x);
    x = 0.25 * (x + lambda);
    y = 0.25 * (y + lambda);
    z = 0.25 * (z + lambda);
  }
}

/// R_J(x, y, z, p): at most one of x, y, z is 0, none negative, p > 0.
inline double carlsonJ(double x, double y, double z, double p)
{
  double sum = 0.0;
  double factor = 1.0;
  for (;;)
  {
    const double mean = (x + y + z + 2.0 * p) / 5.0;
    const double dx = 1.0 - x / mean;
    const double dy = 1.0 - y / mean;
    const double dz = 1.0 - z / mean;
    const double dp = 1.0 - p / mean;
    if (std::max({ std::fabs(dx), std::fabs(dy), std::fabs(dz), std::fabs(dp) }) < 1e-3)
    {
      const double product = dx * dy * dz;
      const double e2 = dx * dy + dx * dz + dy * dz - 3.0 * dp * dp;
      const double e3 = product + 2.0 * e2 * dp + 4.0 * dp * dp * dp;
      const double e4 = (2.0 * product + e2 * dp + 3.0 * dp * dp * dp) * dp;
      const double e5 = product * dp * dp;
      const double series = 1.0 - 3.0 * e2 / 14.0 + e3 / 6.0 + 9.0 * e2 * e2 / 88.0 -
        3.0 * e4 / 22.0 - 9.0 * e2 * e3 / 52.0 + 3.0 * e5 / 26.0;
      return factor * series / (mean * std::sqrt(mean)) + 6.0 * sum;
    }
    const double rx = std::sqrt(x);
    const double ry = std::sqrt(y);
    const double rz = std::sqrt(z);
    const double rp = std::sqrt(p);
    const double lambda = rx * ry + ry * rz + rz * rx;
    const double d = (rp + rx) * (rp + ry) * (rp + rz);
    // R_C(1, 1 + e) with the e of Carlson's formula is R_F(1, 1 + e, 1 + e).
    const double e = (p - x) / d * ((p - y) / d) * (p - z);
    sum += factor / d * carlsonF(1.0, 1.0 + e, 1.0 + e);
    factor *= 0.25;
    x = 0.25 * (x + lambda);
    y = 0.25 * (y + lambda);
    z = 0.25 * (z + lambda);
    p = 0.25 * (p + lambda);
  }
}

} // namespace lumitree

#endif
