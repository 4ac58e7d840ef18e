// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Exact_Quadratic_h
#define Lumitree_Accel_Exact_Quadratic_h

#include "Accel/Exact/Dyadic.h"
#include "Accel/Quadric.h"
#include "Accel/Ray.h"

/// Questions about a ray and quadrics, answered as arithmetic on the stored numbers, taken as
/// reals, answers them: signs of polynomials at roots of polynomials, so nothing stays open. Every
/// number is finite. Called only where floating point cannot decide: some microseconds each.
namespace lumitree::exact
{

/// a t² + b t + c
struct Quadratic
{
  Dyadic a;
  Dyadic b;
  Dyadic c;

  /// The form along the line of a ray.
  static Quadratic along(const Ray& ray, const QuadricForm& form);
  /// normal · (x - point) along it.
  static Quadratic along(const Ray& ray, const QuadricCut& cut);
  /// x[axis] - position along it.
  static Quadratic along(const Ray& ray, int axis, double position);
  /// 0 where the line crosses the triangle's plane, which it does.
  static Quadratic along(const Ray& ray, const std::array<Vec3, 3>& triangle);
  /// 0 at t = limit, which is finite.
  static Quadratic at(double limit);

  /// Number of distinct real roots; 0 also where every t is one.
  [[nodiscard]] int roots() const;
};

/// A root of a quadratic that has it: 0 the lower, 1 the upper one of two.
struct Root
{
  Quadratic of;
  int index = 0;
};

/// Sign of p at the root.
[[nodiscard]] int signAt(const Quadratic& p, const Root& root);

/// Sign of (x - y).
[[nodiscard]] int compare(const Root& x, const Root& y);

/// Sign of (root - limit); the limit may be infinite.
[[nodiscard]] int compare(const Root& x, double limit);

/// Whether the point of the ray at the root of the quadric's form is in its box, its cuts and its
/// bound.
[[nodiscard]] bool isInside(const Ray& ray, const Quadric& quadric, const Root& root);

/// The double nearest to the root, of two equally near the even one; infinite beyond their range.
[[nodiscard]] double nearest(const Root& root);

} // namespace lumitree::exact

#endif
