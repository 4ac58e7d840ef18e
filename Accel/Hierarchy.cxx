// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Hierarchy.h"

#include "Accel/BuildOptions.h"
#include "Accel/Structures/ConvexPolyhedron.h"
#include "Accel/Surface.h"

#include <algorithm>

namespace lumitree
{

namespace
{

/// Cells of a grid that a random ray goes through.
double cellsCrossed(const Box& box, const std::array<int, 3>& resolution)
{
  const Vec3 size = box.size();
  double faces = 0.0;
  double cells = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    // Of each slab across axis k the two faces, divided among its cells.
    const double face = size[(k + 1) % 3] * size[(k + 2) % 3];
    faces += face;
    cells += face * resolution[k];
  }
  return faces > 0.0 ? cells / faces : 1.0;
}

} // namespace

double costOf(const HierarchyView& view, std::size_t node)
{
  const HierarchyNode& n = view.nodes[node];
  if (n.leaf)
  {
    return leafCost(n.referenceCount);
  }
  if (view.gridResolution[0] > 0)
  {
    return view.stepCost * cellsCrossed(n.box, view.gridResolution);
  }
  return n.splitAxis >= 0 ? view.axisStepCost : view.stepCost;
}

void completeHierarchy(HierarchyView& view)
{
  const auto areaOfNode = [&](std::size_t i)
  { return view.polyhedra.empty() ? view.nodes[i].box.area() : areaOf(view.polyhedra[i]); };
  const double rootArea = view.nodes.empty() ? 0.0 : areaOfNode(0);
  // Parents come before their children, so counts flow upward in one backward pass.
  for (std::size_t i = view.nodes.size(); i-- > 0;)
  {
    HierarchyNode& node = view.nodes[i];
    const double share = rootArea > 0.0 ? areaOfNode(i) / rootArea : 0.0;
    node.cost = share * costOf(view, i);
    if (node.parent >= 0)
    {
      view.nodes[static_cast<std::size_t>(node.parent)].referenceCount += node.referenceCount;
    }
  }
}

double duplicationOf(std::size_t references, const Surface& surface)
{
  return surface.hittable().empty()
    ? 1.0
    : static_cast<double>(references) / static_cast<double>(surface.hittable().size());
}

BuildStatistics describe(const HierarchyView& view, const Surface& surface)
{
  BuildStatistics s;
  s.nodes = view.nodes.size();
  for (const HierarchyNode& node : view.nodes)
  {
    s.leaves += node.leaf ? 1 : 0;
    s.depth = std::max(s.depth, static_cast<int>(node.depth));
    s.sahCost += node.cost;
  }
  s.references = view.references.size();
  s.duplication = duplicationOf(s.references, surface);
  return s;
}

} // namespace lumitree
