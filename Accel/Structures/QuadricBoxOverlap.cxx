// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/QuadricBoxOverlap.h"

#include <algorithm>

namespace lumitree
{
namespace
{

/// Far above the rounding of the bounds below (less than 40 operations), and above what the double
/// arithmetic of leaf tests can be wrong by, so that leaves hold what Fast and Watertight may find.
constexpr double relativePad = 0x1p-30;

/// No value of the form on the box is outside.
struct Range
{
  double low;
  double high;
};

Range rangeOf(const QuadricForm& form, const Box& box)
{
  const auto& a = form.coefficients;
  const Vec3 centre = box.centre();
  const Vec3 size = box.size();
  const Vec3 y = centre - form.centre;
  const Vec3 gradient = gradientAt(form, centre);
  Vec3 reach;
  double low = valueAt(form, centre);
  double high = low;
  for (int k = 0; k < 3; ++k)
  {
    const double half = 0.5 * size[k];
    const double square = a[k] * half * half;
    low += std::min(square, 0.0) - std::fabs(gradient[k]) * half;
    high += std::max(square, 0.0) + std::fabs(gradient[k]) * half;
    reach[k] = std::fabs(y[k]) + half;
  }
  double magnitude = std::fabs(a[9]) + std::fabs(form.residue);
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    const double mixed = std::fabs(a[3 + k]) * (0.5 * size[k]) * (0.5 * size[next]);
    low -= mixed;
    high += mixed;
    magnitude += std::fabs(a[k]) * reach[k] * reach[k] +
      std::fabs(a[3 + k]) * reach[k] * reach[next] + std::fabs(a[6 + k]) * reach[k];
  }
  const double pad = relativePad * magnitude;
  return { low - pad, high + pad };
}

/// Whether normal · (x - point) may be 0 or less somewhere in the box.
bool mayReach(const QuadricCut& cut, const Box& box)
{
  double low = 0.0;
  double magnitude = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const double n = cut.normal[k];
    const double x = n > 0.0 ? box.lower[k] : box.upper[k];
    low += n * (x - cut.point[k]);
    magnitude += std::fabs(n) * (std::fabs(x) + std::fabs(cut.point[k]));
  }
  // The negation keeps what overflowed.
  return !(low > relativePad * magnitude);
}

bool mayHavePoints(const Quadric& quadric, const Box& box, int depth)
{
  if (!mayMeet(quadric, box))
  {
    return false;
  }
  // Opposite signs in two corners: there are points between, unless cuts take them all.
  const bool below = valueAt(quadric.form, box.lower) < 0.0;
  if (depth == 0 || (valueAt(quadric.form, box.upper) < 0.0) != below ||
    (valueAt(quadric.form, box.centre()) < 0.0) != below)
  {
    return true;
  }
  const int axis = box.longestAxis();
  Box first = box;
  Box second = box;
  first.upper[axis] = second.lower[axis] = box.centre()[axis];
  return mayHavePoints(quadric, first, depth - 1) || mayHavePoints(quadric, second, depth - 1);
}

} // namespace

bool mayMeet(const Quadric& quadric, const Box& box)
{
  Box common;
  for (int k = 0; k < 3; ++k)
  {
    common.lower[k] = std::max(box.lower[k], quadric.clip.lower[k]);
    common.upper[k] = std::min(box.upper[k], quadric.clip.upper[k]);
    if (!(common.lower[k] <= common.upper[k]))
    {
      return false;
    }
  }
  const Range range = rangeOf(quadric.form, common);
  return !(range.low > 0.0) && !(range.high < 0.0) && mayReach(quadric.cuts[0], common) &&
    mayReach(quadric.cuts[1], common) && !(rangeOf(quadric.bound, common).low > 0.0);
}

bool mayHavePoints(const Quadric& quadric)
{
  return mayHavePoints(quadric, quadric.clip, 9);
}

} // namespace lumitree
