// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BspNodes_h
#define Lumitree_Accel_Structures_BspNodes_h

#include "Accel/Box.h"

#include <cstdint>
#include <vector>

namespace lumitree
{

/// A node of a BSP-tree. Interior: the plane normal · x = offset, first is the child below it
/// (normal · x <= offset), the one above follows. Leaf: count triangles from block first on.
struct BspNode
{
  /// The normal's largest component is ±1. For planes across an axis the other two are 0, so that
  /// normal · x is a coordinate, exactly.
  Vec3 normal = { 0.0, 0.0, 0.0 };
  double offset = 0.0;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  std::int32_t axis = -1; ///< interior, across an axis: 0, 1 or 2
  bool leaf = true;
};

/// Node 0 is the root; children come after their parent, side by side.
struct BspNodes
{
  Box cell; ///< of the root
  std::vector<BspNode> nodes;
};

/// normal · x - offset, and what two such sums and their rounding can never differ by: 2^-44 of the
/// magnitudes added up, where rounding takes 2^-50; the rest is for Fast and Watertight, which may
/// take for hit what a ray misses by rounding.
struct PlaneDistance
{
  double value = 0.0;
  double margin = 0.0;

  PlaneDistance(const Vec3& normal, double offset, const Vec3& x)
  {
    double magnitude = std::fabs(offset);
    for (int k = 0; k < 3; ++k)
    {
      this->value += normal[k] * x[k];
      magnitude += std::fabs(normal[k] * x[k]);
    }
    this->value -= offset;
    this->margin = magnitude * 0x1p-44 + 0x1p-1000;
  }
};

} // namespace lumitree

#endif
