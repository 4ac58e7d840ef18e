// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LUMITREE_TESTING_DATA_MESH_CHECKS_H
#define LUMITREE_TESTING_DATA_MESH_CHECKS_H

#include "Data/Scenes.h"

#include <array>
#include <cstdint>
#include <string>

namespace lumitree::data::testing
{

struct EdgeCounts
{
  std::int64_t open = 0;  ///< edges of one polygon
  std::int64_t wrong = 0; ///< edges of more than two, or of two that run the same way
};

/// Looks at every edge of the mesh.
EdgeCounts countEdges(const Mesh& mesh);

/// The volume that the polygons enclose, polygons being cut into fans; positive when outward.
double signedVolume(const Mesh& mesh);

/// The surface of all polygons, each cut into a fan.
double area(const Mesh& mesh);

/// Whether arrays have matching sizes, and ids, parts and reflectances are in their ranges.
bool isConsistent(const Mesh& mesh);

/// FNV-1a over the bits of the points and the ids.
std::uint64_t fingerprint(const Mesh& mesh);

/// The cells of one part, with all points.
Mesh partOf(const Mesh& mesh, const std::string& name);

struct Bounds
{
  std::array<double, 3> low, high;
};

/// Of the points that cells use.
Bounds bounds(const Mesh& mesh);

}

#endif
