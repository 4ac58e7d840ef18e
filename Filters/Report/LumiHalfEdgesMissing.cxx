// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiHalfEdges.h"

#include <stdexcept>

namespace lumitree::filters
{

HalfEdgeReport halfEdges(const std::vector<Face>&, std::size_t)
{
  throw std::runtime_error("This build of Lumitree has no half-edges: it was made without OpenMesh "
                           "(LUMITREE_OPENMESH).");
}

} // namespace lumitree::filters
