// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BspWalk_h
#define Lumitree_Accel_Structures_BspWalk_h

#include "Accel/Kernel/RayBox.h"
#include "Accel/Kernel/Span.h"
#include "Accel/Structures/BspNodes.h"

namespace lumitree
{

/// Where a ray crosses a plane: below or above first, and bounds of t. Both sides all the way where
/// that cannot be told.
struct BspCrossing
{
  bool nearAbove = false;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  BspCrossing(const BspNode& plane, const Ray& ray)
  {
    const PlaneDistance start(plane.normal, plane.offset, ray.origin);
    double speed = 0.0;
    double speedMargin = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      speed += plane.normal[k] * ray.direction[k];
      speedMargin += std::fabs(plane.normal[k] * ray.direction[k]);
    }
    speedMargin *= 0x1p-44;
    if (speed == 0.0 && speedMargin == 0.0)
    {
      // Along the plane, exactly (or so slow that the product vanished: then the margin decides).
      this->beside(plane, ray, start);
      return;
    }
    // What is below the smallest normal numbers has lost its precision.
    if (!(std::fabs(speed) > 4.0 * speedMargin && std::fabs(speed) > 0x1p-960))
    {
      return;
    }
    // start ± margin over speed ± speedMargin, and the rounding of the quotient.
    const double t = -start.value / speed;
    const double pad = 2.0 * ((start.margin + std::fabs(t) * speedMargin) / std::fabs(speed)) +
      std::fabs(t) * 0x1p-48;
    if (std::isfinite(t) && std::isfinite(pad))
    {
      this->nearAbove = speed < 0.0;
      this->low = t - pad;
      this->high = t + pad;
    }
  }

private:
  void beside(const BspNode& plane, const Ray& ray, const PlaneDistance& start)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (plane.normal[k] != 0.0 && ray.direction[k] != 0.0)
      {
        return;
      }
    }
    if (std::fabs(start.value) > start.margin)
    {
      // The near side for ever.
      this->nearAbove = start.value > 0.0;
      this->low = std::numeric_limits<double>::infinity();
    }
  }
};

/// Takes a ray through a BSP-tree, the nearer child first. Each cell is met over an interval of t
/// that holds all t of the segment inside the closed cell: the bounds of the crossing cut the near
/// child's end and the far child's beginning, so both are visited where the interval overlaps them.
template <class Visitor>
void walkBspTree(const BspNodes& tree, const Ray& ray, const RayBox& box, Visitor& visitor)
{
  struct Entry
  {
    std::uint32_t node;
    double tEnter;
    double tExit;
  };
  // At most one far child waits per level, and no node lies deeper than 64.
  Entry stack[65];
  int height = 0;
  Entry current = { 0, 0.0, 0.0 };
  double tStop = visitor.tStop();
  if (!box.meets(tree.cell, tStop, current.tEnter, current.tExit))
  {
    return;
  }
  while (true)
  {
    visitor.node(current.node);
    const BspNode& node = tree.nodes[current.node];
    if (!node.leaf)
    {
      const BspCrossing crossing(node, ray);
      const std::uint32_t nearAbove = crossing.nearAbove ? 1 : 0;
      const Entry nearChild = { node.first + nearAbove, current.tEnter,
        std::min(crossing.high, current.tExit) };
      const Entry farChild = { node.first + 1 - nearAbove, std::max(crossing.low, current.tEnter),
        current.tExit };
      // low <= high but for a ray beside the plane, which is on the near side.
      if (!(nearChild.tEnter <= nearChild.tExit))
      {
        current = farChild;
        continue;
      }
      if (farChild.tEnter <= farChild.tExit && farChild.tEnter <= tStop)
      {
        stack[height++] = farChild;
      }
      current = nearChild;
      continue;
    }
    if (node.count > 0)
    {
      tStop = visitor.leaf({ node.first, node.count, current.tEnter });
    }
    do
    {
      if (height == 0)
      {
        return;
      }
      current = stack[--height];
    } while (current.tEnter > tStop);
  }
}

} // namespace lumitree

#endif
