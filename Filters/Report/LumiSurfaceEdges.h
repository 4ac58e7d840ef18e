// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Report_LumiSurfaceEdges_h
#define Lumitree_Filters_Report_LumiSurfaceEdges_h

#include "Accel/Surface.h"

#include <array>
#include <cstdint>
#include <vector>

namespace lumitree::filters
{

/// A triangle of three different points.
struct Face
{
  std::array<std::uint32_t, 3> points{};
  PrimitiveId primitive = 0;
};

/// An edge, and the faces at it: uses[first … first + count - 1] of the table.
struct Edge
{
  std::uint32_t low = 0; ///< the lower of its two points
  std::uint32_t high = 0;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// One side of a face.
struct EdgeUse
{
  std::uint32_t face = 0; ///< place in the list of faces
  bool forward = false;   ///< it runs from the lower point to the higher
};

/// Every edge of a list of faces, ordered by its points.
struct EdgeTable
{
  std::vector<Edge> edges;
  std::vector<EdgeUse> uses;

  explicit EdgeTable(const std::vector<Face>& faces);

  /// Null when there is no such edge.
  [[nodiscard]] const Edge* find(std::uint32_t a, std::uint32_t b) const;

  /// Two faces that run along it in the same direction.
  [[nodiscard]] bool isInconsistent(const Edge& edge) const
  {
    return edge.count == 2 && this->uses[edge.first].forward == this->uses[edge.first + 1].forward;
  }

  /// As many faces run along it in one direction as in the other.
  [[nodiscard]] bool isBalanced(const Edge& edge) const;
};

/// Which faces hang together, and whether they are wound alike.
struct Patches
{
  std::vector<std::uint32_t> component; ///< of each face, joined by edges with any number of faces
  std::uint32_t components = 0;
  /// Of each face, whether it is wound against most of those that it is joined to by edges with two
  /// faces; of two halves, the one without the first face.
  std::vector<bool> flipped;
  bool orientable = true; ///< turning faces over can make all of them agree

  Patches(const std::vector<Face>& faces, const EdgeTable& table);
};

/// Of each point, whether its faces, joined by edges with two faces, form more than one fan.
[[nodiscard]] std::vector<bool> splitPoints(
  const std::vector<Face>& faces, const EdgeTable& table, std::size_t points);

} // namespace lumitree::filters

#endif
