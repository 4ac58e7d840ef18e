// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_ConvexPolyhedron_h
#define Lumitree_Accel_Structures_ConvexPolyhedron_h

#include "Accel/Hierarchy.h"

#include <optional>
#include <utility>
#include <vector>

namespace lumitree
{

/// A box as a polyhedron.
[[nodiscard]] Polyhedron polyhedronOf(const Box& box);

/// Both parts of a convex polyhedron, at normal·x <= offset and >= offset; nothing where the plane
/// passes it by or touches it only. In floating point: for areas and pictures, not for decisions.
[[nodiscard]] std::optional<std::pair<Polyhedron, Polyhedron>> cutPolyhedron(
  const Polyhedron& polyhedron, const Vec3& normal, double offset);

/// What areaOf would say of both parts, but for rounding, without making them. Keeps its memory
/// from cut to cut.
class CutAreas
{
public:
  /// Nothing where cutPolyhedron gives nothing (unless rounding has left a part open).
  [[nodiscard]] std::optional<std::pair<double, double>> operator()(
    const Polyhedron& polyhedron, const Vec3& normal, double offset);

private:
  [[nodiscard]] double areaOfPart(const Polyhedron& polyhedron, int kept) const;

  std::vector<double> distance_;
  std::vector<int> side_;
};

/// The sum of its faces' areas.
[[nodiscard]] double areaOf(const Polyhedron& polyhedron);

[[nodiscard]] Box boundsOf(const Polyhedron& polyhedron);

} // namespace lumitree

#endif
