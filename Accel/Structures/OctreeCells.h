// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_OctreeCells_h
#define Lumitree_Accel_Structures_OctreeCells_h

#include "Accel/Box.h"

#include <algorithm>

namespace lumitree
{

/// Where the nodes of an octree lie.
class OctreeCells
{
public:
  explicit OctreeCells(const Box& bounds)
    : bounds_(bounds)
    , root_(bounds)
  {
    if (!bounds.empty())
    {
      const double size = bounds.size()[bounds.longestAxis()];
      this->margin_ = relativeMargin * size;
      for (int k = 0; k < 3; ++k)
      {
        this->root_.upper[k] = std::max(bounds.upper[k], bounds.lower[k] + size);
      }
    }
  }

  /// A cube on the lower corner of the bounds.
  [[nodiscard]] const Box& root() const { return this->root_; }

  /// Octant 0 … 7; bit k: above along axis k.
  static Box octantOf(const Box& cube, const Vec3& centre, int i)
  {
    Box octant;
    for (int k = 0; k < 3; ++k)
    {
      const bool above = (i >> k & 1) != 0;
      octant.lower[k] = above ? centre[k] : cube.lower[k];
      octant.upper[k] = above ? cube.upper[k] : centre[k];
    }
    return octant;
  }

  /// The octant and a hair around it, inside the bounds: for Fast and Watertight, which may take
  /// for hit what a ray misses by rounding.
  [[nodiscard]] Box boxOf(const Box& octant) const
  {
    Box box;
    for (int k = 0; k < 3; ++k)
    {
      box.lower[k] = std::max(octant.lower[k] - this->margin_, this->bounds_.lower[k]);
      box.upper[k] = std::min(octant.upper[k] + this->margin_, this->bounds_.upper[k]);
    }
    return box;
  }

private:
  /// Of the root.
  static constexpr double relativeMargin = 0x1p-36;

  Box bounds_;
  Box root_;
  double margin_ = 0.0;
};

} // namespace lumitree

#endif
