// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BspDivide_h
#define Lumitree_Accel_Structures_BspDivide_h

#include "Accel/Structures/BspFrame.h"
#include "Accel/Structures/KdTreeSplitters.h"
#include "Accel/Surface.h"

namespace lumitree
{

/// A plane that may divide a cell: normal · x = offset, the normal as in BspNode.
struct BspPlane
{
  Vec3 normal = { 0.0, 0.0, 0.0 };
  double offset = 0.0;
  int axis = -1;            ///< across an axis: 0, 1, 2
  bool inPlaneBelow = true; ///< across an axis: what lies in the plane goes below it
};

enum class BspSide : std::uint8_t
{
  Below,
  Above,
  Both
};

/// On one side alone only what is certain to lie there: the vertices, or the part in the cell, by
/// more than PlaneDistance's margin.
[[nodiscard]] BspSide sideOf(const Surface& surface, const KdReference& r, const BspPlane& plane);

/// A cell and what reaches into it.
struct BspPart
{
  Box cell;              ///< holds the cell
  Polyhedron polyhedron; ///< the cell, nearly, in the frame
  std::vector<KdReference> references;
};

/// The two parts of a cell, below and above the plane, of the polyhedra that it was cut into. Order
/// is kept.
[[nodiscard]] std::pair<BspPart, BspPart> divideReferences(const Surface& surface,
  const WideBvhFrame& frame, const BspPart& whole, const BspPlane& plane,
  std::pair<Polyhedron, Polyhedron>&& polyhedra);

} // namespace lumitree

#endif
