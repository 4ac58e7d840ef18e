// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_CellSave_h
#define Lumitree_Accel_Structures_CellSave_h

#include "Accel/Save/SaveStream.h"
#include "Accel/Structures/KdTreeSplitters.h"
#include "Accel/Surface.h"

namespace lumitree
{

/// What the trees of cells share when they are saved. Of these only the divisions are saved, the
/// root first and what is below a plane before what is above it; the surface is divided again by
/// them when they are loaded.

inline constexpr int cellDepthLimit = 64;

/// How many references a loaded tree may have: more than any builder makes.
[[nodiscard]] inline std::size_t mostReferences(const Surface& surface)
{
  return 65536 + 16 * surface.hittable().size();
}

/// What reaches into the root.
[[nodiscard]] inline std::vector<KdReference> rootReferences(const Surface& surface)
{
  std::vector<KdReference> references;
  references.reserve(surface.hittable().size());
  for (const PrimitiveId id : surface.hittable())
  {
    references.push_back({ surface.box(id), id });
  }
  return references;
}

[[nodiscard]] inline std::vector<PrimitiveId> idsOf(const std::vector<KdReference>& references)
{
  std::vector<PrimitiveId> ids;
  ids.reserve(references.size());
  for (const KdReference& r : references)
  {
    ids.push_back(r.id);
  }
  return ids;
}

/// The planes above a leaf that lie across an axis, while a tree is gone through; to find out on
/// which side of its plane a node has what lies in the plane, which the tree itself does not say.
class PlanesAbove
{
public:
  struct Plane
  {
    std::size_t node = 0;
    int axis = -1; ///< -1: not across an axis
    double position = 0.0;
    bool above = false; ///< the side gone to
  };

  explicit PlanesAbove(std::size_t nodes)
    : inPlaneAbove_(nodes, false)
  {
  }

  /// The way goes on from a node of that depth, which forgets deeper ones.
  void go(std::size_t depth, const Plane& plane)
  {
    this->planes_.resize(depth);
    this->planes_.push_back(plane);
  }

  /// At a leaf of that depth: it has this primitive.
  void found(std::size_t depth, const Box& box)
  {
    for (std::size_t i = 0; i < depth; ++i)
    {
      const Plane& p = this->planes_[i];
      if (p.axis >= 0 && p.above && box.lower[p.axis] == p.position &&
        box.upper[p.axis] == p.position)
      {
        this->inPlaneAbove_[p.node] = true;
      }
    }
  }

  [[nodiscard]] bool inPlaneAbove(std::size_t node) const { return this->inPlaneAbove_[node]; }

private:
  std::vector<Plane> planes_;
  std::vector<bool> inPlaneAbove_;
};

} // namespace lumitree

#endif
