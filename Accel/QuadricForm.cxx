// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/QuadricForm.h"

namespace lumitree
{

double valueAt(const QuadricForm& form, const Vec3& point)
{
  const Vec3 y = point - form.centre;
  const auto& a = form.coefficients;
  return (a[0] * y[0] * y[0] + a[1] * y[1] * y[1] + a[2] * y[2] * y[2]) +
    (a[3] * y[0] * y[1] + a[4] * y[1] * y[2] + a[5] * y[0] * y[2]) +
    (a[6] * y[0] + a[7] * y[1] + a[8] * y[2]) + (a[9] + form.residue);
}

Vec3 gradientAt(const QuadricForm& form, const Vec3& point)
{
  const Vec3 y = point - form.centre;
  const auto& a = form.coefficients;
  return { 2.0 * a[0] * y[0] + a[3] * y[1] + a[5] * y[2] + a[6],
    2.0 * a[1] * y[1] + a[3] * y[0] + a[4] * y[2] + a[7],
    2.0 * a[2] * y[2] + a[4] * y[1] + a[5] * y[0] + a[8] };
}

} // namespace lumitree
