// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Quadric_h
#define Lumitree_Accel_Quadric_h

#include "Accel/Box.h"
#include "Accel/Export.h"
#include "Accel/ImplicitTree.h"
#include "Accel/QuadricForm.h"

#include <array>
#include <memory>
#include <vector>

namespace lumitree
{

/// The half-space normal · (x - point) <= 0; no constraint when the normal is 0.
struct QuadricCut
{
  Vec3 normal = { 0.0, 0.0, 0.0 };
  Vec3 point = { 0.0, 0.0, 0.0 };
};

/// An implicit primitive: the points of the closed clip box where the form is 0, that lie in both
/// cuts and where the bound's form is not above 0 (the default bound is 0 everywhere and cuts
/// nothing off). A ray meets it once per root: a tangent once, a ray that lies in it never.
///
/// The factories round what they compute (unit axes, squared ratios) to nearest once or twice; the
/// primitive is what is stored. Spheres are exactly those of their centre and radius, cylinders
/// along an axis of coordinates as well (unless their squares are below 1e-290). Their boxes are a
/// millionth of their size wider than the primitive, so that they never decide. Parameters that
/// make no sense (a radius or a height that is negative, 0 or not a number) give a primitive with
/// an empty box, which a Surface counts and never hits.
struct LUMITREE_ACCEL_EXPORT Quadric
{
  QuadricForm form;
  Box clip;
  std::array<QuadricCut, 2> cuts;
  QuadricForm bound;
  /// If not null, only where this tree is 0 as well, a sign of forms of which form is the first
  /// that has its numbers.
  std::shared_ptr<const ImplicitTree> tree;

  /// The sphere |x - centre| = radius.
  static Quadric sphere(const Vec3& centre, double radius);

  /// The ellipsoid with these semi-axes, at right angles to each other.
  static Quadric ellipsoid(const Vec3& centre, const std::array<Vec3, 3>& semiAxes);

  /// The tube of this radius from one point to the other, without its ends.
  static Quadric cylinder(const Vec3& from, const Vec3& to, double radius);

  /// The same with a disc at each end: the discs end exactly at the tube.
  static std::vector<Quadric> cappedCylinder(const Vec3& from, const Vec3& to, double radius);

  /// The lateral surface of the cone from its apex to a base of this radius.
  static Quadric cone(const Vec3& apex, const Vec3& base, double radius);

  /// The same with its base.
  static std::vector<Quadric> cappedCone(const Vec3& apex, const Vec3& base, double radius);

  /// The paraboloid of revolution from its vertex to where it has this radius around `end`.
  static Quadric paraboloid(const Vec3& vertex, const Vec3& end, double radius);

  /// The disc of this radius around a point.
  static Quadric disc(const Vec3& centre, const Vec3& normal, double radius);

  /// The part of a plane in a closed box.
  static Quadric plane(const Vec3& point, const Vec3& normal, const Box& box);

  /// The six sides of a box; neighbours share their edges exactly.
  static std::vector<Quadric> sides(const Box& box);

  /// The part of any quadric in a closed box.
  static Quadric inBox(const QuadricForm& form, const Box& box);

  /// Where a sign of forms is 0 in a closed box: one quadric for each form that differs from those
  /// before it. A union, an intersection or a difference of solids is thus the pieces of their
  /// surfaces that it shows, each as exact as a sphere. Throws std::invalid_argument where the tree
  /// is not valid or not a sign of forms.
  static std::vector<Quadric> zerosOf(
    const std::shared_ptr<const ImplicitTree>& tree, const Box& box);
};

} // namespace lumitree

#endif
