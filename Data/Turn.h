// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LUMITREE_DATA_TURN_H
#define LUMITREE_DATA_TURN_H

#include <cstdint>
#include <utility>

namespace lumitree::data
{

/// (cos, sin) of k/n of a full turn. Unlike libm's, these are the same bits everywhere, and
/// symmetric: opposite points are exact negatives. Within 2e-16.
inline std::pair<double, double> cosSinOfTurn(std::int64_t k, std::int64_t n)
{
  k = ((k % n) + n) % n;
  const std::int64_t quarter = 4 * k / n;
  std::int64_t rest = 4 * k - quarter * n;
  const bool beyondEighth = 2 * rest > n;
  if (beyondEighth)
  {
    rest = n - rest;
  }
  const double x = static_cast<double>(rest) / static_cast<double>(n) * 1.5707963267948966;
  double c = 1;
  double s = 1;
  // Taylor series in Horner form; below an eighth of a turn the 17th power is the last that counts.
  for (int power = 16; power >= 2; power -= 2)
  {
    c = 1 - x * x / (power * (power - 1)) * c;
    s = 1 - x * x / (power * (power + 1)) * s;
  }
  s *= x;
  if (beyondEighth)
  {
    std::swap(c, s);
  }
  switch (quarter)
  {
    case 0:
      return { c, s };
    case 1:
      return { -s, c };
    case 2:
      return { -c, -s };
    default:
      return { s, -c };
  }
}

}

#endif
