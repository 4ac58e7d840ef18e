// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_QuadricForm_h
#define Lumitree_Accel_QuadricForm_h

#include "Accel/Export.h"
#include "Accel/Vec3.h"

#include <array>

namespace lumitree
{

/// A function of second degree, with y = x - centre:
///
///     f(x) = a0 y0² + a1 y1² + a2 y2² + a3 y0 y1 + a4 y1 y2 + a5 y0 y2
///          + a6 y0 + a7 y1 + a8 y2 + a9 + residue,
///
/// the order of vtkQuadric's coefficients. All numbers are taken as exact reals, the difference
/// from the centre included. The residue is what a9 lost when it was rounded (the square of a
/// sphere's radius is the sum of two doubles).
struct QuadricForm
{
  Vec3 centre = { 0.0, 0.0, 0.0 };
  std::array<double, 10> coefficients = {};
  double residue = 0.0;
};

/// Whether all numbers are equal.
inline bool operator==(const QuadricForm& a, const QuadricForm& b)
{
  return a.centre == b.centre && a.coefficients == b.coefficients && a.residue == b.residue;
}

/// f and its gradient at a point, in double arithmetic.
///@{
[[nodiscard]] LUMITREE_ACCEL_EXPORT double valueAt(const QuadricForm& form, const Vec3& point);
[[nodiscard]] LUMITREE_ACCEL_EXPORT Vec3 gradientAt(const QuadricForm& form, const Vec3& point);
///@}

} // namespace lumitree

#endif
