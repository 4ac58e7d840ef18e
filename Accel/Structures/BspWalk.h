// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BspWalk_h
#define Lumitree_Accel_Structures_BspWalk_h

#include "Accel/Structures/BspNodes.h"
#include "Accel/Structures/PlaneWalk.h"

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

/// Takes a ray through a BSP-tree.
template <class Visitor>
void walkBspTree(const BspNodes& tree, const Ray& ray, const RayBox& box, Visitor& visitor)
{
  walkPlanes(
    tree, box, [](const BspNode& node) { return node.leaf; },
    [&ray](const BspNode& node)
    {
      const BspCrossing crossing(node, ray);
      return PlaneCrossing{ crossing.nearAbove, crossing.low, crossing.high };
    },
    visitor);
}

} // namespace lumitree

#endif
