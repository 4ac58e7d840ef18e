// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_KdTreeWalk_h
#define Lumitree_Accel_Structures_KdTreeWalk_h

#include "Accel/Structures/KdTreeNodes.h"
#include "Accel/Structures/PlaneWalk.h"

namespace lumitree
{

/// Takes a ray through a KD-tree. In a plane (NaN) a ray is in both children.
template <class Visitor>
void walkKdTree(const KdTreeNodes& tree, const RayBox& ray, Visitor& visitor)
{
  walkPlanes(
    tree, ray, [](const KdNode& node) { return node.isLeaf(); },
    [&ray](const KdNode& node)
    {
      PlaneCrossing crossing;
      crossing.nearAbove = ray.negative(node.axis);
      ray.crosses(node.axis, node.position, crossing.low, crossing.high);
      return crossing;
    },
    visitor);
}

} // namespace lumitree

#endif
