// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Exact_Quadratic_h
#define Lumitree_Accel_Exact_Quadratic_h

#include "Accel/Exact/Dyadic.h"
#include "Accel/Exact/QuadraticFormulas.h"

/// Questions about a ray and quadrics, answered as arithmetic on the stored numbers, taken as
/// reals, answers them: signs of polynomials at roots of polynomials, so nothing stays open. Every
/// number is finite. Called only where floating point cannot decide: some microseconds each.
namespace lumitree::exact
{

using Quadratic = BasicQuadratic<Dyadic>;
using Root = BasicRoot<Dyadic>;

/// 0 where the line crosses the triangle's plane, which it does.
[[nodiscard]] Quadratic planeAlong(const Ray& ray, const std::array<Vec3, 3>& triangle);

/// Sign of (x - y).
[[nodiscard]] int compare(const Root& x, const Root& y);

/// Whether the point of the ray at the root of the quadric's form is in its box, its cuts and its
/// bound, and its tree 0 there.
[[nodiscard]] bool isInside(const Ray& ray, const Quadric& quadric, const Root& root);

/// The double nearest to the root, of two equally near the even one; infinite beyond their range.
[[nodiscard]] double nearest(const Root& root);

} // namespace lumitree::exact

#endif
