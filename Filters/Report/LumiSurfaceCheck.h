// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Report_LumiSurfaceCheck_h
#define Lumitree_Filters_Report_LumiSurfaceCheck_h

#include "Accel/Surface.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace lumitree::filters
{

/// What is wrong with a triangle; of several the first that applies. The values are those of the
/// array Defect (Docs/data-model.md).
enum class Defect : int
{
  Sound = 0,
  NonFinite = 1,  ///< a coordinate is not finite: never hit
  Degenerate = 2, ///< zero area, decided exactly: never hit
  Duplicate = 3,  ///< the same three points as an earlier triangle
  Refused = 4,    ///< half-edges do not take it: more than two faces at an edge, or fans at a point
  Flipped = 5     ///< wound against most of its neighbours
};

/// What is wrong with an edge. The values are those of the array Kind.
enum class EdgeKind : int
{
  Boundary = 0,    ///< one face
  NonManifold = 1, ///< more than two faces
  Inconsistent = 2 ///< two faces that run along it in the same direction
};

/// Edges one after the other; a boundary loop repeats its first point at the end.
struct EdgeLine
{
  EdgeKind kind = EdgeKind::Boundary;
  std::vector<std::uint32_t> points; ///< of the surface
  std::uint32_t faces = 0;           ///< at each of its edges
};

/// What a surface is.
struct SurfaceCheck
{
  std::vector<Defect> defects;          ///< one per triangle
  std::vector<std::int64_t> components; ///< one per triangle; -1: not part of the net of faces
  std::vector<unsigned char> boundary;  ///< one per point: on a boundary edge
  std::vector<unsigned char>
    nonManifold; ///< one per point: on a non-manifold edge, or several fans
  std::vector<EdgeLine> lines;

  std::uint64_t points = 0; ///< different ones, in use
  std::uint64_t mergedPoints = 0;
  std::uint64_t counts[6] = {}; ///< triangles of each Defect
  std::uint64_t edges = 0;
  std::uint64_t boundaryEdges = 0;
  std::uint64_t boundaryLoops = 0; ///< lines of that kind
  std::uint64_t nonManifoldEdges = 0;
  std::uint64_t inconsistentEdges = 0;
  std::uint64_t nonManifoldPoints = 0;
  std::uint64_t componentCount = 0;
  std::int64_t eulerCharacteristic = 0; ///< points - edges + faces
  bool closed = false;                  ///< no boundary edge
  bool manifold = false;                ///< half-edges take every face, one fan at each point
  bool consistent = false;              ///< no inconsistent edge
  bool orientable = false;              ///< consistent, or can be made so
  bool even = false;                    ///< an even number of faces at each edge
  double area = 0.0;
  double volume = 0.0; ///< above 0: wound outward; NaN unless closed and wound alike everywhere
};

/// Examines the triangles of a surface. Triangles with a coordinate that is not finite are no part
/// of the net of faces: rays do not see them. Those of zero area are: they close the gap between a
/// long edge and the two that it was cut into. With mergePoints points of the same coordinates are
/// one point, as they are for rays.
///
/// progress is told the fraction done and returns false to stop; what is returned then is empty.
/// Throws std::runtime_error where half-edges are not built in.
[[nodiscard]] SurfaceCheck checkSurface(
  const Surface& surface, bool mergePoints, const std::function<bool(double)>& progress);

} // namespace lumitree::filters

#endif
