// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Report_LumiHalfEdges_h
#define Lumitree_Filters_Report_LumiHalfEdges_h

#include "LumiSurfaceEdges.h"

#include <cstdint>
#include <vector>

namespace lumitree::filters
{

/// Points one after the other along the border of a half-edge mesh; the last is joined to the
/// first.
using Border = std::vector<std::uint32_t>;

/// What became of faces that were put into a half-edge mesh.
struct HalfEdgeReport
{
  std::vector<std::uint32_t> refused; ///< places in the list of faces, ascending
  std::vector<Border> borders;        ///< of what was taken
};

/// Puts faces into a half-edge mesh (OpenMesh), which takes no more than two faces at an edge, in
/// opposite directions, and one fan at a point; the first come are taken. Throws std::runtime_error
/// where this build has no OpenMesh.
[[nodiscard]] HalfEdgeReport halfEdges(const std::vector<Face>& faces, std::size_t points);

} // namespace lumitree::filters

#endif
