// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BspFrame_h
#define Lumitree_Accel_Structures_BspFrame_h

#include "Accel/Structures/BvhFrame.h"
#include "Accel/Structures/ConvexPolyhedron.h"

namespace lumitree
{

/// The frame in which the cells of a BSP-tree are cut, so that areas neither over- nor underflow.
[[nodiscard]] inline WideBvhFrame bspFrameOf(const Box& cell)
{
  return cell.empty() ? WideBvhFrame{} : frameOf(cell);
}

[[nodiscard]] inline Vec3 framedPoint(const WideBvhFrame& frame, const Vec3& x)
{
  return frame.scale * (x - frame.centre);
}

[[nodiscard]] inline double framedOffset(
  const WideBvhFrame& frame, const Vec3& normal, double offset)
{
  return frame.scale * (offset - dot(normal, frame.centre));
}

[[nodiscard]] inline Polyhedron framedRoot(const WideBvhFrame& frame, const Box& cell)
{
  Box framed;
  framed.extend(framedPoint(frame, cell.lower));
  framed.extend(framedPoint(frame, cell.upper));
  return polyhedronOf(framed);
}

/// Out of the frame.
inline void unframe(const WideBvhFrame& frame, Polyhedron& polyhedron)
{
  for (Vec3& p : polyhedron.points)
  {
    for (int k = 0; k < 3; ++k)
    {
      p[k] = frame.centre[k] + p[k] / frame.scale;
    }
  }
}

/// The box of a polyhedron of the frame, out of it, with more room around than rounding takes.
[[nodiscard]] inline Box boxAround(const WideBvhFrame& frame, const Polyhedron& polyhedron)
{
  const Box framed = boundsOf(polyhedron);
  Box box;
  for (int k = 0; k < 3; ++k)
  {
    const double room = (std::fabs(frame.centre[k]) + 1.0 / frame.scale) * 0x1p-40;
    box.lower[k] = frame.centre[k] + framed.lower[k] / frame.scale - room;
    box.upper[k] = frame.centre[k] + framed.upper[k] / frame.scale + room;
  }
  return box;
}

} // namespace lumitree

#endif
