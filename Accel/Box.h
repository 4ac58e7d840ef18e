// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Box_h
#define Lumitree_Accel_Box_h

#include "Accel/Vec3.h"

#include <algorithm>
#include <limits>

namespace lumitree
{

/// A closed axis-aligned box. Empty (lower > upper) until something is put in.
struct Box
{
  Vec3 lower = { std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::infinity() };
  Vec3 upper = { -std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };

  void extend(const Vec3& p)
  {
    for (int k = 0; k < 3; ++k)
    {
      lower[k] = std::min(lower[k], p[k]);
      upper[k] = std::max(upper[k], p[k]);
    }
  }

  void extend(const Box& other)
  {
    for (int k = 0; k < 3; ++k)
    {
      lower[k] = std::min(lower[k], other.lower[k]);
      upper[k] = std::max(upper[k], other.upper[k]);
    }
  }

  [[nodiscard]] bool empty() const { return !(lower[0] <= upper[0]); }

  [[nodiscard]] Vec3 size() const { return upper - lower; }

  [[nodiscard]] Vec3 centre() const
  {
    return { 0.5 * lower[0] + 0.5 * upper[0], 0.5 * lower[1] + 0.5 * upper[1],
      0.5 * lower[2] + 0.5 * upper[2] };
  }

  /// Surface area; 0 for an empty box.
  [[nodiscard]] double area() const
  {
    if (this->empty())
    {
      return 0.0;
    }
    const Vec3 s = this->size();
    return 2.0 * (s[0] * s[1] + s[1] * s[2] + s[2] * s[0]);
  }

  [[nodiscard]] int longestAxis() const
  {
    const Vec3 s = this->size();
    return s[0] >= s[1] ? (s[0] >= s[2] ? 0 : 2) : (s[1] >= s[2] ? 1 : 2);
  }
};

} // namespace lumitree

#endif
